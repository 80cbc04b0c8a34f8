"""``python -m gaussiancad_core.learning`` draws sheets and trains the labels network on them."""

import sys

from gaussiancad_core.learning.learning_command import main

sys.exit(main())

"""``python -m learning`` draws sheets and trains the labels network on them."""

import sys

from learning.learning_command import main

sys.exit(main())

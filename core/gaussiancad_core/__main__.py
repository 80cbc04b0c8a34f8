"""``python -m gaussiancad_core`` is the ``gaussiancad`` command."""

import sys

from gaussiancad_core.cli import main

sys.exit(main())

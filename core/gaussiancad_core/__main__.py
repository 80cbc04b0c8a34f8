"""``python -m gaussiancad_core`` is the ``gaussiancad`` command."""

import sys

from gaussiancad_core.cli.starting import start

sys.exit(start())

"""``python -m gaussiancad_core`` is the ``gaussiancad`` command.

Whatever Python it is started with reads this file, so that an old one can be told apart.
"""

import sys

if sys.version_info < (3, 11):  # noqa: UP036
    print(
        f"gaussiancad: Python {sys.version_info[0]}.{sys.version_info[1]} is too old: start it "
        "with Python 3.11 or later [python-too-old]",
        file=sys.stderr,
    )
    sys.exit(6)

from gaussiancad_core.cli.starting import start

sys.exit(start())

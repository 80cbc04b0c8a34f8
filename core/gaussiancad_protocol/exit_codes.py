"""How the ``gaussiancad`` command ends, and ``freecadcmd`` with a batch."""

from enum import IntEnum


class ExitCode(IntEnum):
    """Exit status of the command."""

    DONE = 0
    SOME_SHEETS_FAILED = 1
    USAGE = 2
    UNREADABLE = 3
    NO_MODEL = 4
    LIMIT = 5
    ENGINE = 6
    CANCELLED = 130

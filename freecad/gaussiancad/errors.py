"""What can go wrong in a way that a person can mend."""

from enum import Enum


class ErrorCode(Enum):
    """Kebab-case codes of the workbench's own errors; the engine adds its own to a run's result."""

    ENGINE_NOT_FOUND = "engine-not-found"
    ENGINE_BROKEN = "engine-broken"
    ENGINE_KILLED = "engine-killed"
    RESULT_UNREADABLE = "result-unreadable"
    NOTHING_TO_COMPARE = "nothing-to-compare"
    SOLUTIONS_GONE = "solutions-gone"
    SHEET_MISSING = "sheet-missing"
    NO_VIEWS = "no-views"
    NO_BODY = "no-body"
    OUTPUT_IS_LINK = "output-is-link"
    NAME_NO_TEXT = "name-no-text"
    DOCUMENT_NOT_WRITTEN = "document-not-written"
    WRONG_ARGUMENTS = "wrong-arguments"


class WorkbenchError(Exception):
    """An error whose message is shown to the user as it is.

    Args:
        code: what kind of error it is.
        message: what happened, where, what to do.
    """

    def __init__(self, code: ErrorCode, message: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message

"""The one family of errors that a user can cause, and the exit codes they end in.

Every error carries a ``code`` (kebab-case, stable, listed in ``docs/messages.md``) and a message of
one sentence or two: what happened, where, and what to do; its values travel with it.  Anything
else that escapes the engine is a defect of the engine and ends in :attr:`ExitCode.ENGINE`.
"""

import errno
from collections.abc import Iterable

from gaussiancad_core.messages import Box, Message
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode


class GaussianCadError(Exception):
    """Root of all errors that are told to a person instead of shown as a traceback.

    Args:
        code: kebab-case identifier, stable between versions.
        message: what happened, where, what to do; no trailing newline.
        boxes: where on the sheet that is of which it speaks, px.
        values: what fills the places ``{name}`` of the message.
    """

    exit_code: ExitCode = ExitCode.ENGINE

    def __init__(
        self, code: str, message: str, /, boxes: Iterable[Box] = (), **values: object
    ) -> None:
        known = message if isinstance(message, Message) else Message(message, boxes, **values)
        super().__init__(str(known))
        self.code = code
        self.message = known


class UsageError(GaussianCadError, ValueError):
    """The command was called in a way that cannot work."""

    exit_code = ExitCode.USAGE


class UnreadableError(GaussianCadError, OSError):
    """A file cannot be read: missing, not of its kind, damaged, too large, empty."""

    exit_code = ExitCode.UNREADABLE

    def __str__(self) -> str:
        return self.message


class NoModelError(GaussianCadError, ValueError):
    """The sheet was read, but no model follows from it."""

    exit_code = ExitCode.NO_MODEL


class LimitError(GaussianCadError, RuntimeError):
    """A limit of time, memory or disk was reached."""

    exit_code = ExitCode.LIMIT


class EngineError(GaussianCadError, RuntimeError):
    """The engine itself is incomplete or broken."""

    exit_code = ExitCode.ENGINE


class CancelledError(GaussianCadError):
    """The run was stopped by the user or by the end of its parent process."""

    exit_code = ExitCode.CANCELLED


_CV_NO_MEMORY = -4
"""OpenCV's ``StsNoMem``."""


_NO_MEMORY = ("allocate memory", "bad_alloc", "failed to map segment")
"""What libraries say where they get none: PyTorch, those of C++, and the system's loader."""


def is_out_of_memory(error: BaseException) -> bool:
    """Whether an error, of Python or of a library, says that memory does not suffice."""
    if isinstance(error, MemoryError) or getattr(error, "errno", None) == errno.ENOMEM:
        return True
    if type(error).__module__.partition(".")[0] == "cv2":
        return getattr(error, "code", None) == _CV_NO_MEMORY
    of_library = isinstance(error, RuntimeError | ImportError | OSError) or (
        type(error).__module__.startswith("onnxruntime.")
    )
    if isinstance(error, GaussianCadError) or not of_library:
        return False
    return any(words in str(error) for words in _NO_MEMORY)


_NO_FILES = frozenset({errno.EMFILE, errno.ENFILE})

_NO_FILES_SAID = "Too many open files"
"""What the system's loader says where it gets none."""


def out_of_files(error: BaseException) -> LimitError | None:
    """What is told of an error that comes of one by which the system lets no more files be opened;
    None of any other.
    """
    cause: BaseException | None = error
    seen: list[BaseException] = []
    # An error that is raised anew may be its own cause.
    while cause is not None and not any(cause is one for one in seen):
        seen.append(cause)
        by_loader = isinstance(cause, ImportError) and _NO_FILES_SAID in str(cause)
        if by_loader or getattr(cause, "errno", None) in _NO_FILES:
            return LimitError(
                Code.TOO_MANY_OPEN_FILES,
                "the system lets the engine open no more files: raise that limit (`ulimit -n`, "
                "or that of the whole system), or close other programs, then retry",
            )
        cause = cause.__cause__
    return None

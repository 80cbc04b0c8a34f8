"""Files are read in a process of their own, so that none can hang or end the engine.

Their libraries parse what anybody may have written, some of it made to break them.  The child has
a limit of time and of memory; what happens to it, the user gets one clear line.
"""

import os
import subprocess
import sys
from pathlib import Path

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.files.answer import outcome_of
from gaussiancad_core.files.content import FileContent
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.messages import filled
from gaussiancad_protocol.codes import Code

TIME_LIMIT = 60.0
"""Seconds.  A sheet takes one or two, the largest that are allowed some twenty."""

MEMORY_LIMIT = 4 << 30
"""Bytes of address space."""

_CHILD = "gaussiancad_core.files.file_child"


def read_isolated(
    kind: FileKind, path: Path, page: int, time_limit: float = TIME_LIMIT
) -> FileContent:
    """Read a page of a file in a child process.

    Args:
        kind: of the file.
        path: the file.
        page: counted from 1.
        time_limit: seconds.

    Raises:
        GaussianCadError: whatever the kind's reader raises.
        LimitError: ``reading-takes-too-long``, ``out-of-memory``.
        UnreadableError: ``damaged-image``, ``damaged-pdf``, ``damaged-svg``, ``damaged-dxf``: the
            library crashed.
    """
    # The child imports from where the engine does.
    isolated = ["-I"] if sys.flags.isolated else []
    arguments = [kind.value, str(path.absolute()), str(page), str(time_limit)]
    command = [sys.executable, *isolated, "-m", _CHILD, *arguments]
    # More threads than one would only take address space.
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    with subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=environment,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    ) as child:
        try:
            answer, _ = child.communicate(timeout=time_limit)
        except subprocess.TimeoutExpired:
            raise LimitError(
                Code.READING_TAKES_TOO_LONG,
                "{path} is not read after {seconds:g} seconds: "
                "save only the views, or export it as PNG",
                path=path,
                seconds=time_limit,
            ) from None
        finally:
            # Also when the run is cancelled meanwhile.
            if child.poll() is None:
                child.kill()
    return content_in(answer, kind, path)


def content_in(answer: bytes, kind: FileKind, path: Path) -> FileContent:
    """What a child's answer holds; errors as of :func:`read_isolated`."""
    try:
        outcome = outcome_of(answer)
    except ValueError:
        raise UnreadableError(
            kind.damaged,
            "{path} is damaged, reading it crashed: export the drawing again, or as PNG",
            path=path,
        ) from None
    if isinstance(outcome, FileContent):
        return outcome
    if outcome.code == Code.OUT_OF_MEMORY:
        raise LimitError(
            outcome.code,
            "{path} takes too much memory to read: export it as PNG, of fewer pixels",
            path=path,
        )
    # Messages name the file as the user did.
    absolute = str(path.absolute())
    args = {
        name: value.replace(absolute, str(path)) if isinstance(value, str) else value
        for name, value in outcome.message.args.items()
    }
    message = filled(outcome.message.replace(absolute, str(path)), args)
    raise type(outcome)(outcome.code, message)

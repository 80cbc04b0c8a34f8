"""The child process of :mod:`gaussiancad_core.files.isolation`.

``python -m gaussiancad_core.files.file_child KIND FILE PAGE SECONDS`` writes what was read, or why
nothing was, to its standard output (:mod:`.answer`).  It limits itself, and dies with its parent.
"""

import gc
import math
import os
import sys
from pathlib import Path

from gaussiancad_core.errors import GaussianCadError, LimitError, UnreadableError
from gaussiancad_core.files.answer import content_bytes, error_bytes
from gaussiancad_core.files.content import FileContent
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.files.isolation import MEMORY_LIMIT
from gaussiancad_core.processes.limited_child import limit_itself
from gaussiancad_protocol.codes import Code

_LARGEST_FILE = 1 << 30
"""Bytes; it writes none."""

_NO_MEMORY = LimitError(Code.OUT_OF_MEMORY, "")
"""Its parent finds the words."""


def main(kind: FileKind, path: Path, page: int) -> None:
    """Read a page and write the outcome."""
    # The process ends with the page: looking for garbage takes a tenth of its time.
    gc.disable()
    # Libraries print to standard output; the answer is alone on it.
    answer = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with answer:
        answer.write(answer_of(kind, path, page))


def answer_of(kind: FileKind, path: Path, page: int) -> bytes:
    """What was read of a page of a file in this process, or why nothing was (:mod:`.answer`)."""
    try:
        return content_bytes(read_directly(kind, path, page))
    except GaussianCadError as error:
        return error_bytes(error)
    except MemoryError:
        return error_bytes(_NO_MEMORY)
    except Exception as error:
        # Broken values make parsers raise anything, a RecursionError too.
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        message = f"{path} cannot be read ({reason}): export the drawing again, or as PNG"
        return error_bytes(UnreadableError(kind.damaged, message))


def read_directly(kind: FileKind, path: Path, page: int) -> FileContent:
    """Read a page of a file in this process; errors as of the kind's reader."""
    if kind is FileKind.RASTER:
        from gaussiancad_core.files.raster_files import read_raster as read
    elif kind is FileKind.PDF:
        from gaussiancad_core.files.pdf import read_pdf as read
    elif kind is FileKind.SVG:
        from gaussiancad_core.files.svg import read_svg as read
    else:
        from gaussiancad_core.files.dxf import read_dxf as read
    return read(path, page)


def _limit_work(seconds: float) -> None:
    """Bound the address space and the processor's time, where the system can."""
    try:
        import resource
    except ImportError:
        return
    for kind, wanted in (
        (resource.RLIMIT_AS, MEMORY_LIMIT),
        (resource.RLIMIT_CPU, math.ceil(seconds)),
    ):
        _, most = resource.getrlimit(kind)
        limit = wanted if most == resource.RLIM_INFINITY else min(wanted, most)
        resource.setrlimit(kind, (limit, most))


if __name__ == "__main__":
    limit_itself(_LARGEST_FILE)
    _limit_work(float(sys.argv[4]))
    main(FileKind(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))

"""The child process of :mod:`gaussiancad_core.sheet.files.isolation`.

``python -m gaussiancad_core.sheet.files.child KIND FILE PAGE`` writes one pickled object to its
standard output: what was read, or an error's class, code and message.
"""

import os
import pickle
import sys
from pathlib import Path

from gaussiancad_core.errors import GaussianCadError, UnreadableError
from gaussiancad_core.sheet.files.content import FileContent
from gaussiancad_core.sheet.files.isolation import MEMORY_LIMIT
from gaussiancad_core.sheet.files.kinds import FileKind


def main(kind: FileKind, path: Path, page: int) -> None:
    """Read a page and write the outcome."""
    # Libraries print to standard output; the answer is alone on it.
    answer = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    _limit_memory()
    try:
        outcome: object = read_directly(kind, path, page)
    except GaussianCadError as error:
        outcome = (type(error), error.code, error.message)
    except MemoryError:
        outcome = (MemoryError, "", "")
    except Exception as error:
        # Broken values make parsers raise anything, a RecursionError too.
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        message = f"{path} cannot be read ({reason}): export the drawing again, or as PNG"
        outcome = (UnreadableError, f"damaged-{kind.value}", message)
    with answer:
        pickle.dump(outcome, answer, protocol=pickle.HIGHEST_PROTOCOL)


def read_directly(kind: FileKind, path: Path, page: int) -> FileContent:
    """Read a page of a vector file in this process; errors as of the kind's reader."""
    if kind is FileKind.PDF:
        from gaussiancad_core.sheet.files.pdf import read_pdf as read
    elif kind is FileKind.SVG:
        from gaussiancad_core.sheet.files.svg import read_svg as read
    else:
        from gaussiancad_core.sheet.files.dxf import read_dxf as read
    return read(path, page)


def _limit_memory() -> None:
    """Bound the address space, where the system can."""
    try:
        import resource
    except ImportError:
        return
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    limit = MEMORY_LIMIT if most == resource.RLIM_INFINITY else min(MEMORY_LIMIT, most)
    resource.setrlimit(resource.RLIMIT_AS, (limit, most))


if __name__ == "__main__":
    main(FileKind(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))

"""One undo step for everything that a command adds, or nothing at all."""

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD


@contextmanager
def transaction(document: FreeCAD.Document, name: str) -> Iterator[None]:
    """Keep all changes of the block as one undo step; after an error, keep none.

    ``freecadcmd`` records no undo steps unless told to; there it is switched on for the block, so
    that an error leaves the document untouched there too.

    Args:
        document: the document that the block changes.
        name: of the undo step, as the user reads it.
    """
    without_undo = document.UndoMode == 0
    if without_undo:
        document.UndoMode = 1
    try:
        document.openTransaction(name)
        try:
            yield
        except BaseException:
            document.abortTransaction()
            raise
        document.commitTransaction()
    finally:
        if without_undo:
            document.UndoMode = 0

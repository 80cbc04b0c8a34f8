"""The part of a run that still goes on: shown as soon as it is final, completed when the run ends.

All that a run adds is one undo step.  Where the user did something between, this is left alone,
and the rest follows in a step of its own.  A run that is cancelled or fails leaves the part, with a
note: the user may be at work with it, and one *Undo* removes it.  Where the document had a result
of the same drawing, the part is changed in place, and that *Undo* brings the result of before.
"""

from dataclasses import dataclass
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.objects.loading import LoadedPart, LoadedRun, PartSource, read_shape
from freecad.gaussiancad.objects.reconstruction import (
    put_part_of_run,
    put_reconstruction,
    undo_step,
    update_reconstruction,
)


@dataclass(frozen=True)
class EarlyPart:
    """A part in a document whose run goes on.  Names, since either may be gone when it ends.

    Attributes:
        document: internal name of the document.
        group: internal name of the reconstruction in it.
        steps: names of the undo steps when it was added, the last one first.
    """

    document: str
    group: str
    steps: tuple[str, ...]

    def find(self) -> FreeCAD.DocumentObject | None:
        """The reconstruction, or None where the user removed it or closed the document."""
        if self.document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self.document).getObject(self.group)


def show_early(
    document: FreeCAD.Document, job: ReconstructJob, path: Path, status: Status
) -> EarlyPart:
    """Show the part of a run that goes on, in one undo step.

    Args:
        document: has a group of the drawing, or receives one.
        job: what was asked.
        path: of the solid's STEP file.
        status: how far the solid can be trusted.

    Raises:
        WorkbenchError: the file cannot be read.
    """
    part = LoadedPart(read_shape(path), PartSource.SOLID)
    group = put_part_of_run(document, job, part, status)
    return EarlyPart(document.Name, group.Name, tuple(document.UndoNames))


def complete(
    early: EarlyPart | None, document: FreeCAD.Document, run: LoadedRun
) -> FreeCAD.DocumentObject:
    """Add what a finished run left beside its part.

    Args:
        early: the part, if it was shown.
        document: receives all where the part is gone, or was never shown.
        run: what the run left.

    Returns:
        The reconstruction.
    """
    group = early.find() if early is not None else None
    if group is None:
        return put_reconstruction(document, run)
    home = group.Document
    if tuple(home.UndoNames) == early.steps and early.steps[:1] == (undo_step(),):
        # Nothing was done since: the part and the rest become one step.
        home.undo()
        return put_reconstruction(home, run)
    update_reconstruction(group, run)
    return group


def leave(early: EarlyPart | None, note: str) -> bool:
    """Say at the part of a run that did not come to its end why nothing follows.

    Returns:
        Whether the part is there.
    """
    group = early.find() if early is not None else None
    if group is None:
        return False
    group.Reasons = [*group.Reasons, note]
    return True

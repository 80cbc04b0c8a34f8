"""A sheet taken apart: the part's ink, and the annotations."""

from dataclasses import dataclass

from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask, line_mark
from gaussiancad_core.sheet.annotations.erase import Told
from gaussiancad_core.sheet.annotations.inked_shapes import points_along
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.label_evidence import NO_LABELS, SheetLabels


@dataclass(frozen=True, eq=False)
class SeparatedSheet:
    """A sheet without its annotations.

    Attributes:
        part: the sheet with the part's ink alone.
        marks: what was taken off.
        hatched: (h, w) bool, cut material; nothing where there is none.
        askew: (h, w) bool, ink of pictorials and auxiliary views; nothing where none was told.
        strokes_known: the lines and circles, and what each is; None where nobody looked.
        labels: what each line was taken for, and how surely; nothing where no labels told it.
        has_paper: False of a drawing in free space, where what spans the sheet is no frame for it.
    """

    part: CleanSheet
    marks: tuple[Mark, ...]
    hatched: Mask | None = None
    askew: Mask | None = None
    strokes_known: Told | None = None
    labels: SheetLabels = NO_LABELS
    has_paper: bool = True


def line_marks(stated: Told) -> list[Mark]:
    """One mark for each run that is an annotation, between its ends."""
    marks = []
    for shape, annotation_kinds in zip(stated.shapes, stated.kinds, strict=True):
        for run, kind in zip(shape.runs, annotation_kinds, strict=True):
            if kind is not None:
                ends = points_along(shape.geometry, run.run, 1e9) + 0.5
                marks.append(line_mark(kind, tuple(ends[0].tolist()), tuple(ends[-1].tolist())))
    return marks

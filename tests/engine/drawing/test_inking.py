from dataclasses import replace

import numpy as np

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.inking import (
    ink_annotations,
)
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.model.views import Linetype, Segment

STYLE = SheetStyle(width=200, height=100)
LINE = Segment((20.0, 50.3), (180.0, 50.3), Linetype.VISIBLE)
MARK = Annotation(AnnotationKind.CENTRE_LINE, 1, (LINE,), 2.0)


def test_without_grey_edges_everything_is_ink_or_paper() -> None:
    ink = ink_annotations((MARK,), replace(STYLE, antialiasing=False))
    assert set(np.unique(ink)) == {0.0, 1.0}


def test_arrowheads_beyond_the_sheet_are_cut_off() -> None:
    outside = Annotation(
        AnnotationKind.LEADER, 1, arrows=(((-50.0, 0.0), (-40.0, 4.0), (-40.0, -4.0)),)
    )
    assert ink_annotations((outside,), STYLE).sum() == 0.0

"""What is cut is told by its hatching, as far as the edges and centre lines around it."""

import itertools

import numpy as np
import pytest
import shapely

from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen
from gaussiancad_core.structure.cut_faces import cut_faces

Points = list[tuple[float, float]]

PEN = Pen(0.35, None, "")
BAR: Points = [(10, 10), (90, 10), (90, 30), (10, 30), (10, 10)]
LEFT: Points = [(50, 10), (10, 10), (10, 30), (50, 30)]
MIDDLE: Points = [(50, 2), (50, 38)]


def _strokes(chain: Points) -> list[PaperStroke]:
    return [PaperStroke(LineSegment(a, b), PEN) for a, b in itertools.pairwise(chain)]


def _hatching(low: float, high: float) -> list[PaperStroke]:
    """Lines at 45 degrees that fill the bar between two columns."""
    found = []
    for at in np.arange(low - 17.5, high, 5.0):
        start, end = max(at, low), min(at + 20.0, high)
        ends = (start, 30.0 - start + at), (end, 30.0 - end + at)
        found.append(PaperStroke(LineSegment(*ends), PEN))
    return found


def _cut(edges: Points, high: float, middle: Label | None) -> shapely.Geometry:
    groups = [(Label.EDGE, _strokes(edges)), (Label.HATCH, _hatching(10.0, high))]
    groups += [(middle, _strokes(MIDDLE))] if middle is not None else []
    labelled = LabelledStrokes.open([stroke for _, strokes in groups for stroke in strokes])
    first = 0
    for label, strokes in groups:
        labelled = labelled.with_label(range(first, first + len(strokes)), label, "")
        first += len(strokes)
    return shapely.union_all(cut_faces(labelled))


@pytest.mark.parametrize("edges", [BAR, LEFT])
@pytest.mark.parametrize("middle", [Label.CENTRE, Label.EXTENSION])
def test_a_half_is_cut_up_to_its_middle_line(edges: Points, middle: Label) -> None:
    assert _cut(edges, 50.0, middle).equals(shapely.box(10, 10, 50, 30))


def test_all_that_edges_enclose_is_cut_where_all_is_hatched() -> None:
    assert _cut(BAR, 90.0, Label.CENTRE).equals(shapely.box(10, 10, 90, 30))
    assert _cut(BAR, 90.0, None).equals(shapely.box(10, 10, 90, 30))


def test_what_is_open_is_not_cut() -> None:
    assert _cut(LEFT, 50.0, None).is_empty

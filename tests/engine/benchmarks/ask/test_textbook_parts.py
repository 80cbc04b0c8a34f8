"""Parts of textbooks: their families, their drawing, their sheets."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from benchmarks.ask.textbook_parts import _mistaken
from benchmarks.parts.textbook_modelling import Family, Lot, belt, milled_slot
from benchmarks.sheets.textbook_drawing import textbook_lines
from benchmarks.sheets.textbook_dxf import write_dxf
from benchmarks.tasks.textbook_work import FAMILIES, SheetKind, Task, draw, worked
from gaussiancad_core.drawing.drawn_sheet import part_lines
from gaussiancad_core.kernel.brep import bounding_box, faces_of, volume
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.samples.modelling import box, cut, cylinder, fuse
from gaussiancad_core.sheet.image.sheet_files import read_sheet


@pytest.mark.parametrize("odd", [False, True])
@pytest.mark.parametrize("name", FAMILIES)
def test_every_family_makes_one_valid_solid(name: str, odd: bool) -> None:
    part = FAMILIES[name].part(seed=3, odd=odd)
    low, high = bounding_box(part)
    assert low == pytest.approx((0.0, 0.0, 0.0), abs=1e-5)
    assert high.min() > 5.0 and high.max() < 200.0
    assert len(faces_of(part)) >= 7


def test_measures_repeat_and_are_round_or_odd() -> None:
    lots = [Lot("x", 7), Lot("x", 7), Lot("x", 8)]
    round_ones, same, others = ([lot.size(10, 90, 5) for _ in range(9)] for lot in lots)
    assert round_ones == same != others
    assert all(value % 5 == 0 and 10 <= value <= 90 for value in round_ones)
    odd = Lot("x", 7, odd=True)
    values = [odd.size(10, 90, 5) for _ in range(9)]
    assert any(value % 1 for value in values)
    assert all(abs(value / 5 - round(value / 5)) <= 0.3 + 1e-9 for value in values)


def test_parts_that_are_no_solid_are_refused() -> None:
    one, other = box((0, 0, 0), (1, 1, 1)), box((2, 0, 0), (3, 1, 1))
    apart = Family("two", "none", lambda lot: fuse(one, other))
    with pytest.raises(ValueError, match="two 0 is not one valid solid"):
        apart.part(0)


def test_belts_and_slots_have_their_volume() -> None:
    straight = belt(((0, 0), 5), ((20, 0), 5), 0, 2)
    assert volume(straight) == pytest.approx(2 * (25 * np.pi + 200))
    # Tangents of circles that touch inside: the smaller one adds its outer piece only.
    pear = belt(((0, 0), 10), ((0, 30), 5), -1, 1)
    assert np.ptp(bounding_box(pear), axis=0) == pytest.approx((20, 45, 2), abs=1e-6)
    plate = cut(box((0, 0, 0), (40, 20, 4)), milled_slot(Axis.Z, (20, 10), 6, 3))
    assert volume(plate) == pytest.approx(4 * (800 - 9 * np.pi - 72))


@pytest.mark.parametrize("name", ["v-block", "flange", "hinge-leaf", "crank-arm"])
def test_lines_are_those_of_the_engine(name: str) -> None:
    part = FAMILIES[name].part(20)
    theirs, item = textbook_lines(part), part_lines(part, (Role.FRONT, Role.TOP, Role.RIGHT))
    assert theirs.size == pytest.approx(item.size)
    for role, strokes in item.views.items():
        for linetype in Linetype:
            lengths = [
                sum(stroke.length for stroke in drawn if stroke.linetype is linetype)
                for drawn in (theirs.views[role], strokes)
            ]
            assert lengths[0] == pytest.approx(lengths[1], abs=0.3)


def test_a_bore_across_a_cylinder_has_a_smooth_mouth_once() -> None:
    """The algorithm tells it as chords, some of them as hidden beside the visible ones."""
    bar = cylinder(Axis.X, (10, 10), 10, 0, 40)
    lines = textbook_lines(cut(bar, cylinder(Axis.Z, (20, 10), 4, -1, 21)))
    (mouth,) = (stroke for stroke in lines.views[Role.TOP] if isinstance(stroke, Arc))
    assert mouth.radius == pytest.approx(4.0)
    assert mouth.sweep == pytest.approx(2 * np.pi)
    assert mouth.linetype is Linetype.VISIBLE


def test_a_bore_that_the_algorithm_sees_by_turns_is_hidden() -> None:
    lines = textbook_lines(FAMILIES["set-collar"].part(20))
    (bore,) = (stroke for stroke in lines.views[Role.FRONT] if isinstance(stroke, Arc))
    assert bore.linetype is Linetype.HIDDEN
    assert bore.sweep == pytest.approx(2 * np.pi)


@pytest.mark.parametrize("projection", Projection)
def test_dxf_files_are_read(projection: Projection, tmp_path: Path) -> None:
    lines = textbook_lines(FAMILIES["slotted-link"].part(1))
    write_dxf(lines, projection, tmp_path / "sheet.dxf")
    vectors = read_sheet(tmp_path / "sheet.dxf").vectors
    assert vectors is not None
    assert len(vectors.strokes) >= sum(map(len, lines.views.values()))


def test_a_sheet_is_solved_and_measured(tmp_path: Path) -> None:
    task = Task("wedge", 4, False, SheetKind.DXF, stated=True, limit=60.0, kept=tmp_path)
    row: dict[str, Any] = dict(task.known)
    for bit in worked(task):
        row |= bit
    assert row["exact"] and row["status"] == "verified" and not row["mistaken"]
    assert (tmp_path / "dxf" / "wedge-4" / "solid.step").is_file()


@pytest.mark.parametrize("kind", [SheetKind.SCAN, SheetKind.PHOTOCOPY])
def test_sheets_on_paper_are_turned_and_noisy(kind: SheetKind, tmp_path: Path) -> None:
    lines = textbook_lines(FAMILIES["wedge"].part(4))
    task = Task("wedge", 4, False, kind, stated=True, limit=60.0)
    grey = cv2.imread(str(draw(task, lines, tmp_path)), cv2.IMREAD_GRAYSCALE)
    as_plotted = draw(replace(task, kind=SheetKind.PICTURE), lines, tmp_path)
    plain = cv2.imread(str(as_plotted), cv2.IMREAD_GRAYSCALE)
    assert grey.shape == plain.shape
    # Paper is not of one shade, and level lines are level no more; copies have dark borders.
    assert grey[grey > 128].std() > 1.0
    longest = [(sheet[100:-100, 100:-100] < 128).sum(axis=1).max() for sheet in (grey, plain)]
    assert longest[0] < 0.9 * longest[1]


def test_mistaken_projections_are_named() -> None:
    rows = [
        {"input": "dxf", "name": "a", "mistaken": True},
        {"input": "dxf", "name": "b", "mistaken": False},
        {"input": "picture", "name": "c", "failure": "x"},
    ]
    assert list(_mistaken(rows)) == ["dxf, wrong projection: 1 a", "picture, wrong projection: 0"]

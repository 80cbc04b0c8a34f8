"""Thread symbols: where they stand, and where there is no room for one."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.centre_lines import Round
from gaussiancad_core.drawing.drawn_sheet import Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.drawn_threads import has_room
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


def _sheet(part: str) -> tuple[Sheet, list[Annotation]]:
    lines = part_lines(sample(part).build(), ROLES)
    sheet = compose_sheet(lines, Projection.THIRD, parse_style("clean,threads=on"))
    return sheet, [note for note in sheet.annotations if note.kind is AnnotationKind.THREAD]


def test_every_bore_has_a_thin_arc_around_it_and_dashes_beside_it() -> None:
    sheet, threads = _sheet("bored-plate")
    rims = [stroke for stroke in sheet[Role.TOP].strokes if isinstance(stroke, Arc)]
    assert len(threads) == len(rims) == 5
    for note in threads:
        arc, *lines = note.strokes
        assert isinstance(arc, Arc)
        assert arc.sweep == pytest.approx(1.5 * np.pi)
        rim = next(
            this_rim
            for this_rim in rims
            if np.hypot(*np.subtract(this_rim.centre, arc.centre)) < 0.01
        )
        assert rim.radius / arc.radius == pytest.approx(0.83)
        # Dashes of both sides in both other views, none longer than the plate is thick.
        assert all(isinstance(line, Segment) for line in lines)
        low, high = sheet[Role.FRONT].box[1], sheet[Role.FRONT].box[3]
        assert max(line.length for line in lines) < 0.5 * (high - low)
        assert len(lines) >= 8


def test_shafts_have_theirs_inside() -> None:
    sheet, threads = _sheet("stepped-shaft")
    rims = [
        stroke.radius
        for stroke in sheet[Role.RIGHT].strokes
        if isinstance(stroke, Arc) and stroke.linetype is Linetype.VISIBLE
    ]
    for note in threads:
        arc, *lines = note.strokes
        assert min(abs(arc.radius / rim - 0.83) for rim in rims) < 1e-6
        # Both sides in front view and top view, each in one stroke.
        assert len(lines) == 4
        # Nothing concentric lies within the ring.
        assert not [rim for rim in rims if arc.radius < rim < arc.radius / 0.83 - 1e-6]
    assert threads


def test_a_ring_that_holds_another_circle_has_no_room() -> None:
    rim, thin = Round((50.0, 50.0), 30.0, True, True), 30.0 / 0.83
    assert has_room(rim, thin, [rim])
    for radius, room in ((33.0, False), (39.0, False), (41.0, True), (27.0, False), (25.0, True)):
        other = Round((50.0, 50.0), radius, True, True)
        assert has_room(rim, thin, [rim, other]) is room
    # Circles closer to each other than two lines are one line.
    assert not has_room(Round((50.0, 50.0), 15.0, True, True), 15.0 / 0.83, [])

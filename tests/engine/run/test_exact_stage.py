"""The exact solid of a sheet, and what it says about first and third angle."""

import gc
from dataclasses import replace
from types import FunctionType, ModuleType, SimpleNamespace

import numpy as np
import pytest
from engine.run.stroke_sheets import SIZE, chain, reading, rectangle

from gaussiancad_core.evidence.projected_reading import ProjectedReading, drawn_views
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.labelling.part_model import PartModel
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.run import exact_stage
from gaussiancad_core.run.exact_stage import ExactModel, find_exact, find_for_hull
from gaussiancad_core.sheet.registration.axis_residuals import Residual
from gaussiancad_core.sheet.registration.view_registration import AxisExtents
from gaussiancad_core.sheet.sheet_stages import StrokesSource
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status

Strokes = dict[Role, list[Segment]]

_OPPOSITE = {Role.FRONT: Role.FRONT, Role.TOP: Role.BOTTOM, Role.RIGHT: Role.LEFT}


def _both(strokes: Strokes) -> tuple[ProjectedReading, ProjectedReading]:
    """The same sheet in third and in first angle: the views beside the front are the opposite ones.

    The depth axis runs backwards in those, from minus the depth to 0.
    """
    moved: Strokes = {}
    for role, stroke in strokes.items():
        right = -SIZE[1] if role is Role.RIGHT else 0.0
        up = -SIZE[1] if role is Role.TOP else 0.0
        moved[_OPPOSITE[role]] = [
            Segment(
                (s.start[0] + right, s.start[1] + up), (s.end[0] + right, s.end[1] + up), s.linetype
            )
            for s in stroke
        ]
    return reading(strokes, Projection.THIRD), reading(moved, Projection.FIRST)


def _step() -> Strokes:
    """A step that rises to the back: only third angle fits."""
    return {
        Role.FRONT: rectangle(40, 20) + chain((0, 8), (40, 8)),
        Role.TOP: rectangle(40, 30) + chain((0, 12), (40, 12)),
        Role.RIGHT: chain((0, 0), (30, 0), (30, 20), (12, 20), (12, 8), (0, 8), (0, 0)),
    }


def _wedge() -> Strokes:
    """A prism over a triangle: its slope faces the front in third angle, and the back in first."""
    return {
        Role.FRONT: rectangle(40, 20),
        Role.TOP: rectangle(40, 30),
        Role.RIGHT: chain((0, 0), (30, 0), (30, 20), (0, 0)),
    }


def _back_pocket(off: float) -> Strokes:
    """A pocket in the back; two views have its floor at places that are so many mm apart."""

    def dashes(*points: tuple[float, float]) -> list[Segment]:
        return chain(*points, linetype=Linetype.HIDDEN)

    return {
        Role.FRONT: rectangle(40, 20) + dashes((10, 5), (25, 5), (25, 12), (10, 12), (10, 5)),
        Role.TOP: rectangle(40, 30) + dashes((10, 30), (10, 22), (25, 22), (25, 30)),
        Role.RIGHT: rectangle(30, 20) + dashes((30, 5), (22 + off, 5), (22 + off, 12), (30, 12)),
    }


def _block() -> Strokes:
    return {
        Role.FRONT: rectangle(40, 20),
        Role.TOP: rectangle(40, 30),
        Role.RIGHT: rectangle(30, 20),
    }


def _codes(found: ExactModel) -> list[str]:
    return [code for code, _ in found.result.reasons if code != "lines-apart"]


def test_a_told_projection_is_not_doubted() -> None:
    third, _ = _both(_wedge())
    found = find_exact(third, None)
    assert found.reading is third and not found.decided
    assert _codes(found) == ["sketched", "assumed"] and found.result.alternatives == ()
    assert soundness(found.result.shape).faces == 5
    assert soundness(found.result.shape).volume_mm3 == pytest.approx(40 * 30 * 20 / 2)


_STEP_MM3 = 40 * (30 * 8 + 18 * 12)


@pytest.mark.parametrize(
    ("strokes", "is_swapped", "by_symbol", "is_decided", "volume"),
    [
        # The reading that has a solid is right, whichever was assumed or told by a symbol.
        (_step(), False, False, True, _STEP_MM3),
        (_step(), True, False, True, _STEP_MM3),
        (_step(), False, True, True, _STEP_MM3),
        (_step(), True, True, True, _STEP_MM3),
        # A symbol decides where both have one, and nothing where it is the same solid.
        (_wedge(), False, True, True, 40 * 30 * 20 / 2),
        (_block(), False, False, False, 40 * 30 * 20),
    ],
)
def test_of_two_readings_one_is_taken(
    strokes: Strokes, is_swapped: bool, by_symbol: bool, is_decided: bool, volume: float
) -> None:
    third, first = _both(strokes)
    asked = (first, third) if is_swapped else (third, first)
    found = find_exact(*asked, by_symbol=by_symbol)
    assert found.reading is third and found.decided is is_decided and found.result.explains
    if not (is_swapped and by_symbol):
        assert _codes(found) == ["sketched", "assumed"] and found.result.alternatives == ()
    assert soundness(found.result.shape).volume_mm3 == pytest.approx(volume)


@pytest.mark.parametrize("off", [0.0, 0.007])
def test_a_reading_is_right_whose_lines_are_not_quite_on_one_coordinate(off: float) -> None:
    third, first = _both(_back_pocket(off))
    found = find_exact(first, third)
    assert found.reading is third and found.decided
    assert found.result.status is Status.VERIFIED
    assert found.result.measures.uncertainty <= 0.01
    volume = 40 * 30 * 20 - 15 * 7 * 8
    assert soundness(found.result.shape).volume_mm3 == pytest.approx(volume, rel=1e-4)


def test_two_readings_with_different_solids_are_ambiguous() -> None:
    third, first = _both(_wedge())
    found = find_exact(third, first)
    assert found.reading is third and not found.decided
    assert found.result.status is Status.APPROXIMATE
    assert _codes(found) == ["sketched", "assumed", "ambiguous"]
    (other,) = found.result.alternatives
    assert not same_solid(found.result.shape, other)
    assert soundness(other).valid
    assert same_solid(other, find_exact(first, None).result.shape)


def _scribbled() -> ProjectedReading:
    """A block with strokes in its front that bound nothing and that no other view has."""
    strokes = _block()
    for k in range(4):
        strokes[Role.FRONT] += chain((3.0 + 8.0 * k, 2.0), (6.0 + 8.0 * k, 18.0))
    return reading(strokes, Projection.THIRD)


def test_where_no_solid_has_all_lines_the_part_is_sketched() -> None:
    found = find_exact(_scribbled(), None)
    assert found.is_sketched and found.result.status is Status.APPROXIMATE
    assert [code for code, _ in found.result.reasons][:2] == ["sketched", "lines-unexplained"]
    facts = soundness(found.result.shape)
    assert (facts.valid, facts.closed, facts.solids, facts.faces) == (True, True, 1, 6)
    assert facts.volume_mm3 == pytest.approx(40 * 30 * 20)
    agreement = found.result.verification.matched[Role.FRONT].agreement
    assert agreement.visible_precision == pytest.approx(1.0)
    assert agreement.visible_recall < 0.7


def test_where_the_memory_does_not_suffice_the_part_is_sketched(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fails(*_: object) -> None:
        raise MemoryError

    monkeypatch.setattr(exact_stage, "exact_solid_and_model", fails)
    found = find_exact(_both(_back_pocket(0.0))[0], None)
    assert found.is_sketched and found.result.status is Status.APPROXIMATE


def test_a_part_whose_lines_all_agree_needs_no_sketch() -> None:
    assert find_exact(_both(_back_pocket(0.0))[0], None).made_of is None


def test_sheets_of_many_lines_are_not_searched_for_the_hull() -> None:
    assert isinstance(find_for_hull(_scribbled(), None), ExactModel)
    many = _block()
    many[Role.FRONT] += [s for k in range(80) for s in rectangle(1.0 + 0.3 * k, 1.0 + 0.1 * k)]
    assert find_for_hull(reading(many, Projection.THIRD), None) is None


def test_the_noise_of_views_is_that_of_the_axis_on_which_they_differ_most() -> None:
    third, _ = _both(_wedge())
    residuals = {Axis.X: Residual(0.01, 0.18), Axis.Z: Residual(0.03, 0.1)}
    noisy = replace(third.registered, extents=AxisExtents({}, {}, residuals))
    assert drawn_views(noisy).noise == pytest.approx(0.03 * noisy.mm_per_pixel)
    # Nearly all coordinates were rounded alike, but not all.
    alike = AxisExtents({}, {}, {Axis.X: Residual(0.0, 0.24), Axis.Z: Residual(0.0, 0.0)})
    rounded = replace(third.registered, extents=alike)
    assert drawn_views(rounded).noise == pytest.approx(0.036 * noisy.mm_per_pixel)
    assert drawn_views(third.registered).noise == pytest.approx(0.015 * noisy.mm_per_pixel)
    # The depth runs along rows of one view and along columns of another: nothing is rounded here.
    fine = AxisExtents({}, {}, {Axis.Y: Residual(0.001, 0.01, 6), Axis.Z: Residual(0.002, 0.01, 4)})
    agreed = replace(third.registered, extents=fine)
    assert drawn_views(agreed).noise == pytest.approx(0.0075 * noisy.mm_per_pixel)
    few = AxisExtents({}, {}, {Axis.Y: Residual(0.001, 0.01, 3), Axis.Z: Residual(0.002, 0.01, 9)})
    unsure = drawn_views(replace(third.registered, extents=few))
    assert unsure.noise == pytest.approx(0.015 * noisy.mm_per_pixel)
    exact = tuple(
        SimpleNamespace(dash=None, source=StrokesSource.VECTOR, step=0.0) for _ in noisy.drawn
    )
    assert drawn_views(replace(noisy, drawn=exact)).noise == 0.0


@pytest.mark.parametrize(
    ("seen", "rounded", "noise"),
    [(0.002, 0, 0.0075), (0.01, 0, 0.015), (0.002, 4, 0.03), (0.002, 1, 0.12)],
)
def test_what_views_round_alike_is_told_by_their_places(
    seen: float, rounded: int, noise: float
) -> None:
    third, _ = _both(_block())
    lines = []
    for at in np.random.default_rng(4).uniform(40.0, 600.0, 20):
        place = round(rounded * at) / rounded if rounded else at
        lines.append(Segment((place, 40.0), (place, 90.0), Linetype.VISIBLE))
        lines.append(Segment((40.0, place), (90.0, place), Linetype.VISIBLE))
    # All views agree, and even the one that shows the depth along the other side of the sheet.
    agreed = AxisExtents({}, {}, {axis: Residual(seen, seen, 6) for axis in (Axis.X, Axis.Z)})
    if rounded:
        agreed.residuals[Axis.Y] = Residual(seen, seen, 6)
    drawn = tuple(
        SimpleNamespace(dash=None, source=StrokesSource.RASTER, strokes=lines, step=0.0)
        for _ in third.registered.drawn
    )
    views = drawn_views(replace(third.registered, extents=agreed, drawn=drawn))
    assert views.noise == pytest.approx(noise * third.registered.mm_per_pixel)


@pytest.mark.parametrize(
    ("step", "tolerance"), [(0.0, 0.05), (0.03, 0.05), (1 / 6, 1.1 / 6), (0.28, 0.308), (0.5, 1.0)]
)
def test_a_file_is_known_as_well_as_the_grid_to_which_it_was_rounded(
    step: float, tolerance: float
) -> None:
    """However well its views agree: it rounds all of them alike."""
    third, _ = _both(_block())
    pixel = third.registered.mm_per_pixel
    source = StrokesSource.VECTOR
    drawn = tuple(
        SimpleNamespace(dash=None, source=source, strokes=(), step=item)
        for item in (0.0, step, 0.0)[: len(third.registered.drawn)]
    )
    agreed = AxisExtents({}, {}, {axis: Residual(0.0, 0.0, 9) for axis in Axis})
    views = drawn_views(replace(third.registered, extents=agreed, drawn=drawn))
    assert views.tolerance == pytest.approx(tolerance * pixel)
    assert views.bound == pytest.approx(0.78 * step * pixel)
    # As coarse as this it is no better than a picture: numbers on the sheet tell more.
    assert (views.noise > 0.0) == (step >= 0.4)
    apart = AxisExtents({}, {}, {axis: Residual(0.2, 0.4, 9) for axis in Axis})
    unlike = drawn_views(replace(third.registered, extents=apart, drawn=drawn))
    assert unlike.bound == pytest.approx(4.1 * 0.2 * pixel)


def test_of_two_readings_without_a_solid_the_one_that_explains_more_is_taken() -> None:
    # A stroke across the front view that no other view has.
    odd = _step()
    odd[Role.FRONT] += chain((5, 3), (33, 11))
    third, first = _both(odd)
    for item, other in ((third, first), (first, third)):
        found = find_exact(item, other)
        assert found.reading is third and found.decided and found.is_sketched


def test_where_sketches_explain_as_much_the_reading_as_named_stays_and_nothing_is_told() -> None:
    odd = _block()
    odd[Role.FRONT] += chain((5, 3), (33, 11))
    for item, other in (_both(odd), _both(odd)[::-1]):
        found = find_exact(item, other)
        assert found.reading is item
        assert not found.decided


@pytest.mark.parametrize("plain", [False, True])
def test_a_symbol_stays_unless_the_other_reading_plainly_explains_more(plain: bool) -> None:
    odd = _step()
    strokes = 1 if plain else 12
    for k in range(strokes):
        odd[Role.FRONT] += chain((2 + 3 * k, 9), (3 + 3 * k, 19))
    third, first = _both(odd)
    found = find_exact(first, third, by_symbol=True)
    assert found.contradicted and found.decided is plain
    assert found.reading is (third if plain else first)
    found = find_exact(third, first, by_symbol=True)
    assert found.reading is third and not found.contradicted


def _holds(root: object, kind: type) -> bool:
    """Whether anything of a kind hangs on an object."""
    seen, waiting = set(), [root]
    while waiting:
        item = waiting.pop()
        if isinstance(item, kind):
            return True
        if id(item) not in seen and not isinstance(item, (type, ModuleType, FunctionType)):
            seen.add(id(item))
            waiting += gc.get_referents(item)
    return False


def test_the_models_of_the_search_are_not_kept_with_what_it_found() -> None:
    found = find_exact(reading(_back_pocket(0.0), Projection.THIRD), None)
    assert _holds(found, ExactResult)
    assert not _holds(found, PartModel)

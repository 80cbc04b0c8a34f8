"""Single changes of a model, and which of them explain its sheet better.

A hole is filled, drilled where one is drawn, or moved there; a flat face is moved to a place that
the sheet shows; the whole is mirrored.  Each is tried on the lines of sight alone.  What of the
model lies on ink is not undone: there the reading lost a line.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.judging.drawn_bores import drawn_bores
from gaussiancad_core.judging.edited_sights import Change, changed, cylinder, extruded
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats
from gaussiancad_core.judging.laying import Laid
from gaussiancad_core.judging.lines_of_sight import Met, crossings
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.judging.model_features import Bore, FlatFace, bores_of, flat_faces
from gaussiancad_core.judging.sheet_ink import SheetInk
from gaussiancad_core.judging.sight_pairs import levels_along
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted

_WORTH = 0.002
"""Share of the lines by which a change has to explain a sheet better to be told."""

_NOTHING = 1e-9
"""Share of the lines within which a change makes no difference."""

_BORES, _FACES, _DRILLS = 40, 40, 40
"""Features of a model, and holes of a sheet, that changes are made of, the largest first."""

_SMALLEST_FACE = 4e-4
"""Square of a share of the longest extent: smaller flat faces are not moved."""

_PLACES = 2
"""Places on either side of a face that it is moved to."""

_NEAR = 0.15
"""Share of the longest extent that a hole is moved at most."""

_LIKE = 0.05
"""Share of a radius by which a hole that is moved may be another one."""

_SAME = 5e-4
"""Share of the longest extent within which two crossings are one."""

_ON_INK = 0.7
"""Share of a feature's outline on ink from which the sheet draws it."""

_AROUND = 48


@dataclass(frozen=True, eq=False)
class Edit:
    """A single change of a model.

    Attributes:
        what: ``fill``, ``drill``, ``move``, ``shift`` or ``mirror``.
        feature: what is changed, in words.
        start, end: (3,) mm on the sheet's axes: where it is and where it goes; None where it has
            no place.
        mm: of line that the sheet explains better with it.
        diameter: mm, of a hole; None of all else.
    """

    what: str
    feature: str
    start: tuple[float, float, float] | None
    end: tuple[float, float, float] | None
    mm: float
    diameter: float | None = None


@dataclass(frozen=True, eq=False)
class _Trial:
    """A change to be tried: tools and what is done with each, in order."""

    what: str
    feature: str
    start: tuple[float, float, float] | None
    end: tuple[float, float, float] | None
    tools: tuple[tuple[FacetedSolid, Change], ...]
    diameter: float | None = None


@dataclass(frozen=True, eq=False)
class TriedEdits:
    """What single changes of a model told.

    Attributes:
        better: those that explain the sheet better, the best first.
        silent: features that may be left out, or moved, without a line that tells.
    """

    better: tuple[Edit, ...]
    silent: tuple[Edit, ...]


def tried_edits(laid: Laid, judge: Judge, ink: SheetInk, mirrored: float) -> TriedEdits:
    """The single changes of a model, as far as they tell something.

    Args:
        laid: the model on the sheet.
        judge: of the sheet.
        ink: of it.
        mirrored: mm of line that the mirror image of the model leaves unexplained, without its
            own edges; infinite where it fits in no pose.
    """
    solid = laid.solid
    base = judge.sighted(solid)
    # Surfaces of tools are numbered on from the solid's: none of them passes into another.
    smooth = np.append(solid.smooth, len(solid.smooth) + np.arange(_NEW))
    before = judge.cost_of(base, smooth)
    least = _WORTH * laid.misfit.drawn
    found, silent = [], []
    for trial in _trials(laid, judge, ink):
        mm = before - judge.cost_of(_tried(trial, base, judge, solid), smooth)
        edit = Edit(trial.what, trial.feature, trial.start, trial.end, mm, trial.diameter)
        if mm > least:
            found.append(edit)
        elif abs(mm) <= _NOTHING * laid.misfit.drawn and trial.start is not None:
            silent.append(edit)
    if before - mirrored > least:
        found.append(Edit("mirror", "the whole part", None, None, before - mirrored))
    return TriedEdits(tuple(sorted(found, key=lambda edit: -edit.mm)), tuple(_once(silent)))


def _once(edits: Sequence[Edit]) -> Iterator[Edit]:
    """The first change of each feature."""
    known: set[tuple[str, tuple[float, float, float] | None]] = set()
    for edit in edits:
        if (edit.feature, edit.start) not in known:
            known.add((edit.feature, edit.start))
            yield edit


_NEW = 6
"""Surfaces that the tools of a change have at most."""


def _tried(
    trial: _Trial, base: Sequence[Met], judge: Judge, solid: FacetedSolid
) -> tuple[Met, ...]:
    met = list(base)
    same = _SAME * judge.sheet.longest
    for tool, change in trial.tools:
        for number, (view, pairs) in enumerate(zip(judge.sheet.views, judge.pairs, strict=True)):
            of_tool = crossings(tool, view.role.frame, pairs.places)
            met[number] = changed(met[number], of_tool, change, same)
    return tuple(met)


def _trials(laid: Laid, judge: Judge, ink: SheetInk) -> Iterator[_Trial]:
    solid, sheet = laid.solid, judge.sheet
    bores, faces = bores_of(solid)[:_BORES], flat_faces(solid)
    known = [bore for bore in bores if _rim_on_ink(bore, judge, ink) < _ON_INK]
    drawn = [
        bore
        for bore in drawn_bores(sheet)
        if not any(_is_there(bore, other, sheet.longest) for other in bores)
    ][:_DRILLS]
    planes = _Planes(solid, faces, 2.0 * _SAME * sheet.longest)
    for bore in known:
        plug = _cylinder(bore, bore.centre, bore.widest + planes.slack, planes, 0)
        name = f"hole of {2.0 * bore.radius:.4g} mm"
        place = _middle(bore)
        wide = 2.0 * bore.radius
        yield _Trial("fill", name, place, None, ((plug, Change.ADD),), wide)
        yield from _shortened(bore, judge, planes)
        for other in drawn:
            if _may_move(bore, other, sheet.longest):
                moved = _cylinder(bore, other.centre, bore.radius, planes, 3)
                tools = (plug, Change.ADD), (moved, Change.CUT)
                yield _Trial("move", name, place, _middle(other), tools, wide)
    for bore in drawn:
        tool = _cylinder(bore, bore.centre, bore.radius, planes, 0)
        name = f"hole of {2.0 * bore.radius:.4g} mm"
        cut = (tool, Change.CUT)
        yield _Trial("drill", name, None, _middle(bore), (cut,), 2.0 * bore.radius)
    for face in faces[:_FACES]:
        if face.area >= _SMALLEST_FACE * sheet.longest**2:
            yield from _shifts(face, laid, judge, ink, planes)


def _shortened(bore: Bore, judge: Judge, planes: "_Planes") -> Iterator[_Trial]:
    """A hole that ends at one of the nearest places within it that the sheet shows."""
    levels = levels_along(judge.sheet, bore.axis.value)
    inner = levels[(levels > bore.low + planes.slack) & (levels < bore.high - planes.slack)]
    radius = bore.widest + planes.slack
    for at in (*inner[:_PLACES], *inner[_PLACES:][-_PLACES:]):
        for part in (replace(bore, high=float(at)), replace(bore, low=float(at))):
            plug = _cylinder(part, bore.centre, radius, planes, 0)
            name = f"hole of {2.0 * bore.radius:.4g} mm from {part.low:.4g} to {part.high:.4g} mm"
            filled = (plug, Change.ADD)
            yield _Trial("fill", name, _middle(part), None, (filled,), 2.0 * bore.radius)


@dataclass(frozen=True, eq=False)
class _Planes:
    """The flat faces of a solid, for tools that end on one.

    Attributes:
        solid: mm.
        faces: its flat faces across the axes.
        slack: mm within which a tool ends on a face.
    """

    solid: FacetedSolid
    faces: Sequence[FlatFace]
    slack: float

    def surface(self, axis: Axis, at: float, number: int) -> int:
        """The number of the surface at a place along an axis; of none of the solid's, a new one."""
        for face in self.faces:
            if face.axis is axis and abs(face.at - at) <= self.slack:
                return int(self.solid.surfaces[face.triangles[0]])
        return len(self.solid.smooth) + number


def _cylinder(
    bore: Bore, centre: tuple[float, float], radius: float, planes: _Planes, first: int
) -> FacetedSolid:
    """A cylinder as long as a hole, whose surfaces are the solid's where it ends on them."""
    surfaces = (
        len(planes.solid.smooth) + first,
        planes.surface(bore.axis, bore.low, first + 1),
        planes.surface(bore.axis, bore.high, first + 2),
    )
    return cylinder(bore.axis, centre, radius, (bore.low, bore.high), surfaces)


def _shifts(
    face: FlatFace, laid: Laid, judge: Judge, ink: SheetInk, planes: _Planes
) -> Iterator[_Trial]:
    """A face moved to the nearest places on either side that the sheet shows."""
    sheet, solid = judge.sheet, laid.solid
    axis = face.axis.value
    low, high = solid.box[:, axis]
    slack = planes.slack
    if min(abs(face.at - low), abs(face.at - high)) <= slack or _is_inked(face, laid, judge, ink):
        return
    levels = levels_along(sheet, axis)
    below, above = levels[levels < face.at - slack], levels[levels > face.at + slack]
    middle = solid.vertices[solid.triangles[face.triangles]].reshape(-1, 3).mean(axis=0)
    for to in (*below[-_PLACES:], *above[:_PLACES]):
        if not low + slack < to < high - slack:
            continue
        surfaces = planes.surface(face.axis, float(to), 0), len(solid.smooth) + 1
        tool = extruded(solid, face.triangles, face.axis, float(to), surfaces)
        change = Change.ADD if (to - face.at) * face.side > 0.0 else Change.CUT
        end = middle.copy()
        end[axis] = to
        yield _Trial("shift", "flat face", _point(middle), _point(end), ((tool, change),))


def _is_inked(face: FlatFace, laid: Laid, judge: Judge, ink: SheetInk) -> bool:
    """Whether a view from beside has ink all along a face where no line was read."""
    corners = laid.solid.vertices[laid.solid.triangles[face.triangles]].reshape(-1, 3)
    low, high = corners.min(axis=0), corners.max(axis=0)
    for view in judge.sheet.views:
        frame = view.role.frame
        if frame.look_axis[0] is face.axis or view.role not in ink.placements:
            continue
        ends = np.array([low, high]) @ np.array([frame.right, frame.up], dtype=np.float64).T
        share = (np.arange(_AROUND) + 0.5)[:, None] / _AROUND
        places = ends[0] + share * (ends[1] - ends[0])
        if ink.covers(view.role, places).mean() >= _ON_INK:
            return True
    return False


def _rim_on_ink(bore: Bore, judge: Judge, ink: SheetInk) -> float:
    """Share of a hole's circle that lies on ink, in the view along it that has the most."""
    angles = 2.0 * np.pi * np.arange(_AROUND) / _AROUND
    rings = [
        np.array(bore.centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        for radius in {bore.radius, bore.widest}
    ]
    shares = [0.0]
    for view in judge.sheet.views:
        if view.role.frame.look_axis[0] is bore.axis and view.role in ink.placements:
            for ring in rings:
                shares.append(float(ink.covers(view.role, _seen(view.role, bore, ring)).mean()))
    return max(shares)


def _seen(role: Role, bore: Bore, ring: Floats) -> Floats:
    """Places in the plane across a hole as a view along it shows them."""
    points = np.zeros((len(ring), 3))
    points[:, list(IN_PLANE[bore.axis])] = ring
    frame = role.frame
    return points @ np.array([frame.right, frame.up], dtype=np.float64).T


def _is_there(bore: Bore, other: Bore, longest: float) -> bool:
    """Whether a model has a hole that a sheet draws."""
    same = 4.0 * _SAME * longest
    return bore.axis is other.axis and bool(
        np.hypot(*np.subtract(bore.centre, other.centre)) <= same
    )


def _may_move(bore: Bore, other: Bore, longest: float) -> bool:
    return (
        bore.axis is other.axis
        and abs(bore.radius - other.radius) <= _LIKE * bore.radius
        and bool(np.hypot(*np.subtract(bore.centre, other.centre)) <= _NEAR * longest)
    )


def _middle(bore: Bore) -> tuple[float, float, float]:
    return lifted(bore.axis, *bore.centre, (bore.low + bore.high) / 2.0)


def _point(values: Floats) -> tuple[float, float, float]:
    return float(values[0]), float(values[1]), float(values[2])


def as_message(edit: Edit) -> Message:
    """A sentence that says what to change."""
    words = {
        "fill": "without the {feature} at {start} mm the model explains the sheet better",
        "drill": "with a {feature} at {end} mm the model explains the sheet better",
        "move": "with the {feature} at {start} mm moved to {end} mm the model explains the sheet "
        "better",
        "shift": "with the {feature} at {start} mm moved to {end} mm the model explains the sheet "
        "better",
        "mirror": "the mirror image of the model explains the sheet better",
    }
    return Message(
        words[edit.what],
        case=edit.what,
        feature=edit.feature,
        start=_place(edit.start),
        end=_place(edit.end),
    )


def _place(place: tuple[float, float, float] | None) -> str:
    return "" if place is None else "({:.4g}, {:.4g}, {:.4g})".format(*place)

"""Bores as holes that a workbench drills: their sketches' planes, depths, counterbores and
countersinks; and the bodies that they take away."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import astuple, dataclass, replace

import numpy as np
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.feature_model import Holes, Sink
from gaussiancad_core.features.frames import frame_across
from gaussiancad_core.features.round_holes import Bore, Section
from gaussiancad_core.kernel.booleans import fused

_DIGITS = 4
"""Decimal places of units and degrees within which holes are alike."""

_POINT = 1e-4
"""Units, radius of a cone's tip."""


@dataclass(frozen=True)
class _Drill:
    """What one tool leaves, as far as it does not depend on the place across the axis."""

    start: float
    diameter: float
    depth: float | None
    tip: float
    sink: Sink | None


def holes_of(bores: Iterable[Bore]) -> tuple[Holes, ...]:
    """Holes of bores; like ones that enter the same plane are one feature."""
    alike: dict[tuple[object, ...], Holes] = {}
    for bore in (mouth for whole in bores for mouth in _mouths(whole)):
        frame = frame_across(tuple(bore.direction.tolist()))
        is_downward = bool(bore.direction @ np.array(frame.normal) < 0.0)
        x, y, _ = frame.project(bore.point[None])[0].tolist()
        for drill in _drills(bore):
            height = -drill.start if is_downward else drill.start
            key = frame, round(height, _DIGITS), is_downward, *_rounded(drill)
            known = alike.get(key)
            if known is not None:
                alike[key] = replace(known, centres=(*known.centres, (x, y)))
                continue
            shape = drill.diameter, drill.depth, drill.tip, drill.sink
            alike[key] = Holes(frame, height, ((x, y),), is_downward, *shape)
    return tuple(alike.values())


def body_of_holes(holes: Holes, reach: float) -> TopoDS_Shape:
    """What holes take away.

    Args:
        holes: like ones.
        reach: that a hole through the part is long.

    Raises:
        RuntimeError: the kernel fails.
    """
    way = -1.0 if holes.is_downward else 1.0
    direction = gp_Dir(*(way * part for part in holes.frame.normal))
    found: list[TopoDS_Shape] = []
    for centre in holes.centres:
        start = holes.frame.lift(np.array([centre]), holes.height)[0]

        def at(depth: float, start: np.ndarray = start) -> gp_Ax2:
            place = start + way * depth * np.array(holes.frame.normal)
            return gp_Ax2(gp_Pnt(*place.tolist()), direction)

        found += _pieces(holes, at, reach)
    return fused(found)


def _pieces(holes: Holes, at: Callable[[float], gp_Ax2], reach: float) -> Iterator[TopoDS_Shape]:
    radius = holes.diameter / 2.0
    depth = reach if holes.depth is None else holes.depth
    yield BRepPrimAPI_MakeCylinder(at(0.0), radius, depth).Shape()
    if holes.depth is not None and holes.tip > 0.0:
        length = radius / np.tan(np.radians(holes.tip) / 2.0)
        yield BRepPrimAPI_MakeCone(at(depth), radius, 0.0, float(length)).Shape()
    if holes.sink is None:
        return
    wide = holes.sink.diameter / 2.0
    if holes.sink.angle > 0.0:
        length = (wide - radius) / np.tan(np.radians(holes.sink.angle) / 2.0)
        yield BRepPrimAPI_MakeCone(at(0.0), wide, radius, float(length)).Shape()
    else:
        yield BRepPrimAPI_MakeCylinder(at(0.0), wide, holes.sink.depth).Shape()


def _rounded(drill: _Drill) -> tuple[float | None, ...]:
    sink = () if drill.sink is None else astuple(drill.sink)
    values = drill.diameter, drill.depth, drill.tip, *sink
    return tuple(None if value is None else round(value, _DIGITS) for value in values)


def _mouths(bore: Bore) -> Iterator[Bore]:
    """A bore from each end from which it narrows: as a whole, and from its far end only what is
    wider there."""
    sections = bore.sections
    radii = [min(section.at_low, section.at_high) for section in sections]
    cylinders = [k for k, section in enumerate(sections) if section.is_cylinder]
    if not cylinders:
        return
    narrow = min(cylinders, key=lambda k: radii[k])
    if bore.is_blind:
        yield bore
        return
    yield replace(bore, sections=sections[: narrow + 1])
    if sections[narrow + 1 :]:
        far = tuple(section.reversed() for section in reversed(sections[narrow:]))
        yield replace(bore, direction=-bore.direction, sections=far)


def _drills(bore: Bore) -> Iterator[_Drill]:
    """The tools that leave a bore from its mouth, the one that goes deepest first."""
    sections, tip = list(bore.sections), 0.0
    if bore.is_blind and not sections[-1].is_cylinder and sections[-1].at_high < _POINT:
        tip = sections.pop().angle
    if not sections or not sections[-1].is_cylinder:
        return
    core, mouth = sections[-1], sections[0].low
    before, sink = _sink(sections[:-1], mouth, core)
    depth = None if bore.is_through else core.high - mouth
    yield _Drill(mouth, 2.0 * core.at_low, depth, tip, sink)
    # Flat-ended drills leave the other steps.
    for section in before:
        if section.is_cylinder:
            yield _Drill(mouth, 2.0 * section.at_low, section.high - mouth, 0.0, None)


def _sink(
    sections: Sequence[Section], mouth: float, core: Section
) -> tuple[list[Section], Sink | None]:
    """What is left of the sections before the narrowest one without the sink, and the sink."""
    if len(sections) != 1:
        return list(sections), None
    section = sections[0]
    if section.is_cylinder:
        return [], Sink(2.0 * section.at_low, section.high - mouth, 0.0)
    if abs(section.at_high - core.at_low) > _POINT:
        return [section], None
    return [], Sink(2.0 * section.at_low, 0.0, section.angle)

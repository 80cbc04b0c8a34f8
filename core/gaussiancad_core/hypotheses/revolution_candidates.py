"""Which bodies of revolution the views speak of.

The axis is the centre of a circle in one view.  A cone shows the same slanted line, a sphere or
torus the same arc, beside that axis in both other views.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import pi

from gaussiancad_core.cells.sectors import Sector, sector_of
from gaussiancad_core.cells.surfaces_of_revolution import (
    ArcProfile,
    LineProfile,
    Profile,
    SurfaceOfRevolution,
)
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import APART, COMPUTED, SAME_PLACE
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.hypotheses.profile_ends import ProfileEnds, with_continuations
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_MOST = 24
"""Bodies that are looked at: each one divides cells."""

_WHOLE = 1.2 * pi
"""Angle of a circle that is drawn at least if the body turns all around."""


_Round = tuple[Circle, Carrier]
"""A circle, and the carrier whose curve it is."""


def find_bodies(carriers: PartCarriers, lone: bool = False) -> tuple[SurfaceOfRevolution, ...]:
    """Bodies whose profile is seen beside an axis in every view that shows the axis lengthwise.

    Args:
        carriers: of all views.
        lone: whether bodies count as well whose profile one of these views shows, if its ends have
            the radii of drawn circles: in the other view something may be cut away there, as the
            outline of a groove by a bore, or the profile lies in front of no edge.
    """
    near = max(SAME_PLACE, 1.5 * carriers.tolerance)
    found: list[SurfaceOfRevolution] = []
    faint: list[SurfaceOfRevolution] = []
    for axis, plane in carriers.planes.items():
        sides = [other for normal, other in carriers.planes.items() if normal is not axis]
        if not sides:
            continue
        for centre in _centres(plane, near):
            concentric = _concentric(plane, centre, near)
            drawn = ([*_profiles(side, axis, centre, near)] for side in sides)
            # What was read exactly is not moved.
            exact = 1.5 * carriers.tolerance
            rounds = [carrier for _, carrier in concentric]
            ends = ProfileEnds.of(carriers.values[axis], rounds, exact)
            by_side = [
                _merged((ends.met_by(profile) for profile in items), near) for items in drawn
            ]
            shown = list(_shown_by_all(by_side, near))
            # Lines at equal distances from two axes belong to one of them.
            whole = [p for p in shown if _meets_circle(p, concentric, near)]
            _add(found, (axis, centre), with_continuations(whole, shown, near), plane, near)
            if lone:
                single = [
                    p for items in by_side for p in items if _is_anchored(p, concentric, near)
                ]
                _add(faint, (axis, centre), single, plane, near)
    found.sort(key=_height)
    faint = [body for body in faint if not any(_repeats(body, other, near) for other in found)]
    return tuple([*found, *sorted(faint, key=_height)][:_MOST])


def _height(body: SurfaceOfRevolution) -> float:
    return body.profile.low - body.profile.high


def _add(
    found: list[SurfaceOfRevolution],
    about: tuple[Axis, tuple[float, float]],
    profiles: list[Profile],
    plane: PlaneCarriers,
    near: float,
) -> None:
    """The bodies of profiles about one axis that are not among those found."""
    for profile in profiles:
        for sector in _sectors(plane, about[1], profile, near):
            body = SurfaceOfRevolution(*about, profile, sector)
            if not any(_repeats(body, other, near) for other in found):
                found.append(body)


def _shown_by_all(by_side: list[list[Profile]], near: float) -> Iterator[Profile]:
    """Profiles of the first view that the others show as well."""
    for profile in by_side[0]:
        matches = [_matching(profile, other, near) for other in by_side[1:]]
        shown = [match for match in matches if match is not None]
        if len(shown) == len(matches):
            yield _joined([profile, *shown])


def _is_anchored(profile: Profile, concentric: list[_Round], near: float) -> bool:
    """Whether circles are drawn where a profile ends: at both ends of a line, at one of an arc.

    A fillet passes without an edge into the flat face that it ends at.
    """
    ends = _ends_at_circles(profile, concentric, near)
    return any(ends) if isinstance(profile, ArcProfile) else all(ends)


def _meets_circle(profile: Profile, concentric: list[_Round], near: float) -> bool:
    """Whether a circle is drawn where a profile ends, or where it is widest."""
    if any(_ends_at_circles(profile, concentric, near)):
        return True
    if not isinstance(profile, ArcProfile) or not profile.low < profile.z < profile.high:
        return False
    widest = profile.radius(profile.z)
    return any(abs(widest - circle.radius) <= near for circle, _ in concentric)


def _ends_at_circles(profile: Profile, concentric: list[_Round], near: float) -> list[bool]:
    """Of both ends of a profile whether a circle is drawn there."""
    return [
        any(abs(profile.radius(z) - circle.radius) <= near for circle, _ in concentric)
        for z in (profile.low, profile.high)
    ]


def _centres(plane: PlaneCarriers, near: float) -> list[tuple[float, float]]:
    centres: list[tuple[float, float]] = []
    for carrier in plane.carriers:
        if isinstance(carrier.curve, Circle):
            a, b = carrier.curve.centre
            if not any(abs(a - x) <= near and abs(b - y) <= near for x, y in centres):
                centres.append((a, b))
    return centres


def _concentric(plane: PlaneCarriers, centre: tuple[float, float], near: float) -> list[_Round]:
    return [
        (carrier.curve, carrier)
        for carrier in plane.carriers
        if isinstance(carrier.curve, Circle)
        and abs(carrier.curve.centre[0] - centre[0]) <= near
        and abs(carrier.curve.centre[1] - centre[1]) <= near
    ]


def _sectors(
    plane: PlaneCarriers, centre: tuple[float, float], profile: Profile, near: float
) -> list[Sector | None]:
    """Through which angles a profile turns: a whole turn, or those of the arcs at its ends.

    A bore in a rounded corner says nothing of the corner's rim.
    """
    concentric = _concentric(plane, centre, near)
    ends = (profile.radius(profile.low), profile.radius(profile.high))
    rims = [pair for pair in concentric if min(abs(pair[0].radius - end) for end in ends) <= near]
    if any(sum(high - low for low, high in s.drawn()) > _WHOLE for _, s in rims or concentric):
        return [None]
    found: list[Sector | None] = []
    for circle, carrier in rims:
        arcs = carrier.drawn()
        if len(arcs) > 1 and arcs[0][0] < COMPUTED and arcs[-1][1] > FULL_TURN - COMPUTED:
            arcs = [*arcs[1:-1], (arcs[-1][0], FULL_TURN + arcs[0][1])]
        found += [sector_of(circle, arc, plane.carriers, near) for arc in arcs]
    return [None] if None in found else found


def _profiles(
    side: PlaneCarriers, axis: Axis, centre: tuple[float, float], near: float
) -> Iterator[Profile]:
    """What the drawn lines and arcs of a view are as profiles about an axis in its plane."""
    axes = IN_PLANE[side.normal]
    along = axes.index(axis.value)
    other = axes[1 - along]
    middle = centre[IN_PLANE[axis].index(other)]
    for carrier in side.carriers:
        if carrier.curve.axis is not None:
            continue
        for low, high in carrier.drawn():
            if isinstance(carrier.curve, Circle):
                yield from _arcs(carrier.curve, (low, high), (along, middle), near)
            else:
                yield from _line(carrier, (low, high), (along, middle), near)


def _line(
    carrier: Carrier,
    stretch: tuple[float, float],
    frame: tuple[int, float],
    near: float,
) -> Iterator[LineProfile]:
    along, middle = frame
    ends = sorted(
        (point[along], point[1 - along] - middle)
        for point in (carrier.curve.at(at) for at in stretch)
    )
    (low, at_low), (high, at_high) = ends
    if at_low * at_high < 0.0 and min(abs(at_low), abs(at_high)) > near:
        return
    profile = LineProfile(low, high, abs(at_low), abs(at_high))
    if high - low > APART and abs(profile.at_high - profile.at_low) > APART:
        yield profile


def _arcs(
    circle: Circle,
    stretch: tuple[float, float],
    frame: tuple[int, float],
    near: float,
) -> Iterator[ArcProfile]:
    """Parts of an arc between its farthest points along the axis, as profiles."""
    along, middle = frame
    off = circle.centre[1 - along] - middle
    sphere = abs(off) <= near
    # Angles at which the arc runs straight away from the axis or back, where profiles end.
    turns = [k * pi for k in range(3)] if along == 0 else [pi / 2 + k * pi for k in range(2)]
    cuts = [stretch[0], *(t for t in turns if stretch[0] < t < stretch[1]), stretch[1]]
    for low, high in pairwise(cuts):
        half = circle.at((low + high) / 2.0)[1 - along] - circle.centre[1 - along]
        heights = [circle.at(at)[along] for at in (low, high)]
        inner = not sphere and half * off < 0.0
        profile = ArcProfile(
            min(heights),
            max(heights),
            circle.centre[along],
            0.0 if sphere else abs(off),
            circle.radius,
            -1 if inner else 1,
        )
        if profile.high - profile.low > APART and _least_radius(profile) > -near:
            yield profile


def _least_radius(profile: ArcProfile) -> float:
    """Of an arc between the farthest points along the axis: one that curves towards the axis may
    cross it between its ends."""
    ends = min(profile.radius(profile.low), profile.radius(profile.high))
    curves_in = profile.side < 0 and profile.low < profile.z < profile.high
    return min(ends, profile.radius(profile.z)) if curves_in else ends


def _same_carrier(one: Profile, other: Profile, near: float) -> bool:
    """Whether two profiles lie on one line or circle."""
    if isinstance(one, LineProfile) and isinstance(other, LineProfile):
        return all(abs(_beyond(one, z) - other.radius(z)) <= near for z in (other.low, other.high))
    if isinstance(one, ArcProfile) and isinstance(other, ArcProfile):
        return one.side == other.side and all(
            abs(a - b) <= near
            for a, b in (
                (one.z, other.z),
                (one.r, other.r),
                (one.radius_of_arc, other.radius_of_arc),
            )
        )
    return False


def _beyond(line: LineProfile, z: float) -> float:
    slope = (line.at_high - line.at_low) / (line.high - line.low)
    return line.at_low + slope * (z - line.low)


def _merged(profiles: Iterator[Profile], near: float) -> list[Profile]:
    """Profiles on one carrier that touch or overlap, as one."""
    merged: list[Profile] = []
    for profile in sorted(profiles, key=lambda p: (p.low, p.high)):
        for place, other in enumerate(merged):
            if profile.low <= other.high + near and _same_carrier(other, profile, near):
                merged[place] = _joined([other, profile])
                break
        else:
            merged.append(profile)
    return merged


def _matching(profile: Profile, others: list[Profile], near: float) -> Profile | None:
    """The other view's profile on the same carrier that shares some height."""
    for other in others:
        overlap = min(profile.high, other.high) - max(profile.low, other.low)
        if overlap > -near and _same_carrier(profile, other, near):
            return other
    return None


def _joined(profiles: list[Profile]) -> Profile:
    """The first profile's line or circle over all heights."""
    leader = max(profiles, key=lambda p: p.high - p.low)
    low = min(p.low for p in profiles)
    high = max(p.high for p in profiles)
    if isinstance(leader, ArcProfile):
        return replace(leader, low=low, high=high)
    at_low, at_high = _beyond(leader, low), _beyond(leader, high)
    return LineProfile(low, high, max(at_low, 0.0), max(at_high, 0.0))


def _repeats(one: SurfaceOfRevolution, other: SurfaceOfRevolution, near: float) -> bool:
    return (
        one.axis is other.axis
        and one.sector == other.sector
        and all(abs(a - b) <= near for a, b in zip(one.centre, other.centre, strict=True))
        and min(one.profile.high, other.profile.high) - max(one.profile.low, other.profile.low)
        > -near
        and _same_carrier(one.profile, other.profile, near)
    )

"""Changes of features that a part has: one is left out, or an end of it lies elsewhere.

An early edit is often half right: the right area between the wrong places, or a large cut that
later ones took the place of.  No further edit mends that; the feature has to change.
"""

from collections.abc import Callable, Iterator

from gaussiancad_core.proposing.equal_loops import pattern_between, places_of_all
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.loop_places import places_of, prism
from gaussiancad_core.proposing.part_features import Feature, Pattern, Prism
from gaussiancad_core.proposing.planned_part import PlannedPart

Price = Callable[[Feature], float]

_FEWER = 0.5
"""Share of the least gain of an edit that a part with a feature less may lose."""


def improved(part: PlannedPart, price: Price, least: float, until: float) -> PlannedPart | None:
    """The part with the one change of a feature that explains most; None where none does.

    Args:
        part: that is changed; itself it stays as it is.
        price: mm that a feature costs.
        least: mm that a change has to explain.
        until: work of the judge at which it ends.
    """
    best, most = None, -least
    before = PlannedPart(part.judge)
    for number, (operation, feature) in enumerate(part.features):
        after = part.features[number + 1 :]
        if part.judge.work > until:
            break
        if number or len(part.features) > 1:
            shorter = before.followed_by(after)
            gain = shorter.cost - part.cost - price(feature) - _FEWER * least
            if gain < most:
                best, most = shorter, gain
        for other in _with_other_ends(part.judge.sheet, feature):
            moved = before.followed_by([(operation, other), *after])
            gain = moved.cost - part.cost + price(other) - price(feature)
            if gain < most:
                best, most = moved, gain
        before = before.followed_by([(operation, feature)])
    return best


def _with_other_ends(sheet: PlaneSheet, feature: Feature) -> Iterator[Feature]:
    """A feature with one end at another place, or through all of the part."""
    if isinstance(feature, Prism):
        places, ends = places_of(sheet, feature.loop), (feature.low, feature.high)
    elif isinstance(feature, Pattern):
        places = places_of_all(sheet, feature)
        ends = feature.parts[0].low, feature.parts[0].high
    else:
        return
    spans = [(ends[0], place) for place in places] + [(place, ends[1]) for place in places]
    spans.append((min(places), max(places)))
    near = 2.0 * sheet.tolerance
    for low, high in dict.fromkeys(spans):
        if high - low > near and abs(low - ends[0]) + abs(high - ends[1]) > near:
            if isinstance(feature, Pattern):
                yield pattern_between(sheet, feature, low, high)
            else:
                yield prism(sheet, feature.loop, low, high)

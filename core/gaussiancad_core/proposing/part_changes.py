"""Changes of features that a part has: one is left out, or an end of it lies elsewhere.

An early edit is often half right: the right area between the wrong places, or a large cut that
later ones took the place of.  No further edit mends that; the feature has to change.
"""

from collections.abc import Iterator

from gaussiancad_core.proposing.equal_loops import pattern_between, places_of_all
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.part_edits import Price
from gaussiancad_core.proposing.part_features import Feature, Pattern, Prism, single_features
from gaussiancad_core.proposing.planned_part import PlannedPart

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
            gain = shorter.cost - part.cost - price(operation, feature) - _FEWER * least
            if gain < most:
                best, most = shorter, gain
        for other in _with_other_ends(part.judge.sheet, feature):
            moved = before.followed_by([(operation, other), *after])
            gain = moved.cost - part.cost + price(operation, other) - price(operation, feature)
            if gain < most:
                best, most = moved, gain
        before = before.followed_by([(operation, feature)])
    return best


def _with_other_ends(sheet: PlaneSheet, feature: Feature) -> Iterator[Feature]:
    """A feature with one end at another place, or through all of the part."""
    prisms = [each for each in single_features(feature) if isinstance(each, Prism)]
    if not prisms:
        return
    loops, ends = [each.loop for each in prisms], (prisms[0].low, prisms[0].high)
    places = places_of_all(sheet, loops)
    spans = [(ends[0], place) for place in places] + [(place, ends[1]) for place in places]
    spans.append((min(places), max(places)))
    near = 2.0 * sheet.tolerance
    for low, high in dict.fromkeys(spans):
        if high - low > near and abs(low - ends[0]) + abs(high - ends[1]) > near:
            is_pattern = isinstance(feature, Pattern)
            make = pattern_between(sheet, loops, low, high)
            yield make if is_pattern else make.parts[0]

"""How a part was put together, in sentences."""

from collections.abc import Iterator

from gaussiancad_core.report.pointing import Values

_MOST = 12
"""Holes that are named at most, the largest first."""

_OPERATIONS = {"add": "added", "cut": "cut off", "meet": "kept alone"}


def construction_in_words(construction: Values) -> list[str]:
    """What ``construction.json`` says, one sentence a line.

    Args:
        construction: its values.
    """
    if "features" in construction:
        return [*_features(construction["features"]), *_breaks(construction["breaks"])]
    axis = construction["axis"]
    lines = [
        f"- from {item['low']:.4g} to {item['high']:.4g} mm along {axis}: "
        f"{sum(not loop['is_hole'] for loop in item['loops'])} outline(s) with "
        f"{sum(loop['is_hole'] for loop in item['loops'])} hole(s){_fixed(item)}"
        for item in construction["slabs"]
    ]
    holes = sorted(construction["holes"], key=lambda item: -item["diameter"])
    lines += _holes(holes[:_MOST])
    if len(holes) > _MOST:
        lines.append(f"- and {len(holes) - _MOST} more holes")
    lines += [
        f"- a countersink of {item['diameter']:.4g} mm on the hole of {item['hole']:.4g} mm at "
        f"({item['centre'][0]:.4g}, {item['centre'][1]:.4g})"
        for item in construction["countersinks"]
    ]
    lines += _breaks(construction["breaks"])
    lines += [_turned(item) for item in construction["turned"]]
    lines += [
        f"- a hole of {item['diameter']:.4g} mm along {item['axis']} at "
        f"({item['centre'][0]:.4g}, {item['centre'][1]:.4g}), {_reach(item)}"
        for item in construction["cross_holes"]
    ]
    return lines


def _features(features: list[Values]) -> Iterator[str]:
    for number, feature in enumerate(features, 1):
        parts = feature["parts"]
        times = "" if len(parts) == 1 else f" {len(parts)} times"
        yield f"- {number}. {_shape(parts[0])}, {_OPERATIONS[feature['operation']]}{times}"


def _shape(part: Values) -> str:
    """What one body of a feature is."""
    axis = part["axis"]
    if part["kind"] == "turned":
        x, y = part["centre"]
        return f"a profile turned about {axis} at ({x:.4g}, {y:.4g})"
    span = f"from {part['low']:.4g} to {part['high']:.4g} mm along {axis}"
    outer, *holes = part["loops"]
    inner = f" with {len(holes)} hole(s)" if holes else ""
    first = outer["edges"][0]
    if first["kind"] == "circle":
        x, y = first["centre"]
        return f"a disc of {2.0 * first['radius']:.4g} mm at ({x:.4g}, {y:.4g}){inner} {span}"
    return f"an outline of {len(outer['edges'])} edges{inner} {span}"


def _breaks(breaks: list[Values]) -> Iterator[str]:
    for item in breaks:
        kind = "rounded" if item["is_round"] else "chamfered"
        along = f" along {item['axis']}" if "axis" in item else ""
        size = f"{item['width']:.3g} by {abs(item['height']):.3g} mm"
        yield f"- edges at {item['at']:.4g} mm{along} {kind}, {size}"


def _turned(entry: Values) -> str:
    x, y = entry["centre"]
    places = [at for edge in entry["edges"] for at, _ in (edge["start"], edge["end"])]
    return (
        f"- a slope turned about the axis at ({x:.4g}, {y:.4g}), from {min(places):.4g} to "
        f"{max(places):.4g} mm"
    )


def _reach(hole: Values) -> str:
    if hole["depth"] is not None:
        return f"{hole['depth']:.4g} mm deep, as a note tells"
    if hole["low"] is None and hole["high"] is None:
        return "through"
    low = "the outside" if hole["low"] is None else f"{hole['low']:.4g}"
    high = "the outside" if hole["high"] is None else f"{hole['high']:.4g} mm"
    return f"from {low} to {high}"


def _fixed(slab: Values) -> str:
    numbers = sorted({value for loop in slab["loops"] for value in loop["numbers"]})
    return f"; by the numbers {', '.join(f'{number:g}' for number in numbers)}" if numbers else ""


def _holes(holes: list[Values]) -> Iterator[str]:
    for hole in holes:
        x, y = hole["centre"]
        depth = "through" if hole["is_through"] else f"{hole['low']:.4g} to {hole['high']:.4g} mm"
        text = "" if not hole["numbers"] else ", as a number tells"
        yield f"- a hole of {hole['diameter']:.4g} mm at ({x:.4g}, {y:.4g}), {depth}{text}"

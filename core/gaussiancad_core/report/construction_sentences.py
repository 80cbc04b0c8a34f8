"""How a sketched part is put together, in sentences."""

from collections.abc import Iterator

from gaussiancad_core.report.pointing import Values

_MOST = 12
"""Holes that are named at most, the largest first."""


def construction_in_words(construction: Values) -> list[str]:
    """What ``construction.json`` says, one sentence a line.

    Args:
        construction: its values.
    """
    axis = construction["axis"]
    lines = [
        f"- from {own['low']:.4g} to {own['high']:.4g} mm along {axis}: "
        f"{sum(not loop['is_hole'] for loop in own['loops'])} outline(s) with "
        f"{sum(loop['is_hole'] for loop in own['loops'])} hole(s){_fixed(own)}"
        for own in construction["slabs"]
    ]
    holes = sorted(construction["holes"], key=lambda own: -own["diameter"])
    lines += _holes(holes[:_MOST])
    if len(holes) > _MOST:
        lines.append(f"- and {len(holes) - _MOST} more holes")
    lines += [
        f"- a countersink of {own['diameter']:.4g} mm on the hole of {own['hole']:.4g} mm at "
        f"({own['centre'][0]:.4g}, {own['centre'][1]:.4g})"
        for own in construction["countersinks"]
    ]
    lines += [
        f"- edges at {own['at']:.4g} mm {'rounded' if own['is_round'] else 'chamfered'}, "
        f"{own['width']:.3g} by {abs(own['height']):.3g} mm"
        for own in construction["breaks"]
    ]
    lines += [_turned(own) for own in construction["turned"]]
    lines += [
        f"- a hole of {own['diameter']:.4g} mm along {own['axis']} at "
        f"({own['centre'][0]:.4g}, {own['centre'][1]:.4g}), {_reach(own)}"
        for own in construction["cross_holes"]
    ]
    return lines


def _turned(own: Values) -> str:
    x, y = own["centre"]
    places = [at for edge in own["edges"] for at, _ in (edge["start"], edge["end"])]
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
    return f"; by the numbers {', '.join(f'{own:g}' for own in numbers)}" if numbers else ""


def _holes(holes: list[Values]) -> Iterator[str]:
    for own in holes:
        x, y = own["centre"]
        depth = "through" if own["is_through"] else f"{own['low']:.4g} to {own['high']:.4g} mm"
        told = "" if not own["numbers"] else ", as a number tells"
        yield f"- a hole of {own['diameter']:.4g} mm at ({x:.4g}, {y:.4g}), {depth}{told}"

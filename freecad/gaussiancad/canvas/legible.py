"""Whether words can be read in a colour, on what they stand on."""

LEGIBLE = 4.5
"""Contrast that small words need (WCAG 2, 1.4.3)."""

_STEP = 0.95
"""Share of its light that a colour keeps in one step of darkening."""

_WEIGHTS = (0.2126, 0.7152, 0.0722)
"""Red's, green's and blue's share of the light."""


def contrast(one: str, other: str) -> float:
    """How much two colours ``#rrggbb`` differ in lightness: from 1 to 21, as WCAG 2 counts it."""
    dark, light = sorted((_luminance(one), _luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def ink_on(paper: str, colour: str) -> str:
    """A colour for words on light paper: that of the lines, darkened until it can be read."""
    while contrast(colour, paper) < LEGIBLE:
        colour = "#" + "".join(f"{int(_STEP * channel):02x}" for channel in _channels(colour))
    return colour


def _luminance(colour: str) -> float:
    shares = [share / 255.0 for share in _channels(colour)]
    linear = [
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares
    ]
    return sum(weight * share for weight, share in zip(_WEIGHTS, linear, strict=True))


def _channels(colour: str) -> list[int]:
    return [int(colour[at : at + 2], 16) for at in (1, 3, 5)]

"""Kinds of strokes and roles of views: their keys, and the colours in which they are shown."""

KEYS = {
    "V": "visible",
    "H": "hidden",
    "C": "centre",
    "T": "tangent",
    "D": "dimension",
    "I": "ignore",
}
"""The kind that a key gives to what is selected."""

ROLES = ("front", "top", "right", "left", "bottom", "rear")
"""The principal views, in the order of the keys 1 to 6."""

DRAWN = ("visible", "hidden")
"""Kinds that the part is made of."""

COLOURS = {
    "visible": "#145ac8",
    "hidden": "#d63c8c",
    "centre": "#c88200",
    "tangent": "#5a96dc",
    "cut": "#aa3c00",
    "hatch": "#96aa3c",
    "dimension": "#3c963c",
    "extension": "#6eb46e",
    "leader": "#3caa8c",
    "thread": "#785ac8",
}
"""The same as in ``reading.png``."""

OTHER = "#969696"

DOUBTFUL, DOUBT = "#ff8c00", 0.6
"""Colour of strokes of the part whose kind is less sure than this."""

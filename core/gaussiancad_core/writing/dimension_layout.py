"""How the parts of a dimension stand to each other, and how sure it is that they do (ISO 129-1).

The standard leaves the distances free; what is given here is what programs and drafters keep to.
Distances from a text are in its height, those between lines in px at 200 dpi.
"""

CLOSE = 0.5
"""Heights between a text and the line that it stands at, where another line may be as near."""

BESIDE = 1.0
"""Heights between a text and its line or leader, and between texts of a row; a head is as long."""

LOOSELY = 1.5
"""Heights between a text and the line that it belongs to, or the note that it goes on, at most."""

ALONG = 6.0
"""Heights along a line from a text or letter that stands outside to what it belongs to at most."""

IN_LINE = 1.5
"""px by which pieces of one line, or the tips of its arrows, may be out of line."""

MISSED = 4.0
"""px by which lines that meet may miss each other; a length that is no longer tells nothing."""

LIKELY = 0.9
"""Weight of what a usual arrangement measures of which a part is inferred; 1 where all is drawn."""

POSSIBLE = 0.5
"""Weight of what is measured where only a half was found, or where others are likelier."""

"""How much a witness tells, as log-odds: what agrees adds up, so that no single one may decide.

Set by eye on the sheets of the benchmark ``labels``.
"""

IMPOSSIBLE = -20.0
"""Log-probability of what is known not to be."""

SURE = 3.0
"""Of one to twenty: what a width, a colour or a rhythm tells at most, and what is believed."""

OF_A_POINT = 4.0
"""What the label of one pixel, or one point of a line, tells at most."""

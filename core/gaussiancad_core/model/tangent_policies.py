"""What a sheet does with tangent edges: the lines where two faces pass smoothly into each other."""

from enum import Enum


class TangentPolicy(Enum):
    """What a sheet does with tangent edges (ISO 128-3, ASME Y14.3: phantom, thin, or none)."""

    DRAWN = "drawn"
    THIN = "thin"
    LEFT_OUT = "left-out"
    UNKNOWN = "unknown"

    @property
    def draws(self) -> bool:
        """Whether a tangent edge has a line: such a line is no sharp edge of the part."""
        return self in (TangentPolicy.DRAWN, TangentPolicy.THIN)


KNOWN_POLICIES = TangentPolicy.DRAWN, TangentPolicy.THIN, TangentPolicy.LEFT_OUT
"""Those that a sheet is drawn by."""


def drawn_policy(text: str) -> TangentPolicy:
    """The policy of a word.

    Raises:
        ValueError: it is none that a sheet is drawn by.
    """
    known = {policy.value: policy for policy in KNOWN_POLICIES}
    if text not in known:
        raise ValueError(f"{text!r} is none of {', '.join(known)}")
    return known[text]

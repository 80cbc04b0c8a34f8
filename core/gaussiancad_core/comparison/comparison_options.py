"""How two models are compared: which protocols, laid over each other how, with which samples."""

import math
from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.errors import UsageError
from gaussiancad_protocol.codes import Code

POINT_LIMITS = (100, 1_000_000)


class Protocol(Enum):
    """A named, exact way to make numbers of two models; ``docs/comparison.md`` defines each."""

    GAUSSIANCAD = "gaussiancad"
    DEEPCAD = "deepcad"
    ENGINEERING = "engineering"


class Alignment(Enum):
    """How the result is laid over the reference."""

    NONE = "none"
    AXES = "axes"
    ICP = "icp"
    GLOBAL = "global"


class ScaleRule(Enum):
    """Whether the result may be scaled to lie over the reference."""

    FIXED = "fixed"
    FREE = "free"


@dataclass(frozen=True)
class CompareOptions:
    """What a comparison is asked for.

    Attributes:
        points: surface points a side, 100 to 1,000,000 (``deepcad`` always takes 8,192).
        seed: not negative; same seed, same numbers.
        protocols: those whose blocks are made; the paper's numbers are always there.
        alignment: None takes each protocol's own: ICP, but none for ``deepcad``.
        scale: None takes each protocol's own: free for ``gaussiancad``, fixed for ``engineering``.
        tolerance_mm: of the share of surface that agrees; None takes 1/1000 of the reference's
            longest edge.
        factor: the result's coordinates are multiplied by it first, for files in other units.
    """

    points: int = 10_000
    seed: int = 0
    protocols: tuple[Protocol, ...] = (Protocol.GAUSSIANCAD,)
    alignment: Alignment | None = None
    scale: ScaleRule | None = None
    tolerance_mm: float | None = None
    factor: float = 1.0

    def check(self) -> None:
        """See whether the numbers can be used.

        Raises:
            UsageError: ``points-out-of-range``, ``seed-negative``, ``factor-not-positive``,
                ``tolerance-not-positive``, ``protocol-has-no-registration``.
        """
        low, high = POINT_LIMITS
        if not low <= self.points <= high:
            raise UsageError(
                Code.POINTS_OUT_OF_RANGE,
                "{points} points cannot be compared: use {low} to {high:,}",
                points=self.points,
                low=low,
                high=high,
            )
        if self.seed < 0:
            raise UsageError(
                Code.SEED_NEGATIVE, "the seed {seed} is negative: use 0 or more", seed=self.seed
            )
        if not math.isfinite(self.factor) or self.factor <= 0.0:
            raise UsageError(
                Code.FACTOR_NOT_POSITIVE,
                "the factor {factor} is no number above 0",
                factor=self.factor,
            )
        tolerance = self.tolerance_mm
        if tolerance is not None and not (math.isfinite(tolerance) and tolerance > 0.0):
            raise UsageError(
                Code.TOLERANCE_NOT_POSITIVE,
                "the tolerance {tolerance} mm is no length above 0",
                tolerance=tolerance,
            )
        bound = self.alignment is not None or self.scale is not None
        if bound and self.protocols == (Protocol.DEEPCAD,):
            raise UsageError(
                Code.PROTOCOL_HAS_NO_REGISTRATION,
                "the protocol deepcad registers nothing and always scales to the unit cube: "
                "leave out --register and --scale",
            )

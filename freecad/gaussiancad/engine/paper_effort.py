"""What the paper's cameras cost: the size of their images, and the time on a processor.

The engine says while it trains how long it will take; this is for the choice before.
"""

from dataclasses import dataclass

from freecad.gaussiancad.engine.protocol import Preset

LARGEST_SCALE_DOWN = 16

_FULL = (1920, 1080)
_DRAFT_SCALE_DOWN = 8
"""The preset *draft* trains on images that are smaller by this to begin with."""

_ITERATIONS = {Preset.DRAFT: 300, Preset.STANDARD: 10_000, Preset.FINE: 10_000}
_USUAL = {Preset.DRAFT: 1, Preset.STANDARD: 6, Preset.FINE: 4}
"""What makes an hour and more a few minutes."""

_FIXED_S, _FULL_SIZE_S = 0.015, 0.44
"""Seconds an iteration takes however small the images are, and those in proportion to the pixels;
two processor cores."""


@dataclass(frozen=True)
class PaperEffort:
    """What a training with the paper's cameras takes.

    Attributes:
        width, height: of the images, px.
        minutes: on a processor, about.
    """

    width: int
    height: int
    minutes: float


def usual_scale_down(preset: Preset) -> int:
    """By how much the images' edges are divided unless somebody asks for something else."""
    return _USUAL[preset]


def paper_effort(preset: Preset, scale_down: int) -> PaperEffort:
    """The effort of a preset with the images' edges divided by ``scale_down``."""
    factor = scale_down * (_DRAFT_SCALE_DOWN if preset is Preset.DRAFT else 1)
    seconds = _ITERATIONS[preset] * (_FIXED_S + _FULL_SIZE_S / factor**2)
    return PaperEffort(_FULL[0] // factor, _FULL[1] // factor, seconds / 60.0)

"""How the Gaussians are trained: two recipes at three presets.

The orthographic recipe keeps the hull's accuracy.  The paper's losses alone pull Gaussians inward:
those seen edge-on are bloated by the dilation, spill over the outline, and are punished for it.
A small dilation, a thin axis that stays thin, slow positions and an anchor in the tangent plane
prevent that.  The paper's recipe is what the GaussianCAD paper describes, with 3DGS's rates and the
paper's 10,000 iterations at the preset ``fine``; its 1920 x 1080 images are scaled down by preset.
3DGS's density control is left out, since the hull's surface is covered from the start.
"""

from dataclasses import dataclass, field

from gaussiancad_core.axes import Role
from gaussiancad_core.cameras import PAPER_RESOLUTION, Camera, orthographic_camera, paper_camera
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.splatting.losses import LossWeights
from gaussiancad_core.splatting.rasteriser import Backend, Optics


@dataclass(frozen=True)
class Rates:
    """Learning rates of Adam (Kingma and Ba 2015), in a scene whose longest edge is 5.

    Attributes:
        position, position_end: at the first and the last iteration; exponential in between.
        quaternion, log_scale, opacity, colour: constant.
        epsilon: Adam's own; a larger one keeps parameters still that hardly matter.
    """

    position: float = 1.6e-4
    position_end: float = 8e-6
    quaternion: float = 1e-4
    log_scale: float = 5e-3
    opacity: float = 0.03
    colour: float = 5e-3
    epsilon: float = 1e-8


@dataclass(frozen=True)
class TrainingSettings:
    """One training.

    Attributes:
        count: number of Gaussians to start with.
        pixels: longest edge of the images.
        iterations: at most.
        thickness: standard deviation across the surface at the start, as a share of that in it.
        opacity: at the start, 0 to 1.
        rates: of the optimiser.
        weights: of the loss.
        optics: of the rasteriser.
        anchor: weight of the mean distance from the tangent plane of the start (scene units).
        thin_axis_locked: whether the third scale keeps its start value.
        patience: iterations without a better loss (by ``least_gain``) after which it ends early.
        least_gain: share of the loss that counts as better.
        backend: who draws.
    """

    count: int = 5_000
    pixels: int = 256
    iterations: int = 150
    thickness: float = 0.04
    opacity: float = 0.88
    rates: Rates = field(default_factory=Rates)
    weights: LossWeights = field(default_factory=LossWeights)
    optics: Optics = field(default_factory=lambda: Optics(dilation=0.02))
    anchor: float = 5.0
    thin_axis_locked: bool = True
    patience: int = 50
    least_gain: float = 1e-3
    backend: Backend = Backend.TILES


_PAPER_RATES = Rates(
    position=8e-4,
    position_end=8e-6,
    quaternion=1e-3,
    log_scale=5e-3,
    opacity=0.05,
    colour=2.5e-3,
    epsilon=1e-15,
)

_WORK = {
    Recipe.ORTHOGRAPHIC: {
        Preset.DRAFT: (2_000, 128, 60),
        Preset.STANDARD: (5_000, 256, 150),
        Preset.FINE: (10_000, 512, 200),
    },
    Recipe.PAPER: {
        Preset.DRAFT: (2_000, 240, 100),
        Preset.STANDARD: (5_000, 480, 200),
        Preset.FINE: (10_000, 640, 10_000),
    },
}
"""Gaussians, longest edge of the images in px, iterations."""


def training_settings(recipe: Recipe, preset: Preset) -> TrainingSettings:
    """The settings of a recipe at a preset."""
    count, pixels, iterations = _WORK[recipe][preset]
    if recipe is Recipe.ORTHOGRAPHIC:
        return TrainingSettings(count=count, pixels=pixels, iterations=iterations)
    return TrainingSettings(
        count=count,
        pixels=pixels,
        iterations=iterations,
        thickness=0.15,
        rates=_PAPER_RATES,
        optics=Optics(dilation=0.3),
        anchor=0.0,
        thin_axis_locked=False,
        patience=iterations,
    )


def training_cameras(
    recipe: Recipe,
    settings: TrainingSettings,
    roles: tuple[Role, ...],
    size: tuple[float, float, float],
) -> tuple[Camera, ...]:
    """The recipe's cameras, one a role, with images of the settings' size."""
    if recipe is Recipe.ORTHOGRAPHIC:
        return tuple(orthographic_camera(role, size, settings.pixels) for role in roles)
    factor = settings.pixels / PAPER_RESOLUTION[0]
    return tuple(paper_camera(role, size, factor) for role in roles)

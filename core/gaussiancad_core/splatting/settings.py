"""How the Gaussians are trained: two recipes at three presets.

The orthographic recipe keeps the hull's accuracy.  The paper's losses alone pull Gaussians inward:
those seen edge-on are bloated by the dilation, spill over the outline, and are punished for it.
A small dilation, a thin axis that stays thin, slow positions and an anchor in the tangent plane
prevent that.

The paper's recipe is what the GaussianCAD paper describes: its pinhole cameras at 1920 x 1080,
10,000 iterations of one view each, density control.  The paper gives no weights and rates: they are
the defaults that GaussianObject (Yang et al. 2024), on which it builds, published with its code;
most are those of 3DGS (Kerbl et al. 2023).  Only the preset ``draft`` does less.
"""

from dataclasses import dataclass, field, replace

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import (
    PAPER_RESOLUTION,
    Camera,
    orthographic_camera,
    paper_camera,
)
from gaussiancad_core.splatting.losses import LossWeights
from gaussiancad_core.splatting.rasterizer import Backend, RasterSettings
from gaussiancad_protocol.modes import Preset, Recipe


@dataclass(frozen=True)
class Rates:
    """Learning rates of Adam (Kingma and Ba 2015), in units of the scene.

    Attributes:
        position, position_end: at the first iteration and after ``position_steps``; exponential in
            between.
        position_steps: iterations, all of the training if None.
        quaternion, log_scale, opacity, colour: constant.
        epsilon: Adam's own; a larger one keeps parameters still that hardly matter.
    """

    position: float = 1.6e-4
    position_end: float = 8e-6
    position_steps: int | None = None
    quaternion: float = 1e-4
    log_scale: float = 5e-3
    opacity: float = 0.03
    colour: float = 5e-3
    epsilon: float = 1e-8


@dataclass(frozen=True)
class DensityControl:
    """When Gaussians are born and die (3DGS, section 5.2; the numbers are GaussianObject's).

    Attributes:
        start, until: iterations between which the density changes.
        every: iterations between two changes.
        pull: mean gradient of a Gaussian's images, per half image, from which on it is doubled.
        dense: size of the standard deviation from which on it is split instead, as a share of the
            radius of the cameras' positions.
        reset_every: iterations after which all become nearly transparent.
        least_opacity: what is more transparent dies.
        largest: what is larger dies once there was a reset; as a share of the same radius.
        most: Gaussians from which on none are born.
    """

    start: int = 500
    until: int = 6_000
    every: int = 100
    pull: float = 2e-4
    dense: float = 0.01
    reset_every: int = 1_000
    least_opacity: float = 0.005
    largest: float = 0.1
    most: int = 1_000_000


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
        anchor: weight of the mean distance of discs from the tangent planes of their starts, that
            of their centres and that to which a tilt lifts their rims (scene units).
        thin_axis_locked: whether the third scale keeps its start value.
        patience: iterations without a better loss (by ``least_gain``) after which it ends early.
        least_gain: share of the loss that counts as better.
        backend: who draws.
        one_view: whether an iteration looks at one view, in random order, instead of all.
        density: None if the number of Gaussians stays.
        seed: of the order of the views and the density control.
    """

    count: int = 5_000
    pixels: int = 256
    iterations: int = 150
    thickness: float = 0.04
    opacity: float = 0.88
    rates: Rates = field(default_factory=Rates)
    weights: LossWeights = field(default_factory=LossWeights)
    optics: RasterSettings = field(default_factory=lambda: RasterSettings(dilation=0.02))
    anchor: float = 5.0
    thin_axis_locked: bool = True
    patience: int = 50
    least_gain: float = 1e-3
    backend: Backend = Backend.TILES
    one_view: bool = False
    density: DensityControl | None = None
    seed: int = 0


_CAMERAS_EXTENT = 4.5
"""Radius of the paper's cameras about their mean and a tenth, by which 3DGS scales its rates."""

_SH_CONSTANT = 0.2821
"""Colours change by this much where 3DGS's coefficient of the constant harmonic changes by 1."""

_PAPER_RATES = Rates(
    position=1.6e-4 * _CAMERAS_EXTENT,
    position_end=1.6e-6 * _CAMERAS_EXTENT,
    position_steps=30_000,
    quaternion=1e-3,
    log_scale=5e-3,
    opacity=0.05,
    colour=2.5e-3 * _SH_CONSTANT,
    epsilon=1e-15,
)

_PAPER_WEIGHTS = LossWeights(ssim=0.2, mask=0.01)
"""GaussianObject's ``lambda_dssim`` and ``lambda_silhouette``."""

PAPER_ITERATIONS = 10_000

_WORK = {
    Recipe.ORTHOGRAPHIC: {
        Preset.DRAFT: (2_000, 128, 60),
        Preset.STANDARD: (5_000, 256, 150),
        Preset.FINE: (10_000, 512, 200),
    },
    Recipe.PAPER: {
        Preset.DRAFT: (2_000, 240, 300),
        Preset.STANDARD: (5_000, PAPER_RESOLUTION[0], PAPER_ITERATIONS),
        Preset.FINE: (10_000, PAPER_RESOLUTION[0], PAPER_ITERATIONS),
    },
}
"""Gaussians at the start, longest edge of the images in px, iterations."""


def training_settings(recipe: Recipe, preset: Preset, scale_down: int = 1) -> TrainingSettings:
    """The settings of a recipe at a preset.

    Args:
        recipe: cameras and training.
        preset: amount of work.
        scale_down: the images' edges are divided by this.
    """
    count, pixels, iterations = _WORK[recipe][preset]
    plain = TrainingSettings(
        count=count, pixels=max(1, pixels // scale_down), iterations=iterations
    )
    if recipe is Recipe.ORTHOGRAPHIC:
        return plain
    return replace(
        plain,
        thickness=0.15,
        rates=_PAPER_RATES,
        weights=_PAPER_WEIGHTS,
        optics=RasterSettings(dilation=0.3),
        anchor=0.0,
        thin_axis_locked=False,
        patience=iterations,
        one_view=True,
        density=DensityControl(),
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

"""Adaptive control of density (Kerbl et al. 2023, section 5.2): Gaussians are born and die.

Where the loss pulls hard at the images of Gaussians, small ones are doubled and large ones split in
two; what is nearly transparent dies.  Every now and then all become nearly transparent, so that
those that are needed have to prove it.
"""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from gaussiancad_core.splatting.gaussian_model import Arrays, GaussianModel
from gaussiancad_core.splatting.settings import DensityControl

_SPLIT_SHRINK = 1.6
"""By how much the halves of a split Gaussian are smaller (3DGS)."""

_RESET_LOGIT = float(np.log(0.01 / 0.99))
"""Logit of the opacity that a reset leaves at most (3DGS)."""


@dataclass
class _Pulls:
    """How hard the loss pulled at each Gaussian's images since the last change of density.

    Attributes:
        sums: (n,) lengths of the gradients, in half images.
        times: (n,) how often the Gaussian was seen.
    """

    sums: Tensor
    times: Tensor


class Density:
    """Density control of one training.

    Args:
        control: when and how.
        extent: radius of the cameras' positions about their mean, in units of the scene.
        trainee: what is controlled.
        random: decides where halves go.
    """

    def __init__(
        self,
        control: DensityControl,
        extent: float,
        trainee: GaussianModel,
        random: np.random.Generator,
    ) -> None:
        self._control = control
        self._extent = extent
        self._trainee = trainee
        self._random = random
        self._pulls = self._no_pulls()

    def note(self, gradients: Tensor, size: tuple[int, int]) -> None:
        """Remember the gradients of image shifts.

        Args:
            gradients: (v, n, 2) of a loss that is the mean over v views, 1 / px.
            size: (width, height) px.
        """
        right, down = (len(gradients) * tensor for tensor in gradients.unbind(dim=2))
        lengths = torch.hypot(right * (size[0] / 2.0), down * (size[1] / 2.0))
        self._pulls.sums += lengths.sum(dim=0)
        self._pulls.times += (lengths > 0.0).sum(dim=0)

    def after(self, iteration: int) -> None:
        """Change the density if it is time to, after ``iteration`` iterations."""
        control = self._control
        if iteration >= control.until:
            return
        if iteration > control.start and iteration % control.every == 0:
            self._adapt(iteration)
        if iteration % control.reset_every == 0:
            self._trainee.hold_opacities(_RESET_LOGIT)

    def state(self) -> Arrays:
        """What a later :meth:`restore` needs."""
        return {
            "pull_sums": self._pulls.sums.cpu().numpy(),
            "pull_times": self._pulls.times.cpu().numpy(),
        }

    def restore(self, state: Arrays) -> None:
        """Become what :meth:`state` was taken of, after the trainee did."""
        device = self._trainee.parameters.means.device
        sums, times = (
            torch.from_numpy(np.array(state[name])).to(device)
            for name in ("pull_sums", "pull_times")
        )
        self._pulls = _Pulls(sums, times)

    def _no_pulls(self) -> _Pulls:
        means = self._trainee.parameters.means
        return _Pulls(means.new_zeros(len(means)), means.new_zeros(len(means)))

    def _adapt(self, iteration: int) -> None:
        parameters = self._trainee.parameters
        pulled = self._pulls.sums / self._pulls.times.clamp_min(1.0) >= self._control.pull
        size = parameters.log_scales.detach().exp().amax(dim=1)
        large = size > self._control.dense * self._extent
        room = len(self._trainee) + int(pulled.sum()) <= self._control.most
        doubled = torch.nonzero(pulled & ~large & room).flatten()
        split = torch.nonzero(pulled & large & room).flatten()
        dead = torch.sigmoid(parameters.logit_opacities.detach()) < self._control.least_opacity
        if iteration > self._control.reset_every:
            dead |= size > self._control.largest * self._extent
        dead[split] = True
        kept = torch.nonzero(~dead).flatten()
        if len(kept) + len(split) == 0:
            return
        halves = split.repeat(2)
        born = [tensor.detach()[torch.cat([doubled, halves])] for tensor in parameters.tensors]
        if len(split):
            born[0][len(doubled) :] += self._places_within(halves)
            born[2][len(doubled) :] -= float(np.log(_SPLIT_SHRINK))
        self._trainee.rebuild(kept, tuple(born), torch.cat([doubled, halves]))
        self._pulls = self._no_pulls()

    def _places_within(self, chosen: Tensor) -> Tensor:
        """(b, 3) random offsets, distributed as the chosen Gaussians are."""
        parameters = self._trainee.parameters
        normal = self._random.standard_normal((len(chosen), 3)).astype(np.float32)
        scales = parameters.log_scales.detach()[chosen].exp()
        local = torch.from_numpy(normal).to(scales.device) * scales
        quaternions = torch.nn.functional.normalize(parameters.quaternions.detach()[chosen], dim=1)
        scalar, vector = quaternions[:, :1], quaternions[:, 1:]
        turn = torch.linalg.cross(vector, local)
        return local + 2.0 * (scalar * turn + torch.linalg.cross(vector, turn))

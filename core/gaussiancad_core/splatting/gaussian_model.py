"""Gaussians in training: their parameters, what Adam remembers of them, and where they started."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.rasterizer import Parameters, parameters_of
from gaussiancad_core.splatting.settings import Rates

Arrays = dict[str, npt.NDArray[np.generic]]

_NAMES = ("means", "quaternions", "log_scales", "logit_opacities", "colours")


@dataclass(frozen=True, eq=False)
class Roots:
    """Where Gaussians started; those that are born later have their parents'.

    Attributes:
        points: (n, 3) in units of the scene.
        normals: (n, 3) unit outward normals.
    """

    points: Tensor
    normals: Tensor


class GaussianModel:
    """n Gaussians with Adam's state (Kingma and Ba 2015); n changes under density control.

    Args:
        gaussians: the start, mm.
        unit: mm that become 1.
        rates: of Adam.
        device: of the tensors.

    Attributes:
        parameters: the leaves that are optimised, in units of the scene.
        roots: where they started.
    """

    def __init__(self, gaussians: Gaussians, unit: float, rates: Rates, device: str) -> None:
        self.parameters = parameters_of(gaussians, unit, device=device)
        points = torch.from_numpy(gaussians.means / np.float32(unit)).to(device)
        self.roots = Roots(points, torch.from_numpy(gaussians.normals).to(device))
        self._unit = unit
        self._rates = rates
        self._adam = self._new_adam()

    def __len__(self) -> int:
        return len(self.parameters.means)

    def step(self, position_rate: float) -> None:
        """Move all parameters by their gradients, and forget these."""
        self._adam.param_groups[0]["lr"] = position_rate
        self._adam.step()
        self._adam.zero_grad()

    def rebuild(self, kept: Tensor, born: tuple[Tensor, ...], parents: Tensor) -> None:
        """Keep some Gaussians and add others behind them.

        Args:
            kept: (k,) indices.
            born: the parameters of b more, in the order of :class:`Parameters`; Adam knows nothing
                of them.
            parents: (b,) indices of those from which they have their roots.
        """
        remembered = self._moments()
        with torch.no_grad():
            tensors = [
                torch.cat([old[kept], new]).requires_grad_()
                for old, new in zip(self.parameters.tensors, born, strict=True)
            ]
        self.parameters = Parameters(*tensors)
        order = torch.cat([kept, parents])
        self.roots = Roots(self.roots.points[order], self.roots.normals[order])
        self._adam = self._new_adam()
        for tensor, (first, second, step) in zip(tensors, remembered, strict=True):
            blank = torch.zeros_like(tensor[len(kept) :])
            self._remember(
                tensor, (torch.cat([first[kept], blank]), torch.cat([second[kept], blank]), step)
            )

    def hold_opacities(self, largest_logit: float) -> None:
        """Make all Gaussians at most so opaque; Adam forgets about opacities."""
        opacities = self.parameters.logit_opacities
        with torch.no_grad():
            opacities.clamp_(max=largest_logit)
        state = self._adam.state[opacities]
        if state:
            state["exp_avg"].zero_()
            state["exp_avg_sq"].zero_()

    def gaussians(self) -> Gaussians:
        """The Gaussians as they are now, in mm, rotations made unit quaternions."""
        means, quaternions, log_scales, logits, colours = (
            tensor.detach().cpu().numpy().copy() for tensor in self.parameters.tensors
        )
        return Gaussians(
            means=means * np.float32(self._unit),
            quaternions=quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True),
            log_scales=log_scales + np.float32(np.log(self._unit)),
            logit_opacities=logits,
            colours=np.clip(colours, 0.0, 1.0),
            normals=self.roots.normals.cpu().numpy().copy(),
        )

    def state(self) -> Arrays:
        """Everything that a later :meth:`restore` needs, as arrays."""
        found: Arrays = {
            "root_points": self.roots.points.cpu().numpy(),
            "root_normals": self.roots.normals.cpu().numpy(),
        }
        moments = self._moments()
        for name, tensor, moment in zip(_NAMES, self.parameters.tensors, moments, strict=True):
            found[name] = tensor.detach().cpu().numpy()
            for part, value in zip(("first", "second", "steps"), moment, strict=True):
                found[f"{name}_{part}"] = value.cpu().numpy()
        return found

    def restore(self, state: Arrays) -> None:
        """Become what :meth:`state` was taken of."""
        device = self.parameters.means.device

        def tensor(name: str) -> Tensor:
            return torch.from_numpy(np.array(state[name])).to(device)

        self.parameters = Parameters(*(tensor(name).requires_grad_() for name in _NAMES))
        self.roots = Roots(tensor("root_points"), tensor("root_normals"))
        self._adam = self._new_adam()
        for name, this_tensor in zip(_NAMES, self.parameters.tensors, strict=True):
            self._remember(
                this_tensor,
                (
                    tensor(f"{name}_first"),
                    tensor(f"{name}_second"),
                    torch.from_numpy(np.array(state[f"{name}_steps"])),
                ),
            )

    def _new_adam(self) -> torch.optim.Adam:
        rates = self._rates
        of_tensor = (rates.position, rates.quaternion, rates.log_scale, rates.opacity, rates.colour)
        groups = [
            {"params": [tensor], "lr": rate}
            for tensor, rate in zip(self.parameters.tensors, of_tensor, strict=True)
        ]
        on_gpu = self.parameters.means.is_cuda
        return torch.optim.Adam(groups, eps=rates.epsilon, fused=True if on_gpu else None)

    def _moments(self) -> list[tuple[Tensor, Tensor, Tensor]]:
        """First and second moments and the number of steps of each tensor; zeros at first."""
        found = []
        for tensor in self.parameters.tensors:
            item = self._adam.state.get(tensor)
            if item:
                found.append((item["exp_avg"], item["exp_avg_sq"], item["step"]))
            else:
                blank = torch.zeros_like(tensor)
                blank = blank.detach()
                found.append((blank, blank.clone(), torch.tensor(0.0)))
        return found

    def _remember(self, tensor: Tensor, moments: tuple[Tensor, Tensor, Tensor]) -> None:
        first, second, step = moments
        # Adam's fused steps count where the tensors are, its others on the processor.
        counted = tensor.device if tensor.is_cuda else torch.device("cpu")
        self._adam.state[tensor] = {
            "step": step.to(counted, copy=True),
            "exp_avg": first.clone(),
            "exp_avg_sq": second.clone(),
        }

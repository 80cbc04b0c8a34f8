"""Gaussians are born where the loss pulls and die where they are transparent."""

from dataclasses import replace

import numpy as np
import pytest
import torch

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.splatting.density import Density
from gaussiancad_core.splatting.gaussian_model import GaussianModel
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.settings import DensityControl, Rates

CONTROL = DensityControl(start=10, until=100, every=10, pull=1.0, reset_every=40, most=1_000)
EXTENT = 4.0
COUNT = 50


@pytest.fixture
def trainee(box_surface: TriangleMesh) -> GaussianModel:
    """Fifty Gaussians of a size of 0.01, all of which have moved once."""
    found = GaussianModel(gaussians_on(box_surface, Start(COUNT)), 4.0, Rates(), "cpu")
    with torch.no_grad():
        found.parameters.log_scales.fill_(float(np.log(0.01)))
    for tensor in found.parameters.tensors:
        tensor.grad = torch.ones_like(tensor)
    found.step(1e-4)
    return found


def density(trainee: GaussianModel, control: DensityControl = CONTROL) -> Density:
    return Density(control, EXTENT, trainee, np.random.default_rng(0))


def pulls(*chosen: int, strength: float = 1.0) -> torch.Tensor:
    """Gradients of three views of a size of 2 px that average to ``strength``."""
    gradients = torch.full((3, COUNT, 2), 1e-6)
    gradients[:, list(chosen), 0] = strength / 3.0
    return gradients


def test_small_ones_are_doubled_where_the_loss_pulls(trainee: GaussianModel) -> None:
    before = [tensor.detach().clone() for tensor in trainee.parameters.tensors]
    roots = trainee.roots
    this_density = density(trainee)
    this_density.note(pulls(3, 7, strength=1.01), (2, 2))
    this_density.after(20)
    assert len(trainee) == COUNT + 2
    for old, new in zip(before, trainee.parameters.tensors, strict=True):
        assert torch.equal(new[:COUNT], old)
        assert torch.equal(new[COUNT:], old[[3, 7]])
        assert new.is_leaf and new.requires_grad
    assert torch.equal(trainee.roots.normals[COUNT:], roots.normals[[3, 7]])
    state = trainee.state()
    assert (state["means_first"][:COUNT] != 0.0).all() and (state["means_first"][COUNT:] == 0).all()


def test_large_ones_are_split_into_two_smaller_ones_nearby(trainee: GaussianModel) -> None:
    with torch.no_grad():
        trainee.parameters.log_scales[5] = torch.log(torch.tensor([0.1, 0.05, 1e-4]))
        trainee.parameters.quaternions[5] = torch.tensor([1.0, 0.0, 0.0, 0.0])
    middle = trainee.parameters.means[5].detach().clone()
    this_density = density(trainee)
    this_density.note(pulls(5, strength=1.01), (2, 2))
    this_density.after(20)
    assert len(trainee) == COUNT + 1
    halves = trainee.parameters.log_scales[-2:].exp()
    assert halves.detach().numpy() == pytest.approx(
        np.array([[0.1, 0.05, 1e-4]] * 2) / 1.6, rel=1e-5
    )
    away = (trainee.parameters.means[-2:] - middle).detach().abs()
    assert (away > 0.0).any(dim=1).all()
    assert (away < 5.0 * torch.tensor([0.1, 0.05, 1e-4])).all()


def test_weak_pulls_change_nothing_and_means_are_over_the_times_seen(
    trainee: GaussianModel,
) -> None:
    this_density = density(trainee)
    this_density.note(pulls(3, strength=0.99), (2, 2))
    this_density.after(20)
    assert len(trainee) == COUNT
    once = torch.zeros((3, COUNT, 2))
    once[0, 4, 1] = 1.01 / 3.0
    this_density.note(once, (2, 2))
    this_density.after(30)
    assert len(trainee) == COUNT + 1


@pytest.mark.parametrize("iteration", [10, 25, 100, 110])
def test_nothing_changes_at_other_times(trainee: GaussianModel, iteration: int) -> None:
    this_density = density(trainee)
    this_density.note(pulls(1, 2, strength=9.0), (2, 2))
    this_density.after(iteration)
    assert len(trainee) == COUNT


def test_the_transparent_die_and_after_a_reset_the_huge(trainee: GaussianModel) -> None:
    with torch.no_grad():
        trainee.parameters.logit_opacities[:4] = -6.0
        trainee.parameters.log_scales[10] = 0.0
    this_density = density(trainee)
    this_density.after(20)
    assert len(trainee) == COUNT - 4
    this_density.after(50)
    assert len(trainee) == COUNT - 5


def test_a_reset_makes_all_nearly_transparent(trainee: GaussianModel) -> None:
    density(trainee, replace(CONTROL, every=7)).after(40)
    opacities = torch.sigmoid(trainee.parameters.logit_opacities.detach())
    assert opacities.numpy() == pytest.approx(np.full(COUNT, 0.01), rel=1e-4)
    assert (trainee.state()["logit_opacities_first"] == 0.0).all()
    assert (trainee.state()["means_first"] != 0.0).all()


def test_none_are_born_beyond_the_limit_and_the_last_do_not_die(trainee: GaussianModel) -> None:
    this_density = density(trainee, replace(CONTROL, most=COUNT + 1))
    this_density.note(pulls(1, 2, strength=9.0), (2, 2))
    this_density.after(20)
    assert len(trainee) == COUNT
    with torch.no_grad():
        trainee.parameters.logit_opacities.fill_(-9.0)
    this_density.after(30)
    assert len(trainee) == COUNT

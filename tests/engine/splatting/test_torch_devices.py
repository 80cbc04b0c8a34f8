"""Which back end draws, and what is said where the GPU cannot be used."""

import sys
from importlib import metadata
from types import SimpleNamespace

import pytest
import torch

from gaussiancad_core.errors import EngineError
from gaussiancad_core.splatting import torch_devices
from gaussiancad_core.splatting.rasterizer import Backend
from gaussiancad_core.splatting.torch_devices import backend_for, cuda_problem
from gaussiancad_protocol.exit_codes import ExitCode
from gaussiancad_protocol.modes import Device


def _machine(
    monkeypatch: pytest.MonkeyPatch, *, cuda: bool, gsplat: bool, kernels: object = None
) -> None:
    """A machine with or without a CUDA device, gsplat and its kernels."""

    def version(name: str) -> str:
        if name == "gsplat" and not gsplat:
            raise metadata.PackageNotFoundError(name)
        return "1.5.3"

    monkeypatch.setattr(torch.cuda, "is_available", lambda: cuda)
    monkeypatch.setattr(torch_devices.metadata, "version", version)
    monkeypatch.setitem(sys.modules, "gsplat", SimpleNamespace())
    package = SimpleNamespace(_backend=SimpleNamespace(_C=kernels))
    monkeypatch.setitem(sys.modules, "gsplat.cuda", package)


def test_a_processor_is_asked_for_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine(monkeypatch, cuda=True, gsplat=True, kernels=object())
    assert backend_for(Device.CPU) is Backend.TILES


def test_a_gpu_that_can_be_used_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine(monkeypatch, cuda=True, gsplat=True, kernels=object())
    assert cuda_problem() is None
    assert backend_for(Device.AUTO) is backend_for(Device.CUDA) is Backend.GSPLAT
    assert Backend.GSPLAT.device == "cuda"
    assert Backend.TILES.device == Backend.REFERENCE.device == "cpu"


@pytest.mark.parametrize(
    ("cuda", "gsplat", "word"),
    [(False, True, "CUDA device"), (True, False, "gsplat"), (True, True, "nvcc")],
)
def test_a_gpu_that_cannot_be_used_is_an_error_only_where_it_was_asked_for(
    monkeypatch: pytest.MonkeyPatch, cuda: bool, gsplat: bool, word: str
) -> None:
    _machine(monkeypatch, cuda=cuda, gsplat=gsplat)
    assert backend_for(Device.AUTO) is Backend.TILES
    with pytest.raises(EngineError) as caught:
        backend_for(Device.CUDA)
    assert caught.value.code == "cuda-unavailable"
    assert caught.value.exit_code is ExitCode.ENGINE
    assert word in caught.value.message and "--device auto" in caught.value.message


def test_a_compiler_that_fails_is_told_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    _machine(monkeypatch, cuda=True, gsplat=True)

    class Broken:
        @property
        def _backend(self) -> object:
            raise RuntimeError("no compiler\nwith many lines")

    monkeypatch.setitem(sys.modules, "gsplat.cuda", Broken())
    problem = cuda_problem()
    assert "no compiler" in problem and "\n" not in problem

"""Where a network is trained."""

import platform
from enum import Enum

import torch

from gaussiancad_core.errors import EngineError
from gaussiancad_protocol.codes import Code


class Place(Enum):
    """What may be asked for."""

    AUTO = "auto"
    CPU = "cpu"
    CUDA = "cuda"


def device_of(place: Place) -> torch.device:
    """The device of a place; ``auto`` is a GPU where there is one.

    Raises:
        EngineError: ``cuda-unavailable``.
    """
    there = torch.cuda.is_available()
    if place is Place.CUDA and not there:
        raise EngineError(
            Code.CUDA_UNAVAILABLE, "PyTorch finds no GPU of NVIDIA: use --device auto or cpu"
        )
    return torch.device("cuda" if there and place is not Place.CPU else "cpu")


def device_name(device: torch.device) -> str:
    """What it is called."""
    if device.type == "cuda":
        return torch.cuda.get_device_name(device)
    return f"CPU, {platform.machine()}, {torch.get_num_threads()} threads"

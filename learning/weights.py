"""Weights as they are stored: in half precision, by their names in the network."""

import pickle
from pathlib import Path

import torch

from gaussiancad_core.errors import UnreadableError
from gaussiancad_protocol.codes import Code
from learning.unet import LabelsNetwork, load_weights


def save_weights(network: LabelsNetwork, path: Path) -> None:
    """Write a network's weights, and give it what was written: what is checked and exported then
    is what a training starts from."""
    stored = {
        name: item.half() if item.is_floating_point() else item
        for name, item in network.state_dict().items()
    }
    torch.save(stored, path)
    load_weights(network, stored)


def starting_network(start: Path | None, seed: int) -> LabelsNetwork:
    """A network with stored weights, or with those of a seed.

    Raises:
        UnreadableError: ``file-missing``, ``file-unreadable``.
    """
    torch.manual_seed(seed)
    network = LabelsNetwork()
    if start is None:
        return network
    try:
        load_weights(network, torch.load(start, map_location="cpu", weights_only=True))
    except FileNotFoundError as error:
        raise UnreadableError(
            Code.FILE_MISSING, "{path} does not exist: check the name of the weights", path=start
        ) from error
    except (OSError, RuntimeError, pickle.UnpicklingError, AttributeError, EOFError) as error:
        raise UnreadableError(
            Code.FILE_UNREADABLE,
            "{path} has no weights of this network: name a weights.pt that training wrote",
            path=start,
        ) from error
    return network

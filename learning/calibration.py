"""How far to trust a network's log-odds: by one number, found on sheets that it never saw.

A trained network is surer than it is right, on sheets of makers whom it does not know most of all.
Its log-odds of part against annotation, multiplied by the number, make the truth of such sheets as
likely as they can (Guo 2017; the number here is the inverse of the temperature there).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import torch

from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from learning.label_checking import KINDS, known_kinds, logits_of
from learning.published import PublishedSheet
from learning.unet import LabelsNetwork

_LEAST, _MOST = 0.05, 20.0
"""Numbers between which it is looked for."""

_HALVINGS = 40


@dataclass(frozen=True)
class Calibration:
    """What was found.

    Attributes:
        temperature: by which log-odds of part against annotation are multiplied.
        px: pixels of ink that say so.
        surprise: mean of minus the logarithm of the truth's probability, without it.
        surprise_after: the same with it.
    """

    temperature: float
    px: int
    surprise: float
    surprise_after: float


def calibrated(
    network: LabelsNetwork, sheets: Sequence[PublishedSheet], device: torch.device
) -> Calibration | None:
    """Calibrate on all known ink of sheets; None where there is none.

    Args:
        network: on the device, in its mode of use.
        sheets: that it was not trained on.
        device: where.
    """
    found = [_margins(network, sheet, device) for sheet in sheets]
    margins = np.concatenate([np.zeros(0), *found])
    if not len(margins):
        return None
    temperature = round(likeliest_temperature(margins), 4)
    return Calibration(
        temperature,
        len(margins),
        round(_surprise(margins), 5),
        round(_surprise(temperature * margins), 5),
    )


def likeliest_temperature(margins: npt.NDArray[np.float64]) -> float:
    """The number that makes the truth likeliest.

    Args:
        margins: (n,) log-odds of what is true against what is not.
    """
    low, high = np.log(_LEAST), np.log(_MOST)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        # The likelihood has one maximum: it still rises where this is positive.
        rise = np.mean(margins * _share(-np.exp(middle) * margins))
        low, high = (middle, high) if rise > 0.0 else (low, middle)
    return float(np.exp(0.5 * (low + high)))


def _margins(
    network: LabelsNetwork, sheet: PublishedSheet, device: torch.device
) -> npt.NDArray[np.float64]:
    """(n,) log-odds of the truth at the known ink of a sheet."""
    kinds = known_kinds(sheet.truth.classes)
    rows, columns = np.nonzero(kinds >= 0)
    logits = logits_of(network, sheet.truth.grey, device)[:, rows, columns].astype(np.float64)
    part = np.logaddexp.reduce(logits[list(PART)])
    rest = np.logaddexp.reduce(logits[max(PART) + 1 : len(InkClass)])
    is_part = kinds[rows, columns] != KINDS.index("annotation")
    return np.where(is_part, part - rest, rest - part)


def _surprise(margins: npt.NDArray[np.float64]) -> float:
    return float(np.mean(np.logaddexp(0.0, -margins)))


def _share(log_odds: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Probability of log-odds."""
    return 0.5 + 0.5 * np.tanh(0.5 * log_odds)

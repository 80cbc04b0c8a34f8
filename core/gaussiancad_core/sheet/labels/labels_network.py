"""The labels network: for each pixel of a picture what its ink stands for.

A U-Net of five levels and 2.3 million parameters (Ronneberger 2015), trained on generated sheets
and a few published ones by the package ``learning`` of the checkout; the card beside the weights
tells on what.  It wants lines of three px (:mod:`gaussiancad_core.sheet.image.working_scale`).
"""

import hashlib
import json
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib.resources import as_file, files
from itertools import product
from typing import TYPE_CHECKING

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.messages import Message
from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from gaussiancad_core.sheet.log_odds import IMPOSSIBLE

if TYPE_CHECKING:
    from onnxruntime import InferenceSession

_WEIGHTS = "labels.onnx"
_DIGEST = "labels.onnx.sha256"
_CARD = "labels.json"

_MULTIPLE = 32
"""Px that the sides of what the network takes are multiples of."""

_TILE, _MARGIN = 1536, 128
"""Side in px of what is labelled at once, and px around it that the network sees beside it."""

_PAPER = 250
"""Grey level from which a pixel is blank."""

_BESIDE = 4
"""Px beside ink up to which it is asked what a pixel is: lines are followed to a pixel, and their
dots looked for in the gaps."""


@dataclass(frozen=True, eq=False)
class InkLabels:
    """What the network says of a picture.

    Attributes:
        log_p: (classes, h, w) float16, natural logarithm of each class's probability; away from
            ink that of paper is 0.
        is_learnt: whether a network says so, that expects what it has learnt from.
    """

    log_p: npt.NDArray[np.float16]
    is_learnt: bool = True

    def at(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, classes) log-probabilities at points (n, 2)."""
        columns = np.clip(np.rint(points[:, 0]).astype(int), 0, self.log_p.shape[2] - 1)
        rows = np.clip(np.rint(points[:, 1]).astype(int), 0, self.log_p.shape[1] - 1)
        return self.log_p[:, rows, columns].T.astype(np.float64)

    def at_size(self, width: int, height: int) -> "InkLabels":
        """The labels of the same picture at another size in px, by the nearest pixel."""
        rows = np.arange(height) * self.log_p.shape[1] // height
        columns = np.arange(width) * self.log_p.shape[2] // width
        return replace(self, log_p=self.log_p[:, rows[:, None], columns])

    def without(self, ink: InkClass, where: npt.NDArray[np.bool_]) -> "InkLabels":
        """The same where it is known that (h, w) bool pixels are not of a class."""
        if not where.any():
            return self
        log_p = self.log_p.copy()
        log_p[ink][where] = IMPOSSIBLE
        return replace(self, log_p=log_p)

    def hidden_odds(self) -> npt.NDArray[np.float16]:
        """(h, w) log-odds of a hidden line's ink against a visible one's."""
        return self.log_p[InkClass.HIDDEN] - self.log_p[InkClass.VISIBLE]

    def best(self) -> npt.NDArray[np.uint8]:
        """(h, w) the likeliest class of each pixel if it is ink."""
        best = np.ones(self.log_p.shape[1:], np.uint8)
        most = self.log_p[1].astype(np.float32)
        for k in range(2, len(self.log_p)):
            item = self.log_p[k].astype(np.float32)
            best[item > most] = k
            np.maximum(most, item, out=most)
        return best


def part_odds(log_p: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """(n,) log-odds of the part's edges against annotation, from (n, classes) log-probabilities;
    paper counts for neither."""
    part = np.logaddexp(*(log_p[:, ink_class] for ink_class in PART))
    rest = np.logaddexp.reduce(log_p[:, max(PART) + 1 :], axis=1)
    return part - rest


@lru_cache(maxsize=1)
def labels_problem() -> Message | None:
    """Why pictures are read without the network; None where it is whole."""
    try:
        weights = files(__package__).joinpath(_WEIGHTS).read_bytes()
        wanted = files(__package__).joinpath(_DIGEST).read_text(encoding="ascii").strip()
    except OSError:
        return Message("the weights of the labels network are missing")
    if hashlib.sha256(weights).hexdigest() != wanted:
        return Message("the weights of the labels network are damaged")
    try:
        import onnxruntime  # noqa: F401
    except ImportError as error:
        return Message("the labels network does not run, as {reason}", reason=error)
    return None


@lru_cache(maxsize=1)
def log_odds_factor() -> float:
    """By how much log-odds of part against annotation are multiplied to be probabilities: the
    ``temperature`` of the network's card, 1 where it was not calibrated."""
    try:
        card = json.loads(files(__package__).joinpath(_CARD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return 1.0
    stated = card.get("temperature") or (card.get("calibration") or {}).get("temperature")
    return float(stated) if stated else 1.0


def ink_labels(grey: npt.NDArray[np.uint8]) -> InkLabels:
    """What the ink of a picture stands for, the same on every run.

    Args:
        grey: (h, w) uint8, dark ink on light paper, wide lines about three px wide.
    """
    height, width = grey.shape
    padded = np.full((_up(height), _up(width)), 255, np.uint8)
    padded[:height, :width] = grey
    log_p = np.full((len(InkClass), *padded.shape), IMPOSSIBLE, np.float16)
    log_p[InkClass.PAPER] = 0.0
    adjacent = np.ones((2 * _BESIDE + 1, 2 * _BESIDE + 1), np.uint8)
    near = cv2.erode(padded, adjacent) < _PAPER
    session = _session()
    name = session.get_inputs()[0].name
    for top, left in product(range(0, padded.shape[0], _TILE), range(0, padded.shape[1], _TILE)):
        inner = np.s_[top : top + _TILE, left : left + _TILE]
        if padded[inner].min() >= _PAPER:
            continue
        above, before = max(0, top - _MARGIN), max(0, left - _MARGIN)
        seen = padded[above : top + _TILE + _MARGIN, before : left + _TILE + _MARGIN]
        ink = 1.0 - seen[None, None].astype(np.float32) / 255.0
        (logits,) = session.run(None, {name: ink})
        rows, columns = np.nonzero(near[inner])
        at = (rows + top - above) * seen.shape[1] + columns + left - before
        item = logits[0, : len(InkClass)].reshape(len(InkClass), -1).take(at, axis=1)
        log_p[:, rows + top, columns + left] = np.maximum(_log_softmax(item), IMPOSSIBLE)
    return InkLabels(log_p[:, :height, :width])


@lru_cache(maxsize=1)
def _session() -> "InferenceSession":
    # Its threads would keep a process from making children.
    import onnxruntime

    options = onnxruntime.SessionOptions()
    # One thread: the same result whatever the machine.
    options.intra_op_num_threads = 1
    # What fails is raised; nothing is printed beside it.
    options.log_severity_level = 4
    # Memory goes back when a sheet is labelled: a long-lived engine reads one now and then.
    options.enable_cpu_mem_arena = False
    with as_file(files(__package__).joinpath(_WEIGHTS)) as path:
        return onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])


def _log_softmax(logits: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Along the first axis."""
    shifted = logits - logits.max(axis=0)
    return shifted - np.log(np.exp(shifted).sum(axis=0))


def _up(side: int) -> int:
    """The next multiple of what the network takes."""
    return -(-side // _MULTIPLE) * _MULTIPLE

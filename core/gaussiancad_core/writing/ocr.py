"""Short lines of text read by a trained network.

It is PP-OCRv6 (Apache-2.0), which lies in ``text_network`` with its card and licence.  It is run
without the code that it comes with: where the texts are is known already, and a drawing needs few
of its 18,000 characters.
"""

import hashlib
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from typing import TYPE_CHECKING

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import EngineError
from gaussiancad_protocol.codes import Code

if TYPE_CHECKING:
    from onnxruntime import InferenceSession

Darkness = npt.NDArray[np.float32]
"""(h, w) 0 for paper to 1 for ink."""

_FOLDER = "text_network"
_WEIGHTS = "PP-OCRv6_rec_small.onnx"
_DIGEST = "PP-OCRv6_rec_small.onnx.sha256"

_ALPHABET = (
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
    " .,:;/+-()[]=\"'\u00b1\u00b0\u00d8\u2300\u03a6\u00f8\u00d7\u00b5\u00c9\u00df\u201d\u2033"
    "\u00fc\u00e8\u4e3b\u6b63\u524d\u4fef\u4e0a\u9876\u5de6\u53f3\u4ef0\u4e0b\u540e\u89c6\u56fe"
)
"""What a drawing is written with; at last the letters of the names of views."""

_ROWS = 48
"""px of height that the network takes; of pictures that are narrower it reads nothing."""

_WIDEST = 1600
"""px of width that no short line of text has."""

_MOST_KNOWN = 500
"""Pictures whose text is kept, some 20 kB each: a sheet has a hundred."""

_FLAT = 0.25
"""Blank border around a text, in its heights."""


@dataclass(frozen=True)
class ReadText:
    """A text as it was read.

    Attributes:
        text: the characters.
        confidence: 0 to 1, the mean over them.
    """

    text: str
    confidence: float


def network_weights() -> bytes:
    """The network's file.

    Raises:
        EngineError: ``engine-incomplete`` where it is missing or not what was published.
    """
    folder = files(__package__).joinpath(_FOLDER)
    try:
        weights = folder.joinpath(_WEIGHTS).read_bytes()
        wanted = folder.joinpath(_DIGEST).read_text(encoding="ascii").strip()
    except OSError:
        weights, wanted = b"", ""
    if hashlib.sha256(weights).hexdigest() != wanted:
        raise EngineError(
            Code.ENGINE_INCOMPLETE,
            "the engine is incomplete ({reason}): run `gaussiancad doctor`",
            reason="the text network is missing or damaged",
        )
    return weights


@dataclass(frozen=True, eq=False)
class _Network:
    """The loaded network.

    Attributes:
        session: runs it.
        columns: of its output that are kept, that of no character first.
        characters: of the others.
    """

    session: "InferenceSession"
    columns: npt.NDArray[np.intp]
    characters: str


@lru_cache(maxsize=1)
def _network() -> _Network:
    import onnxruntime

    options = onnxruntime.SessionOptions()
    # One thread: the same result whatever the machine.
    options.intra_op_num_threads = 1
    options.log_severity_level = 3
    session = onnxruntime.InferenceSession(
        network_weights(), options, providers=["CPUExecutionProvider"]
    )
    known = session.get_modelmeta().custom_metadata_map["character"].split("\n")
    places = {character: place for place, character in enumerate([*known, " "], start=1)}
    kept = [character for character in _ALPHABET if character in places]
    columns = np.array([0, *(places[character] for character in kept)], dtype=np.intp)
    return _Network(session, columns, "".join(kept))


def read_text(picture: Darkness) -> ReadText:
    """Read one line of text.

    Args:
        picture: around the text, upright, without anything else.

    Returns:
        The text, empty where none is seen.
    """
    return _read_prepared(_prepared(picture).tobytes())


@lru_cache(maxsize=_MOST_KNOWN)
def _read_prepared(prepared: bytes) -> ReadText:
    """The text of (48, w) levels: what a program draws letter by letter comes again and again."""
    network = _network()
    name = network.session.get_inputs()[0].name
    paper = np.frombuffer(prepared, np.float32).reshape(_ROWS, -1)
    (scores,) = network.session.run(None, {name: np.tile(paper, (1, 3, 1, 1))})
    return _decoded(scores[0][:, network.columns], network.characters)


def _prepared(picture: Darkness) -> npt.NDArray[np.float32]:
    """(48, w) -1 for ink to 1 for paper."""
    border = max(2, round(_FLAT * picture.shape[0]))
    padded = cv2.copyMakeBorder(picture, border, border, border, border, cv2.BORDER_CONSTANT)
    factor = _ROWS / padded.shape[0]
    width = int(np.clip(round(padded.shape[1] * factor), 1, _WIDEST))
    way = cv2.INTER_AREA if factor < 1.0 else cv2.INTER_CUBIC
    scaled = np.clip(cv2.resize(padded, (width, _ROWS), interpolation=way), 0.0, 1.0)
    if width < _ROWS:
        spare = _ROWS - width
        left = spare // 2
        scaled = cv2.copyMakeBorder(scaled, 0, 0, left, spare - left, cv2.BORDER_CONSTANT)
    return (1.0 - 2.0 * scaled).astype(np.float32)


def _decoded(scores: npt.NDArray[np.float32], characters: str) -> ReadText:
    """The likeliest characters, repeated ones once (connectionist temporal classification,
    Graves 2006).

    Args:
        scores: (time, 1 + characters), that of no character first.
    """
    best = scores.argmax(axis=1)
    starts = np.flatnonzero((best > 0) & (np.diff(best, prepend=0) != 0))
    text = "".join(characters[best[k] - 1] for k in starts)
    sure = float(scores[starts, best[starts]].mean()) if len(starts) else 0.0
    return ReadText(text.strip(), sure)

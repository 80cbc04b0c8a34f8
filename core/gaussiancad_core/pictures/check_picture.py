"""``check.png``: the sheet, pale, with the places over it at which a model differs from it."""

from collections.abc import Mapping
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt

_COLOURS = {
    "missing": (213, 94, 0),
    "extra": (204, 51, 153),
    "linetype": (0, 114, 178),
    "place": (230, 159, 0),
    "number": (0, 158, 115),
    "note": (0, 158, 115),
}
"""RGB of the kinds of differences (Okabe and Ito 2008)."""

_WORDS = {
    "missing": "on the sheet only",
    "extra": "in the model only",
    "linetype": "other linetype",
    "place": "hatched otherwise",
    "number": "number or note not kept",
}

_VERDICTS = {"agrees": (0, 120, 60), "differs": (190, 40, 0), "cannot-tell": (120, 120, 120)}

_PALE = 0.35
"""Share of the sheet's own darkness that is left."""

_MOST_PX = 2400
"""Longer side of the picture."""

_NUMBERED = 40
"""Differences that have their number beside them."""

_SUB = 4
"""Bits of a pixel's fraction that OpenCV draws with."""


def check_picture(values: Mapping[str, Any], sheet: tuple[npt.NDArray[np.uint8], float]) -> bytes:
    """The picture as PNG.

    Args:
        values: the content of ``check.json``.
        sheet: (h, w) uint8, the sheet, and px of the sheet as stored per px of it.
    """
    grey, reduction = sheet
    factor = min(1.0, _MOST_PX / max(grey.shape))
    if factor < 1.0:
        small = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
        grey = np.asarray(small, dtype=np.uint8)
    pale = np.rint(255.0 - _PALE * (255.0 - np.arange(256.0))).astype(np.uint8)
    picture = np.asarray(cv2.cvtColor(pale[grey], cv2.COLOR_GRAY2BGR), dtype=np.uint8)
    scale = factor / reduction
    for number, difference in reversed(list(enumerate(values["differences"], 1))):
        colour = _COLOURS[difference["kind"]][::-1]
        for piece in difference["pieces"]:
            points = np.rint(2**_SUB * (scale * np.array(piece) - 0.5)).astype(np.int32)
            cv2.polylines(picture, [points], False, colour, 3, cv2.LINE_AA, shift=_SUB)
        if number <= _NUMBERED:
            x, y = (round(scale * value) for value in difference["ends"][0])
            _write(picture, str(number), (x + 4, y - 4), colour)
    _legend(picture, values)
    done, content = cv2.imencode(".png", picture)
    if not done:
        raise ValueError("the picture of the check was not encoded")
    return content.tobytes()


def _legend(picture: npt.NDArray[np.uint8], values: Mapping[str, Any]) -> None:
    verdict = values["verdict"]
    _write(picture, verdict.replace("-", " "), (12, 24), _VERDICTS[verdict][::-1], 0.8)
    for row, (kind, words) in enumerate(_WORDS.items()):
        _write(picture, words, (12, 48 + 20 * row), _COLOURS[kind][::-1])


def _write(
    picture: npt.NDArray[np.uint8],
    text: str,
    place: tuple[int, int],
    colour: tuple[int, ...],
    size: float = 0.5,
) -> None:
    font = cv2.FONT_HERSHEY_SIMPLEX
    cv2.putText(picture, text, place, font, size, (255, 255, 255), 4, cv2.LINE_AA)
    cv2.putText(picture, text, place, font, size, colour, 1, cv2.LINE_AA)

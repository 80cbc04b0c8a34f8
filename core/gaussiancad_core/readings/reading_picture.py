"""``reading.png``: the sheet, pale, with its strokes in the colours of their kinds over it."""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.readings.stroke_anchors import points_of
from gaussiancad_protocol.reading_kinds import KIND_COLOURS, OTHER_COLOUR, ViewRole, rgb

_BOX, _UNUSED = (40, 160, 220), (190, 190, 190)

_PALE = 0.25
"""Share of the sheet's own darkness that is left."""

_MOST_PX = 2400
"""Longer side of the picture."""


def reading_picture(reading: SheetReading, grey: npt.NDArray[np.uint8], reduction: float) -> bytes:
    """The picture as PNG.

    Args:
        reading: of the sheet.
        grey: (h, w) uint8, the sheet.
        reduction: px of the sheet as stored per px of ``grey``.
    """
    factor = min(1.0, _MOST_PX / max(grey.shape))
    if factor < 1.0:
        small = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
        grey = np.asarray(small, dtype=np.uint8)
    levels = np.arange(256, dtype=np.float32)
    pale = np.rint(255.0 - _PALE * (255.0 - levels)).astype(np.uint8)
    picture = cv2.cvtColor(pale[grey], cv2.COLOR_GRAY2BGR)
    scale = factor / reduction
    for view in reading.views:
        x0, y0, x1, y1 = (round(scale * value) for value in view.box)
        named = view.role not in (ViewRole.IGNORE, ViewRole.PICTORIAL)
        colour = (_BOX if named else _UNUSED)[::-1]
        cv2.rectangle(picture, (x0 - 4, y0 - 4), (x1 + 4, y1 + 4), colour, 1)
        name = view.kind if view.role is ViewRole.IGNORE and view.kind else view.role.value
        place = (x0 - 2, max(12, y0 - 8))
        cv2.putText(picture, name, place, cv2.FONT_HERSHEY_SIMPLEX, 0.5, colour, 1, cv2.LINE_AA)
    for stroke in reading.strokes:
        colour = rgb(KIND_COLOURS.get(stroke.kind, OTHER_COLOUR))[::-1]
        course = np.array(stroke.line) if stroke.line is not None else points_of(stroke)
        points = np.rint(16.0 * (scale * course - 0.5)).astype(np.int32)
        if len(points):
            thick = 2 if stroke.view is not None else 1
            cv2.polylines(picture, [points], False, colour, thick, cv2.LINE_AA, shift=4)
        elif stroke.box is not None:
            x0, y0, x1, y1 = (round(scale * value) for value in stroke.box)
            cv2.rectangle(picture, (x0, y0), (x1, y1), colour, 1)
    done, content = cv2.imencode(".png", picture)
    if not done:
        raise ValueError("the picture of the reading was not encoded")
    return content.tobytes()

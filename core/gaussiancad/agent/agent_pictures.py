"""Pictures in answers: scaled so that an agent can look at them, and enlarged parts of a sheet."""

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gaussiancad import Reading
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import KIND_COLOURS, OTHER_COLOUR, rgb

if TYPE_CHECKING:
    from PIL.Image import Image

LONGEST_PX = 1600
"""Longer side of a picture: models see no more of a larger one."""

PREVIEW_PX = 1000
"""The same of a shaded part."""

_SHEET_FILE = "sheet.png"

_MOST_BYTES = 400_000
"""Of a PNG as it is; a larger one gets as few colours as a drawing needs, or becomes a JPEG."""

_COLOURS = 64

_ENLARGED = 6.0
"""Pixels of a picture per px of the sheet at most."""

_PALE = 0.35
"""Share of the ink's darkness that is left below strokes."""

_MOST_NAMED = 120
"""Strokes that have their id beside them."""

_LEAST_PX = 24.0
"""Of a part of a sheet, along each side."""

Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Picture:
    """A picture in an answer.

    Attributes:
        content: of the file.
        kind: of the file: ``image/png``, ``image/jpeg``.
        shows: what, in a few words.
    """

    content: bytes
    kind: str
    shows: str

    @property
    def base64(self) -> str:
        """The content as text."""
        return base64.b64encode(self.content).decode("ascii")


def scaled(path: Path, shows: str, longest: int = LONGEST_PX) -> Picture:
    """A picture that a run wrote, no longer than that.

    Raises:
        UnreadableError: ``file-not-readable``, it is gone or was changed.
    """
    picture = _opened(path)
    picture.thumbnail((longest, longest))
    return _encoded(picture, shows)


def enlarged(reading: Reading, box: Box, strokes: Sequence[dict[str, Any]]) -> Picture:
    """A part of a sheet, pale, with its strokes in the colours of their kinds and their ids.

    Args:
        reading: with the folder that has the sheet's picture.
        box: of the part, px of the sheet as stored.
        strokes: entries of ``reading.json``; the first of them are named.

    Raises:
        UsageError: ``wrong-usage``, the box lies outside of the sheet.
        UnreadableError: ``file-not-readable``.
    """
    from PIL import Image, ImageDraw

    assert reading.folder is not None
    sheet = _opened(reading.folder / _SHEET_FILE)
    width, height = reading.data["sheet"].get("size") or sheet.size
    x0, y0, x1, y1 = _within(box, width, height)
    factor = min(_ENLARGED, LONGEST_PX / max(x1 - x0, y1 - y0))
    size = max(1, round(factor * (x1 - x0))), max(1, round(factor * (y1 - y0)))
    drawn = sheet.width / width, sheet.height / height
    cut = (x0 * drawn[0], y0 * drawn[1], x1 * drawn[0], y1 * drawn[1])
    grey = sheet.convert("L").resize(size, Image.Resampling.BICUBIC, box=cut)
    picture = grey.point([round(255 - _PALE * (255 - level)) for level in range(256)])
    picture = picture.convert("RGB")
    _draw_strokes(ImageDraw.Draw(picture), strokes, (x0, y0), factor)
    return _encoded(picture, "part of the sheet")


def _draw_strokes(
    canvas: Any,  # noqa: ANN401
    strokes: Sequence[dict[str, Any]],
    corner: tuple[float, float],
    factor: float,
) -> None:
    import msgspec
    from PIL import ImageFont

    from gaussiancad_core.readings.reading_schema import StrokeEntry
    from gaussiancad_core.readings.stroke_anchors import points_of

    font = ImageFont.load_default(14)
    for number, values in enumerate(strokes):
        stroke = msgspec.convert(values, StrokeEntry)
        colour = rgb(KIND_COLOURS.get(stroke.kind, OTHER_COLOUR))
        points = [
            (factor * (x - corner[0]), factor * (y - corner[1]))
            for x, y in points_of(stroke).tolist()
        ]
        if points:
            canvas.line(points, fill=colour, width=2, joint="curve")
            place = points[len(points) // 2]
        elif stroke.box is not None:
            x0, y0, x1, y1 = (
                factor * (value - corner[index % 2]) for index, value in enumerate(stroke.box)
            )
            canvas.rectangle((x0, y0, x1, y1), outline=colour)
            place = x0, y0
        else:
            continue
        if number < _MOST_NAMED:
            place = place[0] + 3.0, place[1] + 2.0
            canvas.text(place, stroke.id, colour, font, stroke_width=2, stroke_fill="white")


def _within(box: Box, width: float, height: float) -> Box:
    """The part of a box that lies on the sheet, no smaller than can be seen."""
    x0, y0, x1, y1 = box
    if x1 < x0 or y1 < y0 or x1 < 0 or y1 < 0 or x0 > width or y0 > height:
        raise UsageError(
            Code.WRONG_USAGE,
            f"the box {box} is none on the sheet of {width:g} x {height:g} px: give x0, y0, x1, y1 "
            "with x0 < x1 and y0 < y1",
        )
    (x0, x1), (y0, y1) = _interval(x0, x1, width), _interval(y0, y1, height)
    return x0, y0, x1, y1


def _interval(start: float, end: float, size: float) -> tuple[float, float]:
    least = min(_LEAST_PX, size)
    grown = max(0.0, least - (end - start)) / 2.0
    start, end = max(0.0, start - grown), min(size, end + grown)
    return max(0.0, min(start, size - least)), min(size, max(end, least))


def _opened(path: Path) -> "Image":
    from PIL import Image

    try:
        picture = Image.open(path)
        picture.load()
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        raise UnreadableError(
            Code.FILE_NOT_READABLE,
            "{path} cannot be read ({reason}): read the sheet again",
            path=path,
            reason=error,
        ) from error
    return picture


def _encoded(picture: "Image", shows: str) -> Picture:
    from PIL import Image

    content = _content(picture, "PNG")
    if len(content) > _MOST_BYTES:
        few = picture.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
        content = _content(few, "PNG")
    if len(content) > _MOST_BYTES:
        return Picture(_content(picture.convert("RGB"), "JPEG"), "image/jpeg", shows)
    return Picture(content, "image/png", shows)


def _content(picture: "Image", kind: str) -> bytes:
    written = BytesIO()
    picture.save(written, kind)
    return written.getvalue()

"""PDF files of one page as CAD programs write them: pens by width, text as text."""

import zlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from math import cos, hypot, sin
from pathlib import Path

import numpy as np

from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Segment

_PT = 72.0 / 25.4
"""Points to the millimetre."""

_QUARTER = np.pi / 2.0

Point = tuple[float, float]


@dataclass(frozen=True)
class Pen:
    """A width in mm, and dashes and gaps in mm; none for solid lines."""

    width: float
    dashes: tuple[float, ...] = ()


@dataclass
class Page:
    """A sheet in mm, y up.

    Attributes:
        width, height: of the sheet in mm.
    """

    width: float
    height: float
    _marks: list[str] = field(default_factory=list)

    def strokes(self, strokes: Iterable[DrawnStroke], at: Point, scale: float, pen: Pen) -> None:
        """Lines of a view, mm of its plane times a scale, from a place on the sheet."""
        for stroke in strokes:
            if isinstance(stroke, Segment):
                self.line(*(_moved(item, at, scale) for item in (stroke.start, stroke.end)), pen)
            elif isinstance(stroke, Arc):
                self._arc(stroke, at, scale, pen)
            elif isinstance(stroke, Polyline):
                self.path([_moved(point, at, scale) for point in stroke.points], pen)

    def line(self, start: Point, end: Point, pen: Pen) -> None:
        """A line in mm of the sheet."""
        self.path([start, end], pen)

    def path(self, points: Sequence[Point], pen: Pen) -> None:
        """Lines from point to point."""
        first, *rest = (_number(*point) for point in points)
        self._draw([f"{first} m", *(f"{item} l" for item in rest)], pen)

    def filled(self, points: Sequence[Point]) -> None:
        """A filled area: an arrowhead."""
        first, *rest = (_number(*point) for point in points)
        self._marks.append(" ".join([f"{first} m", *(f"{item} l" for item in rest), "h f"]))

    def text(self, at: Point, text: str, height: float, *, upright: bool = False) -> None:
        """A text whose base line begins at a place, capitals of a height in mm."""
        turn = "0 1 -1 0" if upright else "1 0 0 1"
        size = height * _PT / 0.72
        coded = text.encode("cp1252").replace(b"\\", b"\\\\")
        coded = coded.replace(b"(", b"\\(").replace(b")", b"\\)")
        words = coded.decode("latin-1")
        self._marks.append(f"BT /F1 {size:.3f} Tf {turn} {_number(*at)} Tm ({words}) Tj ET")

    def write(self, path: Path) -> None:
        """The file."""
        content = zlib.compress("\n".join(self._marks).encode("latin-1"))
        box = f"[0 0 {self.width * _PT:.2f} {self.height * _PT:.2f}]"
        objects = [
            b"<< /Type /Catalog /Pages 2 0 R >>",
            b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
            f"<< /Type /Page /Parent 2 0 R /MediaBox {box} /Contents 4 0 R "
            "/Resources << /Font << /F1 5 0 R >> >> >>".encode(),
            b"<< /Length %d /Filter /FlateDecode >>\nstream\n%s\nendstream"
            % (len(content), content),
            b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
        ]
        data, places = b"%PDF-1.4\n", []
        for number, this_object in enumerate(objects, 1):
            places.append(len(data))
            data += b"%d 0 obj\n%s\nendobj\n" % (number, this_object)
        start = len(data)
        data += b"xref\n0 %d\n0000000000 65535 f \n" % (len(objects) + 1)
        data += b"".join(b"%010d 00000 n \n" % place for place in places)
        data += b"trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (
            len(objects) + 1,
            start,
        )
        path.write_bytes(data)

    def _arc(self, arc: Arc, at: Point, scale: float, pen: Pen) -> None:
        pieces = max(1, int(np.ceil(arc.sweep / _QUARTER - 1e-9)))
        step = arc.sweep / pieces
        pull = 4.0 / 3.0 * np.tan(step / 4.0)
        x, y = _moved(arc.centre, at, scale)
        radius = arc.radius * scale

        def on(angle: float, aside: float = 0.0) -> Point:
            return (
                x + radius * (cos(angle) - aside * sin(angle)),
                y + radius * (sin(angle) + aside * cos(angle)),
            )

        start = arc.start_angle
        marks = [f"{_number(*on(start))} m"]
        for index in range(pieces):
            one, two = start + index * step, start + (index + 1) * step
            handles = (on(one, pull), on(two, -pull), on(two))
            marks.append(" ".join(_number(*handle) for handle in handles) + " c")
        self._draw(marks, pen)

    def _draw(self, marks: Sequence[str], pen: Pen) -> None:
        dashes = " ".join(f"{dash * _PT:.3f}" for dash in pen.dashes)
        self._marks.append(f"{pen.width * _PT:.3f} w [{dashes}] 0 d {' '.join(marks)} S")


def arrow(page: Page, tip: Point, tail: Point, length: float) -> None:
    """A filled arrowhead at a tip, of a line that comes from a tail."""
    run, rise = tip[0] - tail[0], tip[1] - tail[1]
    far = hypot(run, rise)
    along, aside = (run / far, rise / far), (-rise / far, run / far)
    back = (tip[0] - length * along[0], tip[1] - length * along[1])
    half = length / 6.0
    sides = [(back[0] + s * half * aside[0], back[1] + s * half * aside[1]) for s in (1.0, -1.0)]
    page.filled([tip, *sides])


def _moved(point: Point, at: Point, scale: float) -> Point:
    return at[0] + scale * point[0], at[1] + scale * point[1]


def _number(x: float, y: float) -> str:
    return f"{x * _PT:.3f} {y * _PT:.3f}"

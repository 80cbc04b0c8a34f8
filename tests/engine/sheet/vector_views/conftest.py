"""Drawn sheets written as SVG, PDF and DXF, in the ways that CAD systems write them."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from gaussiancad_core.drawing.dash_rhythm import dash_intervals
from gaussiancad_core.drawing.drawn_sheet import Sheet, draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts import sample

DPI = 200.0
DASH, GAP = 12.0, 6.0
WIDTHS = {Linetype.VISIBLE: 3.0, Linetype.HIDDEN: 2.0}


@dataclass(frozen=True)
class FileStyle:
    """How a file writes its lines.

    Attributes:
        dashes_apart: every dash of a hidden line is a line of its own.
        parts: every line is written in this many pieces.
        centre_lines: with a cross at each circle's centre, drawn long-short.
        step: px to which a plotter rounded all points; 0 for none. In PDF files.
    """

    dashes_apart: bool = False
    parts: int = 1
    centre_lines: bool = False
    step: float = 0.0


@dataclass(frozen=True)
class Written:
    """One line of a file, in px of the sheet."""

    stroke: Segment | Arc
    dashes: tuple[float, ...]


@cache
def drawn_sheet(name: str) -> Sheet:
    """A sample part on a small sheet, in third angle."""
    look = replace(PRESETS["clean"], width=1280, height=720, margin=40.0, view_gap=60.0)
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    return draw_sheet(sample(name).build(), roles, Projection.THIRD, look)


def lines_of(sheet: Sheet, style: FileStyle) -> Iterator[Written]:
    """What a file of a sheet holds."""
    for stroke in (stroke for view in sheet.views for stroke in view.strokes):
        hidden = stroke.linetype is Linetype.HIDDEN
        if hidden and style.dashes_apart:
            for span in dash_intervals(stroke.length, DASH, GAP, stroke.is_closed):
                yield Written(stroke.part(*span), ())
            continue
        dashes = (DASH, GAP) if hidden else ()
        cuts = np.linspace(0.0, stroke.length, style.parts + 1)
        for low, high in pairwise(cuts):
            yield Written(stroke if style.parts == 1 else stroke.part(low, high), dashes)
        if style.centre_lines and isinstance(stroke, Arc) and stroke.is_closed:
            (x, y), reach = stroke.centre, 0.6 * stroke.radius
            for dx, dy in ((reach, 0.0), (0.0, reach)):
                cross = Segment((x - dx, y - dy), (x + dx, y + dy), Linetype.VISIBLE)
                yield Written(cross, (16.0, 3.0, 4.0, 3.0))


def _width(line: Written) -> float:
    return 1.4 if len(line.dashes) > 2 else WIDTHS[line.stroke.linetype]


def _svg(sheet: Sheet, style: FileStyle, path: Path) -> None:
    height, width = sheet.image.shape[:2]
    scale = 25.4 / DPI
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width * scale!r}mm" '
        f'height="{height * scale!r}mm" viewBox="0 0 {width} {height}" fill="none" stroke="#000">'
    ]
    for line in lines_of(sheet, style):
        stroke = line.stroke
        look = f'stroke-width="{_width(line)}" stroke-dasharray="{" ".join(map(str, line.dashes))}"'
        if isinstance(stroke, Segment):
            ends = (*stroke.start, *stroke.end)
            x0, y0, x1, y1 = (f"{value:.9f}" for value in ends)
            parts.append(f'<line x1="{x0}" y1="{y0}" x2="{x1}" y2="{y1}" {look}/>')
        elif stroke.is_closed:
            x, y = stroke.centre
            parts.append(f'<circle cx="{x:.9f}" cy="{y:.9f}" r="{stroke.radius:.9f}" {look}/>')
        else:
            (x0, y0), (x1, y1) = stroke.sample(1e9)[[0, -1]]
            large = int(stroke.sweep > np.pi)
            arc = f"A{stroke.radius:.9f} {stroke.radius:.9f} 0 {large} 1 {x1:.9f} {y1:.9f}"
            parts.append(f'<path d="M{x0:.9f} {y0:.9f}{arc}" {look}/>')
    path.write_text("".join(parts) + "</svg>", encoding="utf-8")


def _pdf(sheet: Sheet, style: FileStyle, path: Path) -> None:
    height, width = sheet.image.shape[:2]
    scale = 72.0 / DPI
    content = [f"{scale!r} 0 0 {-scale!r} 0 {height * scale!r} cm"]
    for line in lines_of(sheet, style):
        stroke = line.stroke
        content.append(f"{_width(line)} w [{' '.join(map(str, line.dashes))}] 0 d")
        if isinstance(stroke, Segment):
            ends = np.array([*stroke.start, *stroke.end])
            if style.step:
                ends = np.rint((ends + style.step / 3.0) / style.step) * style.step
            content.append("{:.6f} {:.6f} m {:.6f} {:.6f} l S".format(*ends))
            continue
        count = max(1, int(np.ceil(stroke.sweep / (np.pi / 2) - 1e-9)))
        handle = 4.0 / 3.0 * np.tan(stroke.sweep / count / 4.0) * stroke.radius
        angles = stroke.start_angle + stroke.sweep * np.arange(count + 1) / count
        radial = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        at = np.array(stroke.centre) + stroke.radius * radial
        along = handle * np.stack([-radial[:, 1], radial[:, 0]], axis=1)
        content.append("{:.6f} {:.6f} m".format(*at[0]))
        corners = np.concatenate([(at + along)[:-1], (at - along)[1:], at[1:]], axis=1)
        form = " ".join(["{:.6f}"] * 6) + " c"
        content += [form.format(*row) for row in corners]
        content.append("s" if stroke.is_closed else "S")
    body = "\n".join(content).encode()
    box = f"0 0 {width * scale!r} {height * scale!r}".encode()
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        b"<< /Type /Page /Parent 2 0 R /MediaBox [%s] /Contents 4 0 R >>" % box,
        b"<< /Length %d >>\nstream\n%s\nendstream" % (len(body), body),
    ]
    data = b"%PDF-1.4\n"
    table = b"0000000000 65535 f \n"
    for number, one in enumerate(objects, start=1):
        table += b"%010d 00000 n \n" % len(data)
        data += b"%d 0 obj\n%s\nendobj\n" % (number, one)
    end = b"trailer << /Size 5 /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF" % len(data)
    path.write_bytes(data + b"xref\n0 5\n" + table + end)


def _dxf(sheet: Sheet, style: FileStyle, path: Path) -> None:
    height, width = sheet.image.shape[:2]
    scale = 25.4 / DPI
    doc = ezdxf.new("R2010", units=4)
    doc.modelspace().reset_limits((0.0, 0.0), (width * scale, height * scale))
    doc.linetypes.add("HIDDEN", [(DASH + GAP) * scale, DASH * scale, -GAP * scale])
    rhythm = [26 * scale, 16 * scale, -3 * scale, 4 * scale, -3 * scale]
    doc.linetypes.add("CENTER", rhythm)
    model = doc.modelspace()

    def at(point: tuple[float, float]) -> tuple[float, float]:
        return point[0] * scale, (height - point[1]) * scale

    for line in lines_of(sheet, style):
        stroke = line.stroke
        name = {0: "Continuous", 2: "HIDDEN", 4: "CENTER"}[len(line.dashes)]
        weight = min((35, 25, 18), key=lambda value: abs(value / 100.0 - _width(line) * scale))
        look = {"linetype": name, "lineweight": weight}
        if isinstance(stroke, Segment):
            model.add_line(at(stroke.start), at(stroke.end), dxfattribs=look)
        elif stroke.is_closed:
            model.add_circle(at(stroke.centre), stroke.radius * scale, dxfattribs=look)
        else:
            # y points up there: what ran towards y runs the other way.
            first, last = (np.degrees(-(stroke.start_angle + turn)) for turn in (stroke.sweep, 0.0))
            model.add_arc(at(stroke.centre), stroke.radius * scale, first, last, dxfattribs=look)
    doc.saveas(path)


_WRITERS = {".svg": _svg, ".pdf": _pdf, ".dxf": _dxf}


@pytest.fixture
def write_sheet(tmp_path: Path) -> Callable[..., tuple[Sheet, Path]]:
    """Writes a sample's sheet to a file by its suffix; options as of :class:`FileStyle`."""

    def write(name: str, suffix: str, **options: object) -> tuple[Sheet, Path]:
        sheet = drawn_sheet(name)
        path = tmp_path / f"{name}{suffix}"
        _WRITERS[suffix](sheet, FileStyle(**options), path)
        return sheet, path

    return write

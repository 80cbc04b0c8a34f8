"""``lines.dxf`` and ``lines.svg``: what was read, as other programs see it."""

import io
from math import pi, tau
from pathlib import Path
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest
from ezdxf.document import Drawing

from gaussiancad_core.readings.cleaned_lines import UNKNOWN_SIZE, lines_dxf, lines_svg
from gaussiancad_core.readings.reading_schema import (
    SCHEMA,
    ReadProjection,
    ReadScale,
    ReadSheet,
    ReadUnit,
    SheetReading,
    StrokeEntry,
    ViewEntry,
)
from gaussiancad_core.readings.stroke_anchors import points_of
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_protocol.reading_kinds import StrokeKind, ViewRole

_MM = 0.125
"""Of a px."""

_STROKES = (
    StrokeEntry(id="1", view="a", kind=StrokeKind.VISIBLE, line=((100.0, 300.0), (500.0, 300.0))),
    StrokeEntry(id="2", view="a", kind=StrokeKind.HIDDEN, arc=(300.0, 300.0, 80.0, pi, pi / 2.0)),
    StrokeEntry(id="3", view="a", kind=StrokeKind.VISIBLE, arc=(300.0, 200.0, 40.0, 0.3, tau)),
    StrokeEntry(
        id="4", view="b", kind=StrokeKind.TANGENT, ellipse=(300.0, 500.0, 90.0, 30.0, 0.4, 0.2, 2.0)
    ),
    StrokeEntry(id="5", view="b", kind=StrokeKind.DIMENSION, line=((0.0, 0.0), (9.0, 9.0))),
    StrokeEntry(id="6", view=None, kind=StrokeKind.VISIBLE, line=((0.0, 0.0), (9.0, 9.0))),
    StrokeEntry(id="7", view=None, kind=StrokeKind.CENTRE, line=((0.0, 0.0), (9.0, 9.0))),
    StrokeEntry(id="8", view=None, kind=StrokeKind.CENTRE, line=((180.0, 500.0), (420.0, 500.0))),
)


def _reading(scale: ReadScale) -> SheetReading:
    return SheetReading(
        schema=SCHEMA,
        sheet=ReadSheet(sha256="0" * 64, size=(800, 600)),
        projection=ReadProjection(value="first", source="given"),
        unit=ReadUnit(),
        scale=scale,
        views=(
            ViewEntry(id="a", role=ViewRole.FRONT, box=(100.0, 160.0, 500.0, 300.0)),
            ViewEntry(id="b", role=ViewRole.SECTION, box=(200.0, 450.0, 400.0, 550.0)),
        ),
        strokes=_STROKES,
    )


def _known() -> SheetReading:
    return _reading(ReadScale(source="dimension", mm_per_px=_MM))


def _opened(content: bytes) -> Drawing:
    drawing = ezdxf.read(io.StringIO(content.decode("utf-8")))
    assert not drawing.audit().has_errors
    return drawing


def test_each_view_is_a_block_in_millimetres_with_a_layer_for_each_kind() -> None:
    drawing = _opened(lines_dxf(_known()))
    assert drawing.units == ezdxf.units.MM
    placed = {item.dxf.name: tuple(item.dxf.insert)[:2] for item in drawing.modelspace()}
    assert placed == {"FRONT": (100.0 * _MM, 300.0 * _MM), "SECTION": (200.0 * _MM, 50.0 * _MM)}
    line, arc, circle = drawing.blocks.get("FRONT")
    assert [item.dxf.layer for item in (line, arc, circle)] == ["VISIBLE", "HIDDEN", "VISIBLE"]
    assert tuple(line.dxf.start)[:2] == (0.0, 0.0)
    assert tuple(line.dxf.end)[:2] == (400.0 * _MM, 0.0)
    # Up and to the left on the sheet.
    assert arc.dxf.radius == 80.0 * _MM
    assert (arc.dxf.start_angle, arc.dxf.end_angle) == pytest.approx((90.0, 180.0))
    assert tuple(circle.dxf.center)[:2] == (200.0 * _MM, 100.0 * _MM)
    assert [block.dxf.layer for block in drawing.blocks.get("SECTION")] == ["TANGENT", "CENTRE"]
    patterns = {layer.dxf.name: layer.dxf.linetype.upper() for layer in drawing.layers}
    assert patterns["VISIBLE"] == patterns["TANGENT"] == "CONTINUOUS"
    assert [patterns[name] for name in ("HIDDEN", "CENTRE", "CUT")] == [
        *("DASHED", "CENTER", "DASHDOT")
    ]
    assert all(pattern in drawing.linetypes for pattern in patterns.values())


@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
def test_what_is_written_is_read_again_where_it_was(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"lines{suffix}"
    path.write_bytes((lines_dxf if suffix == ".dxf" else lines_svg)(_known()))
    image = read_sheet(path)
    assert image.vectors is not None
    found = np.concatenate([stroke.curve.sample(1.0) for stroke in image.vectors.strokes])
    drawn = np.concatenate([points_of(item) for item in (*_STROKES[:4], _STROKES[-1])])
    size = np.ptp(drawn, axis=0)
    assert np.ptp(found, axis=0) / np.ptp(drawn, axis=0) == pytest.approx(
        np.ptp(found, axis=0).max() / size.max(), rel=1e-3
    )
    scale = np.ptp(found, axis=0).max() / size.max()
    placed = (drawn - drawn.min(axis=0)) * scale + found.min(axis=0)
    apart = np.hypot(*(placed[:, None] - found[None]).transpose(2, 0, 1))
    assert apart.min(axis=1).max() < 1.0
    assert apart.min(axis=0).max() < 8.0 * scale


def test_an_unknown_size_is_said_and_px_stay_px() -> None:
    reading = _reading(ReadScale(source="default"))
    drawing = _opened(lines_dxf(reading))
    assert drawing.units == 0
    (text,) = drawing.modelspace().query("TEXT")
    assert text.dxf.text == UNKNOWN_SIZE
    assert tuple(drawing.blocks.get("FRONT")[0].dxf.end)[:2] == (400.0, 0.0)
    root = ElementTree.fromstring(lines_svg(reading))
    assert root.findtext("{http://www.w3.org/2000/svg}desc") == UNKNOWN_SIZE
    assert root.get("width") == "800"


def test_a_length_along_an_axis_tells_the_scale() -> None:
    reading = _reading(ReadScale(source="given", axis="x", length_mm=40.0))
    line = _opened(lines_dxf(reading)).blocks.get("FRONT")[0]
    assert tuple(line.dxf.end)[:2] == (40.0, 0.0)


def test_the_same_reading_gives_the_same_bytes() -> None:
    assert lines_dxf(_known()) == lines_dxf(_known())
    assert lines_svg(_known()) == lines_svg(_known())


def test_a_reading_without_views_gives_empty_files() -> None:
    empty = SheetReading(
        schema=SCHEMA,
        sheet=ReadSheet(sha256="0" * 64),
        projection=ReadProjection(value="third", source="default"),
        unit=ReadUnit(),
        scale=ReadScale(source="default"),
    )
    assert len(_opened(lines_dxf(empty)).modelspace().query("INSERT")) == 0
    assert ElementTree.fromstring(lines_svg(empty)).find("{http://www.w3.org/2000/svg}g") is None

import itertools
from collections.abc import Callable
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from ezdxf.document import Drawing
from ezdxf.enums import TextEntityAlignment
from ezdxf.math import OCS

from gaussiancad_core.errors import GaussianCadError, LimitError, UnreadableError
from gaussiancad_core.files.content import DEEPEST, LONGEST_TEXT, FileContent
from gaussiancad_core.files.dxf import read_dxf
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment

MM = 200.0 / 25.4
TURN = 2.0 * np.pi

LINETYPES = {
    "HIDDEN": (6.35, -3.175),
    "HIDDEN2": (3.175, -1.5875),
    "DASHED": (12.7, -6.35),
    "CENTER": (31.75, -6.35, 6.35, -6.35),
    "DASHDOT": (12.7, -6.35, 0.0, -6.35),
    "PHANTOM": (31.75, -6.35, 6.35, -6.35, 6.35, -6.35),
    "DIVIDE": (12.7, -6.35, 0.0, -6.35, 0.0, -6.35),
}
"""Those of CAD systems, in mm: dashes, and gaps as negative numbers."""

Read = Callable[[Drawing], FileContent]


def _a4(unit: int = 4, per_unit: float = 1.0) -> Drawing:
    """An empty drawing on A4, in a unit of so many to a millimetre."""
    doc = ezdxf.new("R2010")
    for name, lengths in LINETYPES.items():
        doc.linetypes.add(name, [sum(abs(v) for v in lengths), *lengths])
    doc.header["$INSUNITS"] = unit
    doc.modelspace().reset_limits((0, 0), (297 * per_unit, 210 * per_unit))
    return doc


@pytest.fixture
def read(tmp_path: Path) -> Read:
    def save_and_read(doc: Drawing) -> FileContent:
        doc.saveas(tmp_path / "sheet.dxf")
        return read_dxf(tmp_path / "sheet.dxf", 1)

    return save_and_read


def _px(*points: tuple[float, float]) -> np.ndarray:
    """Millimetres of A4 in sheet px."""
    return np.array([(x * MM, (210 - y) * MM) for x, y in points])


def _rest(content: FileContent) -> tuple[VectorStroke, ...]:
    """The strokes without the frame that makes the drawing as large as its paper."""
    return tuple(stroke for stroke in content.vectors.strokes if stroke.layer != "FRAME")


def _framed(doc: Drawing) -> Drawing:
    doc.modelspace().add_line((5, 5), (292, 205), dxfattribs={"layer": "FRAME"})
    return doc


def test_curves_are_exact_at_200_dpi(read: Read) -> None:
    doc = _framed(_a4())
    model = doc.modelspace()
    model.add_line((10, 20), (90, 30))
    model.add_circle((50, 60), 20)
    model.add_arc((100, 100), 30, 20, 110)
    model.add_ellipse((200, 100), (40, 10), 0.25)
    model.add_ellipse((200, 100), (40, 0), 0.5, 0.3, 2.1)
    content = read(doc)
    assert content.grey.shape == (1654, 2339)
    assert content.pixels_per_inch == 200.0
    assert content.notes == ()
    line, circle, arc, ellipse, piece = (stroke.curve for stroke in _rest(content))
    assert np.allclose([line.start, line.end], _px((10, 20), (90, 30)))
    tolerance = 1e-6 * 2339
    assert isinstance(circle, CircularArc)
    assert np.allclose(circle.centre, _px((50, 60))[0], atol=tolerance)
    assert circle.radius == pytest.approx(20 * MM, abs=tolerance)
    assert circle.sweep == TURN
    assert isinstance(arc, CircularArc)
    assert arc.sweep == pytest.approx(np.radians(90))
    # Clockwise to the eye is towards y: it starts where the file's arc ends.
    assert arc.start_angle == pytest.approx(np.radians(360 - 110))
    assert isinstance(ellipse, EllipticArc)
    assert ellipse.semi_major == pytest.approx(np.hypot(40, 10) * MM)
    assert ellipse.semi_minor == pytest.approx(0.25 * ellipse.semi_major)
    t = np.linspace(0.3, 2.1, 7)
    exact = _px(*zip(200 + 40 * np.cos(t), 100 + 20 * np.sin(t), strict=True))
    sampled = piece.sample(0.02)
    nearest = np.sqrt(((exact[:, None] - sampled[None]) ** 2).sum(axis=2).min(axis=1))
    assert nearest.max() < 0.01
    assert np.allclose(sampled[[-1, 0]], exact[[0, -1]])


def test_polylines_with_bulges(read: Read) -> None:
    doc = _framed(_a4())
    points = [(20, 20, 0.0), (60, 20, 1.0), (60, 50, 0.0), (20, 50, -0.4142135623730951)]
    doc.modelspace().add_lwpolyline(points, format="xyb", close=True)
    doc.modelspace().add_polyline2d([(100, 20), (150, 20), (150, 60)])
    strokes = [stroke.curve for stroke in _rest(read(doc))]
    assert [type(curve) for curve in strokes] == [
        LineSegment,
        CircularArc,
        LineSegment,
        CircularArc,
        LineSegment,
        LineSegment,
    ]
    half, quarter = strokes[1], strokes[3]
    assert half.radius == pytest.approx(15 * MM)
    assert half.sweep == pytest.approx(np.pi)
    assert np.allclose(half.centre, _px((60, 35))[0])
    assert quarter.radius == pytest.approx(30 / np.sqrt(2) * MM)
    assert quarter.sweep == pytest.approx(np.pi / 2)
    assert np.allclose(quarter.centre, _px((5, 35))[0])


def test_splines_that_are_arcs_lines_and_ellipses(read: Read) -> None:
    doc = _framed(_a4())
    model = doc.modelspace()
    model.add_rational_spline(
        [(60, 40), (60, 60), (40, 60)], weights=[1, np.sqrt(0.5), 1], degree=2
    )
    model.add_open_spline([(10, 10), (20, 15), (30, 20), (40, 25)])
    model.add_rational_spline(
        [(220, 40), (220, 60), (180, 60)], weights=[1, np.sqrt(0.5), 1], degree=2
    )
    model.add_open_spline([(100, 10), (120, 60), (140, -30), (180, 20)])
    rational, straight, ellipse, free = (s.curve for s in _rest(read(doc)))
    assert isinstance(rational, CircularArc)
    assert np.allclose(rational.centre, _px((40, 40))[0], atol=1e-3)
    assert rational.radius == pytest.approx(20 * MM, abs=1e-3)
    assert isinstance(straight, LineSegment)
    assert isinstance(ellipse, EllipticArc)
    assert np.allclose(ellipse.centre, _px((180, 40))[0], atol=1e-3)
    assert ellipse.semi_minor == pytest.approx(0.5 * ellipse.semi_major, rel=1e-6)
    assert isinstance(free, Chain)


def test_of_a_text_without_end_its_beginning_is_read(read: Read) -> None:
    doc = _a4()
    doc.modelspace().add_line((10, 10), (90, 60))
    doc.modelspace().add_text("M" * 1_000_000)
    doc.modelspace().add_mtext("M\\P" * 100_000)
    texts = read(doc).vectors.texts
    assert max(len(text.text) for text in texts) == LONGEST_TEXT
    assert len(texts) == LONGEST_TEXT + 1


def test_of_a_paragraph_of_endless_format_codes_its_beginning_is_read(read: Read) -> None:
    """Their removal takes the square of their number."""
    doc = _a4()
    doc.modelspace().add_line((10, 10), (90, 60))
    doc.modelspace().add_mtext("PLATE" + "{\\H2;" * 200_000)
    assert [text.text for text in read(doc).vectors.texts] == ["PLATE"]


def _part(doc: Drawing) -> None:
    for corners in ([(20, 20), (80, 20), (80, 60), (20, 60)], [(20, 80), (80, 80), (80, 110)]):
        for start, end in itertools.pairwise(corners):
            doc.modelspace().add_line(start, end)


@pytest.mark.parametrize("unit", [0, 4])
@pytest.mark.parametrize("far", [1e4, 1e9])
@pytest.mark.parametrize("is_through", [False, True])
def test_a_stroke_at_an_absurd_place_is_none_of_the_drawing(
    read: Read, unit: int, far: float, is_through: bool
) -> None:
    doc = _a4(unit)
    _part(doc)
    without = read(doc)
    # What goes through a drawing is left out where the drawing would be a dot beside it.
    far = max(far, 1e6) if is_through else far
    doc.modelspace().add_line((20, 20) if is_through else (far, far), (far + 5, far))
    content = read(doc)
    assert content.vectors == without.vectors
    assert np.array_equal(content.grey, without.grey)
    (note,) = (note for note in content.notes if note.code == "lines-left-out")
    assert note.message.args["count"] == 1 and not note.is_doubt


def test_blocks_are_taken_apart(read: Read) -> None:
    doc = _framed(_a4())
    block = doc.blocks.new("PART")
    block.add_circle((0, 0), 5)
    block.add_line((0, 0), (10, 0), dxfattribs={"linetype": "BYBLOCK"})
    outer = doc.blocks.new("OUTER")
    outer.add_blockref("PART", (10, 0), dxfattribs={"linetype": "HIDDEN"})
    model = doc.modelspace()
    look = {"xscale": 2, "yscale": 2, "rotation": 90}
    model.add_blockref("OUTER", (100, 50), dxfattribs=look)
    model.add_blockref("PART", (200, 50), dxfattribs={"xscale": 3, "yscale": 1})
    grid = {"row_count": 2, "column_count": 3, "row_spacing": 20, "column_spacing": 30}
    model.add_blockref("PART", (100, 120), dxfattribs=grid)
    strokes = _rest(read(doc))
    circle, line, stretched = (stroke.curve for stroke in strokes[:3])
    assert np.allclose(circle.centre, _px((100, 70))[0])
    assert circle.radius == pytest.approx(10 * MM)
    assert np.allclose([line.start, line.end], _px((100, 70), (100, 90)))
    assert strokes[1].role is StrokeRole.HIDDEN
    assert strokes[0].role is StrokeRole.VISIBLE
    assert {stroke.kind for stroke in strokes} == {StrokeKind.BLOCK}
    assert isinstance(stretched, EllipticArc)
    centres = {tuple(np.round(s.curve.centre, 6)) for s in strokes[4::2]}
    cells = [(100 + 30 * i, 120 + 20 * j) for i in range(3) for j in range(2)]
    assert centres == {tuple(np.round(point, 6)) for point in _px(*cells)}


@pytest.mark.parametrize("through", ["entity", "layer", "block", "other name"])
def test_linetypes(read: Read, through: str) -> None:
    doc = _framed(_a4())
    block = doc.blocks.new("B")
    block.add_line((10, 20), (90, 20), dxfattribs={"linetype": "BYBLOCK"})
    model = doc.modelspace()
    for name, lengths in LINETYPES.items():
        if through == "block":
            model.add_blockref("B", (0, 0), dxfattribs={"linetype": name})
            continue
        if through == "layer":
            doc.layers.add(f"L {len(doc.layers)}", linetype=name)
            look = {"layer": f"L {len(doc.layers) - 1}"}
        elif through == "other name":
            mine = f"MY {len(doc.linetypes)}"
            # One that ends in the dash that it begins with is the same.
            halves = (lengths[0] / 2, *lengths[1:], lengths[0] / 2)
            doc.linetypes.add(mine, [sum(abs(v) for v in halves), *halves])
            look = {"linetype": mine}
        else:
            look = {"linetype": name}
        model.add_line((10, 20), (90, 20), dxfattribs=look)
    strokes = _rest(read(doc))
    hidden, centre, other = StrokeRole.HIDDEN, StrokeRole.CENTRE, StrokeRole.OTHER
    roles = [hidden, hidden, hidden, centre, centre, other, other]
    assert [stroke.role for stroke in strokes] == roles
    for stroke, lengths in zip(strokes, LINETYPES.values(), strict=True):
        assert np.allclose(stroke.dashes, np.abs(lengths) * MM)


def test_the_dashes_are_scaled_and_drawn(read: Read) -> None:
    doc = _framed(_a4())
    doc.header["$LTSCALE"] = 2.0
    look = {"linetype": "HIDDEN", "ltscale": 3.0}
    doc.modelspace().add_line((10, 20), (190, 20), dxfattribs=look)
    content = read(doc)
    (stroke,) = _rest(content)
    pattern = np.abs(LINETYPES["HIDDEN"]) * 6
    assert np.allclose(stroke.dashes, pattern * MM)
    row = content.grey[int(190 * MM), int(11 * MM) : int(189 * MM)] < 128
    assert row.mean() == pytest.approx(pattern[0] / pattern.sum(), abs=0.05)
    starts = np.flatnonzero(row[1:] & ~row[:-1])
    assert np.allclose(np.diff(starts), pattern.sum() * MM, atol=1.01)


def test_layers_tell_what_solid_lines_are(read: Read) -> None:
    doc = _framed(_a4())
    names = {
        "虚线层": StrokeRole.HIDDEN,
        "中心线层": StrokeRole.CENTRE,
        "Verdeckte Kanten": StrokeRole.HIDDEN,
        "DIM": StrokeRole.OTHER,
        "轮廓实线层": StrokeRole.VISIBLE,
        "7": StrokeRole.VISIBLE,
    }
    for name in names:
        doc.layers.add(name)
        doc.modelspace().add_line((10, 20), (90, 20), dxfattribs={"layer": name})
    strokes = _rest(read(doc))
    assert [stroke.layer for stroke in strokes] == list(names)
    assert [stroke.role for stroke in strokes] == list(names.values())


def test_line_weights(read: Read) -> None:
    doc = _framed(_a4())
    doc.layers.add("THICK", lineweight=70)
    model = doc.modelspace()
    model.add_line((10, 20), (90, 20), dxfattribs={"lineweight": 35})
    model.add_line((10, 30), (90, 30), dxfattribs={"layer": "THICK"})
    model.add_line((10, 40), (90, 40))
    model.add_lwpolyline([(10, 50), (90, 50)], dxfattribs={"const_width": 1.5})
    item, layer, default, wide = (stroke.width for stroke in _rest(read(doc)))
    assert item == pytest.approx(0.35 * MM)
    assert layer == pytest.approx(0.7 * MM)
    assert default is None
    assert wide == pytest.approx(1.5 * MM)


def test_colours(read: Read) -> None:
    doc = _a4()
    doc.layers.add("green", color=3)
    doc.layers.add("own").rgb = (10, 20, 30)
    block = doc.blocks.new("part")
    block.add_line((0, 0), (10, 0), dxfattribs={"color": 0})
    msp = doc.modelspace()
    expected = []
    for attributes, colour in (
        ({}, (0, 0, 0)),
        ({"color": 1}, (255, 0, 0)),
        ({"color": 7}, (0, 0, 0)),
        ({"layer": "green"}, (0, 255, 0)),
        ({"layer": "own"}, (10, 20, 30)),
        ({"layer": "green", "color": 5}, (0, 0, 255)),
        ({"true_color": 0x123456}, (0x12, 0x34, 0x56)),
    ):
        msp.add_line(
            (20, 20 + 5 * len(expected)), (60, 20 + 5 * len(expected)), dxfattribs=attributes
        )
        expected.append(colour)
    msp.add_blockref("part", (100, 100), dxfattribs={"color": 6})
    found = read(doc).vectors.strokes
    assert [stroke.colour for stroke in found] == [*expected, (255, 0, 255)]


def test_what_is_not_printed_is_left_out(read: Read) -> None:
    doc = _framed(_a4())
    for name in ("OFF", "FROZEN", "SILENT"):
        doc.layers.add(name)
    doc.layers.get("OFF").off()
    doc.layers.get("FROZEN").freeze()
    doc.layers.get("SILENT").dxf.plot = 0
    model = doc.modelspace()
    for name in ("OFF", "FROZEN", "SILENT", "Defpoints"):
        model.add_line((10, 20), (90, 20), dxfattribs={"layer": name})
    model.add_line((10, 20), (90, 20), dxfattribs={"invisible": 1})
    model.add_point((10, 10))
    assert _rest(read(doc)) == ()


def test_annotations_are_told_apart(read: Read) -> None:
    doc = _framed(_a4())
    model = doc.modelspace()
    model.add_linear_dim(base=(50, 40), p1=(20, 20), p2=(80, 20)).render()
    model.add_leader([(100, 100), (120, 120), (140, 120)])
    hatch = model.add_hatch()
    hatch.set_pattern_fill("ANSI31", scale=2)
    hatch.paths.add_polyline_path([(200, 50), (240, 50), (240, 90), (200, 90)])
    model.add_solid([(150, 20), (160, 20), (155, 30)])
    content = read(doc)
    kinds = [stroke.kind for stroke in _rest(content)]
    assert kinds.count(StrokeKind.DIMENSION) >= 3
    assert kinds.count(StrokeKind.LEADER) >= 2
    assert kinds.count(StrokeKind.HATCH) > 5
    assert kinds.count(StrokeKind.FILL) >= 1
    assert StrokeKind.GEOMETRY not in kinds
    assert "60" in [text.text for text in content.vectors.texts]


def test_texts_have_boxes(read: Read) -> None:
    doc = _framed(_a4())
    model = doc.modelspace()
    model.add_text("25.4", height=5).set_placement(
        (100, 100), align=TextEntityAlignment.MIDDLE_CENTER
    )
    model.add_text("R8", height=5, rotation=90).set_placement((200, 50))
    model.add_mtext("one\\Ptwo", dxfattribs={"char_height": 4, "insert": (20, 180)})
    content = read(doc)
    middle, upwards, one, two = content.vectors.texts
    assert [text.text for text in content.vectors.texts] == ["25.4", "R8", "one", "two"]
    box = np.array(middle.box)
    assert np.allclose((box[:2] + box[2:]) / 2, _px((100, 100))[0])
    assert box[3] - box[1] == pytest.approx(5 * MM)
    assert upwards.angle == pytest.approx(-np.pi / 2)
    x0, y0, x1, y1 = upwards.box
    assert (x1, y1) == pytest.approx(tuple(_px((200, 50))[0]))
    assert (x1 - x0) < (y1 - y0)
    assert one.box[1] == pytest.approx(30 * MM)
    assert two.box[1] > one.box[3]
    for text in content.vectors.texts:
        x0, y0, x1, y1 = (round(value) for value in text.box)
        assert (content.grey[y0:y1, x0:x1] < 128).mean() > 0.05


@pytest.mark.parametrize("font", ["\\Fgdt;", "\\fAIGDT|b0|i0|c0|p0;", "\\FAMGDT|c0;"])
def test_letters_of_a_font_of_signs_are_these_signs(read: Read, font: str) -> None:
    doc = _framed(_a4())
    text = f"{{{font}n}}8 {{{font}x}}12\\P{{{font}v}} {{{font}n}}14\\P{{{font}w}}9 next"
    doc.modelspace().add_mtext(text, dxfattribs={"char_height": 4, "insert": (20, 180)})
    lines = [text.text for text in read(doc).vectors.texts]
    assert lines == ["\u23008 \u21a712", "\u2334 \u230014", "\u23359 next"]


def test_tilted_circles_are_ellipses(read: Read) -> None:
    doc = _framed(_a4())
    model = doc.modelspace()
    for axis in ((0, 1, 1), (0, 1, 0)):
        centre = OCS(axis).from_wcs((150, 100, 0))
        model.add_circle(centre, 20, dxfattribs={"extrusion": axis})
    model.add_arc((-100, 50), 20, 0, 90, dxfattribs={"extrusion": (0, 0, -1)})
    ellipse, edge, mirrored = (stroke.curve for stroke in _rest(read(doc)))
    assert isinstance(ellipse, EllipticArc)
    assert ellipse.semi_minor == pytest.approx(np.sqrt(0.5) * ellipse.semi_major)
    assert np.allclose(ellipse.centre, _px((150, 100))[0])
    assert np.allclose(mirrored.centre, _px((100, 50))[0])
    ends = mirrored.sample(np.inf)[[0, -1]]
    assert np.allclose(sorted(map(tuple, ends)), sorted(map(tuple, _px((80, 50), (100, 70)))))
    assert isinstance(edge, LineSegment)
    assert edge.length == pytest.approx(40 * MM)


@pytest.mark.parametrize(
    ("unit", "per_mm"), [(4, 1.0), (5, 0.1), (1, 1 / 25.4), (6, 1e-3), (9, 1000 / 25.4)]
)
def test_units(read: Read, unit: int, per_mm: float) -> None:
    doc = _a4(unit, per_mm)
    doc.modelspace().add_line((5 * per_mm, 5 * per_mm), (292 * per_mm, 205 * per_mm))
    content = read(doc)
    assert content.grey.shape == (1654, 2339)
    assert content.pixels_per_inch == 200.0
    (stroke,) = content.vectors.strokes
    assert np.allclose([stroke.curve.start, stroke.curve.end], _px((5, 5), (292, 205)))


@pytest.mark.parametrize(
    ("unit", "metric", "size", "shape"),
    [
        # A unit that is not named: millimetres if they make a paper, or inches, or none at all.
        (0, 1, 200.0, (158, 1575)),
        (0, 0, 20.0, (400, 4000)),
        # Metres that only a library's default says.
        (6, 1, 200.0, (158, 1575)),
        (0, 1, 1e7, (300, 3000)),
    ],
)
def test_a_unit_that_is_not_named_is_not_known(
    read: Read, unit: int, metric: int, size: float, shape: tuple[int, int]
) -> None:
    doc = _a4(unit)
    doc.header["$MEASUREMENT"] = metric
    doc.modelspace().reset_limits((0, 0), (size, size / 10))
    doc.modelspace().add_line((0, 0), (size, size / 10))
    content = read(doc)
    assert content.grey.shape == shape
    assert content.pixels_per_inch is None
    assert content.vectors.unit_mm is None
    assert [note.code for note in content.notes] == ["paper-size-unknown"]


@pytest.mark.parametrize("unit, millimetres", [(1, 25.4), (4, 1.0), (5, 10.0), (6, 1000.0)])
@pytest.mark.parametrize("size_mm", [1.8, 45.0, 300.0, 9e3])
def test_a_unit_that_is_named_is_kept_at_any_size(
    read: Read, unit: int, millimetres: float, size_mm: float
) -> None:
    doc = _a4(unit)
    size = size_mm / millimetres
    doc.modelspace().add_lwpolyline([(0, 0), (size, 0), (size, size / 2)], close=True)
    doc.modelspace().add_line((0, 0), (0, size), dxfattribs={"lineweight": 100})
    content = read(doc)
    lengths = [
        stroke.curve.length * 25.4 / content.pixels_per_inch for stroke in content.vectors.strokes
    ]
    assert lengths[0] == pytest.approx(size_mm)
    assert content.vectors.unit_mm == pytest.approx(millimetres)
    assert "paper-size-unknown" not in {note.code for note in content.notes}
    # A pen of 1 mm is none on what is drawn twenty times as large as paper, or as small.
    is_paper = 50.8 <= max(content.grey.shape) * 25.4 / content.pixels_per_inch <= 2641.6
    assert (content.vectors.strokes[-1].width is not None) == is_paper


def test_notes_beside_a_drawing_without_paper_are_on_its_sheet(read: Read) -> None:
    doc = _a4()
    model = doc.modelspace()
    model.add_lwpolyline([(0, 0), (60, 0), (60, 40), (0, 40)], close=True)
    for text, place in (("t=3", (0, -12)), ("part 7", (70, 20)), ("far away", (0, 400))):
        model.add_text(text, height=4).set_placement(place)
    content = read(doc)
    height, width = content.grey.shape
    *near, far = (this_text.box for this_text in content.vectors.texts)
    for x0, y0, x1, y1 in near:
        assert 0.0 < x0 < x1 < width
        assert 0.0 < y0 < y1 < height
    assert far[3] < 0.0
    assert not content.vectors.has_paper
    assert content.vectors.strokes[0].curve.length == pytest.approx(60 * MM)


def test_a_long_note_does_not_make_the_drawing_small(read: Read) -> None:
    doc = _a4()
    model = doc.modelspace()
    model.add_lwpolyline([(0, 0), (100, 0), (100, 50), (0, 50)], close=True)
    model.add_text("x" * 2000, height=3).set_placement((0, -12))
    width = 1.1 * 200.0
    assert read(doc).grey.shape[1] == pytest.approx(width * MM, abs=1.0)


def test_without_limits_the_drawing_gets_a_margin(read: Read) -> None:
    doc = _a4()
    doc.modelspace().reset_limits((0, 0), (12, 9))
    doc.modelspace().add_line((1000, 1000), (1100, 1050))
    content = read(doc)
    assert content.grey.shape == (int(np.ceil(60 * MM)), int(np.ceil(110 * MM)))
    (stroke,) = content.vectors.strokes
    assert np.allclose(stroke.curve.start, (5 * MM, 55 * MM))


@pytest.mark.parametrize("start", [(0, 0), (0, 20), (20, 0), (-0.05, 20)])
def test_a_drawing_at_some_edges_of_its_paper_was_not_drawn_for_it(
    read: Read, start: tuple[float, float]
) -> None:
    doc = _a4()
    doc.modelspace().add_lwpolyline(
        [start, (100, start[1]), (100, 100), (start[0], 100)], close=True
    )
    content = read(doc)
    ink = content.grey < 128
    assert not (ink[:10].any() or ink[-10:].any() or ink[:, :10].any() or ink[:, -10:].any())
    rows, columns = np.nonzero(ink)
    assert columns.max() - columns.min() == pytest.approx((100 - start[0]) * MM, abs=3)
    assert rows.max() - rows.min() == pytest.approx((100 - start[1]) * MM, abs=3)


def test_a_drawing_may_reach_over_its_paper_a_little(read: Read) -> None:
    doc = _framed(_a4())
    doc.modelspace().add_line((10, 211), (90, 211))
    content = read(doc)
    (stroke,) = _rest(content)
    assert 0.5 < stroke.curve.start[1] < 2.0
    assert stroke.curve.start[0] == pytest.approx(10 * MM)
    assert content.grey[int(stroke.curve.start[1]), int(50 * MM)] < 128


def test_paper_layouts_are_pages(tmp_path: Path) -> None:
    doc = _a4()
    doc.modelspace().add_circle((100, 100), 50)
    paper = doc.layout("Layout1")
    paper.page_setup(size=(420, 297), margins=(0, 0, 0, 0), units="mm")
    paper.add_line((10, 10), (410, 287))
    paper.add_viewport(
        center=(200, 150), size=(200, 200), view_center_point=(100, 100), view_height=400
    )
    doc.saveas(tmp_path / "a.dxf")
    (model,) = read_dxf(tmp_path / "a.dxf", 1).vectors.strokes
    assert model.curve.radius == pytest.approx(50 * MM)
    content = read_dxf(tmp_path / "a.dxf", 2)
    assert content.grey.shape == (int(np.ceil(297 * MM)), int(np.ceil(420 * MM)))
    line, circle = content.vectors.strokes
    assert np.allclose(line.curve.start, (10 * MM, 287 * MM))
    assert circle.curve.radius == pytest.approx(25 * MM)
    assert np.allclose(circle.curve.centre, (200 * MM, 147 * MM))
    with pytest.raises(UnreadableError, match="2 page") as caught:
        read_dxf(tmp_path / "a.dxf", 3)
    assert caught.value.code == "page-missing"


@pytest.mark.parametrize("version", ["R12", "R2000", "R2018"])
@pytest.mark.parametrize("binary", [False, True])
def test_versions(tmp_path: Path, version: str, binary: bool) -> None:
    doc = ezdxf.new(version)
    doc.modelspace().add_circle((100, 100), 50)
    doc.saveas(tmp_path / "a.dxf", fmt="bin" if binary else "asc")
    (stroke,) = read_dxf(tmp_path / "a.dxf", 1).vectors.strokes
    assert stroke.curve.radius == pytest.approx(50 * MM)


def test_broken_files_are_read_as_far_as_possible(tmp_path: Path) -> None:
    doc = _framed(_a4())
    doc.modelspace().add_circle((100, 100), 50)
    path = tmp_path / "a.dxf"
    doc.saveas(path)
    lines = path.read_text().splitlines()
    # The last sections are missing.
    end = max(i for i, line in enumerate(lines) if line == "OBJECTS") - 3
    path.write_text("\n".join(lines[:end]))
    assert len(read_dxf(path, 1).vectors.strokes) == 2


def _with_entity(path: Path, tags: list[str]) -> None:
    """Put an entity of some tags at the end of a text file's model space."""
    text = path.read_text()
    start = text.index("ENTITIES")
    end = text.index("  0\nENDSEC", start)
    path.write_text(text[:end] + "\n".join(tags) + "\n" + text[end:])


_TABLE = ["  0", "ACAD_TABLE", "  5", "FFF1", "100", "AcDbEntity", "  8", "0"]
_TABLE += ["100", "AcDbBlockReference", "  2", "*T1", " 10", "110.0", " 20", "125.0"]
_TABLE += ["100", "AcDbTable", " 91", "3", " 92", "2"]
_CURVE = ["  0", "SPLINE", "  5", "FFF2", "100", "AcDbEntity", "  8", "0", "100", "AcDbSpline"]
_CURVE += [" 71", "3", " 73", "1", " 10", "1.0", " 20", "1.0"]


def _entity(kind: str, subclass: str, tags: str) -> list[str]:
    """An entity of codes and values in turn."""
    head = ["  0", kind, "  5", "FFF3", "100", "AcDbEntity", "  8", "0", "100", subclass]
    return [*head, *tags.split()]


_ENDLESS = "10 50.0 20 50.0 30 0.0 11 1.0 21 0.0 31 0.0"


@pytest.mark.parametrize(
    ("tags", "kinds", "is_doubt"),
    [
        (_TABLE, "1 ACAD_TABLE", False),
        (_TABLE + _TABLE, "2 ACAD_TABLE", False),
        (_CURVE, "1 SPLINE", True),
        (_CURVE + _TABLE, "1 ACAD_TABLE, 1 SPLINE", True),
        (_entity("LINE", "AcDbLine", "10 20.0 20 30.0 11 nan 21 40.0"), "1 LINE", True),
        (_entity("LINE", "AcDbLine", "10 20.0 20 30.0 11 1e999 21 40.0"), "1 LINE", True),
        (_entity("CIRCLE", "AcDbCircle", "10 20.0 20 30.0 40 nan"), "1 CIRCLE", True),
        (
            _entity("LWPOLYLINE", "AcDbPolyline", "90 2 70 0 10 20.0 20 30.0 10 nan 20 30.0"),
            "1 LWPOLYLINE",
            True,
        ),
        (
            _entity("SOLID", "AcDbTrace", "10 20.0 20 30.0 11 inf 21 0.0 12 20.0 22 50.0"),
            "1 SOLID",
            True,
        ),
        (_entity("TEXT", "AcDbText", "10 nan 20 30.0 40 5.0 1 t=3"), "1 TEXT", False),
        (_entity("XLINE", "AcDbXline", _ENDLESS), "1 XLINE", False),
        (_entity("RAY", "AcDbRay", _ENDLESS), "1 RAY", False),
        (_entity("GEARWHEEL", "AcDbGearwheel", "10 20.0 20 30.0"), "1 GEARWHEEL", True),
        (_entity("ACAD_PROXY_ENTITY", "AcDbProxy", "90 498"), "1 ACAD_PROXY_ENTITY", True),
    ],
)
def test_entities_that_cannot_be_read_are_left_out_and_said(
    tmp_path: Path, tags: list[str], kinds: str, is_doubt: bool
) -> None:
    doc = _framed(_a4())
    doc.modelspace().add_circle((100, 100), 50)
    path = tmp_path / "a.dxf"
    doc.saveas(path)
    whole = read_dxf(path, 1)
    _with_entity(path, tags)
    content = read_dxf(path, 1)
    assert content.vectors == whole.vectors
    (note,) = content.notes
    assert (note.code, note.message.args["kinds"]) == ("entities-left-out", kinds)
    assert note.is_doubt is is_doubt


def test_filled_shapes_without_a_picture_are_left_out_and_said(read: Read) -> None:
    doc = _framed(_a4())
    doc.modelspace().add_mpolygon().paths.add_polyline_path([(20, 20), (90, 20), (90, 60)])
    (note,) = read(doc).notes
    assert (note.message.args["kinds"], note.is_doubt) == ("1 MPOLYGON", True)


def test_lines_of_several_strands_are_drawn(read: Read) -> None:
    doc = _framed(_a4())
    doc.modelspace().add_mline([(20, 20), (90, 20)], dxfattribs={"scale_factor": 5.0})
    content = read(doc)
    assert [type(item.curve) for item in _rest(content)] == [LineSegment, LineSegment]
    assert content.notes == ()


def _many(count: int) -> bytes:
    line = b"  0\nLINE\n  8\n0\n 10\n0.0\n 20\n0.0\n 11\n5.0\n 21\n9.0\n"
    return b"  0\nSECTION\n  2\nENTITIES\n" + line * count + b"  0\nENDSEC\n  0\nEOF\n"


BAD: list[tuple[str, bytes, type[GaussianCadError]]] = [
    ("damaged-dxf", b"this is text", UnreadableError),
    ("damaged-dxf", b"\x00\x01\x02\x03" * 100, UnreadableError),
    ("damaged-dxf", b"AutoCAD Binary DXF\r\n\x1a\x00broken", UnreadableError),
    ("empty-drawing", _many(0), UnreadableError),
    ("too-many-elements", _many(1_000_000), LimitError),
]


@pytest.mark.parametrize(("code", "data", "error"), BAD)
def test_bad_files(save: Callable, code: str, data: bytes, error: type) -> None:
    path = save("bad.dxf", data)
    with pytest.raises(error) as caught:
        read_dxf(path, 1)
    assert caught.value.code == code
    assert str(path) in caught.value.message
    assert "\n" not in caught.value.message


def test_blocks_in_blocks_are_bounded(read: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gaussiancad_core.files.dxf_entities.MAX_ELEMENTS", 2000)
    doc = _a4()
    doc.blocks.new("B0").add_line((0, 0), (1, 1))
    for level in range(6):
        block = doc.blocks.new(f"B{level + 1}")
        for column in range(10):
            block.add_blockref(f"B{level}", (column, 0))
    doc.modelspace().add_blockref("B6", (0, 0))
    with pytest.raises(LimitError) as caught:
        read(doc)
    assert caught.value.code == "too-many-elements"


@pytest.mark.parametrize("times", [1, 3])
def test_blocks_that_hold_themselves_end(
    read: Read, monkeypatch: pytest.MonkeyPatch, times: int
) -> None:
    monkeypatch.setattr("gaussiancad_core.files.dxf_entities.MAX_ELEMENTS", 2000)
    doc = _a4()
    block = doc.blocks.new("A")
    block.add_line((0, 0), (1, 1))
    for column in range(times):
        block.add_blockref("A", (column, 0))
    doc.modelspace().add_blockref("A", (10, 10))
    if times == 1:
        assert len(read(doc).vectors.strokes) == DEEPEST
        return
    with pytest.raises(LimitError) as caught:
        read(doc)
    assert caught.value.code == "too-many-elements"


def test_grids_of_blocks_are_bounded(read: Read) -> None:
    doc = _a4()
    doc.blocks.new("B").add_line((0, 0), (1, 1))
    grid = {"row_count": 30_000, "column_count": 30_000, "row_spacing": 1, "column_spacing": 1}
    doc.modelspace().add_blockref("B", (0, 0), dxfattribs=grid)
    with pytest.raises(LimitError):
        read(doc)

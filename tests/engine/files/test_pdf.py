from collections.abc import Callable
from pathlib import Path

import numpy as np
import pypdfium2 as pdfium
import pytest

from gaussiancad_core.errors import GaussianCadError, LimitError, UnreadableError
from gaussiancad_core.files.pdf import read_pdf
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment

SCALE = 200.0 / 72.0
HEIGHT = 841.89
TURN = 2.0 * np.pi

Save = Callable[[str, bytes], Path]


def test_lines_keep_ends_width_and_dashes(pdf: type, save: Save) -> None:
    content = b"2 w 50 100 m 550 100 l S [6 3] 0 d 50 200 m 550 300 l S [9] 0 d 0 0 m 9 9 l S"
    read = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1)
    assert read.pixels_per_inch == 200.0
    assert read.grey.shape == (2339, 1654)
    solid, dashed, odd = read.vectors.strokes
    assert np.allclose(solid.curve.start, (50 * SCALE, (HEIGHT - 100) * SCALE), atol=1e-3)
    assert np.allclose(solid.curve.end, (550 * SCALE, (HEIGHT - 100) * SCALE), atol=1e-3)
    assert solid.width == pytest.approx(2 * SCALE)
    assert solid.dashes == ()
    assert solid.role is StrokeRole.UNKNOWN
    assert np.allclose(dashed.dashes, (6 * SCALE, 3 * SCALE))
    assert dashed.role is StrokeRole.HIDDEN
    assert np.allclose(odd.dashes, (9 * SCALE, 9 * SCALE))


@pytest.mark.parametrize(("pattern", "role"), [("12 2 2 2", "centre"), ("12 2 2 2 2 2", "other")])
def test_dashes_tell_centre_and_phantom_lines(
    pdf: type, save: Save, pattern: str, role: str
) -> None:
    content = f"[{pattern}] 0 d 50 100 m 550 100 l S".encode()
    (stroke,) = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1).vectors.strokes
    assert stroke.role is StrokeRole(role)


@pytest.mark.parametrize("turns", range(4))
def test_circles_stay_circles_on_turned_pages(
    pdf: type, pdf_circle: Callable[..., bytes], save: Save, turns: int
) -> None:
    page = b"/Rotate %d" % (90 * turns)
    read = read_pdf(save("a.pdf", pdf(pdf_circle(300, 500, 120), page=page).to_bytes()), 1)
    (stroke,) = read.vectors.strokes
    x, y, w, h = 300.0, 500.0, 595.28, HEIGHT
    centre = [(x, h - y), (y, x), (w - x, y), (h - y, w - x)][turns]
    size = max(read.grey.shape)
    assert isinstance(stroke.curve, CircularArc)
    assert stroke.curve.sweep == TURN
    assert np.allclose(stroke.curve.centre, np.array(centre) * SCALE, atol=1e-6 * size)
    assert stroke.curve.radius == pytest.approx(120 * SCALE, abs=1e-6 * size)


def test_stretched_circles_are_ellipses(
    pdf: type, pdf_circle: Callable[..., bytes], save: Save
) -> None:
    content = b"q 2 0 0 1 0 0 cm " + pdf_circle(120, 600, 30) + b"Q"
    (stroke,) = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1).vectors.strokes
    assert isinstance(stroke.curve, EllipticArc)
    assert np.allclose(stroke.curve.centre, (240 * SCALE, (HEIGHT - 600) * SCALE), atol=2e-3)
    assert stroke.curve.semi_major == pytest.approx(60 * SCALE, abs=2e-3)
    assert stroke.curve.semi_minor == pytest.approx(30 * SCALE, abs=2e-3)
    assert stroke.curve.sweep == TURN


def test_forms_are_walked_through_with_their_matrices(
    pdf: type, pdf_circle: Callable[..., bytes], pdf_stream: Callable[..., bytes], save: Save
) -> None:
    entries = b"/Type /XObject /Subtype /Form /BBox [-500 -500 500 500] "
    inner = pdf_stream(pdf_circle(50, 50, 20), entries + b"/Matrix [0 1 -1 0 10 20]")
    outer = pdf_stream(
        b"q 2 0 0 2 5 0 cm /In Do Q", entries + b"/Resources << /XObject << /In 5 0 R >> >>"
    )
    page = b"/Resources << /XObject << /Out 6 0 R >> >>"
    content = b"q 1 0 0 1 300 400 cm /Out Do Q"
    data = pdf(content, page=page, objects=(inner, outer)).to_bytes()
    (stroke,) = read_pdf(save("a.pdf", data), 1).vectors.strokes
    # (50, 50) turned by a right angle, moved, doubled and moved again.
    x, y = 2 * (-50 + 10) + 5 + 300, 2 * (50 + 20) + 400
    assert np.allclose(stroke.curve.centre, (x * SCALE, (HEIGHT - y) * SCALE), atol=2e-3)
    assert stroke.curve.radius == pytest.approx(40 * SCALE, abs=2e-3)
    assert stroke.width == pytest.approx(2 * SCALE, abs=1e-4)


def test_where_pictures_are_is_known(
    pdf: type, pdf_stream: Callable[..., bytes], save: Save
) -> None:
    entries = b"/Type /XObject /Subtype /Form /BBox [-500 -500 500 500] /Matrix [0 1 -1 0 300 0]"
    picture = b"q 40 0 0 20 50 60 cm BI /W 1 /H 1 /CS /G /BPC 8 ID x EI Q "
    form = pdf_stream(picture, entries)
    page = b"/Resources << /XObject << /F 5 0 R >> >>"
    content = b"0 0 m 90 90 l S " + picture + b"/F Do"
    drawing = read_pdf(
        save("a.pdf", pdf(content, page=page, objects=(form,)).to_bytes()), 1
    ).vectors
    # In the form (x, y) is turned to (300 - y, x).
    boxes = [(50.0, 60.0, 90.0, 80.0), (220.0, 50.0, 240.0, 90.0)]
    stated = [
        (x0 * SCALE, (HEIGHT - y1) * SCALE, x1 * SCALE, (HEIGHT - y0) * SCALE)
        for x0, y0, x1, y1 in boxes
    ]
    assert not drawing.complete
    assert np.allclose(drawing.pictures, stated, atol=2e-3)


def test_crop_boxes_move_the_origin(pdf: type, save: Save) -> None:
    data = pdf(b"150 250 m 350 250 l S", page=b"/CropBox [100 200 400 500]").to_bytes()
    read = read_pdf(save("a.pdf", data), 1)
    assert read.grey.shape == (834, 834)
    (stroke,) = read.vectors.strokes
    assert np.allclose(stroke.curve.start, (50 * SCALE, 250 * SCALE), atol=1e-3)


def test_the_picture_lies_under_the_curves(
    pdf: type, pdf_circle: Callable[..., bytes], save: Save, ink_offsets: Callable
) -> None:
    content = b"1.5 w 20.3 100.7 m 575 790.2 l S 33.3 700.1 m 560 700.1 l S " + pdf_circle(
        300, 500, 120
    )
    read = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1)
    assert len(read.vectors.strokes) == 3
    for stroke in read.vectors.strokes:
        offsets = ink_offsets(read.grey, stroke)
        assert len(offsets) > 100
        assert abs(float(np.median(offsets))) < 0.05


def test_text_has_its_box_and_direction(pdf: type, save: Save) -> None:
    font = b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"
    page = b"/Resources << /Font << /T 5 0 R >> >>"
    content = (
        b"BT /T 14 Tf 100 780 Td (25.4) Tj ET BT /T 14 Tf 0 1 -1 0 300 400 Tm (R8) Tj ET "
        b"50 100 m 550 100 l S"
    )
    read = read_pdf(save("a.pdf", pdf(content, page=page, objects=(font,)).to_bytes()), 1)
    across, upwards = read.vectors.texts
    assert (across.text, upwards.text) == ("25.4", "R8")
    x0, y0, x1, y1 = across.box
    assert 100 * SCALE <= x0 < x1 < 140 * SCALE
    assert (HEIGHT - 795) * SCALE < y0 < y1 < (HEIGHT - 775) * SCALE
    assert across.angle == pytest.approx(0.0)
    # Up the sheet is against y.
    assert upwards.angle == pytest.approx(-np.pi / 2)
    dark = read.grey[int(y0) : int(y1) + 1, int(x0) : int(x1) + 1] < 128
    assert dark.any(axis=0).mean() > 0.6


def test_letters_placed_one_by_one_are_one_text(pdf: type, save: Save) -> None:
    font = b"<< /Type /Font /Subtype /Type1 /BaseFont /Courier >>"
    page = b"/Resources << /Font << /T 5 0 R >> >>"
    letters = b"".join(
        b"BT /T 10 Tf %d 700 Td (%s) Tj ET " % (100 + 6 * i, letter)
        for i, letter in enumerate((b"1", b"2", b"5"))
    )
    content = letters + b"BT /T 10 Tf 300 700 Td (9) Tj ET 50 100 m 550 100 l S"
    read = read_pdf(save("a.pdf", pdf(content, page=page, objects=(font,)).to_bytes()), 1)
    assert [text.text for text in read.vectors.texts] == ["125", "9"]


Written = Callable[[bytes], list[str]]


@pytest.fixture
def written(pdf: type, save: Save) -> Written:
    """The texts of a page with such a content, in a usual font ``T``."""

    def texts(content: bytes) -> list[str]:
        font = b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"
        page = b"/Resources << /Font << /T 5 0 R >> >>"
        read = read_pdf(save("a.pdf", pdf(content, page=page, objects=(font,)).to_bytes()), 1)
        return [text.text for text in read.vectors.texts]

    return texts


_WAYS = {
    "level": (np.eye(2), (100.0, 700.0)),
    "upwards": (np.array([[0.0, -1.0], [1.0, 0.0]]), (300.0, 400.0)),
}


@pytest.mark.parametrize("way", _WAYS.values(), ids=_WAYS)
@pytest.mark.parametrize("slant", [0.0, 0.27, 0.33])
@pytest.mark.parametrize("pieces", [("48", ",5"), ("4", "8", ",", "5"), ("48,", "5")])
@pytest.mark.parametrize("narrow", [1.0, 0.88, 0.77])
def test_slanted_letters_narrower_than_told_are_one_text(
    written: Written,
    way: tuple[np.ndarray, tuple[float, float]],
    slant: float,
    pieces: tuple[str, ...],
    narrow: float,
) -> None:
    """The widths are those of a usual font, and letters are placed as for a narrow one."""
    turn, start = way
    letters = np.column_stack([turn @ (1.0, 0.0), turn @ (slant, 1.0)])
    at, content = 0.0, b"50 100 m 550 100 l S "
    for piece in (*pieces, None, "7"):
        if piece is None:
            at += 30.0
            continue
        x, y = turn @ (at, 0.0) + start
        matrix = " ".join(f"{item:.4f}" for item in (*letters.T.ravel(), x, y))
        content += f"BT /T 10 Tf {matrix} Tm ({piece}) Tj ET ".encode()
        at += narrow * sum(2.78 if item == "," else 5.56 for item in piece)
    assert written(content) == ["48,5", "7"]


@pytest.mark.parametrize(
    ("font", "letter", "sign"),
    [
        (b"ABCDEF+AIGDT", b"n", "\u00d8"),
        (b"AMGDT", b"X", "\u2334"),
        (b"Symbol#20type#20A", b"\\307", "\u00d8"),
        (b"ABCDEF+SymboltypeB", b"\\305", "\u00b0"),
        (b"Helvetica", b"\\307", "\u00c7"),
    ],
)
def test_letters_of_sign_fonts_are_signs(
    pdf: type, save: Save, font: bytes, letter: bytes, sign: str
) -> None:
    signs = b"<< /Type /Font /Subtype /TrueType /BaseFont /%b /Encoding /WinAnsiEncoding >>" % font
    plain = b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"
    page = b"/Resources << /Font << /S 5 0 R /T 6 0 R >> >>"
    content = b"BT /S 10 Tf 100 700 Td (%b) Tj /T 10 Tf 8 0 Td (20) Tj ET " % letter
    content += b"50 100 m 550 100 l S"
    made = pdf(content, page=page, objects=(signs, plain)).to_bytes()
    (text,) = read_pdf(save("a.pdf", made), 1).vectors.texts
    assert text.text.replace(" ", "") == f"{sign}20"


def test_numbers_on_each_other_are_two(written: Written) -> None:
    content = b"BT /T 10 Tf 100 700 Td (25) Tj ET BT /T 10 Tf 103 700 Td (36) Tj ET "
    content += b"50 100 m 550 100 l S"
    assert written(content) == ["25", "36"]


def test_what_does_not_show_is_left_out(pdf: type, save: Save) -> None:
    content = (
        b"1 1 1 RG 50 100 m 550 100 l S 0 0 0 RG 50 200 m 550 200 l S "
        b"1 1 1 rg 0 290 500 20 re f 50 700 m 550 700 l S 0 690 595 20 re f 0 0 20 20 re f"
    )
    read = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1)
    (stroke,) = read.vectors.strokes
    assert stroke.curve.start[1] == pytest.approx((HEIGHT - 200) * SCALE, abs=1e-3)


def test_lines_of_absurd_length_cost_nothing(pdf: type, save: Save) -> None:
    content = b"50 100 m 550 100 l S -1e9 -2e9 m 3e9 1e9 l S"
    read = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1)
    assert len(read.vectors.strokes) == 1


def test_filled_shapes_are_told_apart(pdf: type, save: Save) -> None:
    content = b"100 100 m 130 95 l 130 105 l f"
    (stroke,) = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1).vectors.strokes
    assert stroke.kind is StrokeKind.FILL
    assert len(stroke.curve.points) == 4
    assert stroke.curve.points[0] == stroke.curve.points[-1]


def test_white_areas_are_paper(pdf: type, save: Save) -> None:
    content = b"1 1 1 rg 100 100 200 90 re f 0 0 0 RG 100 100 200 90 re S"
    strokes = read_pdf(save("a.pdf", pdf(content).to_bytes()), 1).vectors.strokes
    assert [type(stroke.curve) for stroke in strokes] == [LineSegment] * 4


def test_plotted_circles_are_circles_again(pdf: type, save: Save) -> None:
    """Plotters write arcs as short lines between rounded points."""
    t = np.linspace(0, TURN, 91)
    points = np.round(np.stack([300 + 120 * np.cos(t), 500 + 120 * np.sin(t)], 1), 2)
    first, *others = (f"{x:.2f} {y:.2f}" for x, y in points)
    content = f"{first} m " + " ".join(f"{other} l" for other in others) + " 500 500 l S"
    data = pdf(content.encode()).to_bytes()
    circle, line = (stroke.curve for stroke in read_pdf(save("a.pdf", data), 1).vectors.strokes)
    assert isinstance(circle, CircularArc)
    assert circle.is_closed
    assert np.allclose(circle.centre, (300 * SCALE, (HEIGHT - 500) * SCALE), atol=0.01)
    assert circle.radius == pytest.approx(120 * SCALE, abs=0.01)
    assert isinstance(line, LineSegment)


def test_layers_are_named(pdf: type, save: Save) -> None:
    layer = b"<< /Type /OCG /Name (HIDDEN EDGES) >>"
    page = b"/Resources << /Properties << /L 5 0 R >> >>"
    content = b"/OC /L BDC 50 100 m 550 100 l S EMC 50 200 m 550 200 l S"
    data = pdf(content, page=page, objects=(layer,)).to_bytes()
    inside, outside = read_pdf(save("a.pdf", data), 1).vectors.strokes
    assert (inside.layer, outside.layer) == ("HIDDEN EDGES", "")
    assert (inside.role, outside.role) == (StrokeRole.HIDDEN, StrokeRole.UNKNOWN)


def test_scans_have_no_vectors(save: Save, tmp_path: Path) -> None:
    document = pdfium.PdfDocument.new()
    page = document.new_page(300, 200)
    grey = np.full((400, 600, 3), 255, np.uint8)
    grey[100:110, 50:500] = 0
    bitmap = pdfium.PdfBitmap.new_native(600, 400, 2)
    bitmap.to_numpy()[:] = grey
    picture = pdfium.PdfImage.new(document)
    picture.set_bitmap(bitmap)
    picture.set_matrix(pdfium.PdfMatrix().scale(300, 200))
    page.insert_obj(picture)
    page.gen_content()
    document.save(tmp_path / "scan.pdf")
    read = read_pdf(tmp_path / "scan.pdf", 1)
    assert read.vectors is None
    assert read.grey.shape == (556, 834)
    rows, columns = np.nonzero(read.grey < 128)
    assert rows.min() == pytest.approx(100 * 556 / 400, abs=1.5)
    assert columns.max() == pytest.approx(500 * 834 / 600, abs=1.5)


def test_pages_are_chosen(save: Save, tmp_path: Path) -> None:
    document = pdfium.PdfDocument.new()
    for side in (300, 400, 500):
        document.new_page(side, side)
    document.save(tmp_path / "a.pdf")
    assert read_pdf(tmp_path / "a.pdf", 2).grey.shape == (1112, 1112)
    for page in (0, 4):
        with pytest.raises(UnreadableError, match="3 page") as caught:
            read_pdf(tmp_path / "a.pdf", page)
        assert caught.value.code == "page-missing"


def _encrypted(pdf: type) -> bytes:
    data = pdf(b"0 0 m 9 9 l S").to_bytes()
    filter_ = b"<< /Filter /Standard /V 1 /R 2 /O <%s> /U <%s> /P -4 >>" % (b"00" * 32, b"11" * 32)
    return data.replace(b"/Root 1 0 R", b"/Root 1 0 R /ID [<00><00>] /Encrypt " + filter_)


BAD: dict[str, tuple[Callable[[type], bytes], type[GaussianCadError]]] = {
    "encrypted-pdf": (_encrypted, UnreadableError),
    "damaged-pdf": (lambda _: b"%PDF-1.7\nnothing", UnreadableError),
    "too-many-pages": (lambda pdf: pdf(b"0 0 m 9 9 l S", kids=10_000).to_bytes(), UnreadableError),
    "image-too-large": (lambda pdf: pdf(b"", box="0 0 14400 14400").to_bytes(), UnreadableError),
    "image-too-small": (lambda pdf: pdf(b"", box="0 0 9 14400").to_bytes(), UnreadableError),
    "too-many-elements": (lambda pdf: pdf(b"0 0 m 9 9 l S\n" * 120_000).to_bytes(), LimitError),
}


@pytest.mark.parametrize("code", BAD)
def test_bad_files(pdf: type, save: Save, code: str) -> None:
    make, error = BAD[code]
    path = save("bad.pdf", make(pdf))
    with pytest.raises(error) as caught:
        read_pdf(path, 1)
    assert caught.value.code == code
    assert str(path) in caught.value.message
    assert "\n" not in caught.value.message

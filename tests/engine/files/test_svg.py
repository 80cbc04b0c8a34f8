import gzip
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gaussiancad_core.errors import GaussianCadError, LimitError, UnreadableError
from gaussiancad_core.files.content import LONGEST_TEXT
from gaussiancad_core.files.svg import read_svg
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment

MM = 200.0 / 25.4
TURN = 2.0 * np.pi

Save = Callable[[str, bytes | str], Path]

A4 = 'width="297mm" height="210mm" viewBox="0 0 297 210"'


def _svg(body: str, root: str = A4, before: str = "") -> str:
    return (
        f'{before}<svg xmlns="http://www.w3.org/2000/svg" '
        f'xmlns:xlink="http://www.w3.org/1999/xlink" {root}>'
        f'<g fill="none" stroke="black" stroke-width="0.5">{body}</g></svg>'
    )


def test_shapes_are_exact_at_200_dpi(save: Save) -> None:
    body = (
        '<circle cx="50" cy="60" r="20"/><line x1="10" y1="20" x2="90" y2="30"/>'
        '<path d="M200 100 a15 15 0 0 1 30 0 a15 15 0 0 1 -30 0 z"/>'
        '<path d="M100 20 h80 v40 a10 10 0 0 1 -10 10"/>'
        '<ellipse cx="150" cy="150" rx="30" ry="10"/>'
    )
    read = read_svg(save("a.svg", _svg(body)), 1)
    assert read.grey.shape == (1654, 2339)
    assert read.pixels_per_inch == 200.0
    assert read.notes == ()
    circle, line, halves, across, down, corner, ellipse = (s.curve for s in read.vectors.strokes)
    tolerance = 1e-6 * 2339
    for curve, centre, radius in ((circle, (50, 60), 20), (halves, (215, 100), 15)):
        assert isinstance(curve, CircularArc)
        assert curve.sweep == TURN
        assert np.allclose(curve.centre, np.array(centre) * MM, atol=tolerance)
        assert curve.radius == pytest.approx(radius * MM, abs=tolerance)
    assert np.allclose([line.start, line.end], np.array([(10, 20), (90, 30)]) * MM)
    assert isinstance(across, LineSegment)
    assert isinstance(down, LineSegment)
    assert isinstance(corner, CircularArc)
    assert np.allclose(corner.centre, np.array((170, 60)) * MM, atol=tolerance)
    assert (corner.start_angle, corner.sweep) == pytest.approx((0.0, np.pi / 2))
    assert isinstance(ellipse, EllipticArc)
    assert ellipse.semi_minor == pytest.approx(ellipse.semi_major / 3)
    assert [s.width for s in read.vectors.strokes] == pytest.approx([0.5 * MM] * 7)


def test_transforms_are_exact(save: Save) -> None:
    body = (
        '<g transform="translate(50,150) rotate(30) scale(2)"><circle r="10"/></g>'
        '<g transform="translate(150,100) scale(3,1)"><circle r="10"/></g>'
        '<circle cx="10" cy="10" r="5" transform="matrix(1 0.5 0 1 200 50)"/>'
        '<rect x="200" y="150" width="30" height="20" transform="rotate(90 200 150)"/>'
    )
    strokes = read_svg(save("a.svg", _svg(body)), 1).vectors.strokes
    turned, stretched, sheared = (stroke.curve for stroke in strokes[:3])
    assert np.allclose(turned.centre, np.array((50, 150)) * MM)
    assert turned.radius == pytest.approx(20 * MM)
    assert strokes[0].width == pytest.approx(MM)
    assert isinstance(stretched, EllipticArc)
    assert stretched.semi_minor == pytest.approx(10 * MM)
    assert stretched.semi_major == pytest.approx(30 * MM)
    assert isinstance(sheared, EllipticArc)
    points = (sheared.sample(1.0) / MM - (200, 50)) @ np.linalg.inv([[1, 0.5], [0, 1]])
    assert np.allclose(np.hypot(*(points - (10, 10)).T), 5.0)
    corners = np.array([stroke.curve.start for stroke in strokes[3:]]) / MM
    assert {tuple(np.round(corner, 6)) for corner in corners} == {
        (200, 150),
        (200, 180),
        (180, 180),
        (180, 150),
    }


def test_styles_give_dashes_and_roles(save: Save) -> None:
    body = (
        "<style>.hid{stroke-dasharray:3,1.5;stroke-width:.35px}</style>"
        '<path class="hid" d="M10 10 H100"/>'
        '<g style="stroke-dasharray: 12 2 2 2"><path d="M10 20 H100"/></g>'
        '<path id="hidden_edge" d="M10 30 H100"/><path d="M10 40 H100" stroke-dasharray="5"/>'
    )
    strokes = read_svg(save("a.svg", _svg(body)), 1).vectors.strokes
    assert np.allclose(strokes[0].dashes, np.array((3, 1.5)) * MM)
    assert strokes[0].width == pytest.approx(0.35 * MM)
    assert np.allclose(strokes[1].dashes, np.array((12, 2, 2, 2)) * MM)
    assert np.allclose(strokes[3].dashes, np.array((5, 5)) * MM)
    assert [stroke.role for stroke in strokes] == [
        StrokeRole.HIDDEN,
        StrokeRole.CENTRE,
        StrokeRole.HIDDEN,
        StrokeRole.HIDDEN,
    ]


def test_reused_parts_are_shown_where_they_are_used(save: Save) -> None:
    body = (
        '<defs><g id="part"><circle r="5"/></g></defs>'
        '<symbol id="s"><circle cx="9" cy="9" r="7"/></symbol>'
        '<use xlink:href="#part" x="50" y="60"/><use href="#s" x="100" y="60"/>'
        '<marker id="m"><circle r="3"/></marker><clipPath id="c"><circle r="4"/></clipPath>'
    )
    circles = [stroke.curve for stroke in read_svg(save("a.svg", _svg(body)), 1).vectors.strokes]
    assert [circle.radius for circle in circles] == pytest.approx([5 * MM, 7 * MM])
    assert np.allclose([c.centre for c in circles], np.array([(50, 60), (109, 69)]) * MM)


def test_what_does_not_show_is_left_out(save: Save) -> None:
    body = (
        '<path d="M10 10 H100" display="none"/><path d="M10 20 H100" visibility="hidden"/>'
        '<path d="M10 30 H100" stroke="white"/><path d="M10 40 H100" opacity="0"/>'
        '<clipPath id="c"><rect width="5" height="5"/></clipPath>'
        '<path d="M10 50 H100" clip-path="url(#c)"/><path d="M10 60 H100"/>'
    )
    (stroke,) = read_svg(save("a.svg", _svg(body)), 1).vectors.strokes
    assert stroke.curve.start[1] == pytest.approx(60 * MM)


def test_fills_and_free_curves(save: Save) -> None:
    body = (
        '<path d="M10 10 l9 -3 v6 z" fill="black" stroke="none"/>'
        '<path d="M120 150 q20 -40 40 0 t40 0"/>'
    )
    fill, curve = read_svg(save("a.svg", _svg(body)), 1).vectors.strokes
    assert fill.kind is StrokeKind.FILL
    assert isinstance(curve.curve, Chain)
    t = np.linspace(0, 1, 101)[:, None]
    controls = np.array([(120, 150), (140, 110), (160, 150)]) * MM
    exact = (1 - t) ** 2 * controls[0] + 2 * t * (1 - t) * controls[1] + t**2 * controls[2]
    sampled = curve.curve.sample(0.05)
    nearest = np.sqrt(((exact[:, None] - sampled[None]) ** 2).sum(axis=2).min(axis=1))
    assert nearest.max() < 0.05


def test_the_picture_lies_under_the_curves(save: Save, ink_offsets: Callable) -> None:
    body = (
        '<circle cx="50.03" cy="60.1" r="20.7"/><line x1="10" y1="20.17" x2="290" y2="20.17"/>'
        '<line x1="13" y1="200" x2="280" y2="31"/><ellipse cx="200" cy="150" rx="40" ry="20"/>'
    )
    read = read_svg(save("a.svg", _svg(body)), 1)
    for stroke in read.vectors.strokes:
        offsets = ink_offsets(read.grey, stroke)
        assert len(offsets) > 100
        # resvg draws curves in chords and to quarters of a pixel.
        limit = 0.08 if isinstance(stroke.curve, LineSegment) else 0.15
        assert abs(float(np.median(offsets))) < limit


@pytest.mark.parametrize(
    ("root", "shape", "physical"),
    [
        ('width="4in" height="2in"', (400, 800), True),
        ('width="288pt" height="12pc"', (400, 800), True),
        ('width="960" height="480px"', (1000, 2000), False),
        ('viewBox="0 0 960 480"', (1000, 2000), False),
        ('width="100%" height="100%" viewBox="0 0 960 480"', (1000, 2000), False),
        ('width="960" viewBox="0 0 96 48"', (1000, 2000), False),
        ('viewBox="0 0 2 1"', (1500, 3000), False),
        ('width="100000" height="50000"', (1500, 3000), False),
    ],
)
def test_sizes(save: Save, root: str, shape: tuple[int, int], physical: bool) -> None:
    read = read_svg(save("a.svg", _svg('<path d="M0 0 L96 48"/>', root)), 1)
    assert read.grey.shape == shape
    assert read.pixels_per_inch == (200.0 if physical else None)
    assert [note.code for note in read.notes] == ([] if physical else ["paper-size-unknown"])


def test_a_drawing_without_any_size_is_shown_whole(save: Save) -> None:
    read = read_svg(save("a.svg", _svg('<circle cx="500" cy="300" r="200"/>', "")), 1)
    assert read.grey.shape == (1250, 2084)
    (stroke,) = read.vectors.strokes
    assert stroke.curve.radius == pytest.approx(200 * 200 / 96)


@pytest.mark.parametrize("place", ["1e4 1e4", "-1e9 1e9"])
def test_a_stroke_at_an_absurd_place_does_not_size_a_drawing(save: Save, place: str) -> None:
    body = '<rect x="20" y="20" width="60" height="40"/><path d="M20 90h60 M20 99h60"/>'
    without = read_svg(save("a.svg", _svg(body, "")), 1)
    read = read_svg(save("a.svg", _svg(f'{body}<path d="M{place}h5"/>', "")), 1)
    assert read.vectors == without.vectors
    assert [note.message.args.get("count") for note in read.notes] == [1, None]


@pytest.mark.parametrize("root", ['viewBox="{0} {0} 100 80"', 'width="100" height="80" {1}', ""])
@pytest.mark.parametrize("far", [-1000, 10**6, 10**9])
def test_a_page_may_lie_far_from_the_origin(save: Save, far: int, root: str) -> None:
    def drawing(at: int) -> str:
        view_box = f'viewBox="{at} {at} 100 80"'
        body = f'<path d="M{at + 20} {at + 10}h60v40h-60z"/>'
        return _svg(body, root.format(at, view_box))

    near, read = (read_svg(save("a.svg", drawing(at)), 1) for at in (0, far))
    assert near.vectors is not None and read.vectors is not None
    assert len(read.vectors.strokes) == 4
    if root:
        ends = [[(s.curve.start, s.curve.end) for s in n.vectors.strokes] for n in (near, read)]
        assert np.allclose(*ends, atol=1e-3)
        assert read.grey.shape == near.grey.shape
        dark = [np.argwhere(content.grey < 128) for content in (near, read)]
        corners = [(of.min(axis=0), of.max(axis=0)) for of in dark]
        assert np.allclose(*corners, atol=2.0)
    else:
        # Its size is told by what is drawn.
        (line, *_) = read.vectors.strokes
        assert line.curve.length > 0.25 * read.grey.shape[1]


def test_compressed_and_documented_files(save: Save) -> None:
    doctype = (
        '<?xml version="1.0" encoding="UTF-8"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" '
        '"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
    )
    text = _svg('<circle cx="50" cy="60" r="20"/>', before=doctype)
    plain = read_svg(save("a.svg", text), 1)
    packed = read_svg(save("a.svgz", gzip.compress(text.encode())), 1)
    assert len(plain.vectors.strokes) == 1
    assert np.array_equal(plain.grey, packed.grey)


def test_nothing_outside_is_ever_opened(save: Save, tmp_path: Path) -> None:
    black = tmp_path / "black.png"
    Image.new("L", (300, 300), 0).save(black)
    save("other.svg", _svg('<rect id="x" width="90" height="90" fill="black"/>'))
    body = '<circle cx="50" cy="60" r="20"/>'
    clean = read_svg(save("clean.svg", _svg(body)), 1)
    references = [
        f'<image href="{black.as_uri()}" width="200" height="200"/>',
        f'<image xlink:href="{black}" width="200" height="200"/>',
        '<image href="black.png" width="200" height="200"/>',
        '<image href="http://127.0.0.1:9/x.png" width="200" height="200"/>',
        '<use xlink:href="other.svg#x"/>',
        "<style>@import url('other.css'); circle { fill: url(other.svg#x) }</style>",
        '<rect width="9" height="9" stroke="none" style="fill:url(other.svg#x)"/>',
    ]
    for reference in references:
        read = read_svg(save("a.svg", _svg(body + reference)), 1)
        assert np.array_equal(read.grey, clean.grey), reference
        assert [note.code for note in read.notes] == ["external-left-out"], reference


def test_scripts_and_filters_change_nothing(save: Save) -> None:
    body = '<circle cx="50" cy="60" r="20"/>'
    clean = read_svg(save("clean.svg", _svg(body)), 1)
    blur = '<filter id="f"><feGaussianBlur stdDeviation="900"/></filter><script>1</script>'
    loud = '<circle cx="50" cy="60" r="20" filter="url(#f)" onclick="x()" style="filter:url(#f)"/>'
    read = read_svg(save("a.svg", _svg(blur + loud)), 1)
    assert np.array_equal(read.grey, clean.grey)
    assert read.notes == ()


def test_embedded_pictures_are_shown_and_told(save: Save, tmp_path: Path) -> None:
    import base64

    Image.new("L", (30, 30), 0).save(tmp_path / "black.png")
    data = base64.b64encode((tmp_path / "black.png").read_bytes()).decode()
    body = (
        f'<image href="data:image/png;base64,{data}" width="20" height="20"/>'
        '<circle cx="150" cy="60" r="20"/>'
    )
    read = read_svg(save("a.svg", _svg(body)), 1)
    assert read.grey[80, 80] == 0
    assert not read.vectors.complete


def test_text_has_a_box_and_is_drawn(save: Save) -> None:
    body = '<text x="150" y="100" font-size="10" text-anchor="middle" fill="black">Ø25.4</text>'
    read = read_svg(save("a.svg", _svg(body + '<path d="M1 1H9"/>')), 1)
    (text,) = read.vectors.texts
    x0, y0, x1, y1 = text.box
    assert text.text == "Ø25.4"
    assert (x0 + x1) / 2 == pytest.approx(150 * MM)
    assert y0 < 100 * MM < y1
    dark = np.argwhere(read.grey[: int(150 * MM)] < 128)
    inside = (dark[:, 0] > y0) & (dark[:, 0] < y1) & (dark[:, 1] > x0) & (dark[:, 1] < x1)
    assert inside.mean() > 0.7


def test_of_a_text_without_end_its_beginning_is_read(save: Save) -> None:
    long = "M" * 1_000_000
    body = f'<text x="5" y="9">{long}</text><rect x="20" y="20" width="50" height="30"/>'
    content = read_svg(save("text.svg", _svg(body)), 1)
    assert content.vectors is not None
    assert {len(text.text) for text in content.vectors.texts} == {LONGEST_TEXT}


def test_loops_of_reuse_end(save: Save) -> None:
    body = '<g id="a"><path d="M5 5 H90"/><use href="#a"/></g><use href="#b" id="b"/>'
    assert len(read_svg(save("a.svg", _svg(body)), 1).vectors.strokes) == 1


def _reuse_bomb() -> str:
    levels = "".join(f'<g id="u{i + 1}">' + f'<use href="#u{i}"/>' * 10 + "</g>" for i in range(9))
    return _svg(f'<defs><g id="u0"><path d="M1 1h5"/></g>{levels}</defs><use href="#u9"/>')


LAUGHS = '<!DOCTYPE svg [<!ENTITY a "haha"><!ENTITY b "&a;&a;&a;&a;">]>'
OUTSIDE = '<!DOCTYPE svg [<!ENTITY a SYSTEM "file:///etc/hostname">]>'

BAD: list[tuple[str, bytes | str, type[GaussianCadError]]] = [
    ("svg-entities", _svg("<text>&b;</text>", before=LAUGHS), UnreadableError),
    ("svg-entities", _svg("<text>&a;</text>", before=OUTSIDE), UnreadableError),
    ("damaged-svg", _svg('<path d="M1 1h5"/>')[:-9], UnreadableError),
    ("damaged-svg", "this is text", UnreadableError),
    ("damaged-svg", "<html><svg/></html>", UnreadableError),
    ("damaged-svg", _svg("<g>" * 5000 + "</g>" * 5000), UnreadableError),
    ("damaged-svg", b"\x1f\x8b\x08broken", UnreadableError),
    ("external-content", _svg('<image href="file:///x.png"/>'), UnreadableError),
    ("empty-drawing", _svg("", ""), UnreadableError),
    ("empty-drawing", _svg('<path d="M500 1h9"/>'), UnreadableError),
    ("image-too-large", _svg("", 'width="90000mm" height="90000mm"'), UnreadableError),
    ("image-too-small", _svg("", 'width="5mm" height="5mm"'), UnreadableError),
    ("too-many-elements", _reuse_bomb(), LimitError),
    ("too-many-elements", _svg("<g/>" * 120_000), LimitError),
    ("drawing-file-too-large", gzip.compress(b"<svg>" + b" " * 65_000_000), LimitError),
]


@pytest.mark.parametrize(("code", "data", "error"), BAD)
def test_bad_files(save: Save, code: str, data: bytes | str, error: type) -> None:
    path = save("bad.svg", data)
    with pytest.raises(error) as caught:
        read_svg(path, 1)
    assert caught.value.code == code
    assert str(path) in caught.value.message
    assert "\n" not in caught.value.message


def test_there_is_one_page(save: Save) -> None:
    with pytest.raises(UnreadableError) as caught:
        read_svg(save("a.svg", _svg("")), 2)
    assert caught.value.code == "page-missing"

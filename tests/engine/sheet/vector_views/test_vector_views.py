"""Views from the curves of files: as exact as the file, whatever way it writes them."""

from collections.abc import Iterable
from dataclasses import replace

import cv2
import numpy as np
import pytest

from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.recognition.labelled_file import strokes_of_file
from gaussiancad_core.recognition.picture_views import picture_views
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views, register_views
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet

EXACT = 1e-3
"""px"""


def read(path, change=lambda grey: grey) -> tuple[ReadView, ...]:  # noqa: ANN001
    """The views of a file, its picture changed before it is looked at."""
    stored = read_sheet(path)
    image = replace(stored, grey=change(stored.grey))
    sheet = OpenedSheet(image)
    seen = picture_views(sheet, {}, Projection.THIRD)
    file = strokes_of_file(sheet)
    assert file is not None
    vectors = VectorSheet(file.part, sheet.clean)
    return read_views(seen.separated.part, seen.layout, vectors=vectors)


def distances(points: np.ndarray, strokes: Iterable[Stroke]) -> np.ndarray:
    """(n,) exact distances of points from the nearest stroke."""
    nearest = np.full(len(points), np.inf)
    for stroke in strokes:
        if isinstance(stroke, Segment):
            start, way = np.array(stroke.start), np.subtract(stroke.end, stroke.start)
            share = np.clip((points - start) @ way / (way @ way), 0.0, 1.0)
            away = np.hypot(*(points - start - share[:, None] * way).T)
        else:
            assert isinstance(stroke, Arc)
            offset = points - np.array(stroke.centre)
            turn = np.mod(np.arctan2(offset[:, 1], offset[:, 0]) - stroke.start_angle, 2 * np.pi)
            radial = np.abs(np.hypot(*offset.T) - stroke.radius)
            ends = stroke.sample(1e9)[[0, -1]]
            neighbour = np.min([np.hypot(*(points - end).T) for end in ends], axis=0)
            away = np.where(turn <= stroke.sweep, radial, neighbour)
        nearest = np.minimum(nearest, away)
    return nearest


def sampled(strokes: Iterable[Stroke], kind: Linetype) -> np.ndarray:
    """(n, 2) points along the strokes of a kind, their ends among them."""
    return np.concatenate(
        [np.empty((0, 2)), *(s.sample(2.0) for s in strokes if s.linetype is kind)]
    )


def check(sheet, views: tuple[ReadView, ...], slack: float = EXACT) -> None:  # noqa: ANN001
    """Read and drawn lines are the same, visible and hidden."""
    for view in views:
        truth = sheet[view.role].strokes
        for kind in Linetype:
            ses = [s for s in view.strokes if s.linetype is kind]
            right = [s for s in truth if s.linetype is kind]
            visible = [s for s in truth if s.linetype is Linetype.VISIBLE]
            if ses:
                assert distances(sampled(ses, kind), right).max() <= slack
            drawn = sampled(right, kind)
            if kind is Linetype.HIDDEN and len(drawn):
                drawn = drawn[distances(drawn, visible) > 0.5]
            if len(drawn):
                assert distances(drawn, ses).max() <= max(slack, 0.5 * (kind is Linetype.HIDDEN))


@pytest.mark.parametrize(
    ("name", "suffix"),
    [
        ("u-bracket", ".svg"),
        ("slotted-link", ".pdf"),
        ("u-bracket", ".dxf"),
        ("slotted-link", ".dxf"),
    ],
)
def test_strokes_are_the_file_s_own(write_sheet, name: str, suffix: str) -> None:  # noqa: ANN001
    sheet, path = write_sheet(name, suffix)
    views = read(path)
    assert {view.source for view in views} == {StrokesSource.VECTOR}
    check(sheet, views)
    assert all(view.step == 0.0 for view in views)
    for view in views:
        assert view.box == pytest.approx(sheet[view.role].box, abs=EXACT)
        assert all(stroke.confidence == 1.0 for stroke in view.strokes)
    registered = register_views(views, ReadingOptions(mm_per_pixel=sheet.mm_per_pixel))
    assert registered.source is StrokesSource.VECTOR
    assert all(residual.largest < EXACT for residual in registered.extents.residuals.values())


def test_lines_in_pieces_are_put_together(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("slotted-link", ".svg", parts=3)
    views = read(path)
    check(sheet, views)
    whole = read(write_sheet("slotted-link", ".svg")[1])
    counts = [sorted(type(s).__name__ for s in view.strokes) for view in (*views, *whole)]
    assert counts[:3] == counts[3:]


@pytest.mark.parametrize("suffix", [".svg", ".pdf"])
def test_dashes_of_their_own_are_hidden_lines(write_sheet, suffix: str) -> None:  # noqa: ANN001
    sheet, path = write_sheet("u-bracket", suffix, dashes_apart=True)
    views = read(path)
    assert {view.source for view in views} == {StrokesSource.VECTOR}
    check(sheet, views)
    hidden = [s for view in views for s in view.strokes if s.linetype is Linetype.HIDDEN]
    assert min(stroke.length for stroke in hidden) > 2 * 12.0


def test_plotted_lines_are_taken_for_what_they_are(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("slotted-link", ".pdf", step=1.0 / 6.0)
    views = read(path)
    assert {view.source for view in views} == {StrokesSource.VECTOR}
    # Its circles and arcs were not rounded; they were drawn with what was.
    assert [view.step for view in views] == pytest.approx([1.0 / 6.0] * 3, rel=1e-3)
    check(sheet, views, slack=0.2)
    registered = register_views(views, ReadingOptions(mm_per_pixel=1.0))
    assert registered.source is StrokesSource.VECTOR
    strokes = registered.views.views[1].strokes
    corners = np.concatenate([s.sample(1e9)[[0, -1]] for s in strokes if isinstance(s, Segment)])
    arcs = [s for s in strokes if isinstance(s, Arc) and s.sweep < 6.0]
    assert len(arcs) == 4
    for arc in arcs:
        for end in arc.sample(1e9)[[0, -1]]:
            assert np.hypot(*(corners - end).T).min() < 1e-9


def test_centre_lines_by_their_linetype_are_none_of_the_part(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("bored-plate", ".dxf", centre_lines=True)
    views = read(path)
    assert {view.source for view in views} == {StrokesSource.VECTOR}
    check(sheet, views)


def test_a_turned_picture_keeps_the_curves_on_the_ink(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("slotted-link", ".svg")
    text = path.read_text()
    body = text.replace('stroke="#000">', 'stroke="#000"><g transform="rotate(1.5 640 360)">')
    path.write_text(body.replace("</svg>", "</g></svg>"))
    views = read(path)
    assert {view.source for view in views} == {StrokesSource.VECTOR}
    for view in views:
        width, height = np.subtract(view.box[2:], view.box[:2])
        x0, y0, x1, y1 = sheet[view.role].box
        assert (width, height) == pytest.approx((x1 - x0, y1 - y0), abs=0.02)


def test_a_view_whose_ink_is_not_explained_is_read_from_the_picture(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("u-bracket", ".svg")
    x0, y0, x1, y1 = (int(value) for value in sheet.views[0].box)

    def with_more(grey: np.ndarray) -> np.ndarray:
        changed = grey.copy()
        at = (y0 + y1) // 2
        cv2.line(changed, (x0, at - 9), (x1, at - 9), 0, 3)
        return changed

    views = {view.role: view for view in read(path, with_more)}
    sources = [views[view.role].source for view in sheet.views]
    assert sources == [StrokesSource.RASTER, StrokesSource.VECTOR, StrokesSource.VECTOR]


def test_lines_that_the_picture_does_not_show_are_not_believed(write_sheet) -> None:  # noqa: ANN001
    sheet, path = write_sheet("u-bracket", ".svg")
    x0, y0, x1, y1 = sheet.views[1].box
    row = (y0 + y1) / 2 - 11.0
    line = f'<line x1="{x0}" y1="{row}" x2="{x1}" y2="{row}" stroke-width="3"/>'
    path.write_text(path.read_text().replace("</svg>", line + "</svg>"))

    def without_it(grey: np.ndarray) -> np.ndarray:
        changed = grey.copy()
        changed[int(row) - 3 : int(row) + 4, int(x0) + 5 : int(x1) - 4] = 255
        return changed

    views = {view.role: view for view in read(path, without_it)}
    view = views[sheet.views[1].role]
    levels = [s.start[1] for s in view.strokes if isinstance(s, Segment)]
    assert not any(abs(level - row) < 2.0 for level in levels)

"""Photographs made into sheets."""

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.sheet.image.photographs import straightened

WIDTH, HEIGHT = 1200, 850
HOLES = (260, 60), (450, 60)


def drawing(*holes: tuple[int, int]) -> npt.NDArray[np.uint8]:
    """Three views of a plate, 480 x 300 x 90 px, with holes at some x of some radius."""
    sheet = np.full((HEIGHT, WIDTH), 255, np.uint8)
    for x, y, width, height in ((100, 500, 480, 90), (100, 130, 480, 300), (700, 500, 300, 90)):
        cv2.rectangle(sheet, (x, y), (x + width, y + height), 0, 3)
        cv2.line(sheet, (x, y + 60), (x + width, y + 60), 0, 3)
        cv2.line(sheet, (x + 70, y), (x + 70, y + height), 0, 3)
    for x, radius in holes:
        cv2.circle(sheet, (x, 310), radius, 0, 3, cv2.LINE_AA)
    return sheet


def photograph(
    sheet: npt.NDArray[np.uint8], tilt: float, way: float, table: int | None = 60
) -> npt.NDArray[np.uint8]:
    """A sheet seen from a tilt, in degrees, with one side in the shade."""
    size, focal = (1800, 1350), 0.75 * 1800
    axis = np.radians(tilt) * np.array([np.cos(np.radians(way)), np.sin(np.radians(way)), 0.0])
    middle = np.array([WIDTH, HEIGHT]) / 2
    rim = np.array([[0, 0], [WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]], float)
    places = np.column_stack([rim - middle, np.zeros(4)]) @ cv2.Rodrigues(axis)[0].T
    places += [0.0, 0.0, 1.1 * focal]
    seen = focal * places[:, :2] / places[:, 2:] + np.array(size) / 2
    matrix = cv2.getPerspectiveTransform(rim.astype(np.float32), seen.astype(np.float32))
    picture = cv2.warpPerspective(sheet, matrix, size, flags=cv2.INTER_AREA, borderValue=255)
    if table is not None:
        paper = cv2.warpPerspective(np.full_like(sheet, 255), matrix, size)
        picture = np.where(paper > 127, picture, np.uint8(table))
    shade = np.linspace(0.65, 0.9, size[0])
    noise = np.random.default_rng(1).normal(0.0, 3.0, picture.shape)
    return np.clip(picture * shade + noise, 0, 255).astype(np.uint8)


def plan(sheet: npt.NDArray[np.uint8]) -> tuple[int, int, int, int]:
    """The box (x, y, width, height) of the largest view: that of the top."""
    ink = (sheet < 128).astype(np.uint8)
    _, _, stats, _ = cv2.connectedComponentsWithStats(ink, connectivity=8)
    areas = stats[1:, cv2.CC_STAT_WIDTH] * stats[1:, cv2.CC_STAT_HEIGHT]
    return tuple(int(item) for item in stats[1 + int(np.argmax(areas)), :4])


@pytest.mark.parametrize(("tilt", "way"), [(6, 30), (15, 100), (24, 250)])
@pytest.mark.parametrize("table", [60, None])
def test_a_slant_is_undone(tilt: float, way: float, table: int | None) -> None:
    made = straightened(photograph(drawing(*HOLES), tilt, way, table), None)
    assert made is not None
    assert np.degrees(made.slant) == pytest.approx(tilt, abs=1.5)
    assert made.true_width
    x, y, width, height = plan(made.grey)
    assert width / height == pytest.approx(483 / 303, rel=0.006)
    edge = made.grey[y : y + height, x : x + width] < 128
    assert edge[:, :6].any(axis=1).mean() > 0.99, "its left edge is upright"
    assert edge[:6].any(axis=0).mean() > 0.99, "its upper edge is level"
    assert np.median(made.grey) > 250, "its paper is white"
    assert made.note.code == "photographed-at-a-slant"
    assert made.note.is_doubt


@pytest.mark.parametrize("holes", [(), ((350, 60),), ((350, 60), (350, 90))])
def test_without_two_circles_the_camera_tells_the_width(holes: tuple[tuple[int, int], ...]) -> None:
    """One circle may be an ellipse, and those about one middle are one."""
    made = straightened(photograph(drawing(*holes), 15, 60, None), None)
    assert made is not None
    assert not made.true_width
    assert made.note.message.args["case"] == "width"
    _, _, width, height = plan(made.grey)
    assert width / height == pytest.approx(483 / 303, rel=0.02)


def test_from_straight_above_only_the_table_is_left_out() -> None:
    picture = photograph(drawing(*HOLES), 0, 0)
    made = straightened(picture, np.full(picture.shape, 7, np.uint8))
    assert made is not None
    assert made.slant == 0.0
    assert made.grey.shape == picture.shape, "places are as they were"
    assert made.note.code == "surroundings-left-out"
    assert not made.note.is_doubt
    assert made.grey[10, 10] == 255
    assert made.tint is not None
    assert made.tint[10, 10] == 0
    assert made.tint[675, 900] == 7


def _turned(degrees: float) -> npt.NDArray[np.uint8]:
    matrix = cv2.getRotationMatrix2D((WIDTH / 2, HEIGHT / 2), degrees, 1.0)
    return cv2.warpAffine(drawing(*HOLES), matrix, (WIDTH, HEIGHT), borderValue=255)


def _with_slopes() -> npt.NDArray[np.uint8]:
    sheet = drawing(*HOLES)
    for k in range(6):
        cv2.line(sheet, (620, 130 + 40 * k), (1150, 100 + 52 * k), 0, 3)
    return sheet


def _with_a_dark_field() -> npt.NDArray[np.uint8]:
    sheet = np.full((900, 1200), 235, np.uint8)
    sheet[:, 900:] = 80
    return sheet


def _light_lines() -> npt.NDArray[np.uint8]:
    sheet = np.full((900, 1200), 20, np.uint8)
    for x in range(200, 1000, 40):
        cv2.line(sheet, (x, 150), (x, 750), 240, 3)
        cv2.line(sheet, (200, x * 3 // 4), (1000, x * 3 // 4), 240, 3)
    return sheet


@pytest.mark.parametrize(
    "sheet",
    [drawing(*HOLES), _turned(4.0), _with_slopes(), _with_a_dark_field(), _light_lines()],
    ids=["a sheet", "a turned one", "a part with slopes", "a dark field", "light lines"],
)
def test_a_sheet_stays_as_it_is(sheet: npt.NDArray[np.uint8]) -> None:
    assert straightened(sheet, None) is None


@pytest.mark.parametrize("table", [205, 225])
def test_paper_hardly_lighter_than_what_is_around_it_is_not_told(table: int) -> None:
    assert straightened(photograph(drawing(*HOLES), 0, 0, table), None) is None

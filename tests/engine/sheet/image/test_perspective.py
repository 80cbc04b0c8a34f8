"""How a flat sheet was seen: known cameras are found again from the lines that they see."""

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.sheet.image.perspective import (
    Sight,
    explained,
    find_sight,
    find_turned,
    segments_of,
)

SIZE = (1600, 1200)


def seen(tilt: float, way: float, turn: float, focal: float) -> Sight:
    """A camera, angles in degrees."""
    tilt, way, turn = np.radians([tilt, way, turn])
    axis = tilt * np.array([np.cos(way), np.sin(way), 0.0])
    turned = cv2.Rodrigues(np.array([0.0, 0.0, turn]))[0]
    return Sight(cv2.Rodrigues(axis)[0] @ turned, focal)


def drawing() -> npt.NDArray[np.uint8]:
    """Three views of a stepped block, and a few slanted lines."""
    sheet = np.full((SIZE[1], SIZE[0]), 255, np.uint8)
    for x, y in ((300, 250), (300, 700), (900, 700)):
        cv2.rectangle(sheet, (x, y), (x + 360, y + 280), 0, 3)
        cv2.line(sheet, (x, y + 120), (x + 360, y + 120), 0, 3)
        cv2.line(sheet, (x + 150, y), (x + 150, y + 280), 0, 3)
        cv2.line(sheet, (x + 150, y + 280), (x + 360, y + 120), 0, 3)
    return sheet


def picture(sight: Sight) -> npt.NDArray[np.uint8]:
    """The drawing as a camera sees it."""
    centred = np.array([[1, 0, -(SIZE[0] - 1) / 2], [0, 1, -(SIZE[1] - 1) / 2], [0, 0, 1]])
    matrix = sight.to_picture(SIZE) @ centred
    return cv2.warpPerspective(drawing(), matrix, SIZE, flags=cv2.INTER_AREA, borderValue=255)


@pytest.mark.parametrize(
    "sight",
    [
        seen(8, 20, 0, 0.75),
        seen(15, 200, 3, 0.70),
        seen(25, 110, -4, 0.85),
        seen(20, 90, 2, 0.75),
    ],
)
def test_a_camera_is_found_again(sight: Sight) -> None:
    segments = segments_of(picture(sight))
    found = find_sight(segments)
    turned_by = found.rotation.T @ sight.rotation
    apart = np.degrees(np.arccos((np.trace(turned_by) - 1.0) / 2.0))
    assert apart < 1.0
    assert found.focal == pytest.approx(sight.focal, rel=0.12)
    assert explained(found, segments) > 1.3 * explained(find_turned(segments), segments)


@pytest.mark.parametrize("turn", [0.0, 2.5, -7.0])
def test_from_straight_above_a_turn_tells_all(turn: float) -> None:
    segments = segments_of(picture(seen(0, 0, turn, 0.75)))
    turned, sight = find_turned(segments), find_sight(segments)
    angle = np.degrees(np.arctan2(turned.rotation[1, 0], turned.rotation[0, 0]))
    assert angle == pytest.approx(turn, abs=0.1)
    assert sight.tilt < np.radians(1.0)
    assert explained(sight, segments) <= 1.02 * explained(turned, segments)


def test_a_blank_picture_tells_nothing() -> None:
    segments = segments_of(np.full((200, 300), 255, np.uint8))
    assert len(segments.lengths) == 0
    assert explained(find_turned(segments), segments) == 0.0


def test_the_middle_of_the_picture_keeps_its_place_and_scale() -> None:
    matrix = seen(20, 40, 0, 0.75).to_picture(SIZE)
    places = np.array([[0, 0, 1], [1, 0, 1], [0, 1, 1]]) @ matrix.T
    places = places[:, :2] / places[:, 2:]
    assert places[0] == pytest.approx(((SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2))
    steps = np.hypot(*(places[1:] - places[0]).T)
    assert (steps <= 1.0 + 1e-3).all()
    assert (steps > np.cos(np.radians(20)) - 0.01).all()

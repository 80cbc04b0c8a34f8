from dataclasses import replace

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.views import Linetype, Segment

STYLE = SheetStyle(width=300, height=200)
X, Y = 90.37, 60.81
INK = rasterise(
    (
        Segment((X, 20.0), (X, 180.0), Linetype.VISIBLE),
        Segment((140.0, Y), (280.0, Y), Linetype.VISIBLE),
    ),
    STYLE,
)
PAPER = np.zeros_like(INK)

DEFECTS = {
    "bleed": 0.6,
    "fade": 0.5,
    "specks": 400.0,
    "blur": 0.8,
    "contrast": 3.0,
    "light": 0.4,
    "shadow": 20.0,
    "noise": 4.0,
    "salt": 0.01,
}


def _dark(image: np.ndarray) -> np.ndarray:
    return 255.0 - image[..., 0].astype(np.float64)


def _centre(profile: np.ndarray) -> float:
    return float(profile @ (np.arange(len(profile)) + 0.5) / profile.sum())


def _plain(ink: np.ndarray) -> np.ndarray:
    return np.repeat(np.rint(255.0 * (1.0 - ink))[..., None], 3, axis=2).astype(np.uint8)


def test_a_style_without_defects_is_ink_on_paper() -> None:
    np.testing.assert_array_equal(finished(INK, STYLE, seed=3), _plain(INK))


@pytest.mark.parametrize("name", DEFECTS)
def test_every_defect_shows_and_comes_from_the_seed_alone(name: str) -> None:
    style = replace(STYLE, **{name: DEFECTS[name]})
    before = INK.copy()
    one, same, other = (finished(INK, style, seed) for seed in (5, 5, 6))
    np.testing.assert_array_equal(one, same)
    np.testing.assert_array_equal(INK, before)
    assert (one != _plain(INK)).any()
    chance = name not in ("bleed", "blur", "shadow")
    assert (one != other).any() == chance


def test_one_defect_does_not_change_the_chance_of_another() -> None:
    grey = np.full_like(INK, 0.5)
    salted = finished(grey, replace(STYLE, salt=0.02), 1)
    noisy = finished(grey, replace(STYLE, salt=0.02, noise=4.0, light=0.1), 1)
    for level in (0, 255):
        np.testing.assert_array_equal(salted == level, noisy == level)


@pytest.mark.parametrize("names", [("bleed",), ("blur",), ("bleed", "blur", "contrast"), ("fade",)])
def test_lines_stay_where_they_are(names: tuple[str, ...]) -> None:
    image = finished(INK, replace(STYLE, **{name: DEFECTS[name] for name in names}), 2)
    dark = _dark(image)
    column = dark[40:160, 80:101].sum(axis=0)
    row = dark[50:72, 160:260].sum(axis=1)
    # Fading has grains: over a hundred px of line their shifts cancel out to a fraction.
    tolerance = 0.06 if "fade" in names or "contrast" in names else 0.01
    assert _centre(column) + 80.0 == pytest.approx(X, abs=tolerance)
    assert _centre(row) + 50.0 == pytest.approx(Y, abs=tolerance)


@pytest.mark.parametrize("reach", [0.4, 1.0, 2.0])
def test_ink_creeps_as_far_as_asked(reach: float) -> None:
    wide = rasterise(
        (Segment((X, 20.0), (X, 180.0), Linetype.VISIBLE),), replace(STYLE, visible_width=20.0)
    )
    dark = _dark(finished(wide, replace(STYLE, bleed=reach), 0)) / 255.0
    assert dark[100].sum() == pytest.approx(20.0 + 2.0 * reach, abs=0.02)


def test_fading_takes_ink_and_adds_none() -> None:
    faded = _dark(finished(INK, replace(STYLE, fade=0.6), 4)) / 255.0
    assert (faded <= INK + 0.003).all()
    assert 0.3 * INK.sum() < faded.sum() < 0.95 * INK.sum()


def test_specks_are_as_many_as_asked() -> None:
    style = replace(STYLE, width=1000, height=1000)
    paper = np.zeros((1000, 1000), dtype=np.float32)
    count, *_ = cv2.connectedComponents((_dark(finished(paper, style, 0)) > 60).astype(np.uint8))
    assert count == 1
    style = replace(style, specks=300.0)
    count, *_ = cv2.connectedComponents((_dark(finished(paper, style, 0)) > 60).astype(np.uint8))
    # One in seven is light and leaves no trace on paper; the smallest are paler than the threshold.
    assert 0.4 * 300 < count < 1.1 * 300


def test_light_is_lost_by_its_share_at_most() -> None:
    image = finished(PAPER, replace(STYLE, light=0.4), 7).astype(np.float64)
    assert image.min() == pytest.approx(255.0 * 0.6, abs=1.0)
    assert image.max() == 255.0
    # Smooth: no step between neighbours that could be taken for a line.
    assert np.abs(np.diff(image[..., 0], axis=0)).max() <= 6.0
    assert np.abs(np.diff(image[..., 0], axis=1)).max() <= 6.0


def test_the_lid_darkens_the_left_and_the_upper_border_only() -> None:
    image = finished(PAPER, replace(STYLE, shadow=20.0), 0)[..., 0]
    assert image[:, 0].max() < 60
    assert image[0, 100] < 160
    assert image[60:, 60:].min() == 255


def test_contrast_makes_ink_darker_and_paper_lighter() -> None:
    grey = np.full((200, 300), 0.75, dtype=np.float32)
    grey[:, 150:] = 0.2
    image = _dark(finished(grey, replace(STYLE, contrast=3.0), 0)) / 255.0
    assert image[:, :140].mean() > 0.85
    assert image[:, 160:].mean() < 0.08


def test_salt_is_black_and_white_in_equal_shares() -> None:
    grey = np.full((200, 300), 0.5, dtype=np.float32)
    image = finished(grey, replace(STYLE, salt=0.1), 0)[..., 0]
    assert (image == 0).mean() == pytest.approx(0.05, abs=0.005)
    assert (image == 255).mean() == pytest.approx(0.05, abs=0.005)

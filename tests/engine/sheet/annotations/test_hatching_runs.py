"""Hatching goes as a whole, and nothing else does."""

from functools import cache
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, compose_sheet, part_lines
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.sheet.annotations.hatching_runs import _directions
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.labels_network import ink_labels
from gaussiancad_core.sheet.line_conventions import HATCHING
from gaussiancad_core.sheet.picture_noise import PARALLEL
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
SIZE = "width=1440,height=900,section=front"


@cache
def _lines(part: str) -> PartLines:
    kinds = tuple((Role.FRONT, kind) for kind in SectionKind)
    return part_lines(sample(part).build(), ROLES, sections=kinds)


def _near(ink: np.ndarray, px: int) -> np.ndarray:
    return cv2.dilate(ink.astype(np.uint8), np.ones((2 * px + 1, 2 * px + 1), np.uint8)) > 0


@pytest.mark.parametrize(
    ("part", "look"),
    [
        ("counterbored-block", "clean,annotation-width=3"),
        ("stepped-shaft", "clean,hatch-pitch=8"),
        ("counterbored-block", "clean,hatch-pitch=30"),
        ("counterbored-block", "scan,skew=0,section-kind=half"),
        ("stepped-shaft", "clean,section-kind=broken-out"),
        ("stepped-shaft", "photocopy,skew=0"),
        ("counterbored-block", "dimensioned"),
    ],
)
def test_hatching_is_taken_off(part: str, look: str) -> None:
    style = parse_style(f"{look},{SIZE}")
    drawn = compose_sheet(_lines(part), Projection.THIRD, style)
    clean = clean_sheet(cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY))
    separated = separate_by_labels(clean, ink_labels(clean.picture))
    hatching = tuple(m for m in drawn.annotations if m.kind is AnnotationKind.HATCHING)
    strokes = tuple(stroke for view in drawn.views for stroke in view.strokes)
    part_ink = rasterise(strokes, style) > 0.5
    others = tuple(m for m in drawn.annotations if m.kind is not AnnotationKind.HATCHING)
    neighbour = _near(part_ink, 4)
    if others:
        neighbour |= _near(ink_annotations(others, style) > 0.1, 4)
    lines = (ink_annotations(hatching, style) > 0.5) & ~neighbour
    assert lines.sum() > 200
    assert (lines & separated.part.ink).sum() <= 0.015 * lines.sum()
    kept = _near(separated.part.ink, 1)
    assert (part_ink & kept).sum() >= 0.985 * (part_ink & _near(clean.ink, 1)).sum()
    # The marks lie around the lines, and within the view.
    boxes = [m.box for m in separated.marks if m.kind is AnnotationKind.HATCHING]
    x0, y0, x1, y1 = hatching[0].box
    low, high = np.min(boxes, axis=0)[:2], np.max(boxes, axis=0)[2:]
    assert (*low, *high) == pytest.approx((x0, y0, x1, y1), abs=0.8 * style.hatch_pitch + 8)
    assert separated.hatched is not None


def test_hatching_of_a_turned_sheet_is_taken_off() -> None:
    style = parse_style(f"photocopy,{SIZE}")
    drawn = compose_sheet(_lines("counterbored-block"), Projection.THIRD, style)
    clean = upright_sheet(clean_sheet(cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)))
    separated = separate_by_labels(clean, ink_labels(clean.picture))
    upright = tuple(
        mark.turned(np.radians(3.0), (720.0, 450.0))
        for mark in drawn.annotations
        if mark.kind is AnnotationKind.HATCHING
    )
    lines = ink_annotations(upright, style) > 0.5
    strokes = tuple(stroke for view in drawn.views for stroke in view.strokes)
    cosine, sine = np.cos(np.radians(3.0)), np.sin(np.radians(3.0))
    matrix = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0]])
    matrix[:, 2] = np.array([720.0, 450.0]) - matrix[:, :2] @ np.array([720.0, 450.0])
    part_ink = cv2.warpAffine(rasterise(strokes, style), matrix, (1440, 900)) > 0.3
    lines &= ~_near(part_ink, 5)
    assert lines.sum() > 2000
    assert (lines & separated.part.ink).sum() <= 0.015 * lines.sum()


def _teeth(sketch, steep: bool):  # noqa: ANN001, ANN202
    """A rack: a body whose upper side has many equal slanted edges."""
    corners = [(20.0, 130.0), (20.0, 80.0)]
    for k in range(7):
        start = 20.0 + 22.0 * k
        slant = (start + 22.0, 58.0)
        corners += [slant, (slant[0], 80.0)] if steep else [(start + 11.0, 58.0), (slant[0], 80.0)]
    corners += [(corners[-1][0], 130.0), (20.0, 130.0)]
    return sketch().lines(*corners)


@pytest.mark.parametrize("steep", [True, False])
def test_teeth_are_no_hatching(sketch, steep: bool) -> None:  # noqa: ANN001
    clean = clean_sheet(_teeth(sketch, steep).grey)
    separated = separate_by_labels(clean, ink_labels(clean.picture))
    assert AnnotationKind.HATCHING not in {mark.kind for mark in separated.marks}


def test_three_lines_are_no_hatching(sketch) -> None:  # noqa: ANN001
    drawn = sketch().lines((20, 20), (180, 20), (180, 140), (20, 140), (20, 20))
    for k in range(3):
        drawn.line((40.0 + 20.0 * k, 140.0), (160.0 + 20.0 * k - 40.0, 20.0))
    sheet = clean_sheet(drawn.grey)
    separated = separate_by_labels(sheet, ink_labels(sheet.picture))
    assert AnnotationKind.HATCHING not in {mark.kind for mark in separated.marks}


def test_hatching_goes_on_beyond_a_bore(sketch) -> None:  # noqa: ANN001
    """Two lines below it are as far from the others as these from each other."""
    drawn = sketch(160, 420).lines((20, 20), (120, 20), (120, 400), (20, 400), (20, 20))
    drawn.lines((20, 290), (120, 290)).lines((20, 350), (120, 350))
    for k in range(16):
        # Lines x + y = 20 (k + 4), cut off at the outline and at the bore.
        for low, high in ((20.0, 290.0), (350.0, 400.0)):
            total = 24.0 * k + 64.0
            first, last = max(20.0, total - high), min(120.0, total - low)
            if last - first > 8.0:
                drawn.line((first, total - first), (last, total - last), 2.0)
    clean = clean_sheet(drawn.grey)
    separated = separate_by_labels(clean, ink_labels(clean.picture))
    below = separated.part.ink[356:394, 26:114]
    assert clean.ink[356:394, 26:114].sum() > 100
    # What is left is where the lines touch the outline.
    assert below[:, 4:-4].sum() < 10


def _pieces(angles: np.ndarray, lengths: np.ndarray) -> list[SimpleNamespace]:
    return [
        SimpleNamespace(angle=float(angle), run=SimpleNamespace(length=float(length)))
        for angle, length in zip(angles, lengths, strict=True)
    ]


def _plain_directions(angles: np.ndarray, lengths: np.ndarray) -> list[float]:
    """The same by looking from each piece at all others."""
    found: list[float] = []
    left = np.ones(len(angles), dtype=bool)
    while left.sum() >= HATCHING:
        offsets = (angles - angles[:, None] + np.pi / 2) % np.pi - np.pi / 2
        near = (np.abs(offsets) < PARALLEL) & left
        best = int(np.argmax(np.where(left, (near * lengths).sum(axis=1), -1.0)))
        item = near[best]
        if item.sum() < HATCHING:
            break
        found.append(float(angles[best] + np.average(offsets[best][item], weights=lengths[item])))
        left &= ~item
    return found


@pytest.mark.parametrize("seed", range(5))
def test_directions_are_those_that_have_most_length_around_them(seed: int) -> None:
    lot = np.random.default_rng(seed)
    shared = lot.uniform(0.0, np.pi, 4)[lot.integers(4, size=150)] + lot.normal(0.0, 0.01, 150)
    angles = np.concatenate([shared, lot.uniform(0.0, np.pi, 60)]) % np.pi
    lengths = lot.uniform(100.0, 300.0, len(angles))
    plain = _plain_directions(angles, lengths)
    assert plain and _directions(_pieces(angles, lengths), 2.0) == pytest.approx(plain)


def test_directions_of_tens_of_thousands_of_pieces_fit_into_memory() -> None:
    lot = np.random.default_rng(0)
    angles, lengths = lot.uniform(0.0, np.pi, 60_000), lot.uniform(100.0, 300.0, 60_000)
    assert len(_directions(_pieces(angles, lengths), 2.0)) > 1

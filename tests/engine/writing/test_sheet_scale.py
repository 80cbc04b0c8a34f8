"""The scale of whole sheets, whose true one is known."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import Sheet, draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.files.vectors import VectorDrawing, VectorText
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.picture_views import picture_views
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views
from gaussiancad_core.writing import sheet_scale
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale, find_scale
from sample_parts import sample

Grey = npt.NDArray[np.uint8]

STYLES = {
    "iso": "dimensioned",
    "ansi": "ansi,annotations=on,frame=on,margin=130,view-gap=170",
    "askew": "dimensioned,skew=1.5",
}


@dataclass(frozen=True)
class Case:
    """A drawn sheet, and how it is read."""

    drawn: Sheet
    grey: Grey
    marks: tuple[Mark, ...]
    views: tuple[ReadView, ...]

    def scale(self, **image: object) -> SheetScale:
        """The scale of the sheet as an image of given properties."""
        read = SheetImage(Path("sheet.png"), self.grey, "", **image)
        marks = self.marks
        if read.vectors is not None:
            # What such a file does not have as a text is not on its sheet.
            marks = tuple(mark for mark in marks if mark.kind is not AnnotationKind.TEXT)
        return find_scale(OpenedSheet(read), marks, self.views)

    @property
    def texts(self) -> tuple[VectorText, ...]:
        """All that is written on it, as a vector file has it."""
        labels = (
            annotation.label
            for annotation in self.drawn.annotations
            if annotation.label is not None
        )
        corners = ((label, np.array(label.corners)) for label in labels)
        return tuple(
            VectorText(item.text, (*at.min(axis=0).tolist(), *at.max(axis=0).tolist()), item.angle)
            for item, at in corners
        )


@cache
def case(part: str, style: str) -> Case:
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    look = parse_style(STYLES[style])
    drawn = draw_sheet(sample(part).build(), roles, Projection.THIRD, look)
    grey = cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)
    image = SheetImage(Path("sheet.png"), grey, "")
    found = picture_views(OpenedSheet(image), {}, Projection.THIRD)
    views = read_views(found.separated.part, found.layout)
    return Case(drawn, grey, found.separated.marks, views)


def dimension_texts(sheet: Sheet) -> list[str]:
    """What its dimensions and leaders say."""
    groups = {
        annotation.group for annotation in sheet.annotations if annotation.value_mm is not None
    }
    labels = (
        annotation.label
        for annotation in sheet.annotations
        if annotation.label and annotation.group in groups
    )
    return sorted(label.text for label in labels)


@pytest.mark.parametrize(
    ("part", "style"), [("l-bracket", "iso"), ("pulley", "askew"), ("counterbored-block", "ansi")]
)
def test_dimensions_in_pixels_give_the_scale(part: str, style: str) -> None:
    this_case = case(part, style)
    found = this_case.scale()
    assert found.source is ScaleSource.DIMENSION
    assert found.mm_per_pixel == pytest.approx(this_case.drawn.mm_per_pixel, rel=0.002)
    assert found.notes == ()
    numbers = sorted(
        float(re.sub(r"^\d+x |[\u00d8R]", "", t)) for t in dimension_texts(this_case.drawn)
    )
    read = sorted(dimension.value_mm for dimension in found.dimensions if dimension.used)
    # Never a number that is not there; a few may not be told what they measure.
    left = list(numbers)
    for value in read:
        left.remove(value)
    assert len(read) >= 0.8 * len(numbers)


def test_texts_of_a_vector_file_are_taken_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    this_case = case("l-bracket", "iso")
    monkeypatch.delattr(sheet_scale, "pixel_texts")
    found = this_case.scale(
        vectors=VectorDrawing((), this_case.texts), pixels_per_inch=this_case.drawn.dpi
    )
    assert found.source is ScaleSource.DIMENSION
    assert found.mm_per_pixel == pytest.approx(this_case.drawn.mm_per_pixel, rel=0.002)
    texts = [dimension.text for dimension in found.dimensions if dimension.used]
    assert sorted(texts) == dimension_texts(this_case.drawn)
    assert found.notes == ()


def in_inches(text: VectorText) -> VectorText:
    """The text with its number as a decimal of an inch."""
    said = re.fullmatch(r"(\u00d8?)(\d+(?:\.\d+)?)", text.text)
    if said is None:
        return text
    decimal = f"{float(said[2]) / 25.4:.4f}".removeprefix("0")
    return replace(text, text=said[1] + decimal)


@pytest.mark.parametrize("noted", [True, False])
def test_inch_sheets_come_out_in_millimetres(noted: bool) -> None:
    this_case = case("l-bracket", "iso")
    # Their other note says millimetres.
    texts = tuple(in_inches(text) for text in this_case.texts if text.text != "mm")
    if noted:
        texts += (VectorText("DIMENSIONS ARE IN INCHES", (1600.0, 870.0, 1800.0, 880.0)),)
    dpi = None if noted else this_case.drawn.dpi
    found = this_case.scale(vectors=VectorDrawing((), texts), pixels_per_inch=dpi)
    assert found.source is ScaleSource.DIMENSION
    assert found.mm_per_pixel == pytest.approx(this_case.drawn.mm_per_pixel, rel=0.002)


def test_a_wrong_dimension_is_named_with_its_place() -> None:
    this_case = case("l-bracket", "iso")
    texts = tuple(
        replace(text, text="88") if text.text == "80" else text for text in this_case.texts
    )
    found = this_case.scale(vectors=VectorDrawing((), texts))
    assert found.mm_per_pixel == pytest.approx(this_case.drawn.mm_per_pixel, rel=0.002)
    (note,) = found.contradictions
    assert note not in found.notes
    (place,) = (text.box for text in texts if text.text == "88")
    assert note.code == "dimensions-disagree"
    assert f"'88' at ({place[0]:.0f}, {place[1]:.0f})" in note.message
    (wrong,) = (
        dimension for dimension in found.dimensions if dimension.mm_per_pixel and not dimension.used
    )
    assert wrong.mm_per_pixel == pytest.approx(1.1 * found.mm_per_pixel, rel=0.002)


def only(keep: Callable[[str], bool], case: Case) -> VectorDrawing:
    """The sheet's texts, but for some."""
    return VectorDrawing((), tuple(text for text in case.texts if keep(text.text)))


def test_without_dimensions_paper_and_scale_note_tell() -> None:
    this_case = case("l-bracket", "iso")
    vectors = only(lambda text: not re.search(r"\d", text) or ":" in text, this_case)
    found = this_case.scale(vectors=vectors, pixels_per_inch=this_case.drawn.dpi)
    assert (found.source, found.dimensions, found.notes) == (ScaleSource.SHEET, (), ())
    assert found.mm_per_pixel == pytest.approx(this_case.drawn.mm_per_pixel, rel=1e-9)
    smaller = VectorDrawing((), tuple(replace(t, text="1:5") for t in vectors.texts))
    found = this_case.scale(vectors=smaller, pixels_per_inch=this_case.drawn.dpi)
    assert found.mm_per_pixel == pytest.approx(5.0 * 25.4 / this_case.drawn.dpi, rel=1e-9)


def test_a_vector_sheet_without_a_note_is_full_scale_and_says_so() -> None:
    this_case = case("l-bracket", "iso")
    found = this_case.scale(vectors=only(str.isalpha, this_case), pixels_per_inch=200.0)
    assert found.source is ScaleSource.SHEET
    assert found.mm_per_pixel == pytest.approx(0.127, rel=1e-9)
    assert [note.code for note in found.notes] == ["full-scale-assumed"]


def test_a_wrong_note_of_the_unit_is_named_though_no_dimensions_give_the_scale() -> None:
    this_case = case("l-bracket", "iso")
    note = VectorText("DIMENSIONS ARE IN INCHES", (1600.0, 870.0, 1800.0, 880.0))
    (text,) = (text for text in this_case.texts if text.text == "80")
    vectors = VectorDrawing((), (text, note), unit_mm=1.0)
    found = this_case.scale(vectors=vectors, pixels_per_inch=25.4 / this_case.drawn.mm_per_pixel)
    assert found.source is ScaleSource.SHEET
    assert [note.code for note in found.contradictions] == ["unit-contradicts-note"]


def test_a_sheet_without_texts_says_nothing_of_its_scale() -> None:
    item = replace(case("l-bracket", "iso"), marks=())
    assert item.scale() == SheetScale(None, ScaleSource.DEFAULT)

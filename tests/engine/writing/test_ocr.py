"""Texts read from pixels, without a network connection."""

import socket
from importlib.metadata import PackageNotFoundError

import numpy as np
import pytest

from gaussiancad_core.drawing.lettering import ink_label, label
from gaussiancad_core.writing import ocr
from gaussiancad_core.writing.numbers import parse_dimension
from gaussiancad_core.writing.ocr import ocr_problem, read_text

needs_ocr = pytest.mark.skipif(ocr_problem() is not None, reason=f"OCR is {ocr_problem()}")


def written(text: str, height: float) -> np.ndarray:
    """(h, w) ink of a text, as it is cut out of a sheet."""
    name = label(text, (0.0, 0.0), height)
    ink = np.zeros((int(1.5 * height) + 8, int(name.width) + 12), np.float32)
    ink_label(ink, label(text, (ink.shape[1] / 2, ink.shape[0] / 2), height))
    rows, columns = np.nonzero(ink > 0.3)
    return ink[rows.min() - 2 : rows.max() + 3, columns.min() - 2 : columns.max() + 3]


@needs_ocr
@pytest.mark.parametrize("height", [12.0, 18.0, 40.0])
@pytest.mark.parametrize(
    "text", ["1", "7", "12", "80", "12.5", "0.25", "347.18", "R12", "1:2", "ISO 2768-m", '2.50"']
)
def test_lines_of_text_are_read(text: str, height: float) -> None:
    found = read_text(written(text, height))
    assert found.text.replace(" ", "") == text.replace(" ", "")
    assert found.confidence > 0.8


@needs_ocr
@pytest.mark.parametrize("value", [6.0, 16.0, 36.0, 120.0])
def test_a_diameter_keeps_its_number_even_where_its_sign_is_lost(value: float) -> None:
    found = parse_dimension(read_text(written(f"\u00d8{value:g}", 18.0)).text)
    assert found.value == value


@needs_ocr
def test_paper_says_nothing() -> None:
    assert read_text(np.zeros((20, 60), np.float32)).text == ""


@needs_ocr
def test_the_same_picture_reads_the_same() -> None:
    picture = written("4x R12", 18.0)
    assert read_text(picture) == read_text(picture)


@needs_ocr
def test_no_connection_is_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a connection was opened")

    monkeypatch.setattr(socket, "socket", refuse)
    monkeypatch.setattr(socket, "create_connection", refuse)
    monkeypatch.setattr(socket, "getaddrinfo", refuse)
    ocr._network.cache_clear()
    assert read_text(written("48", 18.0)).text == "48"


def test_the_extra_may_be_absent(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(_: str) -> None:
        raise PackageNotFoundError

    monkeypatch.setattr(ocr, "distribution", missing)
    assert 'pip install "gaussiancad-core[ocr]"' in ocr_problem()


@needs_ocr
def test_what_was_read_before_is_not_read_again() -> None:
    picture = written("17.5", 18.0)
    first = read_text(picture)
    known = ocr._read_prepared.cache_info()
    assert read_text(picture.copy()) == first
    assert ocr._read_prepared.cache_info().hits == known.hits + 1
    assert ocr._read_prepared.cache_info().misses == known.misses

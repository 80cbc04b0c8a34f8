"""Texts read from pixels, without a network connection."""

import hashlib
import re
import socket
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.drawing.lettering import ink_label, label
from gaussiancad_core.errors import EngineError
from gaussiancad_core.writing import ocr
from gaussiancad_core.writing.numbers import parse_dimension
from gaussiancad_core.writing.ocr import network_weights, read_text

NETWORK = Path(ocr.__file__).with_name("text_network")


def written(text: str, height: float) -> np.ndarray:
    """(h, w) ink of a text, as it is cut out of a sheet."""
    name = label(text, (0.0, 0.0), height)
    ink = np.zeros((int(1.5 * height) + 8, int(name.width) + 12), np.float32)
    ink_label(ink, label(text, (ink.shape[1] / 2, ink.shape[0] / 2), height))
    rows, columns = np.nonzero(ink > 0.3)
    return ink[rows.min() - 2 : rows.max() + 3, columns.min() - 2 : columns.max() + 3]


@pytest.mark.parametrize("height", [12.0, 18.0, 40.0])
@pytest.mark.parametrize(
    "text", ["1", "7", "12", "80", "12.5", "0.25", "347.18", "R12", "1:2", "ISO 2768-m", '2.50"']
)
def test_lines_of_text_are_read(text: str, height: float) -> None:
    found = read_text(written(text, height))
    assert found.text.replace(" ", "") == text.replace(" ", "")
    assert found.confidence > 0.8


@pytest.mark.parametrize("value", [6.0, 16.0, 36.0, 120.0])
def test_a_diameter_keeps_its_number_even_where_its_sign_is_lost(value: float) -> None:
    found = parse_dimension(read_text(written(f"\u00d8{value:g}", 18.0)).text)
    assert found.value == value


def test_paper_says_nothing() -> None:
    assert read_text(np.zeros((20, 60), np.float32)).text == ""


def test_no_connection_is_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a connection was opened")

    monkeypatch.setattr(socket, "socket", refuse)
    monkeypatch.setattr(socket, "create_connection", refuse)
    monkeypatch.setattr(socket, "getaddrinfo", refuse)
    ocr._network.cache_clear()
    assert read_text(written("48", 18.0)).text == "48"


def test_the_network_is_the_one_that_its_card_tells_of() -> None:
    weights = network_weights()
    digest = hashlib.sha256(weights).hexdigest()
    card = (NETWORK / "README.md").read_text(encoding="utf-8")
    (stated,) = re.findall(r"SHA-256 of the file \| `([0-9a-f]{64})`", card)
    assert stated == digest
    assert f"{len(weights):,} bytes" in card
    assert "Apache License" in (NETWORK / "LICENSE").read_text(encoding="utf-8")


def test_all_characters_that_are_looked_for_are_known() -> None:
    network = ocr._network()
    assert network.characters == "".join(c for c in ocr._ALPHABET if c in network.characters)
    assert len(network.columns) == len(network.characters) + 1 == len(set(network.columns.tolist()))
    lost = set(ocr._ALPHABET) - set(network.characters)
    assert lost == set()


@pytest.mark.parametrize("name", ["absent.onnx", "README.md"])
def test_another_file_is_no_network(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ocr, "_WEIGHTS", name)
    with pytest.raises(EngineError, match="text network is missing or damaged") as caught:
        network_weights()
    assert caught.value.code == "engine-incomplete"

"""The card says of the shipped network what is true, and nothing else passes for one."""

import json
import subprocess
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning import model_card as card_module
from learning.label_checking import KINDS, figure_of
from learning.model_card import (
    NOT_KNOWN,
    SCHEMA,
    Card,
    commit,
    read_card,
    write_card,
)
from learning.unet import LabelsNetwork

pytestmark = pytest.mark.slow


@pytest.fixture
def path() -> Path:
    """Of the shipped card."""
    return Path(str(files("gaussiancad_core.sheet.labels").joinpath("labels.json")))


@pytest.fixture
def shipped(path: Path) -> Card:
    """The shipped card."""
    return read_card(path)


def test_the_shipped_card_is_of_the_shipped_network(path: Path, shipped: Card) -> None:
    assert shipped.schema == SCHEMA
    digest = path.with_name("labels.onnx.sha256").read_text(encoding="ascii").strip()
    assert shipped.sha256 == digest
    assert shipped.classes == tuple(item.name.lower() for item in InkClass)
    assert shipped.parameters == sum(
        parameter.numel() for parameter in LabelsNetwork().parameters()
    )


def test_the_shipped_card_names_every_source(shipped: Card) -> None:
    data = shipped.data
    assert sum(item.sheets for item in data.trained_on) == 23
    assert all(item.licence.startswith(("BSD", "CC0")) for item in data.trained_on)
    checked = {item.name for item in data.validated_on}
    assert not checked & {item.name for item in data.trained_on}
    assert {figure.source for figure in shipped.figures} == checked | {"all"}
    assert {figure.factor for figure in shipped.figures} == {1.0, 0.6, 0.4}


def test_the_figures_of_the_shipped_card_follow_from_its_counts(shipped: Card) -> None:
    for figure in shipped.figures:
        assert figure == figure_of(figure.source, figure.factor, np.array(figure.px))


def test_what_has_no_pixel_has_no_share() -> None:
    figure = figure_of("a", 1.0, np.array([[8, 0, 2], [0, 0, 0], [0, 0, 10]]))
    assert figure.precision == dict(zip(KINDS, (1.0, None, 0.8333), strict=True))
    assert figure.recall == dict(zip(KINDS, (0.8, None, 1.0), strict=True))


def test_a_card_is_read_as_written(shipped: Card, tmp_path: Path) -> None:
    write_card(shipped, tmp_path / "card.json")
    assert read_card(tmp_path / "card.json") == shipped


@pytest.mark.parametrize("key", ["sha256", "data", "training", "figures", "calibration"])
def test_a_card_without_a_key_is_none(path: Path, tmp_path: Path, key: str) -> None:
    stated = json.loads(path.read_text(encoding="utf-8"))
    del stated[key]
    (tmp_path / "card.json").write_text(json.dumps(stated), encoding="utf-8")
    with pytest.raises(UnreadableError, match=key) as error:
        read_card(tmp_path / "card.json")
    assert error.value.code == "file-unreadable"


def test_another_schema_and_no_file_are_told(path: Path, tmp_path: Path) -> None:
    other = tmp_path / "card.json"
    other.write_text(path.read_text(encoding="utf-8").replace(SCHEMA, "other/2"), encoding="utf-8")
    with pytest.raises(UnreadableError, match="other/2"):
        read_card(other)
    with pytest.raises(UnreadableError) as error:
        read_card(tmp_path / "absent.json")
    assert error.value.code == "file-missing"


def test_what_is_no_checkout_has_no_commit(monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*_: object, **__: object) -> None:
        raise subprocess.CalledProcessError(128, "git")

    monkeypatch.setattr(card_module.subprocess, "run", failing)
    assert commit() == NOT_KNOWN

"""The card of a trained network: on what it was trained, how, and how good it is.

``labels.json`` beside ``labels.onnx``; each dataclass here is one object of the file.
"""

import json
import subprocess
from dataclasses import asdict, dataclass
from pathlib import Path

from gaussiancad_core.errors import UnreadableError
from gaussiancad_protocol.codes import Code
from learning.calibration import Calibration
from learning.label_checking import Figure

SCHEMA = "gaussiancad-labels-card/1"

NOT_KNOWN = "not known"
"""Commit of what is no checkout."""


@dataclass(frozen=True)
class Source:
    """Published sheets of somebody.

    Attributes:
        name: of the source.
        licence: of its sheets.
        sheets: how many.
    """

    name: str
    licence: str
    sheets: int


@dataclass(frozen=True)
class Data:
    """What the network was shown.

    Attributes:
        parts: drawn ones of which sheets were made.
        held_out: of them, never trained on.
        samples: crops made for the training.
        trained_on: published sheets that it learnt from.
        validated_on: published sheets that it never saw.
        fonts: of the writing on generated sheets.
    """

    parts: int
    held_out: int
    samples: int
    trained_on: tuple[Source, ...]
    validated_on: tuple[Source, ...]
    fonts: tuple[str, ...]


@dataclass(frozen=True)
class Training:
    """How it was trained.

    Attributes:
        started_from: file name of the weights that it began with; None from chance.
        steps: batches learnt from.
        batch: crops of each.
        size: px of the sides of a crop.
        rate: the highest rate of learning.
        seconds: s of the clock.
        workers: processes that made sheets.
        seed: of everything.
        device: that it was trained on.
        torch: version.
        commit: of the checkout, with ``+`` where it was changed since.
    """

    started_from: str | None
    steps: int
    batch: int
    size: int
    rate: float
    seconds: float
    workers: int
    seed: int
    device: str
    torch: str
    commit: str


@dataclass(frozen=True)
class Card:
    """All that is told of a network.

    Attributes:
        parameters: numbers that were trained.
        classes: names of the outputs.
        sha256: digest of the ONNX file.
        data: what it was shown.
        training: how it was trained.
        calibration: how far its log-odds are trusted; None as they are.
        figures: how good it is, by source and by factor.
        note: what else there is to say.
        schema: of the card.
    """

    parameters: int
    classes: tuple[str, ...]
    sha256: str
    data: Data
    training: Training
    calibration: Calibration | None
    figures: tuple[Figure, ...]
    note: str = ""
    schema: str = SCHEMA


def write_card(card: Card, path: Path) -> None:
    """Write a card as JSON."""
    path.write_text(json.dumps(asdict(card), indent=1) + "\n", encoding="utf-8")


def read_card(path: Path) -> Card:
    """Read a card, every key and type of which is looked at.

    Raises:
        UnreadableError: ``file-missing``, ``file-unreadable``.
    """
    # Machines that only train have no need of it.
    import msgspec

    try:
        card = msgspec.json.decode(path.read_bytes(), type=Card)
        if card.schema != SCHEMA:
            raise ValueError(f"its schema is {card.schema}")
    except FileNotFoundError as error:
        raise UnreadableError(
            Code.FILE_MISSING, "{path} does not exist: check the name of the card", path=path
        ) from error
    except (OSError, ValueError, msgspec.MsgspecError) as error:
        raise UnreadableError(
            Code.FILE_UNREADABLE,
            "{path} is no card of a labels network ({reason}): make it anew",
            path=path,
            reason=error,
        ) from error
    return card


def commit() -> str:
    """What the checkout is at, with ``+`` where it was changed since."""
    stated = []
    for items in (["rev-parse", "--short", "HEAD"], ["status", "--porcelain", "-uno"]):
        try:
            run = subprocess.run(
                ["git", *items],
                cwd=Path(__file__).parent,
                capture_output=True,
                text=True,
                check=True,
            )
        except (OSError, subprocess.CalledProcessError):
            return NOT_KNOWN
        stated.append(run.stdout.strip())
    return stated[0] + ("+" if stated[1] else "")

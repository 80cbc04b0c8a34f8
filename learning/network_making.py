"""The whole way from parts to a network that the engine loads, with its card."""

import random
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

import torch

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.storage.outputs import check_writable, os_error
from learning.calibration import Calibration, calibrated
from learning.export import write_network
from learning.feeding import FeedPlan, feeding
from learning.label_checking import Figure, figures_of
from learning.mixing import Composing, Mixture
from learning.model_card import Card, Data, Source, Training, commit, write_card
from learning.published import Published, PublishedSheet, published_sheets
from learning.schedule import ByClock, BySteps, best_rate
from learning.training import Tell, Trained, train
from learning.training_devices import Place, device_name, device_of
from learning.training_samples import Sample
from learning.unet import LabelsNetwork
from learning.weights import save_weights, starting_network

NETWORK_FILE, WEIGHTS_FILE, CARD_FILE = "labels.onnx", "weights.pt", "labels.json"

TEMPERATURE = "temperature"
"""Key of the ONNX file's metadata of the number by which log-odds are multiplied."""

_HELD_OUT = 12
"""One part in so many is never trained on."""

_CHECKED = 60
"""Crops of generated sheets of held out parts on which the network is checked."""

_GENERATED = "generated"
"""Source of these."""

_SEEDS = 2**31
"""First seed of these: the workers' are smaller."""


@dataclass(frozen=True)
class Generator:
    """What draws.

    Attributes:
        draw: parts, from a seed, and how many.
        compose: crops of sheets of parts.
        fonts: names of the fonts of their writing.
    """

    draw: Callable[[int, int], Sequence[Any]]
    compose: Composing
    fonts: tuple[str, ...] = ()


@dataclass(frozen=True)
class Order:
    """What is asked for.

    Attributes:
        out: folder, made where it is missing.
        seconds: s of training, by the clock; without meaning where there are steps.
        steps: batches to learn from; None to go by the clock.
        parts: to be drawn.
        workers: processes that make sheets.
        place: where it is trained.
        size: px of the sides of a crop, a multiple of 32.
        batch: crops to learn from at once.
        published: folder of sheets to learn from, too.
        validation: folder of sheets to calibrate and check on.
        start: weights to start from.
        seed: of everything.
    """

    out: Path
    seconds: float = 520.0
    steps: int | None = None
    parts: int = 731
    workers: int = 1
    place: Place = Place.AUTO
    size: int = 640
    batch: int = 32
    published: Path | None = None
    validation: Path | None = None
    start: Path | None = None
    seed: int = 0


@dataclass(frozen=True, eq=False)
class _Shown:
    """What a network learns from and is checked on.

    Attributes:
        learnt: drawn parts to learn from.
        held_out: others, to check on.
        published: sheets to learn from, too.
        validation: sheets to calibrate and check on.
    """

    learnt: Sequence[Any]
    held_out: Sequence[Any]
    published: Published = field(default_factory=Published)
    validation: Published = field(default_factory=Published)


def make(order: Order, generator: Generator, tell: Tell) -> Card:
    """Train a network and write it: the files named at the head of this module.

    Args:
        order: what is asked for.
        generator: draws parts and sheets.
        tell: takes a line about how it goes.

    Returns:
        The card, as written.

    Raises:
        GaussianCadError: of many kinds; nothing was drawn yet where a folder or file is wrong.
    """
    device = device_of(order.place)
    network = starting_network(order.start, order.seed)
    published, validation = _sheets(order.published), _sheets(order.validation)
    _make_folder(order.out)
    learnt, held_out = _parts(order, generator)
    shown = _Shown(learnt, held_out, published, validation)
    tell(
        f"{len(learnt)} parts, {len(held_out)} more held out, "
        f"{len(published.sheets)} published sheets, {len(validation.sheets)} to check on"
    )
    begun = time.monotonic()
    trained = _trained(order, network, generator, shown, device=device, tell=tell)
    seconds = time.monotonic() - begun
    tell(f"trained {trained.steps} steps in {seconds:.0f} s on {trained.samples} samples")
    save_weights(trained.network, order.out / WEIGHTS_FILE)
    calibration, figures = _judged(order, trained.network, generator, shown, device)
    metadata = {TEMPERATURE: str(calibration.temperature)} if calibration else {}
    card = Card(
        parameters=sum(parameter.numel() for parameter in trained.network.parameters()),
        classes=tuple(ink_class.name.lower() for ink_class in InkClass),
        sha256=write_network(trained.network, order.out / NETWORK_FILE, metadata),
        data=_data(shown, trained, generator),
        training=_training(order, trained, seconds, device),
        calibration=calibration,
        figures=figures,
    )
    write_card(card, order.out / CARD_FILE)
    return card


def _sheets(folder: Path | None) -> Published:
    return published_sheets(folder) if folder else Published()


def _make_folder(path: Path) -> None:
    check_writable(path)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise os_error(path, error) from error


def _parts(order: Order, generator: Generator) -> tuple[Sequence[Any], Sequence[Any]]:
    """Parts to learn from, and parts to check on."""
    parts = list(generator.draw(order.seed, order.parts))
    random.Random(order.seed).shuffle(parts)
    count = max(1, len(parts) // _HELD_OUT)
    return parts[count:], parts[:count]


def _trained(
    order: Order,
    network: LabelsNetwork,
    generator: Generator,
    shown: _Shown,
    *,
    device: torch.device,
    tell: Tell,
) -> Trained:
    """The network after its training; the workers live as long as it takes."""
    paced = order.steps is not None
    plan = FeedPlan(order.size, order.batch, order.workers, paced=paced, seed=order.seed)
    mixture = Mixture(
        shown.learnt, generator.compose, shown.published.sheets, order.size, order.seed
    )
    with feeding(plan, mixture.stream()) as feed:
        course = ByClock(order.seconds) if order.steps is None else BySteps(order.steps)
        most = best_rate(order.batch, order.size)
        return train(network, feed, course, most=most, device=device, tell=tell)


def _judged(
    order: Order,
    network: LabelsNetwork,
    generator: Generator,
    shown: _Shown,
    device: torch.device,
) -> tuple[Calibration | None, tuple[Figure, ...]]:
    """How far to trust the network, and how good it is; it is back on the CPU afterwards."""
    network.to(device)
    sheets = shown.validation.sheets
    calibration = calibrated(network, sheets, device)
    figures = figures_of(network, sheets, device)
    generated = _generated(order, generator, shown.held_out)
    figures += figures_of(network, generated, device, factors=(1.0,))
    network.cpu()
    return calibration, figures


def _generated(
    order: Order, generator: Generator, parts: Sequence[Any]
) -> tuple[PublishedSheet, ...]:
    """Crops of sheets on which parts are that the network never saw, one of each sheet."""
    first = _SEEDS + order.seed * _CHECKED
    found: list[Sample] = []
    for seed in range(first, first + _CHECKED):
        found += islice(generator.compose(seed, parts, order.size, 1), 1)
    return tuple(PublishedSheet(_GENERATED, _GENERATED, item) for item in found)


def _data(shown: _Shown, trained: Trained, generator: Generator) -> Data:
    return Data(
        parts=len(shown.learnt) + len(shown.held_out),
        held_out=len(shown.held_out),
        samples=trained.samples,
        trained_on=_sources(shown.published),
        validated_on=_sources(shown.validation),
        fonts=generator.fonts,
    )


def _training(order: Order, trained: Trained, seconds: float, device: torch.device) -> Training:
    return Training(
        started_from=order.start.name if order.start else None,
        steps=trained.steps,
        batch=order.batch,
        size=order.size,
        rate=best_rate(order.batch, order.size),
        seconds=round(seconds, 1),
        workers=order.workers,
        seed=order.seed,
        device=device_name(device),
        torch=torch.__version__,
        commit=commit(),
    )


def _sources(published: Published) -> tuple[Source, ...]:
    counts = published.counts()
    return tuple(Source(name, licence, counts[name]) for name, licence in published.licences)

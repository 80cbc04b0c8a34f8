"""A network is trained on samples of workers, the same twice, and wrong folders are told."""

import hashlib
import json
import os
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import count, islice
from pathlib import Path

import cv2
import numpy as np
import pytest
import torch

from gaussiancad_core.errors import EngineError, UnreadableError, UsageError
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning import feeding as feeding_module
from learning.calibration import likeliest_temperature
from learning.feeding import Batch, FeedPlan, feeding
from learning.label_checking import figures_of
from learning.learning_command import main
from learning.loss import labels_loss
from learning.mixing import Mixture
from learning.model_card import read_card
from learning.network_making import Generator, Order, make
from learning.published import (
    NOT_TOLD,
    PublishedSheet,
    published_crop,
    published_sheets,
)
from learning.schedule import ByClock, BySteps, best_rate, rate_at
from learning.training import train
from learning.training_devices import Place
from learning.training_samples import (
    EITHER,
    HEAT_MOST,
    HEAT_SHIFT,
    ON_HIDDEN,
    SOME_ANNOTATION,
    UNKNOWN,
    Sample,
)
from learning.unet import LabelsNetwork
from learning.weights import starting_network

pytestmark = pytest.mark.slow

SIZE = 64
CPU = torch.device("cpu")


@pytest.fixture(autouse=True)
def one_thread() -> Iterator[None]:
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    yield
    torch.set_num_threads(before)


def silent(_: str) -> None:
    """Tells nothing."""


def drawn(seed: int, size: int = SIZE) -> Sample:
    """A wide rectangle, a dashed line in it and a thin line beside it."""
    rng = np.random.default_rng(seed)
    grey, classes = np.full((size, size), 255, np.uint8), np.zeros((size, size), np.uint8)
    extra = np.zeros((size, size), np.uint8)
    x, y = rng.integers(4, 16, 2).tolist()
    w, h = rng.integers(24, 40, 2).tolist()
    row = y + h // 2
    for start in range(x + 3, x + w - 3, 9):
        cv2.line(grey, (start, row), (start + 5, row), 0, 1)
        cv2.line(classes, (start, row), (start + 5, row), int(InkClass.HIDDEN), 1)
    cv2.line(extra, (x, row), (x + w, row), ON_HIDDEN, 1)
    cv2.rectangle(grey, (x, y), (x + w, y + h), 0, 3)
    cv2.rectangle(classes, (x, y), (x + w, y + h), int(InkClass.VISIBLE), 3)
    extra[y, x] |= HEAT_MOST << HEAT_SHIFT
    cv2.line(grey, (0, y + h + 5), (size, y + h + 5), 60, 1)
    cv2.line(classes, (0, y + h + 5), (size, y + h + 5), int(InkClass.DIMENSION), 1)
    return Sample(grey, classes, extra)


def composed(seed: int, parts: Sequence[int], size: int, most: int) -> Iterator[Sample]:
    """Stands for the sheets."""
    yield from (drawn(1000 * seed + item + parts[0], size) for item in range(most))


GENERATOR = Generator(draw=lambda seed, most: list(range(seed, seed + most)), compose=composed)


def order(out: Path, **more: object) -> Order:
    """A small one."""
    small = Order(out, steps=3, parts=12, place=Place.CPU, size=SIZE, batch=4, workers=1, seed=3)
    return replace(small, **more)


def sheets_folder(folder: Path, licences: bool = True) -> Path:
    """Two sheets of one maker and one of another."""
    folder.mkdir()
    for seed, name in enumerate(("one+a", "one+b", "other+c")):
        this_drawn = drawn(seed, 160)
        classes = np.where(
            this_drawn.classes > InkClass.HIDDEN, SOME_ANNOTATION, this_drawn.classes
        )
        cv2.imwrite(str(folder / f"{name}.img.png"), this_drawn.grey)
        cv2.imwrite(str(folder / f"{name}.lab.png"), classes.astype(np.uint8))
    if licences:
        (folder / "LICENCES.json").write_text(json.dumps({"one": "CC0-1.0"}))
    return folder


def test_training_makes_the_loss_fall() -> None:
    plan = FeedPlan(SIZE, batch=4, slots=32, paced=True)
    with feeding(plan, lambda _: (drawn(item % 20) for item in count())) as feed:
        trained = train(
            starting_network(None, 1), feed, BySteps(20), most=2e-3, device=CPU, tell=silent
        )
    first, last = np.mean(trained.losses[:4]), np.mean(trained.losses[-4:])
    assert trained.steps == len(trained.losses) == 20
    assert last < 0.6 * first
    assert not trained.network.training


def test_training_by_the_clock_ends_with_it() -> None:
    batches = list(islice(_batches(1), 4))
    begun = time.monotonic()
    trained = train(
        starting_network(None, 1),
        (batches[item % 4] for item in count()),
        ByClock(1.0),
        most=1e-3,
        device=CPU,
        tell=silent,
    )
    assert time.monotonic() - begun >= 1.0
    assert trained.steps > 0


def _batches(seed: int) -> Iterator[Batch]:
    for number in count():
        samples = [drawn(seed + 4 * number + item) for item in range(4)]
        maps = np.stack([[sample.grey, sample.classes, sample.extra] for sample in samples], axis=1)
        yield Batch(maps, np.ones(4, np.float32), 4 * (number + 1))


def test_a_loss_that_is_no_number_is_not_learnt_from() -> None:
    def broken() -> Iterator[Batch]:
        for number, batch in enumerate(_batches(1)):
            gain = np.full(4, np.nan if number == 2 else 1.0, np.float32)
            yield replace(batch, gain=gain)

    trained = train(
        starting_network(None, 1), broken(), BySteps(5), most=1e-3, device=CPU, tell=silent
    )
    assert len(trained.losses) == 4
    assert all(torch.isfinite(item).all() for item in trained.network.state_dict().values())


def test_an_error_of_the_feed_ends_the_training() -> None:
    def broken() -> Iterator[Batch]:
        yield from islice(_batches(1), 1)
        raise EngineError("worker-lost", "lost")

    with pytest.raises(EngineError, match="lost"):
        train(starting_network(None, 1), broken(), BySteps(5), most=1e-3, device=CPU, tell=silent)


def test_paced_batches_are_the_same_with_any_speed_of_the_workers() -> None:
    plan = FeedPlan(SIZE, batch=4, workers=2, slots=32, paced=True, seed=5)

    def stream(pause: float) -> list[Batch]:
        def made(number: int) -> Iterator[Sample]:
            for item in count():
                time.sleep(pause)
                yield drawn(100 * number + item)

        with feeding(plan, made) as feed:
            return list(islice(feed, 30))

    for one, other in zip(stream(0.0), stream(0.003), strict=True):
        assert np.array_equal(one.maps, other.maps)
        assert np.array_equal(one.gain, other.gain)


@pytest.mark.parametrize("paced", [True, False])
def test_batches_are_whole_samples_that_change(paced: bool) -> None:
    def numbered(number: int) -> Iterator[Sample]:
        for item in count():
            level = np.full((SIZE, SIZE), item % 250, np.uint8)
            yield Sample(level, level, level)

    seen: list[set[int]] = []
    with feeding(FeedPlan(SIZE, batch=8, slots=64, paced=paced), numbered) as feed:
        for batch in islice(feed, 40):
            levels = batch.maps[:, :, :1, :1]
            assert (batch.maps == levels).all()
            assert (levels == levels[0]).all()
            assert len(set(levels[0].ravel().tolist())) == 8
            seen.append(set(levels[0].ravel().tolist()))
            time.sleep(0.0 if paced else 0.01)
    assert max(seen[-1]) > max(seen[0])


def test_a_lost_worker_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(feeding_module, "_PAUSE", 0.001)

    def ending(_: int) -> Iterator[Sample]:
        yield drawn(1)
        os._exit(7)

    with (
        feeding(FeedPlan(SIZE, batch=4, slots=32), ending) as feed,
        pytest.raises(EngineError) as stated,
    ):
        next(iter(feed))
    assert stated.value.code == "worker-lost"
    assert "7" in str(stated.value.message)


def test_a_sheet_that_fails_is_left_out_and_many_end_the_worker(
    capfd: pytest.CaptureFixture[str],
) -> None:
    def failing(seed: int, parts: Sequence[int], size: int, most: int) -> Iterator[Sample]:
        if seed % 2 or parts[0]:
            raise ZeroDivisionError
        return composed(seed, parts, size, most)

    mixture = Mixture([0], failing, (), SIZE, seed=1)
    assert len(list(islice(mixture.stream()(0), 30))) == 30
    assert "ZeroDivisionError" in capfd.readouterr().err
    with pytest.raises(RuntimeError, match="20 sheets"):
        next(replace(mixture, parts=[1]).stream()(0))


def test_the_loss_knows_what_counts() -> None:
    this_drawn = drawn(4)
    truth = (
        torch.from_numpy(np.stack([this_drawn.classes])),
        torch.from_numpy(np.stack([this_drawn.extra])),
    )
    right = torch.full((1, len(InkClass) + 2, SIZE, SIZE), -20.0)
    right.scatter_(1, truth[0][:, None].long(), 20.0)
    right[:, len(InkClass)] = torch.where((truth[1] & EITHER) == ON_HIDDEN, 20.0, -20.0)
    right[:, -1] = torch.where(truth[1] >> HEAT_SHIFT > 0, 20.0, -20.0)
    assert labels_loss(right, *truth) < 1e-6
    assert labels_loss(-right, *truth) > 10.0
    unknown = torch.full_like(truth[0], UNKNOWN)
    assert labels_loss(-right, unknown, unknown) == 0.0
    # Any kind of annotation will do where it is not known which.
    some = torch.full_like(truth[0], SOME_ANNOTATION)
    text = torch.full_like(right, -20.0)
    text[:, InkClass.TEXT] = 20.0
    edge = torch.full_like(right, -20.0)
    edge[:, InkClass.VISIBLE] = 20.0
    assert labels_loss(text, some, unknown) < 1e-6
    assert labels_loss(edge, some, unknown) > 10.0


def test_the_rate_rises_and_falls_and_goes_with_the_batch() -> None:
    rates = [rate_at(item, 1e-3) for item in np.linspace(0.0, 1.0, 200)]
    top = int(np.argmax(rates))
    assert rates[0] == rates[-1] == pytest.approx(1e-5)
    assert np.all(np.diff(rates[: top + 1]) > 0) and np.all(np.diff(rates[top:]) < 0)
    assert max(rates) == pytest.approx(1e-3, rel=0.02)
    assert best_rate(8, 640) == pytest.approx(best_rate(32, 640) / 2)


def test_the_temperature_is_found_again() -> None:
    rng = np.random.default_rng(0)
    log_odds = rng.normal(0.0, 3.0, 100_000)
    true = rng.random(log_odds.size) < 1.0 / (1.0 + np.exp(-log_odds))
    margins = np.where(true, log_odds, -log_odds)
    assert likeliest_temperature(margins) == pytest.approx(1.0, rel=0.03)
    assert likeliest_temperature(3.0 * margins) == pytest.approx(1.0 / 3.0, rel=0.03)


def test_figures_count_every_known_pixel_of_ink() -> None:
    sheets = [PublishedSheet(item, item, drawn(own_seed)) for own_seed, item in enumerate("ab")]
    found = figures_of(LabelsNetwork().eval(), sheets, CPU)
    assert [(item.source, item.factor) for item in found] == [
        (source, factor) for factor in (1.0, 0.6, 0.4) for source in ("a", "b", "all")
    ]
    whole = found[2]
    ink = sum((sheet.truth.classes > 0).sum() for sheet in sheets)
    assert np.sum(whole.px) == ink
    assert np.array_equal(whole.px, np.add(found[0].px, found[1].px))
    for row, kind in enumerate(whole.recall):
        assert whole.recall[kind] == round(whole.px[row][row] / sum(whole.px[row]), 4)


def test_published_sheets_are_read_with_their_licences(tmp_path: Path) -> None:
    published = published_sheets(sheets_folder(tmp_path / "sheets"))
    assert published.counts() == {"one": 2, "other": 1}
    assert dict(published.licences) == {"one": "CC0-1.0", "other": NOT_TOLD}
    rng = np.random.default_rng(2)
    crops = [published_crop(published.sheets, SIZE, rng) for _ in range(40)]
    assert all(crop.grey.shape == crop.classes.shape == (SIZE, SIZE) for crop in crops)
    known = {int(item) for crop in crops for item in np.unique(crop.classes)}
    assert known - {UNKNOWN} == {0, InkClass.VISIBLE, InkClass.HIDDEN, SOME_ANNOTATION}
    assert sum((crop.classes == InkClass.VISIBLE).any() for crop in crops) > 20


def test_two_runs_give_the_same_files(tmp_path: Path) -> None:
    published = sheets_folder(tmp_path / "published")
    outs = [tmp_path / item for item in ("a", "b")]
    for out in outs:
        make(order(out, published=published), GENERATOR, silent)
    one, other = (torch.load(this_out / "weights.pt", weights_only=True) for this_out in outs)
    assert one.keys() == other.keys()
    assert all(torch.equal(one[name], other[name]) for name in one)
    assert one["head.0.weight"].dtype == torch.float16
    assert (outs[0] / "labels.onnx").read_bytes() == (outs[1] / "labels.onnx").read_bytes()


def test_a_run_writes_the_network_with_its_temperature_and_card(tmp_path: Path) -> None:
    import onnx

    folder = sheets_folder(tmp_path / "sheets")
    out = tmp_path / "out" / "deep"
    card = make(order(out, validation=folder), GENERATOR, silent)
    assert read_card(out / "labels.json") == card
    data = (out / "labels.onnx").read_bytes()
    digest = hashlib.sha256(data).hexdigest()
    assert card.sha256 == digest == (out / "labels.onnx.sha256").read_text().strip()
    stated = {
        metadata_prop.key: metadata_prop.value
        for metadata_prop in onnx.load_model_from_string(data).metadata_props
    }
    assert card.calibration is not None
    assert float(stated["temperature"]) == card.calibration.temperature
    assert card.calibration.surprise_after <= card.calibration.surprise
    assert {figure.source for figure in card.figures} == {"one", "other", "all", "generated"}
    assert (card.data.parts, card.data.held_out) == (12, 1)
    assert card.training.steps == 3
    again = make(order(tmp_path / "on", steps=0, start=out / "weights.pt"), GENERATOR, silent)
    assert again.sha256 != card.sha256  # It has no temperature.
    assert again.training.started_from == "weights.pt"
    assert again.calibration is None


def test_no_step_changes_no_weights(tmp_path: Path) -> None:
    make(order(tmp_path / "a", steps=1), GENERATOR, silent)
    start = tmp_path / "a" / "weights.pt"
    make(order(tmp_path / "b", steps=0, start=start), GENERATOR, silent)
    one, other = (
        torch.load(tmp_path / item / "weights.pt", weights_only=True) for item in ("a", "b")
    )
    assert all(torch.equal(one[name], other[name]) for name in one)


@pytest.mark.parametrize("option", ["--published", "--validation", "--start"])
def test_what_is_missing_is_one_sentence(
    tmp_path: Path, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = {option[2:]: tmp_path / "absent"}
    with pytest.raises(UnreadableError) as stated:
        make(order(tmp_path / "out", **wrong), GENERATOR, silent)
    assert stated.value.code == "file-missing"
    assert "absent" in str(stated.value.message)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("one+a.lab.png", None, "file-missing"),
        ("one+a.lab.png", b"no picture", "damaged-image"),
        ("LICENCES.json", b"[]", "file-unreadable"),
        ("LICENCES.json", b"{", "file-unreadable"),
    ],
)
def test_damaged_folders_are_told(
    tmp_path: Path, name: str, content: bytes | None, code: str
) -> None:
    path = sheets_folder(tmp_path / "sheets") / name
    path.unlink()
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(UnreadableError) as stated:
        published_sheets(path.parent)
    assert stated.value.code == code


def test_a_folder_without_sheets_and_truth_of_another_size_are_told(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as stated:
        published_sheets(tmp_path)
    assert stated.value.code == "no-sheets"
    folder = sheets_folder(tmp_path / "sheets")
    cv2.imwrite(str(folder / "one+a.ext.png"), np.zeros((5, 5), np.uint8))
    with pytest.raises(UnreadableError, match="differ in size"):
        published_sheets(folder)


def test_weights_that_are_none_and_a_gpu_that_is_none_are_told(tmp_path: Path) -> None:
    path = tmp_path / "weights.pt"
    for content in (b"", b"no weights"):
        path.write_bytes(content)
        with pytest.raises(UnreadableError, match="no weights"):
            starting_network(path, 0)
    torch.save({"stem": torch.zeros(2)}, path)
    with pytest.raises(UnreadableError, match="no weights"):
        starting_network(path, 0)
    if not torch.cuda.is_available():
        with pytest.raises(EngineError, match="no GPU"):
            make(order(tmp_path / "out", place=Place.CUDA), GENERATOR, silent)


@pytest.mark.parametrize(
    "wrong", [["--size", "100"], ["--batch", "0"], ["--steps", "-1"], ["--seconds", "nan"]]
)
def test_wrong_numbers_are_one_line(wrong: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--out", "absent", *wrong]) == 2
    stated = capsys.readouterr().err.strip()
    assert stated.endswith("[wrong-usage]")
    assert "\n" not in stated


def test_packages_that_are_missing_are_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("learning.learning_command.find_spec", lambda _: None)
    assert main(["--out", str(tmp_path / "out")]) == 6
    stated = capsys.readouterr().err
    assert "torch, onnx" in stated and stated.strip().endswith("[engine-incomplete]")
    assert not (tmp_path / "out").exists()


def test_an_output_that_is_a_file_is_told(tmp_path: Path) -> None:
    taken = tmp_path / "file"
    taken.touch()
    with pytest.raises(UsageError) as stated:
        make(order(taken), GENERATOR, silent)
    assert stated.value.code == "output-not-writable"

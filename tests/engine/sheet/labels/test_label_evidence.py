"""How sure labels are, and which of them a stroke runs along."""

import json
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels import label_evidence, labels_network
from gaussiancad_core.sheet.labels.ink_classes import Evidence, InkClass
from gaussiancad_core.sheet.labels.label_evidence import (
    NO_LABELS,
    LabelledLine,
    SheetLabels,
    labelled_curves,
    labelled_lines,
    solver_weight,
)
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.tracing.ink_runs import Run

WIDTH = 3.0


@pytest.fixture(autouse=True)
def _plain_odds(monkeypatch: pytest.MonkeyPatch) -> None:
    """The network's log-odds are taken as they are, whatever its calibration says."""
    monkeypatch.setattr(label_evidence, "log_odds_factor", lambda: 1.0)


def labelled(
    start: tuple[float, float],
    end: tuple[float, float],
    margin: float,
    turned: float | None = None,
    why: Evidence = Evidence.NETWORK,
) -> LabelledLine:
    """A straight line with a margin of the part, turned where something else supports that."""
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    run = InkedRun(Run(0.0, length), WIDTH)
    log_p = np.full(len(InkClass), -9.0)
    log_p[InkClass.VISIBLE], log_p[InkClass.DIMENSION] = -1.0, -1.0 - margin
    is_part = (margin > 0.0) is (turned is None)
    ink = InkClass.VISIBLE if is_part else InkClass.DIMENSION
    shape = InkedShape(Line(start, tuple(way / length)), (run,))
    (line,) = labelled_lines([shape], [[LabelledRun(run, ink, margin, log_p, why, turned)]])
    return line


def test_the_confidence_is_the_probability_of_the_margin() -> None:
    edge, dimension = (labelled((0.0, 0.0), (50.0, 0.0), margin) for margin in (1.0, -1.0))
    for line in (edge, dimension):
        assert line.margin == 1.0
        assert line.confidence == pytest.approx(1.0 / (1.0 + np.exp(-1.0)))
    assert (edge.ink, edge.otherwise) == (InkClass.VISIBLE, InkClass.DIMENSION)
    assert (dimension.ink, dimension.otherwise) == (InkClass.DIMENSION, InkClass.VISIBLE)


def test_a_calibrated_network_is_as_sure_as_its_card_says(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(label_evidence, "log_odds_factor", lambda: 0.5)
    line = labelled((0.0, 0.0), (50.0, 0.0), 2.0)
    assert line.confidence == pytest.approx(1.0 / (1.0 + np.exp(-1.0)))


def test_the_shipped_network_says_the_temperature_of_its_card() -> None:
    card = json.loads(
        Path(labels_network.__file__).with_name("labels.json").read_text(encoding="utf-8")
    )
    stated = card["calibration"]["temperature"] if card["calibration"] else 1.0
    assert labels_network.log_odds_factor() == pytest.approx(stated)


def test_what_turned_a_line_makes_it_no_surer_than_its_ink_allows() -> None:
    ends = (0.0, 0.0), (50.0, 0.0)
    weak, tied, firm = (
        labelled(*ends, margin, support, Evidence.LOOSE_END)
        for margin, support in ((-2.0, 0.1), (-0.1, 9.0), (-2.0, 9.0))
    )
    assert firm.is_part
    assert weak.confidence == tied.confidence == pytest.approx(0.525, abs=1e-3)
    assert firm.confidence == pytest.approx(0.881, abs=1e-3)
    assert firm.margin == -2.0
    assert SheetLabels((firm, weak), WIDTH).doubtful() == (weak,)


def test_doubts_come_in_order_and_scraps_are_none() -> None:
    lines = [labelled((0.0, y), (60.0, y), margin) for y, margin in ((0, 0.4), (9, -0.1), (18, 3))]
    scrap = labelled((0.0, 40.0), (10.0, 40.0), 0.0)
    labels = SheetLabels((*lines, scrap), WIDTH)
    assert labels.doubtful() == (lines[1], lines[0])
    assert labels.within((0.0, 5.0, 60.0, 25.0)).lines == (lines[1], lines[2])


def test_a_stroke_is_as_sure_as_the_least_sure_line_that_tells() -> None:
    sure = labelled((0.0, 0.0), (100.0, 0.0), 4.0)
    doubtful = labelled((100.0, 0.0), (140.0, 0.0), 0.2)
    crossing = labelled((50.0, -80.0), (50.0, 80.0), 0.1)
    neighbour = labelled((0.0, 1.0), (140.0, 1.0), -0.1)
    labels = SheetLabels((sure, doubtful, crossing, neighbour), WIDTH)
    points = Segment((0.5, 0.5), (140.5, 0.5), Linetype.VISIBLE).sample(2.0)
    assert labels.along(points, part=True) is doubtful
    assert labels.along(points[:40], part=True) is sure
    assert labels.along(points, part=False) is neighbour
    assert labels.along(points + np.array([0.0, 30.0]), part=True) is None
    assert NO_LABELS.along(points, part=True) is None


def test_a_person_goes_before_labels() -> None:
    doubtful = labelled((0.0, 0.0), (100.0, 0.0), 0.2)
    said = labelled((0.0, 0.0), (100.0, 0.0), 4.0, why=Evidence.PERSON)
    points = Segment((0.0, 0.0), (100.0, 0.0), Linetype.VISIBLE).sample(2.0)
    assert SheetLabels((doubtful, said), WIDTH).along(points, part=True) is said


def test_doubtful_strokes_are_given_up_first_but_are_of_their_linetype() -> None:
    lines = [
        labelled((0.0, y), (60.0, y), margin) for y, margin in ((0, 4.0), (20, 1.0), (40, 0.0))
    ]
    strokes = [Segment((0.0, y), (60.0, y), Linetype.VISIBLE) for y in (0.0, 20.0)]
    found = SheetLabels(tuple(lines), WIDTH).weighed(strokes)
    assert [item.confidence for item in found] == pytest.approx([1.0, 0.7311], abs=1e-3)
    # From 0.4 down, readers say that a stroke may be visible or hidden.
    assert solver_weight(0.1) == 0.5
    assert [solver_weight(item) for item in (0.95, 0.7)] == [1.0, 0.7]


def test_a_curve_is_all_of_one_kind() -> None:
    points = np.array([[float(x), 5.0] for x in range(20)] + [[90.0, 90.0]])
    log_p = np.full((21, len(InkClass)), -9.0)
    log_p[:, InkClass.VISIBLE] = -0.5
    log_p[:15, InkClass.DIMENSION] = -1.0
    log_p[15:, InkClass.DIMENSION] = -4.5
    (curve,) = labelled_curves(points, np.array([1] * 20 + [2]), log_p)
    assert (curve.ink, curve.otherwise) == (InkClass.VISIBLE, InkClass.DIMENSION)
    assert curve.margin == pytest.approx((15 * 0.5 + 5 * 4.0) / 20, abs=0.03)
    assert curve.length == 20.0

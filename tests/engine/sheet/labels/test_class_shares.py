"""What is rare on a sheet is rarely right."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels.class_shares import learnt_shares
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import part_odds
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.tracing.ink_runs import Run

WIDTH = 3.0
SHAPE = InkedShape(Line((0.0, 0.0), (1.0, 0.0)), ())


def piece(ink: InkClass, odds: float, length: float) -> LabelledRun:
    """A piece that is a class with log-odds against an edge, or annotation where it is one."""
    log_p = np.full(len(InkClass), -12.0)
    log_p[ink] = -0.05
    other = InkClass.DIMENSION if ink is InkClass.VISIBLE else InkClass.VISIBLE
    log_p[other] = -0.05 - odds
    margin = float(part_odds(log_p[None])[0])
    return LabelledRun(InkedRun(Run(0.0, length), WIDTH), ink, margin, log_p)


def shifted(doubt: LabelledRun, others: list[LabelledRun]) -> float:
    """Log-odds of a piece among others, the sheet's shares counted."""
    shares = learnt_shares([[doubt], others], WIDTH)
    return doubt.margin + float(shares.odds(SHAPE, doubt.run, doubt.log_p[None])[0])


EDGES = [piece(InkClass.VISIBLE, 8.0, 400.0) for _ in range(20)]
DIMENSIONS = [piece(InkClass.DIMENSION, 8.0, 200.0) for _ in range(20)]
CENTRES = [piece(InkClass.CENTRE, 8.0, 300.0) for _ in range(10)]


def test_a_doubtful_line_of_a_sheet_of_edges_alone_is_an_edge() -> None:
    for ink in (InkClass.CENTRE, InkClass.DIMENSION, InkClass.OTHER, InkClass.FRAME):
        doubt = piece(ink, 1.5, 60.0)
        assert doubt.margin == pytest.approx(-1.5, abs=0.01)
        assert shifted(doubt, EDGES) > 0.0


def test_a_class_that_is_usual_on_the_sheet_keeps_what_is_in_doubt() -> None:
    dimension, centre = piece(InkClass.DIMENSION, 1.5, 60.0), piece(InkClass.CENTRE, 1.5, 60.0)
    assert shifted(dimension, [*EDGES[:10], *DIMENSIONS]) < 0.0
    # Each class for itself.
    assert shifted(centre, [*EDGES[:10], *CENTRES]) < 0.0
    assert shifted(dimension, [*EDGES[:10], *CENTRES]) > shifted(
        dimension, [*EDGES[:10], *DIMENSIONS]
    )


def test_shares_never_decide_alone() -> None:
    sure = piece(InkClass.OTHER, 9.0, 60.0)
    assert sure.margin < shifted(sure, EDGES) <= sure.margin + SURE < 0.0


def test_few_lines_tell_little_of_what_is_usual() -> None:
    doubt = piece(InkClass.OTHER, 1.5, 20.0)
    assert shifted(doubt, EDGES[:1]) < shifted(doubt, EDGES)
    assert not learnt_shares([], WIDTH).shift.any()

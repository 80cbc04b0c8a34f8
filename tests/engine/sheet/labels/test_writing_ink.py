"""What is writing has to be sure, by itself or by its neighbours."""

import numpy as np
import pytest

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels
from gaussiancad_core.sheet.labels.writing_ink import writing_ink

SIZE = 60, 200


def sheet(*letters: tuple[int, float]) -> tuple[np.ndarray, InkLabels]:
    """Ink and labels of letters at columns, each with log-odds of writing against an edge."""
    ink = np.zeros(SIZE, bool)
    log_p = np.full((len(InkClass), *SIZE), -12.0, np.float16)
    for column, odds in letters:
        where = np.s_[20:36, column : column + 10]
        ink[where] = True
        log_p[InkClass.TEXT][where] = -0.1
        log_p[InkClass.HIDDEN][where] = -0.1 - odds
    return ink, InkLabels(log_p)


def test_a_sure_letter_is_writing() -> None:
    ink, labels = sheet((50, 6.0))
    assert (writing_ink(ink, labels) == ink).all()


@pytest.mark.parametrize("odds", [0.5, 2.0])
def test_a_doubtful_piece_that_stands_alone_is_none(odds: float) -> None:
    assert not writing_ink(*sheet((50, odds))).any()
    assert not writing_ink(*sheet((50, odds), (150, odds))).any()


def test_a_doubtful_letter_in_a_line_with_a_sure_one_is_writing() -> None:
    ink, labels = sheet((50, 1.0), (64, 6.0), (78, 0.5))
    assert (writing_ink(ink, labels) == ink).all()
    ink, labels = sheet((20, 1.0), (150, 6.0))
    assert writing_ink(ink, labels)[:, 100:].any() and not writing_ink(ink, labels)[:, :100].any()


def test_a_sheet_without_writing_has_none() -> None:
    assert not writing_ink(*sheet()).any()

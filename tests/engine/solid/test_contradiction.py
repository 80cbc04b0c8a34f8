"""Contradictions in words."""

import numpy as np
import pytest

from gaussiancad_core.labelling.conflict_lines import Conflict, ConflictLine
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.contradiction import conflict_reason

_POINTS = np.array([[0.0, -0.01], [40.0, 12.34]])


def _line(
    drawn: Linetype | None, suspect: bool = False, fitting: Linetype | None = None
) -> ConflictLine:
    return ConflictLine(Role.TOP, _POINTS, drawn, suspect, fitting)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (
            _line(None, True, Linetype.HIDDEN),
            "but for one: a hidden line is missing in the top view from (0.0, 0.0) to (40.0, 12.3)",
        ),
        (
            _line(Linetype.VISIBLE, True),
            "the visible line in the top view from (0.0, 0.0) to (40.0, 12.3) mm should not be",
        ),
        (_line(Linetype.VISIBLE, True, Linetype.HIDDEN), "(40.0, 12.3) mm should be hidden"),
        (_line(Linetype.HIDDEN, True, Linetype.VISIBLE), "(40.0, 12.3) mm should be visible"),
        (
            _line(Linetype.HIDDEN),
            "has this line next to what is blank around it: hidden",
        ),
    ],
)
def test_one_line_is_told_with_its_place(line: ConflictLine, words: str) -> None:
    code, sentence = conflict_reason(Conflict((line,), True))
    assert code == "lines-contradict" and words in sentence


@pytest.mark.parametrize(
    ("line", "values"),
    [
        (_line(None, True, Linetype.HIDDEN), ("missing", "hidden")),
        (_line(Linetype.VISIBLE, True), ("surplus", "visible")),
        (_line(Linetype.VISIBLE, True, Linetype.HIDDEN), ("kind", "hidden")),
    ],
)
def test_the_values_say_what_would_have_to_be(line: ConflictLine, values: tuple[str, str]) -> None:
    _, sentence = conflict_reason(Conflict((line,), True))
    args = sentence.args
    assert (args["case"], args["linetype"], args["view"]) == (*values, "top")
    _, sentence = conflict_reason(Conflict((line, line), True))
    assert sentence.args["suspects"] == 2 and "case" not in sentence.args


def test_closed_curves_are_told_by_their_middle() -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, 33)
    points = np.array([10.0, 20.0]) + 5.0 * np.stack([np.cos(angles), np.sin(angles)], 1)
    line = ConflictLine(Role.FRONT, points, Linetype.VISIBLE, True)
    _, sentence = conflict_reason(Conflict((line,), True))
    assert "in the front view around (10.0, 20.0) mm" in sentence


def test_suspects_go_before_all_others_and_long_lists_are_cut() -> None:
    others = [_line(Linetype.HIDDEN) for _ in range(6)]
    _, sentence = conflict_reason(Conflict((_line(Linetype.VISIBLE, True), *others), True))
    assert "hidden" not in sentence
    _, sentence = conflict_reason(Conflict(tuple(others), True))
    assert sentence.startswith("6 lines") and sentence.endswith("; and 2 more")
    assert "the fewest lines" in sentence
    _, sentence = conflict_reason(Conflict(tuple(others), False))
    assert "not all are needed" in sentence
    suspects = tuple(_line(Linetype.VISIBLE, True) for _ in range(2))
    _, sentence = conflict_reason(Conflict(suspects, True))
    assert "but for one: any of these: " in sentence

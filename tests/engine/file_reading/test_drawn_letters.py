import numpy as np

from gaussiancad_core.file_reading.drawn_letters import drawn_words
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen

PEN = Pen(0.1, None, "thin")
LETTERS = {
    "n": [(0, 0), (0, 1), (0.1, 0.6), (0.4, 1), (0.6, 0.8), (0.6, 0)],
    "e": [(0, 0.5), (0.6, 0.5), (0.5, 0.9), (0.2, 1), (0, 0.6), (0.1, 0.1), (0.6, 0)],
    "s": [(0.4, 0.9), (0.2, 1), (0.1, 0.7), (0.4, 0.3), (0.3, 0), (0, 0.1)],
}


def _chain(points: np.ndarray) -> list[PaperStroke]:
    ends = zip(points[:-1].tolist(), points[1:].tolist(), strict=True)
    return [PaperStroke(LineSegment(tuple(one), tuple(other)), PEN) for one, other in ends]


def _word(text: str, at: tuple[float, float], height: float) -> list[PaperStroke]:
    return [
        stroke
        for place, letter in enumerate(text)
        for stroke in _chain(np.array(at) + height * np.add(LETTERS[letter], (place, 0)))
    ]


def test_letters_of_hairlines_are_a_word() -> None:
    edges = _chain(np.array([(0, 0), (80, 0), (80, 50), (0, 50), (0, 0)], float))
    letters = _word("nenses", (100.0, 20.0), 2.5)
    boxes, members = drawn_words([*edges, *letters])
    (box,) = boxes
    assert np.allclose(box, (100.0, 20.0, 113.5, 22.5))
    assert sorted(members) == list(range(len(edges), len(edges) + len(letters)))


def test_holes_of_chords_in_a_row_are_no_word() -> None:
    turns = np.linspace(0.0, 2.0 * np.pi, 25)
    hole = 1.5 * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    small = 0.8 * hole
    holes = [
        stroke
        for place in range(6)
        for stroke in _chain((hole if place % 2 else small) + (10.0 + 4.0 * place, 30.0))
    ]
    assert drawn_words(holes) == ([], [])


def test_words_of_any_sizes_stand_beside_each_other() -> None:
    strokes = _word("sen", (10.0, 60.0), 7.0)
    rows = [_word("nenses", (10.0, 10.0 + 2.0 * row), 1.0) for row in range(12)]
    for row in rows:
        strokes += row
    boxes, members = drawn_words(strokes)
    assert len(members) == len(strokes)
    assert len(boxes) == 1 + len(rows)

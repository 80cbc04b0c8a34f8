"""What is counted of verified solids, and of measures."""

from benchmarks.ask.measures import by_group, is_right
from benchmarks.ask.verified import by_source, is_false, table
from benchmarks.run.workers import Row

_RIGHT: Row = {
    "policy": "all", "status": "verified", "reasons": [], "why": "", "within": 11, "faces": 12,
}  # fmt: skip
_FALSE = {**_RIGHT, "policy": "some", "why": "off by 3 mm, bound 0.01 mm", "within": 6}
_DOUBTED: Row = {"policy": "all", "status": "approximate", "reasons": ["assumed"]}


def test_table_counts_by_source_and_policy_and_names_what_is_wrong() -> None:
    rows = [
        {"source": "twins", "seed": 0, "cases": [_RIGHT, _FALSE, _DOUBTED]},
        {"source": "parts", "seed": 7, "cases": [_RIGHT]},
        {"source": "grids", "seed": 2, "failure": "prepare-crashed"},
    ]
    lines = [line.split() for line in table(rows).splitlines()]
    assert ["twins", "3", "2", "1", "0", "1", "70.8", "%"] in lines
    assert ["all", "4", "3", "1", "0", "1", "77.8", "%"] in lines
    assert by_source(rows)[-1] == ("all", "4", "3", "1", "0", "1", "77.8 %")
    assert [is_false(case) for case in (_RIGHT, _FALSE, _DOUBTED)] == [False, True, False]
    text = table(rows)
    assert "FALSE twins 0 case 1 (some): off by 3 mm" in text
    assert "grids 2: prepare-crashed" in text


def test_measures_are_counted_for_the_right_shapes_alone() -> None:
    row: Row = {
        "group": "twins", "input": "scan", "px_mm": 0.1, "valid": True, "faces": 4,
        "true_faces": 4, "displaced": [0.0, 0.0, 0.004, 0.006] * 2, "farthest": 0.01,
        "uncertainty_mm": 0.005, "measures_source": "drawing",
    }  # fmt: skip
    assert is_right(row)
    other = [{**row, "faces": 5}, {**row, "farthest": 0.3}, {**row, "valid": False}]
    assert not any(map(is_right, other))
    lines = list(by_group([row, *other]))
    stated = 4, 1, 8, "0.060", "0.050", "75.0 %", "75 %", "1.20"
    assert ("twins", "scan", *stated) in lines
    assert ("all", "by drawing", *stated) in lines

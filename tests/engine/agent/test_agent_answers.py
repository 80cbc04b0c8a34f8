"""Summaries stay short however much was read, and pictures small however large the sheet."""

import json
from io import BytesIO
from math import pi
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest
from PIL import Image

from gaussiancad import Reading
from gaussiancad.agent.agent_pictures import enlarged, scaled
from gaussiancad.agent.reading_summary import reading_summary
from gaussiancad.agent.stroke_selection import check_ids, selected_box, selected_strokes
from gaussiancad.agent.tool_arguments import CorrectArguments, LookArguments, decoded
from gaussiancad_core.errors import UnreadableError, UsageError

SIZE = 4000, 3000


def stroke(number: int, **changes: Any) -> dict[str, Any]:  # noqa: ANN401
    """A short level line of the top view."""
    x, y = 40.0 * (number % 90) + 100.0, 20.0 * (number // 90) + 100.0
    values = {"id": f"s{number}", "view": "v2", "kind": "visible", "line": [[x, y], [x + 30.0, y]]}
    return {**values, "confidence": 0.9, **changes}


@pytest.fixture
def reading(tmp_path: Path) -> Reading:
    """A reading of 8000 strokes, a fourth of them in doubt, and of many problems."""
    views = [
        {"id": "v1", "role": "front", "box": [0.0, 1900.0, 3900.0, 2900.0]},
        {"id": "v2", "role": "top", "box": [0.0, 50.0, 3900.0, 1900.0]},
        {"id": "v3", "role": "ignore", "kind": "table", "box": [1, 1, 9, 9], "used": False},
    ]
    doubt = {"confidence": 0.4, "why": {"by": "network", "otherwise": "dimension"}}
    strokes = [stroke(number, **(doubt if number % 4 == 0 else {})) for number in range(8000)]
    strokes += [
        {"id": "c1", "view": "v1", "kind": "hidden", "arc": [500.0, 2400.0, 100.0, 0.0, 2 * pi]},
        {"id": "t1", "view": None, "kind": "text", "box": [10.0, 10.0, 90.0, 30.0]},
    ]
    problem = {
        "code": "unused-view",
        "severity": "doubt",
        "message": "a view was not used",
        "offers": ["view", "projection", "region"],
    }
    data = {
        "sheet": {"sha256": "0", "page": 1, "size": list(SIZE)},
        "projection": {"value": "third", "source": "default"},
        "unit": {"value": "mm"},
        "scale": {"source": "default"},
        "views": views,
        "strokes": strokes,
        "dimensions": [
            {"id": f"d{number}", "text": "40", "value_mm": 40.0, "box": [1, 2, 3, 4]}
            for number in range(500)
        ],
        "problems": [problem] * 300,
    }
    Image.new("L", (2000, 1500), 255).save(tmp_path / "sheet.png")
    return Reading(tmp_path / "a.png", MappingProxyType(data), 1, tmp_path)


def look(**values: object) -> LookArguments:
    """Arguments of the tool."""
    return decoded("look", LookArguments, {"reading_id": "r", **values})


def test_a_summary_of_much_is_short(reading: Reading) -> None:
    summary = reading_summary(reading)
    assert len(json.dumps(summary)) < 20_000
    assert summary["views"][1]["strokes"] == {"visible": 8000}
    assert summary["views"][2] | {"box": 0} == {
        "id": "v3",
        "role": "ignore",
        "box": 0,
        "strokes": {},
        "used": False,
        "what": "table",
    }
    assert summary["strokes_outside_views"] == {"text": 1}
    assert (len(summary["doubtful_strokes"]), summary["more_doubtful_strokes"]) == (20, 1980)
    assert (summary["more_dimensions"], summary["more_problems"]) == (480, 280)
    assert summary["doubtful_strokes"][0]["offers"] == [
        {"op": "kind", "target": {"id": "s0"}, "to": "visible"},
        {"op": "kind", "target": {"id": "s0"}, "to": "dimension"},
    ]


def test_offers_are_operations(reading: Reading) -> None:
    view, projection, region = reading_summary(reading)["problems"][0]["offers"]
    assert view == {"op": "view", "id": "v3", "role": "ROLE"}
    assert projection == {"op": "projection", "value": "first"}
    assert (region["op"], region["kind"], len(region["polygon"])) == ("region", "ignore", 4)
    doubts = reading_summary(reading)["doubtful_strokes"]
    operations = [projection, *(offer for entry in doubts for offer in entry["offers"])]
    arguments = decoded("correct", CorrectArguments, {"reading_id": "r", "operations": operations})
    check_ids(reading, arguments.operations)


def test_strokes_are_chosen_by_view_box_kind_and_doubt(reading: Reading) -> None:
    assert [entry["id"] for entry in selected_strokes(reading, look(view="front"))] == ["c1"]
    assert len(selected_strokes(reading, look(view="top"))) == 8000
    assert len(selected_strokes(reading, look())) == 8002
    near = selected_strokes(reading, look(box=[95, 95, 175, 125]))
    assert [entry["id"] for entry in near] == ["s0", "s1", "s90", "s91"]
    # A circle is where it runs, not where its middle is.
    assert not selected_strokes(reading, look(box=[480, 2380, 520, 2420]))
    assert selected_strokes(reading, look(box=[590, 2380, 610, 2420]))
    assert selected_strokes(reading, look(box=[0, 0, 20, 20]))[0]["id"] == "t1"
    assert selected_strokes(reading, look(kinds=["hidden"]))[0]["id"] == "c1"
    assert selected_strokes(reading, look(doubtful_first=True))[0]["confidence"] == 0.4
    x0, y0, x1, y1 = selected_box(reading, look(view="front"))
    assert x0 < 0.0 and y0 < 1900.0 and x1 > 3900.0 and y1 > 2900.0
    with pytest.raises(UsageError, match="front, top, ignore"):
        selected_strokes(reading, look(view="left"))


@pytest.mark.parametrize(
    ("operation", "known"),
    [
        ({"op": "kind", "target": {"id": "s1"}, "to": "hidden"}, True),
        ({"op": "kind", "target": {"id": "s9000"}, "to": "hidden"}, False),
        # It is found by its place.
        ({"op": "erase", "target": {"id": "old", "line": [[1, 2], [3, 4]]}}, True),
        ({"op": "dimension", "id": "d7", "value_mm": 3}, True),
        ({"op": "dimension", "id": "d777", "value_mm": 3}, False),
        ({"op": "view", "id": "new", "role": "left"}, False),
        ({"op": "view", "id": "new", "role": "left", "box": [1, 1, 9, 9]}, True),
        ({"op": "draw", "view": "v9", "kind": "visible", "line": [[1, 2], [3, 4]]}, False),
        ({"op": "section", "id": "v3", "in_view": "top", "line": [[1, 2], [3, 4]]}, True),
        ({"op": "section", "id": "v3", "in_view": "left", "line": [[1, 2], [3, 4]]}, False),
    ],
)
def test_operations_on_what_is_not_there_are_refused(
    reading: Reading, operation: dict[str, Any], known: bool
) -> None:
    values = {"reading_id": "r", "operations": [operation]}
    asked = decoded("correct", CorrectArguments, values)
    if known:
        check_ids(reading, asked.operations)
        return
    with pytest.raises(UsageError, match="operation 1") as refused:
        check_ids(reading, asked.operations)
    assert refused.value.code == "unknown-id"
    assert len(str(refused.value)) < 300


def test_a_part_of_a_sheet_is_enlarged(reading: Reading) -> None:
    strokes = selected_strokes(reading, look(view="front"))
    picture = Image.open(BytesIO(enlarged(reading, (350, 2250, 650, 2550), strokes).content))
    assert picture.size == (1600, 1600)
    # The rim of the circle is pink at its right.
    factor = 1600 / 300
    colour = picture.convert("RGB").getpixel((round(factor * 250), round(factor * 150)))
    assert isinstance(colour, tuple)
    assert colour[0] > 180 and colour[1] < 120
    whole = Image.open(BytesIO(enlarged(reading, (-9, -9, 9e5, 9e5), []).content))
    assert whole.size == (1600, 1200)
    point = Image.open(BytesIO(enlarged(reading, (5, 5, 5, 5), []).content))
    assert point.size[0] == point.size[1] >= 100


@pytest.mark.parametrize(
    "box", [(9, 0, 1, 5), (0, 9, 5, 1), (-90, 0, -1, 5), (0, 3001, 5, 4000), (5000, 0, 6000, 9)]
)
def test_a_box_that_is_none_is_refused(
    reading: Reading, box: tuple[float, float, float, float]
) -> None:
    with pytest.raises(UsageError, match="4000 x 3000"):
        enlarged(reading, box, [])


def test_pictures_become_small(tmp_path: Path) -> None:
    chance = np.random.default_rng(0)
    noise = chance.integers(0, 256, (2400, 1200, 3), dtype=np.uint8)
    Image.fromarray(noise).save(tmp_path / "noise.png")
    found = scaled(tmp_path / "noise.png", "noise")
    assert Image.open(BytesIO(found.content)).size == (800, 1600)
    assert len(found.content) < 1_500_000
    Image.new("RGB", (300, 200), "white").save(tmp_path / "white.png")
    small = scaled(tmp_path / "white.png", "white")
    assert Image.open(BytesIO(small.content)).size == (300, 200)
    assert small.kind == "image/png"


@pytest.mark.parametrize("content", [None, b"", b"\x89PNG\r\n\x1a\n broken"])
def test_a_picture_that_is_gone_or_broken_is_told(tmp_path: Path, content: bytes | None) -> None:
    if content is not None:
        (tmp_path / "a.png").write_bytes(content)
    with pytest.raises(UnreadableError) as refused:
        scaled(tmp_path / "a.png", "a")
    assert refused.value.code == "file-not-readable"

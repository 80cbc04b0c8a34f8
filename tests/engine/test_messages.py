"""Messages keep their values, and every code is explained in docs/messages.md."""

import ast
import copy
import pickle
import re
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.messages import Message, args_of, event_fields, filled, on_one_line
from gaussiancad_core.model.axes import Role
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.readings.views_to_reading import refusal

ROOT = Path(__file__).resolve().parents[2]
GIVERS = {"_warn", "warned", "doubted", "_told", "_tell"}


def _codes_in(path: Path) -> set[str]:
    codes = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        if not (name.endswith("Error") or name in GIVERS):
            continue
        for argument in node.args[:2]:
            if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                if re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)+|cancelled", argument.value):
                    codes.add(argument.value)
                break
    return codes


def test_every_code_is_explained() -> None:
    sources = (ROOT / "core" / "gaussiancad_core").rglob("*.py")
    given = set().union(*(_codes_in(path) for path in sources))
    explained = set(re.findall(r"`([a-z0-9-]+)`", (ROOT / "docs/messages.md").read_text("utf-8")))
    assert len(given) > 40
    assert not given - explained


def test_no_code_is_explained_that_no_one_gives() -> None:
    sources = "\n".join(
        path.read_text("utf-8") for path in (ROOT / "core" / "gaussiancad_core").rglob("*.py")
    )
    text = (ROOT / "docs/messages.md").read_text("utf-8")
    rows = re.findall(r"^\| ((?:`[a-z0-9-]+`(?:, )?)+) \|", text, re.MULTILINE)
    listed = {code for row in rows for code in re.findall(r"`([a-z0-9-]+)`", row)}
    assert not {code for code in listed if not re.search(rf'["\[]{code}["\]]', sources)}


def test_a_message_is_its_sentence_and_keeps_its_values() -> None:
    made = Message(
        "{path}: {size:.1f} mm in the {view} view", path=Path("a{b}.png"), size=2.04, view=Role.TOP
    )
    assert made == "a{b}.png: 2.0 mm in the top view"
    assert args_of(made) == {"path": "a{b}.png", "size": 2.04, "view": "top"}
    for again in (copy.deepcopy(made), pickle.loads(pickle.dumps(made)), on_one_line(made)):
        assert (again, args_of(again)) == (made, args_of(made))


def test_values_are_what_json_has() -> None:
    made = Message("{a} {b} {c}", a=np.int64(3), b=np.float32(0.5), c=Message("{d}", d=1))
    assert [type(value) for value in made.args.values()] == [int, float, str]


def test_texts_without_values_stay_as_they_are() -> None:
    assert Message("braces {stay}") == "braces {stay}"
    assert (args_of("plain"), args_of(Message("plain"))) == ({}, {})
    assert event_fields("a-code", "plain") == {"code": "a-code", "message": "plain"}
    assert filled("{as} it was", {"as": "x"}) == "{as} it was"


def test_a_value_without_its_place_is_no_message() -> None:
    with pytest.raises(KeyError):
        Message("{here} {missing}", here=1)


def test_errors_fill_their_messages() -> None:
    error = UnreadableError("page-missing", "{path} has no page {page}", path="a.pdf", page=2)
    assert str(error) == error.message == "a.pdf has no page 2"
    assert event_fields(error.code, error.message)["args"] == {"path": "a.pdf", "page": 2}
    known = LimitError("again", error.message)
    assert args_of(known.message) == {"path": "a.pdf", "page": 2}


def test_problems_of_a_reading_have_the_values() -> None:
    problem = refusal("views-parallel", Message("nothing of the {axis} axis", axis="Y"))
    assert problem.args == {"axis": "Y"}
    assert "args" in SheetReading.__annotations__["problems"].__args__[0].__struct_fields__

"""Messages keep their values, and every code is explained in docs/messages.md."""

import ast
import copy
import json
import pickle
from pathlib import Path

import messages_page
import msgspec
import numpy as np
import pytest

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.messages import Message, args_of, event_fields, filled, on_one_line
from gaussiancad_core.model.axes import Role
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.readings.views_to_reading import refusal
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

ENGINE = Path(__file__).resolve().parents[3] / "core"
SOURCES = [
    path
    for package in ("gaussiancad", "gaussiancad_core")
    for path in (ENGINE / package).rglob("*.py")
]
GIVERS = ("Error", "warn", "doubt", "tell", "Problem", "event_fields")
"""Ends of the names of what is called with a code first."""


def test_every_code_is_explained_and_the_page_says_so() -> None:
    rows = [row for rows in messages_page.SECTIONS.values() for row in rows]
    assert {code for row in rows for code in row.codes} == set(Code)
    assert messages_page.page() == messages_page.PAGE.read_text("utf-8")
    errors = [row for name, rows in messages_page.SECTIONS.items() for row in rows if "Err" in name]
    assert {row.exit_code for row in errors} <= set(ExitCode)


def test_every_code_is_given_and_none_but_these() -> None:
    given, literal = set(), []
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "Code":
                given.add(node.attr)
            if isinstance(node, ast.Call) and len(node.args) > 1 and _gives(node.func):
                first = node.args[0]
                if isinstance(first, ast.Constant) and isinstance(first.value, str):
                    literal.append((path.name, first.value))
    # The one that no newer syntax may stand beside.
    assert given | {"PYTHON_TOO_OLD"} == {code.name for code in Code}
    assert literal == []


def _gives(called: ast.expr) -> bool:
    name = getattr(called, "attr", getattr(called, "id", ""))
    return name.endswith(GIVERS)


def test_a_code_is_its_value_wherever_it_is_written() -> None:
    code = Code.NO_VIEWS
    assert (str(code), f"{code}", f"{code:>10}") == ("no-views", "no-views", "  no-views")
    assert json.loads(json.dumps({"code": code})) == {"code": "no-views"}
    assert msgspec.json.encode(code) == b'"no-views"'
    assert {"no-views": 1}[code] == 1


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

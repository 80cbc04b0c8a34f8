"""Schemas say what the tools take, and what they do not take is refused in a sentence."""

import json
from collections.abc import Iterator, Mapping
from math import inf, nan
from typing import Any

import pytest
from jsonschema import Draft7Validator, Draft202012Validator

from gaussiancad.agent.tool_arguments import CorrectArguments, LookArguments, decoded
from gaussiancad.agent.tool_list import TOOLS
from gaussiancad.agent.tool_schemas import input_schema
from gaussiancad_core.errors import UsageError

SCHEMA_BYTES = 11_000
"""Of the largest schema: all operations with words and examples."""


@pytest.mark.parametrize("name", TOOLS)
def test_schemas_are_schemas_of_any_draft(name: str) -> None:
    tool = TOOLS[name].described()
    Draft202012Validator.check_schema(tool.input_schema)
    Draft7Validator.check_schema(tool.input_schema)
    text = json.dumps(tool.input_schema)
    assert len(text) < SCHEMA_BYTES
    assert "prefixItems" not in text and '"null"' not in text
    assert all("description" in attribute for attribute in tool.input_schema["properties"].values())


def operations() -> Iterator[Mapping[str, Any]]:
    """The example of each operation."""
    for schema in input_schema(CorrectArguments)["$defs"].values():
        yield from schema.get("examples", ())


def test_every_operation_has_an_example_that_is_taken() -> None:
    examples = list(operations())
    assert len({example["op"] for example in examples}) == len(examples) == 13
    values = {"reading_id": "r", "operations": examples}
    Draft202012Validator(input_schema(CorrectArguments)).validate(values)
    found = decoded("correct", CorrectArguments, values)
    assert len(found.operations) == 13
    as_text = {"reading_id": "r", "operations": json.dumps(examples)}
    assert decoded("correct", CorrectArguments, as_text) == found


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({}, "reading_id"),
        ({"reading_id": 3}, r"\$\.reading_id"),
        ({"reading_id": "r", "colour": "red"}, "colour"),
        ({"reading_id": "r", "box": [1, 2, 3]}, r"\$\.box"),
        ({"reading_id": "r", "box": [1, 2, 3, nan]}, "box"),
        ({"reading_id": "r", "box": [1, 2, 3, inf]}, "box"),
        ({"reading_id": "r", "box": "[1, 2, "}, "box"),
        ({"reading_id": "r", "limit": 10**9}, r"\$\.limit"),
        ({"reading_id": "r", "offset": -1}, r"\$\.offset"),
        ({"reading_id": "r", "kinds": ["purple"]}, r"\$\.kinds"),
        ({"reading_id": "x" * 5000}, r"\$\.reading_id"),
    ],
)
def test_nonsense_is_refused_with_its_place(values: dict[str, Any], words: str) -> None:
    with pytest.raises(UsageError, match=words) as refused:
        decoded("look", LookArguments, values)
    assert refused.value.code == "wrong-usage"
    assert len(str(refused.value)) < 300


def test_too_many_operations_are_refused() -> None:
    many = [{"op": "unit", "value": "mm"}] * 1001
    with pytest.raises(UsageError, match="1000"):
        decoded("correct", CorrectArguments, {"reading_id": "r", "operations": many})

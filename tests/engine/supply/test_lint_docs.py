"""The checker of the documentation finds what is planted, and takes what is true."""

from pathlib import Path

import pytest
from doc_names import Tree
from doc_texts import CHECKOUT, Kind, Module, Passage, page_passages
from lint_docs import Reader

PAGE = CHECKOUT / "docs" / "planted.md"
MODULE = Path(__file__).with_name("planted_module.txt").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def reader() -> Reader:
    """Of this checkout."""
    return Reader()


_TRUE = (
    "docs/solid.md | readings.md | engine/locate.py | gaussiancad_core/storage/extras.py | "
    "benchmarks/*/__init__.py | core/locks/NAME.txt | make lint | make lock UPGRADE=1 | "
    ".venv/bin/gaussiancad reconstruct SHEET --output DIR --length x=80 | "
    "gaussiancad COMMAND --help | .venv/bin/python -m benchmarks --list | "
    "python -m learning --out build/labels --steps 3 | "
    "python3 resources/scripts/gaussiancad_batch.py sheets --output models | --numprocesses | "
    "sheet.tracing | gaussiancad.reconstruct() | solid.step | no-exact-solid | "
    "sheet.png.corrections.json | kind | page_passages"
)


@pytest.mark.parametrize("span", _TRUE.split(" | "))
def test_what_is_there_is_taken(reader: Reader, span: str) -> None:
    assert list(reader.in_text(Passage(PAGE, 1, f"See `{span}`.", Kind.PAGE))) == []


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        (text, said)
        for said, texts in {
            "link": "[page](absent.md) | [place](solid.md#no-such-heading)",
            "path": (
                "`docs/absent.md` | plain core/absent.py | `engine/absent.py` | `absent_module.py`"
            ),
            "command": (
                "`make absent` | `gaussiancad absent SHEET` | "
                "`gaussiancad read SHEET --absent 3` | `python -m benchmarks absent` | "
                "`python -m learning\n--absent` | `--absent-everywhere` | "
                "    .venv/bin/gaussiancad explain model --absent  # why"
            ),
            "name": (
                "`gaussiancad_core.run.absent` | gaussiancad.absent | `sheet.absent` | "
                "`absent_name` | `AbsentName` | `absent-code` | `SheetImage.absent` | "
                "`absent_call()` | `absentword` | `absent.json`"
            ),
        }.items()
        for text in texts.split(" | ")
    ],
)
def test_what_is_planted_in_a_page_is_found(reader: Reader, text: str, kind: str) -> None:
    found = [
        finding
        for passage in page_passages(PAGE, f"# Head\n\nFirst.\n\n{text}\n")
        for finding in reader.in_text(passage)
    ]
    assert {finding.kind for finding in found} == {kind}
    assert {finding.line for finding in found} == {5}
    assert str(found[0]).startswith(f"docs/planted.md:5: {kind}: ")


def test_what_is_planted_in_a_module_is_found(reader: Reader) -> None:
    reader.tree.add("planted", Module(CHECKOUT / "scripts" / "planted.py", MODULE))
    found = {(finding.line, finding.kind) for finding in reader.in_module("planted")}
    wrong = {
        "third: is": "Attributes",
        "fifth: is": "Args",
        ":func:`absent`": "reference",
        "other: is": "Args",
        "no-such-code": "Raises",
        "AbsentError": "Raises",
        "scripts/absent.py": "path",
    }
    lines = MODULE.split("\n")
    places = {
        (next(number for number, line in enumerate(lines, 1) if text in line), kind)
        for text, kind in wrong.items()
    }
    assert found - places <= {(line, "name") for line, _ in places}
    assert places <= found


def test_only_the_newest_section_of_the_changelog_counts() -> None:
    text = "# Changelog\n\n## 2\n\nnew\n\n## 1\n\nold\n"
    (passage,) = page_passages(CHECKOUT / "CHANGELOG.md", text)
    assert "new" in passage.text and "old" not in passage.text


def test_names_of_another_library_are_not_looked_into() -> None:
    tree = Tree()
    assert tree.leads_somewhere("pathlib.Path.anything")
    assert not tree.leads_somewhere("no_library_at_all.name")
    assert tree.leads_somewhere("gaussiancad.Error.code")

"""What ``python -m benchmarks`` does with its arguments."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks import ask
from benchmarks.run import command
from benchmarks.run.catalogue import Entry, entries, load
from benchmarks.run.checkout import ROOT
from benchmarks.run.command import main
from benchmarks.run.outcome import Figure, Outcome
from gaussiancad_core.errors import UsageError


class _Asked:
    """A benchmark that finds what its option says."""

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        parser.add_argument("--found", type=int, default=3)

    @staticmethod
    def run(options: argparse.Namespace) -> Outcome:
        if options.found < 0:
            raise UsageError("too-few", "fewer than none\ncannot be found")
        return Outcome((Figure("found", options.found),), wrong=options.found == 0)


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> None:
    entry = Entry("asked", "How many are found?", "They are counted.", 1.0)
    monkeypatch.setattr(command, "entries", lambda: (entry,))
    monkeypatch.setattr(command, "load", lambda _: _Asked)


def test_each_benchmark_has_a_question_minutes_and_options() -> None:
    assert len(entries()) == 12
    for entry in entries():
        assert entry.question.endswith("?") and entry.method, entry.name
        assert entry.minutes > 0.0


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.name)
def test_each_benchmark_tells_its_options(entry: Entry, capsys: pytest.CaptureFixture[str]) -> None:
    assert " ".join(load(entry.name).__doc__.split("\n\n")[0].split()) == entry.question
    with pytest.raises(SystemExit) as ended:
        main([entry.name, "--help"])
    assert ended.value.code == 0
    assert "--record" in capsys.readouterr().out


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.name)
def test_each_benchmark_declares_the_options_that_it_reads(entry: Entry) -> None:
    parser = argparse.ArgumentParser()
    load(entry.name).add_arguments(parser)
    declared = {action.dest for action in parser._actions} | set(parser._defaults)
    source = Path(ask.__file__).with_name(f"{entry.name}.py").read_text(encoding="utf-8")
    assert set(re.findall(r"\boptions\.(\w+)", source)) <= declared


def test_the_list_needs_none_of_what_benchmarks_need() -> None:
    code = "import sys; from benchmarks.run.command import main; main(['--list']); "
    code += "assert 'numpy' not in sys.modules"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert "exact_solid\n    How often, how exactly and how fast" in done.stdout
    assert "about 30 min; " in done.stdout


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["nobody"], "there is no benchmark nobody"),
        (["asked", "--found", "many"], "invalid int value"),
        (["asked", "--found", "-1"], "fewer than none cannot be found"),
        (["asked", "--what"], "unrecognized arguments"),
        ([], "required"),
    ],
)
def test_a_wrong_call_is_one_line(
    arguments: list[str], said: str, asked: None, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        code = main(arguments)
    except SystemExit as ended:
        code = ended.code
    (line,) = capsys.readouterr().err.splitlines()
    assert code == 2 and said in line


@pytest.mark.parametrize(("found", "code"), [("3", 0), ("0", 1)])
def test_what_must_not_be_ends_with_1(
    found: str, code: int, asked: None, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["asked", "--found", found]) == code
    assert capsys.readouterr().out == f"found: {found}\n"


def test_a_run_is_recorded_where_it_is_asked_for(
    asked: None, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    store = command.record
    monkeypatch.setattr(command, "record", lambda *given: store(*given, tmp_path))
    assert main(["asked", "--found", "7", "--record"]) == 0
    (entry,) = json.loads((tmp_path / "asked.json").read_text(encoding="utf-8"))
    assert entry["options"] == "--found 7"
    assert entry["figures"] == [{"name": "found", "value": 7, "unit": ""}]

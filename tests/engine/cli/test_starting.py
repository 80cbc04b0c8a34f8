"""What is told where a library ended the command's process."""

import signal
import sys
from pathlib import Path

import pytest

from gaussiancad_core.cli import starting
from gaussiancad_core.cli.starting import _failure
from gaussiancad_core.processes.watched import Watched

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="processes die otherwise there")


@pytest.mark.parametrize(
    ("number", "solid", "code", "exit_code"),
    [
        (-11, Path("a.step"), "damaged-model", 3),
        (-11, None, "engine-died", 6),
        (-9, Path("a.step"), "killed", 5),
        (-15, Path("a.step"), "cancelled", 130),
        (-24, None, "takes-too-long", 5),
    ],
)
def test_a_solid_that_breaks_the_library_is_damaged(
    number: int, solid: Path | None, code: str, exit_code: int
) -> None:
    error = _failure(Watched(number, ""), solid)
    assert (error.code, int(error.exit_code)) == (code, exit_code)


def test_a_way_that_comes_to_no_end_is_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    runs: list[list[str]] = []

    def hangs(arguments: list[str]) -> Watched:
        runs.append(arguments)
        return Watched(-signal.SIGXCPU, "solid")

    monkeypatch.setattr(starting, "watch", hangs)
    asked = ["reconstruct", "a.png", "--output", str(tmp_path / "out"), "--result", "solid"]
    assert starting._started(asked) == 5
    assert runs == [asked, [*asked, "--solid-way", "sketch"]]
    assert "[takes-too-long]" in capsys.readouterr().err

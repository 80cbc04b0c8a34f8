"""What is told where a library ended the command's process."""

from pathlib import Path

import pytest

from gaussiancad_core.cli.starting import _failure
from gaussiancad_core.processes.watched import Watched


@pytest.mark.parametrize(
    ("number", "solid", "code", "exit_code"),
    [
        (-11, Path("a.step"), "damaged-model", 3),
        (-11, None, "engine-died", 6),
        (-9, Path("a.step"), "killed", 5),
        (-15, Path("a.step"), "cancelled", 130),
    ],
)
def test_a_solid_that_breaks_the_library_is_damaged(
    number: int, solid: Path | None, code: str, exit_code: int
) -> None:
    error = _failure(Watched(number, ""), solid)
    assert (error.code, int(error.exit_code)) == (code, exit_code)

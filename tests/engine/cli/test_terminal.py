"""What a person at a terminal sees of a run."""

import io

import pytest

from gaussiancad_core.cli.terminal import Terminal


class _Screen(io.StringIO):
    """A terminal's text."""

    def __init__(self, *, is_terminal: bool) -> None:
        super().__init__()
        self._is_terminal = is_terminal

    def isatty(self) -> bool:
        return self._is_terminal

    @property
    def seen(self) -> str:
        """What stands on the line in the end."""
        return self.getvalue().split("\x1b[K")[-1]


def _half_of_training(shown: Terminal) -> None:
    shown.send("stage", name="gaussians", index=7, of=10)
    shown.send("progress", stage="gaussians", fraction=0.5, eta_s=31.6)


def test_a_terminal_shows_stage_fraction_and_time_left() -> None:
    screen = _Screen(is_terminal=True)
    shown = Terminal(screen)
    _half_of_training(shown)
    assert screen.seen == "[7/10] training the Gaussians: 50 %, about 32 s left"
    shown.send("progress", stage="gaussians", fraction=1.0, eta_s=0.0)
    shown.send("result", path="report.json", status="verified")
    assert screen.seen == "" and "\n" not in screen.getvalue()


def test_a_line_of_progress_is_gone_before_an_error_is_told() -> None:
    screen = _Screen(is_terminal=True)
    shown = Terminal(screen)
    _half_of_training(shown)
    shown.send("error", code="disk-full", message="no space", exit_code=5)
    assert screen.seen == ""


@pytest.mark.parametrize("verbose", [False, True])
def test_what_is_no_terminal_gets_whole_lines_where_they_are_wanted(verbose: bool) -> None:
    screen = _Screen(is_terminal=False)
    shown = Terminal(screen, verbose)
    _half_of_training(shown)
    shown.send("warning", code="scale-assumed", message="the scale\nis not known")
    shown.send("progress", stage="gaussians", fraction=1.0, eta_s=0.0)
    lines = screen.getvalue().splitlines()
    if not verbose:
        assert lines == []
        return
    assert lines[0] == "the scale is not known [scale-assumed]"
    assert lines[1].startswith("[7/10] training the Gaussians: ") and lines[1].endswith(" s")
    assert "\x1b" not in screen.getvalue()

"""A slice of the benchmark ``batch``."""

import pytest

from benchmarks.run.command import main


def test_no_sheet_is_lost_and_resuming_does_none_again(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["batch", "--sheets", "2", "--workers", "2"]) == 0
    head, *table = capsys.readouterr().out.split("\n\n")
    assert "2 sheets" in head
    assert table[0].splitlines()[1].split()[0] == "2"
    assert table[1].splitlines()[0] == "no sheet was lost"

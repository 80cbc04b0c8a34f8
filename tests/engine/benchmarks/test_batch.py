"""A slice of benchmarks/batch.py."""

import batch
import pytest


def test_no_sheet_is_lost_and_resuming_does_none_again(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["batch.py", "--sheets", "2", "--workers", "2"])
    assert batch.main() == 0
    head, *table = capsys.readouterr().out.split("\n\n")
    assert "2 sheets" in head
    assert table[0].splitlines()[1].split()[0] == "2"

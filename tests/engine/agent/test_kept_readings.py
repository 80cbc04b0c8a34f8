"""What has an id is bounded, and what is gone says so."""

from pathlib import Path

import pytest

from gaussiancad.agent.kept_readings import Kept, KeptReading, KeptResult
from gaussiancad_core.errors import UsageError


def test_the_oldest_are_dropped() -> None:
    kept: Kept[int] = Kept("reading", "read the sheet again", most=3)
    for number in range(5):
        kept.keep(f"r{number}", number)
    assert [f"r{number}" in kept for number in range(5)] == [False, False, True, True, True]
    assert kept.find("r3") == 3
    with pytest.raises(UsageError, match=r"r2, r3, r4\): read the sheet again") as refused:
        kept.find("r1")
    assert refused.value.code == "unknown-id"


def test_an_id_is_taken_again_as_the_latest() -> None:
    kept: Kept[str] = Kept("part", "reconstruct it again", most=2)
    for name, value in (("a", "old"), ("b", "b"), ("a", "new"), ("c", "c")):
        kept.keep(name, value)
    assert kept.find("a") == "new"
    assert "b" not in kept


def test_before_the_first_there_is_none() -> None:
    with pytest.raises(UsageError, match="there is none yet"):
        Kept("reading", "read the sheet again").find("x" * 5000)


@pytest.mark.parametrize("content", [None, "", "[]", "{", '{"sheet": 3}'])
def test_files_that_are_gone_or_changed_are_told(tmp_path: Path, content: str | None) -> None:
    if content is not None:
        for name in ("reading.json", "report.json"):
            (tmp_path / name).write_text(content)
    with pytest.raises(UsageError) as refused:
        KeptReading(tmp_path, tmp_path / "a.png").load()
    assert refused.value.code == "unknown-id"
    if content != '{"sheet": 3}':
        with pytest.raises(UsageError) as refused:
            KeptResult(tmp_path).load()
        assert refused.value.code == "unknown-id"

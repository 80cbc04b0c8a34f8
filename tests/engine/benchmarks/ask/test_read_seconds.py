"""A slice of the benchmark ``read_seconds``."""

from pathlib import Path

import pypdfium2
import pytest

from benchmarks.ask.read_seconds import Read, table
from benchmarks.run.command import main


def test_the_table_has_each_kind_and_all() -> None:
    rows = [Read(f"a/{number}", "strokes", number / 10.0, 0.5) for number in range(1, 12)]
    head, strokes, none, every = table([*rows, Read("b/1", "no views", 9.0, 1.0)]).splitlines()
    assert head.split()[:2] == ["views", "by"]
    assert strokes.split() == ["strokes", "11", "1.10", "1.55", "12.10"]
    assert none.split() == ["no", "views", "1", "10.00", "10.00", "10.00"]
    assert every.split()[:3] == ["all", "12", "1.15"]


def test_sheets_of_one_page_are_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "source").mkdir()
    for name, pages in (("one", 1), ("two", 2)):
        document = pypdfium2.PdfDocument.new()
        for _ in range(pages):
            document.new_page(100.0, 100.0)
        document.save(tmp_path / "source" / f"{name}.pdf")
    assert main(["read_seconds", "--data", str(tmp_path)]) == 0
    said = capsys.readouterr()
    assert [line.split()[:3] for line in said.out.splitlines()[1:-1]] == [
        ["no", "views", "1"],
        ["all", "1", said.out.splitlines()[2].split()[2]],
    ]
    assert said.err.split()[-1] == "source/one"

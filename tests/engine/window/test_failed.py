"""The sheets of a batch that need a person."""

import json
from pathlib import Path

import pytest

from freecad.gaussiancad.canvas.engine_server import Program
from freecad.gaussiancad.canvas.failed import FailedSheet, failed_sheets
from freecad.gaussiancad.canvas.standalone import StandaloneWindow
from freecad.gaussiancad.qt import QtGui, QtWidgets
from gaussiancad_core.batches.batch_table import BatchRow, table_bytes

_STATUSES = {"good": "verified", "near": "approximate", "=bad": "failed"}


@pytest.fixture
def report(tmp_path: Path) -> Path:
    """A report of three sheets; the one that failed was the third page of a file."""
    rows = []
    for name, status in _STATUSES.items():
        sheet, folder = tmp_path / f"{name}.png", tmp_path / name
        picture = QtGui.QImage(64, 48, QtGui.QImage.Format.Format_Grayscale8)
        picture.fill(255)
        assert picture.save(str(sheet))
        rows.append(BatchRow(name, str(sheet), str(folder), status, "", 0, "", "", 1.0))
    of_bad = tmp_path / "=bad"
    of_bad.mkdir()
    why = {"code": "unused-view", "message": "not used", "args": {"count": 2}}
    values = {"settings": {"page": 3}, "reasons": [why]}
    (of_bad / "report.json").write_text(json.dumps(values), encoding="utf-8")
    path = tmp_path / "report.csv"
    path.write_bytes(table_bytes(rows))
    return path


def test_failed_sheets_come_first_and_verified_ones_not_at_all(report: Path) -> None:
    bad, near = failed_sheets(report)
    folder = report.parent
    assert bad == FailedSheet(
        "=bad", folder / "=bad.png", 3, "failed", "unused-view", "not used", {"count": 2}
    )
    assert near == FailedSheet("near", folder / "near.png", 1, "approximate")


def test_the_report_of_freecads_console_says_the_same(report: Path) -> None:
    folder = report.parent
    rows = [
        {"name": name, "sheet": str(folder / f"{name}.png"), "status": status, "folder": ""}
        for name, status in _STATUSES.items()
    ]
    path = report.with_suffix(".json")
    path.write_text(json.dumps({"schema": 2, "sheets": rows}), encoding="utf-8")
    stated = [
        (failed_sheet.name, failed_sheet.sheet, failed_sheet.status)
        for failed_sheet in failed_sheets(path)
    ]
    assert stated == [
        (failed_sheet.name, failed_sheet.sheet, failed_sheet.status)
        for failed_sheet in failed_sheets(report)
    ]


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.json", "{"),
        ("a.json", "[]"),
        ("a.json", '{"sheets": [1]}'),
        ("a.csv", "x,y\n1,2\n"),
        ("a.csv", "x,y\n"),
    ],
)
def test_what_is_no_report_is_told(tmp_path: Path, name: str, content: str) -> None:
    path = tmp_path / name
    path.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match="no report of a batch"):
        failed_sheets(path)


def test_the_next_sheet_is_one_that_is_not_verified_yet(report: Path) -> None:
    application = QtWidgets.QApplication.instance() or QtWidgets.QApplication([])
    bad, near = failed_sheets(report)
    standalone = StandaloneWindow((bad, near), Program((str(report.parent / "none"),)))
    opened = []
    standalone.list.chosen.connect(opened.append)
    standalone.list.open_next()
    standalone.list.open_next()
    assert opened == [bad, near]
    assert standalone.canvas.session.path == near.sheet and standalone.canvas.session.page == 1
    standalone.canvas.session.solved.emit({"status": "verified"}, "")
    assert [row.status for row in standalone.list.sheets] == ["failed", "verified"]
    standalone.list.open_next()
    standalone.list.open_next()
    assert opened[2:] == [bad, bad]
    assert standalone.canvas.session.page == 3
    standalone.canvas.session.solved.emit({"status": "verified"}, "")
    assert not standalone.list.next_button.isEnabled()
    standalone.close()
    application.processEvents()

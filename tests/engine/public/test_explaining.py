"""What readings and parts say of themselves, and what a run says while it says nothing new."""

import json
import shutil
from pathlib import Path

import pytest

import gaussiancad
from gaussiancad.engine_call import Watch, run_command


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, plain_picture: Path) -> Path:
    """A folder with a sheet and corrections beside it: a hidden line is erased."""
    found = tmp_path_factory.mktemp("sheet")
    shutil.copy(plain_picture, found / "sheet.png")
    bare = gaussiancad.read(plain_picture)
    assert bare.folder is None
    sha256 = bare.data["sheet"]["sha256"]
    hidden = next(item["id"] for item in bare.data["strokes"] if item["kind"] == "hidden")
    operations = [{"op": "erase", "target": {"id": hidden}}]
    stated = {"schema": "gaussiancad-corrections/1", "sheet_sha256": sha256, "ops": operations}
    (found / "sheet.png.corrections.json").write_text(json.dumps(stated))
    return found


@pytest.fixture(scope="module")
def reading(folder: Path) -> gaussiancad.Reading:
    return gaussiancad.read(folder / "sheet.png", output=folder / "read")


@pytest.fixture(scope="module")
def part(reading: gaussiancad.Reading) -> gaussiancad.Result:
    return gaussiancad.solve(reading, result="solid")


def test_a_reading_that_is_kept_has_its_files(folder: Path, reading: gaussiancad.Reading) -> None:
    names = {"reading.json", "reading.png", "sheet.png", "lines.dxf", "lines.svg"}
    assert {path.name for path in (folder / "read").iterdir()} == names
    assert reading.folder == folder / "read"
    again = gaussiancad.Reading.load(folder / "read" / "reading.json", folder / "sheet.png")
    assert again == reading


def test_what_no_run_made_is_not_replaced_by_a_reading(plain_picture: Path, tmp_path: Path) -> None:
    (tmp_path / "lines.svg").write_text("mine")
    with pytest.raises(gaussiancad.UsageError) as refused:
        gaussiancad.read(plain_picture, output=tmp_path)
    assert refused.value.code == "foreign-files"
    assert [path.name for path in tmp_path.iterdir()] == ["lines.svg"]


def test_corrections_beside_the_sheet_are_taken_once(
    reading: gaussiancad.Reading, part: gaussiancad.Result
) -> None:
    assert reading.data["corrected"] == 1
    assert "corrections-unmatched" not in {reason.code for reason in part.reasons}
    (warning,) = [warning for warning in part.warnings if warning.code == "corrected"]
    assert warning.message.startswith("1 correction")


def test_a_reading_is_explained(reading: gaussiancad.Reading) -> None:
    assert any(line.startswith("The front view at") for line in gaussiancad.explain(reading))
    (of_view,) = gaussiancad.explain(reading, view="front")
    assert of_view.endswith("px has 6 visible and 1 hidden lines.")
    (at_edge,) = gaussiancad.explain(reading, at=(160, 420))
    assert at_edge.startswith("A visible line of 200 px")
    assert gaussiancad.explain(reading, at=(5, 5))[0].startswith("No line was read at (5, 5)")


def test_a_part_is_explained(part: gaussiancad.Result) -> None:
    lines = gaussiancad.explain(part)
    assert lines[0] == part.report["verdict"]
    assert "What was tried:" in lines
    assert "6 visible and" in gaussiancad.explain(part, view="front")[0]
    assert "It lies within the front view." in gaussiancad.explain(part, at=[160, 420])


def test_what_cannot_be_explained_is_refused(
    reading: gaussiancad.Reading, part: gaussiancad.Result
) -> None:
    for known in (reading, part):
        with pytest.raises(gaussiancad.UsageError, match="front") as refused:
            gaussiancad.explain(known, view="inside")
        assert refused.value.code == "unknown-view"
    for place in ((1,), (1, 2, 3), ("a", "b"), (float("nan"), 1.0)):
        with pytest.raises(gaussiancad.UsageError, match="two numbers"):
            gaussiancad.explain(reading, at=place)  # type: ignore[arg-type]
    with pytest.raises(gaussiancad.UsageError, match="not both"):
        gaussiancad.explain(reading, at=(1, 2), view="front")


def test_progress_is_told_while_a_run_says_nothing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    class Enough(Exception):
        pass

    silent = tmp_path / "python"
    silent.write_text("#!/bin/sh\nexec sleep 60\n")
    silent.chmod(0o755)
    monkeypatch.setenv("GAUSSIANCAD_PYTHON", str(silent))
    heard: list[tuple[str, float]] = []

    def progress(stage: str, fraction: float) -> None:
        heard.append((stage, fraction))
        if len(heard) == 2:
            raise Enough

    with pytest.raises(Enough):
        run_command(["compare", "a", "b"], Watch(progress))
    assert heard == [("compare", 0.0)] * 2

import os
import subprocess
import sys
from pathlib import Path

import pytest

from gaussiancad_core.errors import UsageError
from gaussiancad_core.storage.foreign_files import check_no_foreign
from gaussiancad_core.storage.outputs import (
    PUBLISHED_FILE,
    RUN_FILES,
    STAGING_PREFIX,
    OutputFolder,
    check_writable,
)


def _folder(path: Path) -> OutputFolder:
    return OutputFolder(path, ("model.stl", "pictures"), "report.json")


def test_files_appear_on_commit_only(tmp_path: Path) -> None:
    folder = _folder(tmp_path / "a b 图")
    (folder.staging / "model.stl").write_text("new")
    (folder.staging / "report.json").write_text("{}")
    assert not (folder.path / "model.stl").exists()
    folder.commit()
    assert {p.name for p in folder.path.iterdir()} == {"model.stl", "report.json"}


def test_what_a_new_run_does_not_write_anew_is_removed(tmp_path: Path) -> None:
    (tmp_path / "model.stl").write_text("old")
    (tmp_path / "pictures").mkdir()
    (tmp_path / "pictures" / "1.png").write_text("old")
    (tmp_path / "mine.txt").write_text("the user's")
    folder = _folder(tmp_path)
    (folder.staging / "report.json").write_text("{}")
    folder.commit()
    assert {p.name for p in tmp_path.iterdir()} == {"mine.txt", "report.json"}


def test_what_goes_ahead_sweeps_away_an_earlier_run_and_stays(tmp_path: Path) -> None:
    for name in ("model.stl", "report.json", "mine.txt"):
        (tmp_path / name).write_text("old")
    folder = _folder(tmp_path)
    assert not folder.ahead
    (folder.staging / "pictures").mkdir()
    (folder.staging / "pictures" / "1.png").write_text("new")
    folder.publish()
    assert folder.ahead
    assert {p.name for p in tmp_path.iterdir()} == {
        "mine.txt",
        "pictures",
        folder.staging.name,
        PUBLISHED_FILE,
    }
    (folder.staging / "model.stl").write_text("new")
    (folder.staging / "report.json").write_text("{}")
    folder.commit()
    assert {p.name for p in tmp_path.iterdir()} == {
        "mine.txt",
        "pictures",
        "model.stl",
        "report.json",
    }
    assert (tmp_path / "pictures" / "1.png").read_text() == "new"


def test_what_went_ahead_outlives_a_run_that_stops(tmp_path: Path) -> None:
    folder = _folder(tmp_path / "out")
    (folder.staging / "model.stl").write_text("new")
    folder.publish()
    (folder.staging / "report.json").write_text("half")
    folder.discard()
    assert {p.name for p in (tmp_path / "out").iterdir()} == {"model.stl", PUBLISHED_FILE}
    # The next run knows whose it is.
    check_no_foreign(tmp_path / "out", ["model.stl"])


@pytest.mark.parametrize("below", ["file", "file/below", "file/far/below"])
def test_a_folder_that_cannot_be_is_told_before_anything_is_made(
    tmp_path: Path, below: str
) -> None:
    (tmp_path / "file").write_text("")
    for ask in (check_writable, _folder):
        with pytest.raises(UsageError, match="cannot write") as caught:
            ask(tmp_path / below)
        assert caught.value.code == "output-not-writable"


def test_a_folder_that_can_be_made_is_not_made_by_the_question(tmp_path: Path) -> None:
    check_writable(tmp_path / "a" / "b")
    check_writable(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_discarding_leaves_earlier_results_alone(tmp_path: Path) -> None:
    (tmp_path / "model.stl").write_text("old")
    folder = _folder(tmp_path)
    (folder.staging / "model.stl").write_text("half")
    folder.discard()
    assert [p.name for p in tmp_path.iterdir()] == ["model.stl"]
    assert (tmp_path / "model.stl").read_text() == "old"


def test_a_folder_made_in_vain_goes_again(tmp_path: Path) -> None:
    folder = _folder(tmp_path / "new")
    folder.discard()
    assert not (tmp_path / "new").exists()


def _staged_elsewhere(path: Path) -> "tuple[subprocess.Popen[bytes], Path]":
    """A process that has begun to write into a folder, and where."""
    known = set(path.iterdir())
    code = (
        "import sys\nfrom pathlib import Path\n"
        "from gaussiancad_core.storage.outputs import OutputFolder\n"
        "folder = OutputFolder(Path(sys.argv[1]), (), 'report.json')\n"
        "print('ready', flush=True)\nsys.stdin.read()"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", code, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    assert process.stdout.readline() == b"ready\n"
    (staging,) = set(path.iterdir()) - known
    return process, staging


def test_leftovers_of_dead_processes_are_swept_and_of_living_ones_kept(tmp_path: Path) -> None:
    dead, gone = _staged_elsewhere(tmp_path)
    dead.kill()
    dead.wait()
    alive, kept = _staged_elsewhere(tmp_path)
    try:
        assert not gone.exists()
        _folder(tmp_path).discard()
        assert kept.exists()
    finally:
        alive.kill()
        alive.wait()
    _folder(tmp_path).discard()
    assert not kept.exists()


def test_links_that_lie_where_a_run_writes_are_not_followed(tmp_path: Path) -> None:
    outside, output = tmp_path / "outside", tmp_path / "out"
    outside.mkdir()
    output.mkdir()
    (outside / "mine.txt").write_text("mine")
    for name in ("cameras", "solid.step", "report.json", f"{STAGING_PREFIX}{os.getpid()}"):
        target = outside if name == "cameras" else outside / "mine.txt"
        (output / name).symlink_to(outside if name.startswith(STAGING_PREFIX) else target)
    folder = OutputFolder(output, RUN_FILES, "report.json")
    (folder.staging / "cameras").mkdir()
    (folder.staging / "cameras" / "cameras.txt").write_text("new")
    for name in ("solid.step", "report.json"):
        (folder.staging / name).write_text("new")
    folder.commit()
    assert [path.name for path in outside.iterdir()] == ["mine.txt"]
    assert (outside / "mine.txt").read_text() == "mine"
    assert (output / "report.json").read_text() == "new"
    assert (output / "cameras" / "cameras.txt").read_text() == "new"


@pytest.mark.parametrize("kept", [False, True])
def test_a_checkpoint_outlives_a_run_only_where_it_is_wanted(tmp_path: Path, kept: bool) -> None:
    folder = _folder(tmp_path / "out")
    folder.checkpoint.write_bytes(b"state")
    folder.discard(keep_checkpoint=kept)
    assert folder.checkpoint.exists() is kept
    assert (tmp_path / "out").exists() is kept
    if kept:
        again = _folder(tmp_path / "out")
        assert again.checkpoint.read_bytes() == b"state"


def test_a_finished_run_leaves_no_checkpoint(tmp_path: Path) -> None:
    folder = _folder(tmp_path / "out")
    folder.checkpoint.write_bytes(b"state")
    (folder.staging / "report.json").write_text("{}")
    folder.commit()
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["report.json"]

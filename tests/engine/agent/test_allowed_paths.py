"""Nothing outside of the one folder is named, and no output takes the place of another."""

import os
from pathlib import Path

import pytest

from gaussiancad.agent.allowed_paths import WorkFolder
from gaussiancad_core.errors import UsageError


@pytest.fixture
def work(tmp_path: Path) -> WorkFolder:
    """A folder with neighbours."""
    (tmp_path / "work" / "deep").mkdir(parents=True)
    (tmp_path / "workshop").mkdir()
    (tmp_path / "workshop" / "secret.png").touch()
    return WorkFolder.at(tmp_path / "work")


@pytest.mark.parametrize(
    "name",
    [
        *("..", "../workshop/secret.png", "deep/../../workshop/secret.png", "/etc/passwd"),
        *("link/secret.png", "link/../..", "chain"),
    ],
)
def test_what_lies_outside_is_refused(work: WorkFolder, name: str) -> None:
    (work.root / "link").symlink_to(work.root.parent / "workshop")
    (work.root / "chain").symlink_to("link/secret.png")
    with pytest.raises(UsageError) as refused:
        work.inside(name)
    assert refused.value.code == "outside-folder"


def test_what_lies_inside_has_its_path(work: WorkFolder) -> None:
    (work.root / "near").symlink_to("deep")
    for name in ("deep/a.png", "near/a.png", "./deep/../deep/a.png", str(work.root / "deep/a.png")):
        assert work.inside(name) == work.root / "deep" / "a.png"
    assert work.name_of(work.inside("near/a.png")) == "deep/a.png"


@pytest.mark.parametrize("name", ["a\0b", "loop/a.png", "\ud800"])
def test_what_is_no_path_is_refused(work: WorkFolder, name: str) -> None:
    (work.root / "loop").symlink_to("loop")
    with pytest.raises(UsageError):
        path = work.inside(name)
        # Newer versions of Python follow a loop to itself.
        path.stat()
        raise AssertionError(path)


def test_the_folder_may_be_reached_by_a_link(work: WorkFolder) -> None:
    link = work.root.parent / "to-work"
    link.symlink_to("work")
    assert WorkFolder.at(link) == work


def test_a_folder_has_to_be_one(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for name in ("none", "file"):
        with pytest.raises(UsageError) as refused:
            WorkFolder.at(tmp_path / name)
        assert refused.value.code == "path-not-usable"


def test_outputs_are_new_and_go_where_nothing_was_written(work: WorkFolder) -> None:
    sheet = work.root / "Wel le?.pdf"
    with work.output(sheet, "reading") as first, work.output(sheet, "reading") as second:
        (first / "reading.json").touch()
        (second / "reading.json").touch()
    assert work.id_of(first) == "Wel-le-reading-1"
    assert work.id_of(second) == "Wel-le-reading-2"

    def fail(*, after_writing: bool) -> Path:
        with pytest.raises(RuntimeError), work.output(sheet, "part") as third:
            if after_writing:
                (third / "report.json").touch()
            raise RuntimeError
        return third

    assert not fail(after_writing=False).exists()
    assert fail(after_writing=True).exists()


def test_outputs_are_kept_out_of_folders_that_links_lead_to(work: WorkFolder) -> None:
    (work.root / "gaussiancad-mcp").symlink_to(work.root.parent / "workshop")
    with pytest.raises(UsageError) as refused, work.output(work.root / "a.png", "reading"):
        pass
    assert refused.value.code == "outside-folder"


def test_a_named_output_is_a_subfolder(work: WorkFolder) -> None:
    with work.output(work.root / "a.png", "part", "models/a") as output:
        assert output == work.root / "models" / "a"
    assert work.id_of(output) == "models/a"
    for name in (".", "deep/..", str(work.root)):
        with pytest.raises(UsageError), work.output(work.root / "a.png", "part", name):
            pass


def test_files_are_listed_without_links_outputs_and_pictures_of_runs(work: WorkFolder) -> None:
    for name in (
        *("b.PNG", "a.step", "deep/c.dxf", "notes.txt", ".hidden/d.png"),
        *("gaussiancad-mcp/x/overlay.png", "model/report.json", "model/overlay.png"),
        "model/solid.step",
    ):
        path = work.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    (work.root / "link.png").symlink_to("b.PNG")
    found = work.files(frozenset({".png", ".dxf"}), frozenset({".step"}))
    names = ["a.step", "b.PNG", "deep/c.dxf", "model/solid.step"]
    assert [work.name_of(path) for path in found] == names


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="nothing is refused to root")
def test_a_folder_that_cannot_be_written_is_told(work: WorkFolder) -> None:
    work.root.chmod(0o500)
    with pytest.raises(UsageError) as refused, work.output(work.root / "a.png", "reading"):
        pass
    assert refused.value.code == "output-not-writable"

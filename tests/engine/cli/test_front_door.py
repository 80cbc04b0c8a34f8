"""What a command does where its output, its files, or the engine itself are not as they should."""

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from gaussiancad_core.cli import explain, main

_LONG = "a" * 260


def _started(*arguments: str, **options: object) -> subprocess.CompletedProcess[bytes]:
    command = [sys.executable, "-m", "gaussiancad_core", *arguments]
    return subprocess.run(command, stderr=subprocess.PIPE, check=False, **options)


def test_what_nobody_foresaw_is_one_line_and_a_file_to_send(
    plain_picture: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", None)

    def broken(*_: object) -> None:
        raise ZeroDivisionError("by a secret")

    monkeypatch.setattr(explain, "_of_run", broken)
    monkeypatch.setattr(explain, "_of_sheet", broken)
    assert main(["explain", str(plain_picture)]) == 6
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and "[unforeseen]" in line and "ZeroDivisionError" in line
    stated = Path(re.search(r"file (\S+) ", line).group(1)).read_text("utf-8")
    assert "by a secret" in stated and "in broken" in stated
    assert hashlib.sha256(plain_picture.read_bytes()).hexdigest() in stated


def test_a_reader_that_has_read_enough_is_no_error(plain_picture: Path) -> None:
    ours, theirs = os.pipe()
    os.close(ours)
    with open(theirs, "wb") as closed:
        ended = _started("explain", str(plain_picture), stdout=closed)
    assert (ended.returncode, ended.stderr) == (0, b"")


@pytest.mark.skipif(os.name != "posix", reason="limits of files are those of POSIX")
@pytest.mark.parametrize("command", ["reconstruct", "compare"])
def test_too_few_files_are_told_as_that(plain_picture: Path, command: str, tmp_path: Path) -> None:
    inputs = [str(plain_picture)]
    if command == "compare":
        inputs = ["a.step"] * 2
    limited = ["sh", "-c", 'ulimit -n 6 && exec "$@"', "sh", sys.executable, "-m"]
    command_line = [*limited, "gaussiancad_core", command, *inputs, "--output", str(tmp_path / "o")]
    ended = subprocess.run(command_line, capture_output=True, check=False)
    assert (ended.returncode, ended.stdout) == (5, b"")
    assert ended.stderr.count(b"\n") == 1 and b"[too-many-open-files]" in ended.stderr


@pytest.mark.parametrize("error", [BrokenPipeError("to a child"), FileNotFoundError(2, "no", "x")])
def test_a_pipe_or_a_file_of_our_own_that_is_gone_is_no_success(
    plain_picture: Path,
    error: OSError,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def broken(*_: object) -> None:
        raise error

    monkeypatch.setattr(explain, "_of_sheet", broken)
    assert main(["explain", str(plain_picture)]) == 6
    assert "[unforeseen]" in capsys.readouterr().err


@pytest.mark.skipif(os.name != "posix", reason="streams are closed by a shell")
@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&- 2>&-"])
def test_streams_that_are_closed_change_no_exit_code(closed: str) -> None:
    words = [sys.executable, "-m", "gaussiancad_core", "explain", "missing.step"]
    shell = ["sh", "-c", f'exec "$@" {closed}', "sh", *words]
    ended = subprocess.run(shell, stderr=subprocess.PIPE, check=False)
    assert ended.returncode == 3
    assert ended.stderr.count(b"\n") == ("2>&-" not in closed)


@pytest.mark.skipif(os.name != "posix", reason="streams are closed by a shell")
def test_what_is_printed_on_closed_streams_goes_nowhere(plain_picture: Path) -> None:
    words = [sys.executable, "-m", "gaussiancad_core", "explain", str(plain_picture)]
    shell = ["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", *words]
    assert subprocess.run(shell, check=False).returncode == 0


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no full device")
def test_a_word_that_finds_no_room_leaves_the_exit_code() -> None:
    command = [sys.executable, "-m", "gaussiancad_core"]
    with open("/dev/full", "wb") as full:
        stated = subprocess.run(
            [*command, "draw", "missing.step", "a.png"], stderr=full, check=False
        )
        usage = subprocess.run([*command, "nonsense"], stderr=full, check=False)
    assert (stated.returncode, usage.returncode) == (3, 2)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no full device")
def test_output_that_finds_no_room_is_told(plain_picture: Path) -> None:
    with open("/dev/full", "wb") as full:
        ended = _started("explain", str(plain_picture), stdout=full)
    assert ended.returncode == 5
    assert ended.stderr.count(b"\n") == 1 and b"[disk-full]" in ended.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ["reconstruct", "{sample}", "--output", _LONG],
        ["reconstruct", _LONG + ".png", "--output", "{tmp}/o"],
        ["read", "{sample}", "--output", "{tmp}/" + _LONG + "/below"],
        ["compare", _LONG, _LONG],
        ["explain", _LONG],
        ["batch", _LONG, "--output", "{tmp}/o"],
    ],
)
def test_a_name_that_is_too_long_is_told(
    plain_picture: Path, arguments: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    filled = [argument.format(tmp=tmp_path, sample=plain_picture) for argument in arguments]
    assert main(filled) in (2, 3)
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and "too long" in line


def test_a_name_with_control_characters_prints_as_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["reconstruct", "a\nb\x1b[31m.png", "--output", str(tmp_path)]) == 3
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and "\\x1b[31m" in line


def test_files_of_the_user_are_not_written_over(
    plain_picture: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mine = tmp_path / "lines.dxf"
    mine.write_text("drawn in a week")
    asked = ["read", str(plain_picture), "--output", str(tmp_path)]
    assert main(asked) == 2
    assert "[foreign-files]" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["lines.dxf"]
    assert mine.read_text() == "drawn in a week"
    assert main([*asked, "--overwrite"]) == 0
    assert mine.read_text() != "drawn in a week"
    # What a run made, the next one replaces.
    assert main(asked) == 0


def test_what_a_run_made_is_replaced_and_nothing_else(plain_picture: Path, tmp_path: Path) -> None:
    files = [str(plain_picture), "--output", str(tmp_path)]
    asked = ["reconstruct", *files, "--result", "solid"]
    (tmp_path / "overlay.png").symlink_to(plain_picture)
    assert main(asked) == 2
    (tmp_path / "overlay.png").unlink()
    assert main(asked) == 0
    (tmp_path / "hull.stl").write_text("my own")
    assert main(asked) == 2
    (tmp_path / "hull.stl").unlink()
    # A page that is read into the folder of a run stays known.
    assert main(["read", *files]) == 0
    assert main(asked) == 0

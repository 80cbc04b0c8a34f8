"""Nothing waits for a pipe, nor reads a device to its end."""

import os
from pathlib import Path

import pytest

from gaussiancad_core.storage.plain_files import check_plain, plain_bytes
from gaussiancad_core.storage.resume_check import sha256


def test_a_file_is_read_and_what_is_missing_or_a_folder_is_told_as_that(tmp_path: Path) -> None:
    (tmp_path / "plain").write_bytes(b"content")
    assert plain_bytes(tmp_path / "plain") == b"content"
    with pytest.raises(FileNotFoundError):
        plain_bytes(tmp_path / "missing")
    with pytest.raises(IsADirectoryError):
        check_plain(tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_a_pipe_is_no_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for read in (plain_bytes, sha256):
        with pytest.raises(OSError, match="a device or a pipe"):
            read(tmp_path / "pipe")

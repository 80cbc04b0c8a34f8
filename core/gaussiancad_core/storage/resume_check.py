"""Whether what a run left is finished, of the same job, and whole."""

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from gaussiancad_core import __version__
from gaussiancad_core.storage.plain_files import check_plain, plain_bytes
from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions
from gaussiancad_protocol.modes import Status


def file_facts(entries: Iterable[Path]) -> dict[str, dict[str, Any]]:
    """Size in bytes and SHA-256 of files, and of all files in folders, by their path from where the
    entries lie."""
    return {
        path.relative_to(entry.parent).as_posix(): {
            "size": path.stat().st_size,
            "sha256": sha256(path),
        }
        for entry in sorted(entries)
        for path in ([entry] if entry.is_file() else sorted(entry.rglob("*")))
        if path.is_file()
    }


def sha256(path: Path) -> str:
    """SHA-256 of a file, in hexadecimal digits.

    Raises:
        OSError: it cannot be read, or is no plain file.
    """
    check_plain(path)
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def finished_report(
    path: Path, settings: Mapping[str, Any], sheet_sha256: str
) -> dict[str, Any] | None:
    """The report of an earlier run of the same job by the same engine, if all of its files are as
    it left them.

    Args:
        path: of the report.
        settings: of the job.
        sheet_sha256: of the sheet.
    """
    try:
        report = json.loads(plain_bytes(path))
        engine = report["engine"]
        same = (
            report["settings"] == settings
            and report["status"] != Status.FAILED.value
            and engine["sheet_sha256"] == sheet_sha256
            and engine["version"] == __version__
            and engine["packages"] == installed_versions(ENGINE_PACKAGES)
            and all(
                (path.parent / name).stat().st_size == facts["size"]
                and sha256(path.parent / name) == facts["sha256"]
                for name, facts in report["files"].items()
            )
        )
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
        return None
    return report if same else None

"""Files that lie where a run would write, and that no run made: they are the user's own."""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from gaussiancad_core.errors import UsageError
from gaussiancad_core.storage.outputs import CHECK_FILES, PUBLISHED_FILE, READ_FILES, REPORT_FILE
from gaussiancad_protocol.codes import Code

_MOST_BYTES = 64 << 20
"""Of a report or a reading."""

_MOST_NAMED = 3

_CHECKED = {"schema", "verdict", "differences", "tally"}
"""Keys by which a check's file is known."""


def check_no_foreign(folder: Path, names: Iterable[str]) -> None:
    """Refuse to write over what is not of an earlier run.

    What a run made is told by its report, its reading or its check, and by its list of what went
    ahead.

    Args:
        folder: of the output; it may be missing.
        names: of the files and folders that would be written.

    Raises:
        UsageError: ``foreign-files``.
    """
    there = [name for name in names if _is_there(folder / name)]
    if not there:
        return
    known = _known(folder)
    foreign = [name for name in there if name not in known]
    if foreign:
        raise UsageError(
            Code.FOREIGN_FILES,
            "{folder} holds {names} that no run of GaussianCAD made: choose another output folder, "
            "or --overwrite",
            folder=folder,
            names=", ".join(foreign[:_MOST_NAMED]),
        )


def _known(folder: Path) -> set[str]:
    """Names of what earlier runs made in a folder."""
    found: set[str] = set()
    report = _values(folder / REPORT_FILE)
    if "engine" in report and isinstance(report.get("files"), Mapping):
        found |= {REPORT_FILE, *(str(name).split("/")[0] for name in report["files"])}
    if str(_values(folder / READ_FILES[0]).get("schema")).startswith("gaussiancad-reading/"):
        found |= set(READ_FILES)
    if set(_values(folder / CHECK_FILES[0])) >= _CHECKED:
        found |= set(CHECK_FILES)
    ahead = _values(folder / PUBLISHED_FILE).get("names")
    if isinstance(ahead, list):
        found |= {str(name) for name in ahead}
    return found


def _values(path: Path) -> Mapping[str, Any]:
    """The JSON object in a file; empty where there is none."""
    try:
        if not path.is_file() or path.stat().st_size > _MOST_BYTES:
            return {}
        values = json.loads(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return {}
    return values if isinstance(values, dict) else {}


def _is_there(path: Path) -> bool:
    """Whether something has a name, be it a link to nothing."""
    try:
        return path.is_symlink() or path.exists()
    except OSError:
        return False

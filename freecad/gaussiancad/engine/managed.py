"""The environment that the addon manages: whether it is whole, how large it is, and its end."""

import hashlib
import json
import os
import re
import shutil
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from freecad.gaussiancad.engine.locate import MARKER, interpreter_of
from freecad.gaussiancad.engine.locks import EngineBuild, normalised, pins
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.paths import CORE

_ASIDE = ".removed"
"""What is appended to the folder's name before its files are deleted."""


class Condition(Enum):
    """What is there of the environment."""

    ABSENT = "absent"
    INCOMPLETE = "incomplete"
    COMPLETE = "complete"


@dataclass(frozen=True)
class Managed:
    """The environment as it was found.

    Attributes:
        condition: what is there.
        build: of the engine, as far as it is known.
        missing: packages that are not there, or in another version; their normalised names.
        size: bytes on disk.
    """

    condition: Condition
    build: EngineBuild | None = None
    missing: tuple[str, ...] = ()
    size: int = 0


def look_at(root: Path) -> Managed:
    """Look at the environment, without running anything.

    Args:
        root: of the environment.
    """
    if not root.is_dir():
        return Managed(Condition.ABSENT)
    facts = _facts(root)
    build = next((one for one in EngineBuild if one.value == facts.get("build")), None)
    size = size_of(root)
    if build is None or interpreter_of(root) is None:
        return Managed(Condition.INCOMPLETE, build, size=size)
    missing = _missing(root, build)
    whole = not missing and facts.get("lock_sha256") == digest_of(build)
    condition = Condition.COMPLETE if whole else Condition.INCOMPLETE
    return Managed(condition, build, missing, size)


def engine_version() -> str:
    """Version of the engine that belongs to this addon."""
    text = (CORE / "pyproject.toml").read_text(encoding="utf-8")
    found = re.search(r'^version = "([^"]+)"', text, re.MULTILINE)
    return found[1] if found is not None else "?"


def digest_of(build: EngineBuild) -> str:
    """What tells one lock from another."""
    return hashlib.sha256(build.lock.read_bytes()).hexdigest()


def size_of(folder: Path) -> int:
    """Bytes of a folder's files; a file with two names counts once, what links lead to does not."""
    total, seen, waiting = 0, set(), [str(folder)]
    while waiting:
        try:
            with os.scandir(waiting.pop()) as found:
                for entry in found:
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)
                        continue
                    state = entry.stat(follow_symlinks=False)
                    if state.st_nlink == 1 or state.st_ino not in seen:
                        total += state.st_size
                    seen.add(state.st_ino)
        except OSError:
            continue  # it went in the meantime
    return total


def remove(root: Path) -> None:
    """Remove the environment, whole or not at all: it goes by its name first.

    Args:
        root: of the environment.

    Raises:
        WorkbenchError: the folder is no environment, or cannot be moved; nothing has changed.
    """
    if root.is_symlink() or not (root / "pyvenv.cfg").is_file():
        text = translate(
            "GaussianCAD",
            "{folder} is not an environment that GaussianCAD made, and stays as it is.",
        )
        raise WorkbenchError(ErrorCode.ENGINE_BROKEN, text.format(folder=root))
    aside = root.with_name(root.name + _ASIDE)
    shutil.rmtree(aside, ignore_errors=True)
    try:
        root.rename(aside)
    except OSError as error:
        text = translate(
            "GaussianCAD",
            "The engine cannot be removed: {reason}. Nothing has changed. Close what uses it, then "
            "try again.",
        )
        reason = error.strerror or error
        raise WorkbenchError(ErrorCode.ENGINE_BROKEN, text.format(reason=reason)) from error
    shutil.rmtree(aside, ignore_errors=True)


def _facts(root: Path) -> dict[str, object]:
    try:
        stated = json.loads((root / MARKER).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return stated if isinstance(stated, dict) else {}


def _missing(root: Path, build: EngineBuild) -> tuple[str, ...]:
    """The packages that every machine needs and that have left no trace of their version."""
    there: set[tuple[str, str]] = set()
    for pattern in ("lib/python*/site-packages/*.dist-info", "Lib/site-packages/*.dist-info"):
        for path in root.glob(pattern):
            name, _, version = path.name.removesuffix(".dist-info").rpartition("-")
            there.add((normalised(name), version))
    lock = pins(build.lock.read_text(encoding="utf-8"))
    return tuple(
        one.name for one in lock if one.everywhere and (one.name, one.version) not in there
    )

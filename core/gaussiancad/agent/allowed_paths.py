"""The one folder that the server works in: paths that an agent names, and where outputs go."""

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from gaussiancad_core.errors import UsageError
from gaussiancad_core.storage.outputs import os_error
from gaussiancad_protocol.codes import Code

OUTPUTS = "gaussiancad-mcp"
"""The folder in it for outputs that the agent gives no name."""

_OF_RUNS = frozenset({"reading.json", "report.json"})
"""Files by which the folder of a run is known."""

_LONGEST_NAME = 40
"""Characters of a sheet's name that the folder of its outputs has."""

_DEEPEST = 6
"""Folders below the one that are listed."""


@dataclass(frozen=True)
class WorkFolder:
    """The folder outside of which nothing is read or written.

    Attributes:
        root: its path, without links.
    """

    root: Path

    @classmethod
    def at(cls, folder: Path) -> "WorkFolder":
        """A folder that exists.

        Raises:
            UsageError: ``path-not-usable``.
        """
        try:
            root = folder.resolve(strict=True)
        except (OSError, RuntimeError, ValueError) as error:
            raise _not_usable(str(folder), error) from error
        if not root.is_dir():
            raise _not_usable(str(folder), "no folder")
        return cls(root)

    def inside(self, name: str) -> Path:
        """The path of a file or folder, links followed.

        Args:
            name: relative to the folder, or absolute.

        Raises:
            UsageError: ``outside-folder``; ``path-not-usable``.
        """
        try:
            path = Path(self.root, name).resolve()
        except (OSError, RuntimeError, ValueError) as error:
            raise _not_usable(name, error) from error
        if not path.is_relative_to(self.root):
            raise UsageError(
                Code.OUTSIDE_FOLDER,
                "{path} lies outside of the folder {folder}: name a file in it, relative to it",
                path=name,
                folder=self.root,
            )
        return path

    def name_of(self, path: Path) -> str:
        """A path as the agent names it."""
        return path.relative_to(self.root).as_posix()

    @contextmanager
    def output(self, sheet: Path, kind: str, named: str | None = None) -> Iterator[Path]:
        """The folder for an output: the named one, else a new one, which goes where nothing is
        written into it.

        Args:
            sheet: that the output is of.
            kind: of output: ``reading``, ``part``.
            named: by the agent; what an earlier run left in it is replaced.

        Raises:
            UsageError: ``outside-folder``, ``wrong-usage``, ``output-not-writable``.
            LimitError: ``disk-full``.
        """
        if named is not None:
            path = self.inside(named)
            if path == self.root:
                raise UsageError(
                    Code.WRONG_USAGE, "output: name a subfolder, such as parts/bracket"
                )
            yield path
            return
        path = self._new_output(sheet, kind)
        try:
            yield path
        except BaseException:
            with suppress(OSError):
                path.rmdir()
            raise

    def _new_output(self, sheet: Path, kind: str) -> Path:
        outputs = self.inside(OUTPUTS)
        stem = re.sub(r"[^\w-]+", "-", sheet.stem)[:_LONGEST_NAME].strip("-") or "sheet"
        try:
            outputs.mkdir(exist_ok=True)
            for number in count(1):
                path = outputs / f"{stem}-{kind}-{number}"
                # Another server may work in the same folder.
                with suppress(FileExistsError):
                    path.mkdir()
                    return path
        except OSError as error:
            raise os_error(outputs, error) from error
        raise AssertionError("there is always a next number")

    def id_of(self, output: Path) -> str:
        """By what the agent names an output: its folder, short where it is a new one."""
        return self.name_of(output).removeprefix(f"{OUTPUTS}/")

    def files(self, drawings: frozenset[str], models: frozenset[str]) -> Iterator[Path]:
        """Drawings and models of the folder, in order; links are left out, and pictures of runs.

        Args:
            drawings, models: how their names end.
        """
        for folder, folders, names in os.walk(self.root):
            depth = len(Path(folder).relative_to(self.root).parts)
            folders[:] = sorted(
                name
                for name in folders
                if depth < _DEEPEST and not name.startswith(".") and name != OUTPUTS
            )
            suffixes = models if _OF_RUNS & set(names) else drawings | models
            for name in sorted(names):
                path = Path(folder, name)
                if path.suffix.lower() in suffixes and not path.is_symlink():
                    yield path


def _not_usable(path: str, reason: Exception | str) -> UsageError:
    return UsageError(
        Code.PATH_NOT_USABLE,
        "{path} cannot be used ({reason}): choose another name or folder",
        path=path,
        reason=getattr(reason, "strerror", None) or reason,
    )

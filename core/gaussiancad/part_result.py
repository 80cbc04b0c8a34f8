"""What a reconstruction made: its status, its report, its solid and its files."""

import json
import shutil
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from gaussiancad.options import PathLike
from gaussiancad_core.errors import EngineError
from gaussiancad_protocol.codes import Code

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape

REPORT_FILE = "report.json"
SOLID_FILE = "solid.step"


@dataclass(frozen=True)
class Finding:
    """A reason or a warning of a report.

    Attributes:
        code: in kebab-case, stable; docs/messages.md explains each.
        message: a sentence.
    """

    code: str
    message: str


class Result:
    """A part, as far as a sheet tells it.

    The files of the run lie in a temporary folder as long as the object lives; ``save`` copies
    them.

    Args:
        folder: what a run wrote.
        kept: holds the folder, where it is a temporary one.

    Attributes:
        folder: that of the files.
        report: ``report.json``, see the documentation.
    """

    def __init__(
        self, folder: Path, kept: "tempfile.TemporaryDirectory[str] | None" = None
    ) -> None:
        self.folder = folder
        self._kept = kept
        self.report: Mapping[str, Any] = MappingProxyType(
            json.loads((folder / REPORT_FILE).read_bytes())
        )

    @property
    def status(self) -> str:
        """``verified``, ``approximate`` or ``failed``."""
        return str(self.report["status"])

    @property
    def reasons(self) -> tuple[Finding, ...]:
        """Why the part is not ``verified``, or failed."""
        return _findings(self.report.get("reasons", ()))

    @property
    def warnings(self) -> tuple[Finding, ...]:
        """What a person should know, whatever the status."""
        return _findings(self.report.get("warnings", ()))

    @property
    def files(self) -> Mapping[str, Path]:
        """The files of the run by their names, such as ``solid.step`` and ``surface.stl``."""
        found = {
            path.relative_to(self.folder).as_posix(): path
            for path in sorted(self.folder.rglob("*"))
            if path.is_file()
        }
        return MappingProxyType(found)

    @cached_property
    def solid(self) -> "TopoDS_Shape | None":
        """The exact solid in mm, its bounding box beginning at the origin; None if there is none.

        Raises:
            EngineError: ``engine-missing``, this Python lacks OpenCASCADE: take the file
                ``solid.step``.
        """
        path = self.folder / SOLID_FILE
        if not path.is_file():
            return None
        try:
            from gaussiancad_core.kernel.brep_files import read_solid
        except ImportError as error:
            raise EngineError(
                Code.ENGINE_MISSING,
                "this Python lacks {library}: import the file {path} with a program that reads "
                "STEP, or call from the engine's Python",
                library=error.name or "OCP",
                path=path,
            ) from error
        return read_solid(path)

    def to_build123d(self) -> Any:  # noqa: ANN401
        """The solid as a ``build123d.Solid``, or a ``Compound`` of several; None if there is none.

        Raises:
            EngineError: ``extra-missing``, build123d is not installed.
        """
        shape = self.solid
        if shape is None:
            return None
        try:
            from build123d import Compound, Solid
        except ImportError as error:
            raise EngineError(
                Code.EXTRA_MISSING,
                "{library} is not installed: pip install {library}",
                library="build123d",
            ) from error
        solids = Compound(shape).solids()
        return Solid(solids[0].wrapped) if len(solids) == 1 else Compound(shape)

    def save(self, folder: PathLike, *, overwrite: bool = False) -> Path:
        """Write the files of the run into a folder, all of them together.

        What an earlier run left there is replaced.

        Args:
            folder: made if it does not exist.
            overwrite: replace files of the same names that no run made, too.

        Returns:
            The folder.

        Raises:
            UsageError: ``foreign-files``, or the folder cannot be written.
            LimitError: ``disk-full``.
        """
        from gaussiancad_core.storage.foreign_files import check_no_foreign
        from gaussiancad_core.storage.outputs import RUN_FILES, OutputFolder, os_error

        target = Path(folder)
        names = (*RUN_FILES, REPORT_FILE)
        if not overwrite:
            check_no_foreign(target, names)
        output = OutputFolder(target, RUN_FILES, REPORT_FILE)
        try:
            shutil.copytree(self.folder, output.staging, dirs_exist_ok=True)
            output.commit()
        except OSError as error:
            output.discard()
            raise os_error(target, error) from error
        except BaseException:
            output.discard()
            raise
        return target

    def __repr__(self) -> str:
        solid = self.report.get("solid")
        if solid is None:
            return f"<Result {self.status}: no solid>"
        extents = " x ".join(f"{value:.6g}" for value in solid["bounding_box_mm"])
        return f"<Result {self.status}: {solid['faces']} faces, {extents} mm>"


def _findings(entries: Any) -> tuple[Finding, ...]:  # noqa: ANN401
    return tuple(Finding(str(entry["code"]), str(entry["message"])) for entry in entries)

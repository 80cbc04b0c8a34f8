"""Does a model agree with its drawing?"""

import json
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gaussiancad.engine_call import Progress, Watch, run_command
from gaussiancad.models import model_file
from gaussiancad.options import Box, PathLike, path_of, reading_options
from gaussiancad.part_result import Result

_CHECK_FILES = ("check.json", "check.png")


class Check(Mapping[str, Any]):
    """Whether a model agrees with its drawing; the keys are those of ``check.json``.

    Args:
        values: the file's content.
    """

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = MappingProxyType(dict(values))

    def __getitem__(self, name: str) -> Any:  # noqa: ANN401
        return self._values[name]

    def __iter__(self) -> Any:  # noqa: ANN401
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    @property
    def verdict(self) -> str:
        """``agrees``, ``differs`` or ``cannot-tell``."""
        return str(self._values["verdict"])

    @property
    def reasons(self) -> list[Mapping[str, Any]]:
        """Why, the strongest first: ``code``, ``message`` and the ``args`` in it."""
        return list(self._values["reasons"])

    @property
    def differences(self) -> list[Mapping[str, Any]]:
        """Places at which both differ, the worst first."""
        return list(self._values["differences"])

    @property
    def tally(self) -> list[Mapping[str, Any]]:
        """Notes of the sheet against the model, those that it does not keep first."""
        return list(self._values["tally"])

    @property
    def edits(self) -> list[Mapping[str, Any]]:
        """Single changes of the model that explain the sheet better, the best first."""
        return list(self._values["edits"])

    @property
    def silent(self) -> list[Mapping[str, Any]]:
        """Features of the model of which the sheet tells nothing."""
        return list(self._values["silent"])

    def __repr__(self) -> str:
        return f"<Check: {self.verdict}, {len(self.differences)} differences>"


def check(
    sheet: PathLike,
    solid: Result | PathLike,
    *,
    projection: str | None = None,
    views: Mapping[str, Box] | None = None,
    page: int = 1,
    length: Mapping[str, float] | None = None,
    mm_per_pixel: float | None = None,
    unit: str | None = None,
    output: PathLike | None = None,
    progress: Progress | None = None,
    limit_s: float | None = None,
) -> Check:
    """Tell whether a model agrees with its drawing, and where it does not.

    Args:
        sheet, projection, views, page, length, mm_per_pixel, unit, progress, limit_s: as of
            :func:`gaussiancad.read`.
        solid: what a sheet gave, or a file: STEP, BREP, STL, PLY or OBJ, in any position.
        output: folder for ``check.json`` and ``check.png``; nothing is written where None.

    Raises:
        UnreadableError: the sheet is no drawing, or the file no model.
        UsageError: an option has no such value, or the output cannot be written.
        LimitError: a limit was reached.
        EngineError: the engine is missing or incomplete.
    """
    stated = reading_options(
        projection=projection,
        views=views,
        page=page,
        length=length,
        mm_per_pixel=mm_per_pixel,
        unit=unit,
    )
    with tempfile.TemporaryDirectory(prefix="gaussiancad-") as name:
        folder = Path(name) / "check"
        files = path_of(sheet), model_file(solid), f"--output={folder}"
        ended = run_command(["check", *files, *stated, "--events"], Watch(progress, limit_s))
        data = folder / _CHECK_FILES[0]
        if not data.is_file():
            raise ended.error()
        values = json.loads(data.read_text(encoding="utf-8"))
        if output is not None:
            Path(output).mkdir(parents=True, exist_ok=True)
            for file in _CHECK_FILES:
                shutil.copy2(folder / file, Path(output) / file)
    return Check(values)

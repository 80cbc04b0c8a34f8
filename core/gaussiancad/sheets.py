"""From a sheet to what it says, and to the part that it shows."""

import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gaussiancad.engine_call import Progress, Watch, run_command
from gaussiancad.options import Box, PathLike, options, path_of, reading_options
from gaussiancad.part_result import REPORT_FILE, Result
from gaussiancad.sheet_reading import Reading
from gaussiancad_protocol.exit_codes import ExitCode

_READING_FILE = "reading.json"
_CORRECTIONS_FILE = "corrections.json"
_CORRECTIONS_SCHEMA = "gaussiancad-corrections/1"
_PREFIX = "gaussiancad-"


def read(
    sheet: PathLike,
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
) -> Reading:
    """Read a sheet: its views, their strokes, its dimensions and notes.

    What no part follows from is told in ``problems`` and raises nothing.

    Args:
        sheet: PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF.
        projection: ``first`` or ``third`` angle; found on the sheet where None.
        views: boxes around views by their roles, px of the sheet as stored (y down).
        page: of a file that has several, from 1.
        length: the part's extents in mm by axis, such as ``{"x": 80}``.
        mm_per_pixel: the scale.
        unit: of a file that does not say its own: ``mm``, ``cm``, ``m``, ``in`` or ``ft``.
        output: folder for ``reading.json``, ``reading.png``, ``sheet.png``, ``lines.dxf`` and
            ``lines.svg``; nothing is written where None.
        progress: called with the running stage and the fraction of it that is done, at least
            twice a second; an exception in it stops the run.
        limit_s: seconds after which the run is stopped.

    Raises:
        UsageError: an option has no such value, or the output cannot be written.
        UnreadableError: the file is no sheet, or damaged.
        LimitError: it is too large, memory does not suffice, or ``limit_s`` has passed.
        EngineError: the engine is missing or incomplete.
    """
    stated_reading_options = reading_options(
        projection=projection,
        views=views,
        page=page,
        length=length,
        mm_per_pixel=mm_per_pixel,
        unit=unit,
    )
    return _read(Path(sheet), page, stated_reading_options, output, Watch(progress, limit_s))


def correct(
    reading: Reading,
    corrections: Sequence[Mapping[str, Any]],
    *,
    output: PathLike | None = None,
    progress: Progress | None = None,
    limit_s: float | None = None,
) -> Reading:
    """Apply corrections to what was read, as the canvas does.

    Args:
        reading: of a sheet.
        corrections: operations of ``corrections.json``, one after another.
        output, progress, limit_s: as of :func:`read`.

    Returns:
        The corrected reading, with the problems that it still has.

    Raises:
        UnreadableError: ``corrections-not-read``: one has no such form; the message says which.
    """
    with tempfile.TemporaryDirectory(prefix=_PREFIX) as name:
        stated_options = _of_reading(reading, corrections, Path(name))
        return _read(reading.sheet, reading.page, stated_options, output, Watch(progress, limit_s))


def reconstruct(
    sheet: PathLike,
    *,
    result: str | None = None,
    projection: str | None = None,
    views: Mapping[str, Box] | None = None,
    page: int = 1,
    length: Mapping[str, float] | None = None,
    mm_per_pixel: float | None = None,
    unit: str | None = None,
    recipe: str | None = None,
    preset: str | None = None,
    seed: int = 0,
    device: str | None = None,
    progress: Progress | None = None,
    limit_s: float | None = None,
) -> Result:
    """Make a part from a sheet; nothing is written but into a temporary folder.

    Args:
        sheet, projection, views, page, length, mm_per_pixel, unit, progress, limit_s: as of
            :func:`read`.
        result: ``solid`` for the exact solid alone, ``surface`` for the Gaussians and their
            surface alone, ``both``; what is installed where None.
        recipe: ``orthographic``, or ``paper`` for the cameras of the paper.
        preset: ``draft``, ``standard`` or ``fine``: how long Gaussians are trained.
        seed: of all chance.
        device: ``auto``, ``cpu`` or ``cuda``.

    Returns:
        The part; ``failed`` where the sheet was read but no part follows from it.

    Raises:
        GaussianCadError: as of :func:`read`.
    """
    stated_reading_options = reading_options(
        projection=projection,
        views=views,
        page=page,
        length=length,
        mm_per_pixel=mm_per_pixel,
        unit=unit,
    )
    stated_reading_options += options(
        result=result, recipe=recipe, preset=preset, seed=seed, device=device
    )
    return _reconstructed(Path(sheet), stated_reading_options, Watch(progress, limit_s))


def solve(
    reading: Reading,
    *,
    result: str | None = None,
    recipe: str | None = None,
    preset: str | None = None,
    seed: int = 0,
    device: str | None = None,
    progress: Progress | None = None,
    limit_s: float | None = None,
) -> Result:
    """Make a part from what was read of a sheet, corrected or not.

    Args:
        reading: of the sheet, whose file must still be there.
        result, recipe, preset, seed, device, progress, limit_s: as of :func:`reconstruct`.

    Raises:
        GaussianCadError: as of :func:`reconstruct`.
    """
    with tempfile.TemporaryDirectory(prefix=_PREFIX) as name:
        # None on top of it: those that lie beside the sheet are in it already.
        stated_options = _of_reading(reading, (), Path(name))
        stated_options += options(
            result=result, recipe=recipe, preset=preset, seed=seed, device=device
        )
        return _reconstructed(reading.sheet, stated_options, Watch(progress, limit_s))


def _of_reading(
    reading: Reading, corrections: Sequence[Mapping[str, Any]], folder: Path
) -> list[str]:
    """The options that name a reading and its corrections, which are written into a folder."""
    (folder / _READING_FILE).write_bytes(reading.as_json())
    stated = {
        "schema": _CORRECTIONS_SCHEMA,
        "sheet_sha256": reading.data["sheet"]["sha256"],
        "ops": list(corrections),
    }
    (folder / _CORRECTIONS_FILE).write_text(json.dumps(stated), encoding="utf-8")
    return options(
        page=reading.page,
        reading=folder / _READING_FILE,
        corrections=folder / _CORRECTIONS_FILE,
    )


def _read(
    sheet: Path,
    page: int,
    stated: list[str],
    output: PathLike | None,
    watch: Watch,
) -> Reading:
    with tempfile.TemporaryDirectory(prefix=_PREFIX) as name:
        folder = Path(name if output is None else path_of(output))
        arguments = ["read", path_of(sheet), f"--output={folder}", *stated, "--events"]
        ended = run_command(arguments, watch)
        if ended.exit_code != ExitCode.DONE:
            raise ended.error()
        data = json.loads((folder / _READING_FILE).read_bytes())
    kept = None if output is None else folder
    return Reading(Path(path_of(sheet)), MappingProxyType(data), page, kept)


def _reconstructed(sheet: Path, stated: list[str], watch: Watch) -> Result:
    kept = tempfile.TemporaryDirectory(prefix=_PREFIX)
    try:
        arguments = ["reconstruct", path_of(sheet), f"--output={kept.name}", *stated, "--events"]
        ended = run_command(arguments, watch)
        reported = Path(kept.name, REPORT_FILE).is_file()
        if ended.exit_code == ExitCode.DONE or (ended.exit_code == ExitCode.NO_MODEL and reported):
            return Result(Path(kept.name), kept)
        raise ended.error()
    except BaseException:
        kept.cleanup()
        raise

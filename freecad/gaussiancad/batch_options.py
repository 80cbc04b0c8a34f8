"""The options of a batch."""

import argparse
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum
from functools import partial
from pathlib import Path
from typing import TypeVar

from freecad.gaussiancad.engine.job import (
    SHEET_SUFFIXES,
    Outcome,
    Preset,
    Projection,
    Recipe,
    ReconstructJob,
    Scale,
    ScaleKind,
)

_Mode = TypeVar("_Mode", bound=Enum)


@dataclass(frozen=True)
class BatchOptions:
    """What a batch is asked to do.

    Attributes:
        sheets: at least one.
        output: folder for everything; it exists.
        flat: whether the one sheet's files go into ``output`` itself.
        job: the settings; its paths are not used.
    """

    sheets: tuple[Path, ...]
    output: Path
    flat: bool
    job: ReconstructJob


def parse_options(arguments: Sequence[str]) -> BatchOptions:
    """Read the arguments, and make the output folder.

    Raises:
        SystemExit: after a message, with 2 for wrong usage and 0 for ``--help``.
    """
    parser = _parser()
    found = parser.parse_args(arguments)
    sheets = collect_sheets(found.sheets)
    _check(parser, found, sheets)
    scale = found.length or found.mm_per_pixel or Scale()
    job = ReconstructJob(
        "",
        "",
        found.projection,
        found.preset,
        found.result,
        found.recipe,
        scale,
        found.colour,
        found.page,
        found.seed,
        found.scale_down,
    )
    return BatchOptions(tuple(sheets), found.output, found.flat, job)


def collect_sheets(paths: Iterable[Path]) -> list[Path]:
    """The files, and of each folder the drawings in it, in the order of their names; each once."""
    sheets: list[Path] = []
    for path in paths:
        if path.is_dir():
            sheets += sorted(entry for entry in path.iterdir() if _is_sheet(entry))
        else:
            sheets.append(path)
    return list({os.path.abspath(sheet): sheet for sheet in sheets}.values())


def _is_sheet(path: Path) -> bool:
    return path.suffix.lower().lstrip(".") in SHEET_SUFFIXES and path.is_file()


def _check(parser: argparse.ArgumentParser, found: argparse.Namespace, sheets: list[Path]) -> None:
    if not sheets:
        parser.error("there is no drawing in the folder that was named")
    if found.flat and len(sheets) != 1:
        parser.error(f"--flat takes one sheet, not {len(sheets)}")
    try:
        found.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        parser.error(f"cannot write to {found.output}: {error.strerror}")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="gaussiancad_batch.py",
        description="Convert drawings to FreeCAD documents, STEP and STL files.",
    )
    parser.add_argument("sheets", type=Path, nargs="+", metavar="SHEET", help="file or folder")
    parser.add_argument("--output", type=Path, required=True, metavar="DIR")
    parser.add_argument(
        "--flat", action="store_true", help="one sheet, all of its files in DIR itself"
    )
    for option, modes, default in (
        ("--projection", Projection, Projection.AUTO),
        ("--preset", Preset, Preset.STANDARD),
        ("--result", Outcome, Outcome.BOTH),
        ("--recipe", Recipe, Recipe.ORTHOGRAPHIC),
    ):
        parser.add_argument(
            option,
            type=partial(_mode, modes),
            default=default,
            metavar="|".join(mode.value for mode in modes),
        )
    scale = parser.add_mutually_exclusive_group()
    scale.add_argument("--length", type=_length, metavar="AXIS=MM", help="extent on x, y or z")
    scale.add_argument("--mm-per-pixel", type=_mm_per_pixel, metavar="S")
    parser.add_argument("--colour", default=ReconstructJob.colour, metavar="#RRGGBB")
    parser.add_argument("--page", type=int, default=1, metavar="N")
    parser.add_argument("--seed", type=int, default=0, metavar="N")
    parser.add_argument(
        "--scale-down",
        type=_whole,
        default=1,
        metavar="N",
        help="divides the edges of the images that train the Gaussians",
    )
    return parser


def _mode(modes: type[_Mode], text: str) -> _Mode:
    try:
        return modes(text)
    except ValueError as error:
        choices = ", ".join(mode.value for mode in modes)
        raise argparse.ArgumentTypeError(f"'{text}' is not one of {choices}") from error


def _length(text: str) -> Scale:
    axis, _, number = text.partition("=")
    kinds = {"x": ScaleKind.LENGTH_X, "y": ScaleKind.LENGTH_Y, "z": ScaleKind.LENGTH_Z}
    if axis not in kinds:
        raise argparse.ArgumentTypeError(f"'{text}' is not AXIS=MM, such as x=60")
    return Scale(kinds[axis], _positive(number))


def _mm_per_pixel(text: str) -> Scale:
    return Scale(ScaleKind.MM_PER_PIXEL, _positive(text))


def _whole(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1")
    return int(text)


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number") from error
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not positive")
    return value

"""The options of a batch."""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from functools import partial
from pathlib import Path
from typing import TypeVar

from freecad.gaussiancad.engine.job import (
    BatchJob,
    BatchLimits,
    Projection,
    ReconstructJob,
    Scale,
    ScaleKind,
)
from freecad.gaussiancad.engine.protocol import Preset, Recipe, ResultKind

_Mode = TypeVar("_Mode", bound=Enum)


@dataclass(frozen=True)
class BatchOptions:
    """What a batch is asked to do.

    Attributes:
        job: what the engine does.
        flat: whether the files of its one sheet go into its output folder itself.
        body: whether documents get a body beside the solid.
    """

    job: BatchJob
    flat: bool
    body: bool = False

    @property
    def output(self) -> Path:
        """Folder for everything; it exists."""
        return Path(self.job.output)

    @property
    def one(self) -> ReconstructJob:
        """The first sheet, with its files in the output folder itself."""
        return replace(self.job.settings, sheet=self.job.sheets[0], output=self.job.output)


def parse_options(arguments: Sequence[str]) -> BatchOptions:
    """Read the arguments, and make the output folder.

    Raises:
        SystemExit: after a message, with 2 for wrong usage and 0 for ``--help``.
    """
    parser = _parser()
    found = parser.parse_args(arguments)
    limits = BatchLimits(found.workers, found.memory, found.seconds)
    _check(parser, found, limits)
    scale = found.length or found.mm_per_pixel or Scale()
    settings = ReconstructJob(
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
    job = BatchJob(tuple(found.sheets), str(found.output), settings, limits, found.resume)
    return BatchOptions(job, found.flat, found.body)


def _check(parser: argparse.ArgumentParser, found: argparse.Namespace, limits: BatchLimits) -> None:
    if found.flat and len(found.sheets) != 1:
        parser.error(f"--flat takes one sheet, not {len(found.sheets)}")
    if found.flat and Path(found.sheets[0]).is_dir():
        parser.error("--flat takes a sheet, not a folder")
    if found.flat and (found.resume or limits != BatchLimits()):
        parser.error("--flat takes neither --resume nor limits")
    try:
        found.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        parser.error(f"cannot write to {found.output}: {error.strerror}")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="gaussiancad_batch.py",
        description="Convert drawings to FreeCAD documents, STEP and STL files.",
    )
    parser.add_argument(
        "sheets",
        nargs="+",
        metavar="SHEET|FOLDER|TABLE.csv",
        help="files, folders of drawings, patterns, tables with a column 'sheet' and options",
    )
    parser.add_argument("--output", type=Path, required=True, metavar="DIR")
    parser.add_argument(
        "--flat", action="store_true", help="one sheet, all of its files in DIR itself"
    )
    parser.add_argument(
        "--body", action="store_true", help="put an editable body into each document as well"
    )
    parser.add_argument("--workers", type=_whole, metavar="N", help="sheets at a time")
    parser.add_argument("--memory", type=_positive, metavar="GB", help="that a sheet may take")
    parser.add_argument("--seconds", type=_positive, metavar="S", help="that a sheet may take")
    parser.add_argument("--resume", action="store_true", help="keep what an earlier batch finished")
    for option, modes, default in (
        ("--projection", Projection, Projection.AUTO),
        ("--preset", Preset, Preset.STANDARD),
        ("--result", ResultKind, ResultKind.BOTH),
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

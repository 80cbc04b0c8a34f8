"""Parts, the samples first and then parts by chance, on sheets of many styles."""

import argparse
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path

from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import SheetStyle, parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.samples import SAMPLES, sample
from gaussiancad_core.samples.random_parts import random_part
from gaussiancad_core.sheet.reading_options import Finder, ReadingOptions

STYLES = (
    "clean", "thin", "thick", "scan", "photocopy", "dimensioned", "workshop", "jpeg30",
    "iso", "ansi", "even",
)  # fmt: skip
"""The last three have line weights and rhythms that nothing was tuned on."""

FOREIGN = {"foreign": False, "foreign-dimensioned": True}
"""Styles of other programs, and whether these have dimensions."""

ARRANGEMENTS = (
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.BOTTOM, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.FIRST),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.THIRD),
    ((Role.FRONT, Role.BOTTOM, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.TOP, Role.RIGHT, Role.LEFT), Projection.THIRD),
)


@dataclass(frozen=True)
class Job:
    """A part to be drawn in some styles, and where to keep what was misread."""

    name: str
    seed: int
    arrangement: int
    styles: tuple[str, ...]
    keep: Path | None
    keep_below: float
    reading: ReadingOptions

    def lines(self) -> tuple[PartLines, Projection]:
        """The part's lines, which all styles share."""
        roles, projection = ARRANGEMENTS[self.arrangement % len(ARRANGEMENTS)]
        known = {part.name for part in SAMPLES}
        shape = sample(self.name).build() if self.name in known else random_part(self.seed)
        picture = any(style_of(text).picture for text in self.styles)
        return part_lines(shape, roles, picture=picture), projection


@dataclass(frozen=True)
class Drawn:
    """A sheet, the quality of its file and half the width of its visible lines."""

    sheet: Sheet
    quality: int
    covered: float


def style_of(text: str) -> SheetStyle:
    """The style of that name; for sheets of other programs one that asks for nothing."""
    return SheetStyle() if text in FOREIGN else parse_style(text)


def drawn_in(lines: PartLines, projection: Projection, text: str, job: Job) -> Drawn:
    """The sheet of a part's lines in a style."""
    if text in FOREIGN:
        how = Conventions.drawn_by_lot(job.seed, dimensioned=FOREIGN[text])
        return Drawn(foreign_sheet(lines, how, projection), 95, 0.5 * how.visible)
    style = parse_style(text)
    sheet = compose_sheet(lines, projection, style, job.seed, title=job.name.upper())
    return Drawn(sheet, style.jpeg_quality, 0.5 * style.visible_width)


def jobs_of(options: argparse.Namespace) -> Iterator[Job]:
    """The samples, then parts by chance, as many as asked for."""
    chance = ((f"random-{number}", number) for number in range(options.seed, sys.maxsize))
    names = chain(((part.name, options.seed + i) for i, part in enumerate(SAMPLES)), chance)
    for index, (name, seed) in enumerate(islice(names, options.skip + options.parts)):
        if index < options.skip:
            continue
        if not options.only or name in options.only:
            styles, reading = tuple(options.styles), _reading(options)
            yield Job(name, seed, index, styles, options.keep, options.keep_below, reading)


def _reading(options: argparse.Namespace) -> ReadingOptions:
    """How sheets are read; the GaussianCAD paper's way is ``--finder hough --median 3``."""
    return ReadingOptions(median_kernel=options.median, finder=Finder(options.finder))

"""Sheets of a folder, read without a truth; vector files directly and as pictures."""

import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from itertools import chain
from pathlib import Path

import numpy as np
from reading_found import Found, drawn_over, read
from stroke_matching import Marks, Matched, match, of_kind

from gaussiancad_core.drawing.command import write_image
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.sheet.options import ReadingOptions
from gaussiancad_core.sheet.read import read_sheet
from gaussiancad_core.views import Linetype

FILES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".pdf", ".svg", ".dxf")


def read_folder(folder: Path, reading: ReadingOptions, keep: Path | None) -> None:
    """Read other material and say what was found.

    There is no truth to compare with, but vector files are read twice: the lines that their picture
    gives are matched with those that the file has.

    Args:
        folder: with its own folders.
        reading: finder and filter.
        keep: folder for pictures of what was read, or nothing.
    """
    compared = []
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() not in FILES:
            continue
        started = time.perf_counter()
        try:
            found = read(path, reading)
        except GaussianCadError as error:
            print(f"{path.name:32}{time.perf_counter() - started:7.2f} s  {error.code}: {error}")
            continue
        seconds = time.perf_counter() - started
        views = ", ".join(
            f"{role.value} {len(of_kind(strokes, Linetype.VISIBLE))}"
            f"+{len(of_kind(strokes, Linetype.HIDDEN))}"
            for role, strokes in found.strokes.items()
        )
        print(f"{path.name:32}{seconds:7.2f} s  {found.projection.value}: {views}", flush=True)
        if found.direct_views:
            compared.append(as_a_picture(path, found, reading, keep))
        if keep is not None:
            keep.mkdir(parents=True, exist_ok=True)
            image = np.repeat(read_sheet(path).grey[..., None], 3, axis=2)
            write_image(drawn_over(image, found, Marks()), keep / f"{path.stem}-read.png")
    if compared:
        print_compared(compared)


@dataclass(frozen=True)
class Compared:
    """A vector sheet read from its picture, against what the file has."""

    views: int
    direct_views: int
    visible: Matched = field(default_factory=Matched)
    hidden: Matched = field(default_factory=Matched)
    errors: tuple[float, ...] = ()
    failed: bool = False


def as_a_picture(
    path: Path, direct: Found, reading: ReadingOptions, keep: Path | None = None
) -> Compared:
    """Read a vector sheet again, as a picture, and match its lines with those of the file."""
    count = len(direct.strokes)
    try:
        found = read(path, reading, direct=False)
    except GaussianCadError as error:
        print(f"{'':32}as a picture: {error.code}")
        return Compared(count, direct.direct_views, failed=True)
    drawn = list(chain.from_iterable(direct.strokes.values()))
    seen = list(chain.from_iterable(found.strokes.values()))
    matched, errors, marks = match(drawn, seen, covered=1.0)
    if keep is not None:
        keep.mkdir(parents=True, exist_ok=True)
        image = np.repeat(read_sheet(path).grey[..., None], 3, axis=2)
        write_image(drawn_over(image, found, marks), keep / f"{path.stem}-picture-read.png")
    visible, hidden = matched[Linetype.VISIBLE], matched[Linetype.HIDDEN]
    print(
        f"{'':32}{direct.direct_views} of {count} views direct; as a picture visible "
        f"{visible.precision:.3f}/{visible.recall:.3f} hidden {hidden.precision:.3f}/"
        f"{hidden.recall:.3f} median {np.median(errors) if len(errors) else np.nan:.3f} px",
        flush=True,
    )
    return Compared(count, direct.direct_views, visible, hidden, tuple(errors.tolist()))


def print_compared(rows: Sequence[Compared]) -> None:
    """One line for all vector sheets."""
    good = [row for row in rows if not row.failed]
    shares = []
    for kind in ("visible", "hidden"):
        parts = [getattr(row, kind) for row in good]
        total = Matched(*(sum(getattr(p, name) for p in parts) for name in asdict(Matched())))
        shares.append(f"{kind} {total.precision:.4f}/{total.recall:.4f}")
    errors = np.concatenate([np.array(row.errors) for row in good] or [np.empty(0)])
    middle, most = np.percentile(errors, (50, 95)) if len(errors) else (np.nan, np.nan)
    print(
        f"\n{len(rows)} vector sheets: {sum(row.direct_views for row in rows)} of "
        f"{sum(row.views for row in rows)} views direct; as pictures {', '.join(shares)} "
        f"(precision/recall), median {middle:.3f} px, 95 % {most:.3f} px, "
        f"{len(rows) - len(good)} not read"
    )

"""How exactly sheets are read: strokes, ends, boxes, roles and projection against what was drawn.

Parts (the samples and parts by chance) are drawn in every style, with roles and projection changing
from part to part, written to files, and read with nothing told.

    .venv/bin/python benchmarks/sheet_reading.py [--parts N] [--styles NAME ...] [--keep DIR]
    .venv/bin/python benchmarks/sheet_reading.py --finder hough --median 5
    .venv/bin/python benchmarks/sheet_reading.py --data DIR [--keep DIR]

Precision and recall are shares of length: a point of a stroke counts where a stroke of the same
linetype passes within 1 px in the same direction.  Hidden lines under the ink of visible ones do
not count.  The position error is the distance of matched points across the true stroke.  Vertices
are ends of true strokes with an end of a read stroke within 1 px.  ``box px`` is the largest error
of a corner in nine of ten sheets.  ``views`` is the share of views with their right names, ``proj``
of sheets with the right projection, ``or`` of those where it was at least kept as an alternative.

With ``--data`` other sheets are read.  PDF, SVG and DXF files are read directly and as pictures,
and the lines of the picture are matched with those of the file.
"""

import argparse
import json
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field
from functools import partial
from itertools import chain, islice
from multiprocessing import get_context
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
from stroke_matching import Box, Marks, Matched, ends_of, match, nearness, of_kind, overlap

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.drawing.command import write_image
from gaussiancad_core.drawing.sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.strokes import DrawnStroke, turned
from gaussiancad_core.drawing.style import SheetStyle, parse_style
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.projection_choice import choose_projection
from gaussiancad_core.samples import SAMPLES, sample
from gaussiancad_core.samples.random_parts import random_part
from gaussiancad_core.sheet.clean import clean_sheet, upright_sheet
from gaussiancad_core.sheet.options import MEDIAN_KERNEL, Finder, ReadingOptions
from gaussiancad_core.sheet.precision import StrokesSource
from gaussiancad_core.sheet.read import read_sheet
from gaussiancad_core.sheet.reading import find_views, read_views
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.views import Linetype

STYLES = (
    "clean", "thin", "thick", "scan", "photocopy", "dimensioned", "workshop", "jpeg30",
    "iso", "ansi", "even",
)  # fmt: skip
"""The last three have line weights and rhythms that nothing was tuned on."""

ARRANGEMENTS = (
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.BOTTOM, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.FIRST),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.THIRD),
    ((Role.FRONT, Role.BOTTOM, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.TOP, Role.RIGHT, Role.LEFT), Projection.THIRD),
)

FILES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".pdf", ".svg", ".dxf")


@dataclass(frozen=True)
class Found:
    """What was read: views in px of the sheet as stored, the projection, and how many views have
    the strokes of the file."""

    boxes: dict[Role, Box]
    strokes: dict[Role, tuple[DrawnStroke, ...]]
    projection: Projection
    alternatives: tuple[Projection, ...]
    direct_views: int = 0


def read(path: Path, reading: ReadingOptions, direct: bool = True) -> Found:
    """Read a sheet as ``gaussiancad reconstruct`` does, with nothing told of it.

    Args:
        path: of the sheet.
        reading: finder and filter.
        direct: use the exact lines of vector files; else their picture alone.
    """
    image = read_sheet(path)
    clean = upright_sheet(clean_sheet(image.grey, reading.median_kernel))
    separated, layout = find_views(clean, {}, None)
    vectors = VectorSheet(image.vectors, clean) if direct and image.vectors else None
    drawn = read_views(separated.part, layout, finder=reading.finder, vectors=vectors)
    projection, alternatives = layout.projection, layout.alternatives
    if alternatives:
        choice = choose_projection(drawn, projection, reading)
        drawn, projection = choice.registered.drawn, choice.projection
        alternatives = () if choice.inferred else (projection.other,)
    turn = clean.turn
    strokes = {
        view.role: tuple(turned(stroke, turn.angle, turn.centre) for stroke in view.strokes)
        for view in drawn
    }
    boxes = {view.role: view.stored_box(turn) for view in drawn}
    direct_views = sum(view.source is not StrokesSource.RASTER for view in drawn)
    return Found(boxes, strokes, projection, alternatives, direct_views)


@dataclass(frozen=True)
class Result:
    """One sheet's figures; ``failure`` is the code of the error that reading it ended in."""

    part: str
    style: str
    seconds: float
    visible: Matched
    hidden: Matched
    errors: tuple[float, ...] = field(repr=False, default=())
    ends: int = 0
    ends_found: int = 0
    box_error: float = float("nan")
    views: int = 0
    views_named: int = 0
    projection: bool = False
    projection_possible: bool = False
    failure: str = ""

    @property
    def score(self) -> float:
        """The worst of its precisions and recalls."""
        kinds = (self.visible, self.hidden)
        return min(min(kind.recall, kind.precision) for kind in kinds)


def compare(
    sheet: Sheet, style: SheetStyle, found: Found, about: tuple[str, str, float]
) -> tuple[Result, "Marks"]:
    """A sheet's figures, and what to mark on its picture."""
    drawn = [stroke for view in sheet.views for stroke in view.strokes]
    seen = list(chain.from_iterable(found.strokes.values()))
    covered = 0.5 * style.visible_width
    matched, errors, marks = match(drawn, seen, covered)
    corners = ends_of(drawn, covered)
    near = nearness(corners, ends_of(seen))
    marks.missed.append(corners[~near])
    right = [role for role in sheet_roles(sheet) if role in found.boxes]
    named = [role for role in right if overlap(sheet[role].box, found.boxes[role]) > 0.5]
    result = Result(
        *about,
        matched[Linetype.VISIBLE],
        matched[Linetype.HIDDEN],
        tuple(errors.tolist()),
        len(corners),
        int(near.sum()),
        _box_error(sheet, found),
        len(sheet.views),
        len(named),
        found.projection is sheet.projection,
        sheet.projection in (found.projection, *found.alternatives),
    )
    return result, marks


def sheet_roles(sheet: Sheet) -> tuple[Role, ...]:
    """The roles of a drawn sheet."""
    return tuple(view.role for view in sheet.views)


def _box_error(sheet: Sheet, found: Found) -> float:
    """The largest error of a box, whatever the view was called; inf where a view is missing."""
    worst = 0.0
    for view in sheet.views:
        over = [box for box in found.boxes.values() if overlap(view.box, box) > 0.5]
        errors = [float(np.abs(np.subtract(view.box, box)).max()) for box in over]
        worst = max(worst, min(errors, default=float("inf")))
    return worst


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
        picture = any(parse_style(text).picture for text in self.styles)
        return part_lines(shape, roles, picture=picture), projection


def run(job: Job) -> list[Result]:
    """Draw and read a part in all styles."""
    lines, projection = job.lines()
    results = []
    for text in job.styles:
        style = parse_style(text)
        sheet = compose_sheet(lines, projection, style, job.seed, title=job.name.upper())
        suffix = "png" if style.jpeg_quality >= 95 else "jpg"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{job.name}-{text.replace(',', '-').replace('=', '')}.{suffix}"
            write_image(sheet.image, path, style.jpeg_quality, sheet.dpi)
            result, marks, found = _read_and_compare(path, sheet, style, job, text)
            results.append(result)
            if job.keep is not None and (result.failure or result.score < job.keep_below):
                job.keep.mkdir(parents=True, exist_ok=True)
                (job.keep / path.name).write_bytes(path.read_bytes())
                picture = drawn_over(sheet.image, found, marks)
                write_image(picture, job.keep / f"{path.stem}-read.png")
    return results


def _read_and_compare(
    path: Path, sheet: Sheet, style: SheetStyle, job: Job, text: str
) -> tuple[Result, Marks, Found | None]:
    names = (job.name, text)
    started = time.perf_counter()
    try:
        found = read(path, job.reading)
    except GaussianCadError as error:
        drawn = [stroke for view in sheet.views for stroke in view.strokes]
        lost, _, _ = match(drawn, [], 0.5 * style.visible_width)
        result = Result(
            *names,
            time.perf_counter() - started,
            lost[Linetype.VISIBLE],
            lost[Linetype.HIDDEN],
            ends=len(ends_of(drawn, 0.5 * style.visible_width)),
            box_error=float("inf"),
            views=len(sheet.views),
            failure=error.code,
        )
        return result, Marks(), None
    result, marks = compare(sheet, style, found, (*names, time.perf_counter() - started))
    return result, marks, found


def drawn_over(image: npt.NDArray[np.uint8], found: Found | None, marks: Marks) -> npt.NDArray:
    """The sheet, twice as large and pale; visible strokes green, hidden ones blue; missed points
    red, wrong ones magenta."""
    pale = (255 - (255 - image.astype(np.int32)) // 3).astype(np.uint8)
    picture = cv2.resize(pale, None, fx=2, fy=2, interpolation=cv2.INTER_NEAREST)
    colours = {Linetype.VISIBLE: (0, 140, 0), Linetype.HIDDEN: (0, 60, 255)}
    for role, strokes in found.strokes.items() if found else ():
        for stroke in strokes:
            chain_px = np.rint(stroke.sample(1.0) * 2.0 * 16.0).astype(np.int32)
            cv2.polylines(picture, [chain_px], False, colours[stroke.linetype], 1, cv2.LINE_AA, 4)
        x0, y0, x1, y1 = (round(2 * value) for value in found.boxes[role])
        cv2.rectangle(picture, (x0 - 12, y0 - 12), (x1 + 12, y1 + 12), (200, 160, 0), 1)
        place = (x0 - 12, y0 - 18)
        cv2.putText(picture, role.value, place, cv2.FONT_HERSHEY_SIMPLEX, 0.8, (160, 120, 0), 1)
    for points, colour in ((marks.missed, (230, 0, 0)), (marks.wrong, (220, 0, 220))):
        for x, y in np.rint(2.0 * np.concatenate([np.empty((0, 2)), *points])).astype(int):
            cv2.circle(picture, (int(x), int(y)), 3, colour, -1)
    return picture


def jobs_of(options: argparse.Namespace) -> Iterator[Job]:
    """The samples, then parts by chance, as many as asked for."""
    chance = ((f"random-{number}", number) for number in range(options.seed, sys.maxsize))
    names = chain(((part.name, options.seed + i) for i, part in enumerate(SAMPLES)), chance)
    for index, (name, seed) in enumerate(islice(names, options.parts)):
        if not options.only or name in options.only:
            styles, reading = tuple(options.styles), _reading(options)
            yield Job(name, seed, index, styles, options.keep, options.keep_below, reading)


def _reading(options: argparse.Namespace) -> ReadingOptions:
    """How sheets are read; the GaussianCAD paper's way is ``--finder hough --median 3``."""
    return ReadingOptions(median_kernel=options.median, finder=Finder(options.finder))


def print_table(results: Sequence[Result]) -> None:
    """A row for each style and one for all."""
    styles = defaultdict(list)
    for result in results:
        styles[result.style].append(result)
    width = max(map(len, styles)) + 2
    print(
        f"{'style':{width}}{'sheets':>7}{'failed':>7}{'vis P':>8}{'vis R':>8}{'hid P':>8}"
        f"{'hid R':>8}{'med px':>8}{'95% px':>8}{'vertices':>9}{'box px':>8}{'views':>7}"
        f"{'proj':>7}{'or':>7}{'s':>7}"
    )
    for style, rows in (*styles.items(), ("all", results)):
        print(f"{style:{width}}" + "".join(_cells(rows)))


def _cells(rows: Sequence[Result]) -> Iterator[str]:
    yield f"{len(rows):7}{sum(bool(row.failure) for row in rows):7}"
    for kind in ("visible", "hidden"):
        parts = [getattr(row, kind) for row in rows]
        total = Matched(*(sum(getattr(part, name) for part in parts) for name in asdict(parts[0])))
        yield f"{total.precision:8.4f}{total.recall:8.4f}"
    errors = np.concatenate([np.array(row.errors) for row in rows])
    middle, most = np.percentile(errors, (50, 95)) if len(errors) else (np.nan, np.nan)
    yield f"{middle:8.3f}{most:8.3f}"
    yield f"{sum(row.ends_found for row in rows) / max(sum(row.ends for row in rows), 1):9.4f}"
    # The box that nine of ten sheets have: single failures are in the list of the worst.
    yield f"{np.percentile([row.box_error for row in rows], 90, method='lower'):8.2f}"
    yield f"{sum(row.views_named for row in rows) / sum(row.views for row in rows):7.3f}"
    yield f"{np.mean([row.projection for row in rows]):7.3f}"
    yield f"{np.mean([row.projection_possible for row in rows]):7.3f}"
    yield f"{np.median([row.seconds for row in rows]):7.2f}"


def print_worst(results: Sequence[Result], count: int) -> None:
    """The sheets whose lines, names or projection are worst."""
    print(f"\nworst {count} sheets")
    for row in sorted(results, key=lambda row: (row.score, row.projection))[:count]:
        print(
            f"{row.part + ' ' + row.style:36} visible {row.visible.precision:.3f}/"
            f"{row.visible.recall:.3f} hidden {row.hidden.precision:.3f}/{row.hidden.recall:.3f} "
            f"ends {row.ends_found}/{row.ends} box {row.box_error:.1f} "
            f"views {row.views_named}/{row.views} "
            f"projection {'right' if row.projection else 'wrong'} {row.failure}"
        )


def read_folder(options: argparse.Namespace) -> None:
    """Read other material and say what was found.

    There is no truth to compare with, but vector files are read twice: the lines that their picture
    gives are matched with those that the file has.
    """
    compared = []
    for path in sorted(options.data.rglob("*")):
        if path.suffix.lower() not in FILES:
            continue
        started = time.perf_counter()
        try:
            found = read(path, _reading(options))
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
            compared.append(as_a_picture(path, found, _reading(options)))
        if options.keep is not None:
            options.keep.mkdir(parents=True, exist_ok=True)
            image = np.repeat(read_sheet(path).grey[..., None], 3, axis=2)
            write_image(drawn_over(image, found, Marks()), options.keep / f"{path.stem}-read.png")
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


def as_a_picture(path: Path, direct: Found, reading: ReadingOptions) -> Compared:
    """Read a vector sheet again, as a picture, and match its lines with those of the file."""
    count = len(direct.strokes)
    try:
        found = read(path, reading, direct=False)
    except GaussianCadError as error:
        print(f"{'':32}as a picture: {error.code}")
        return Compared(count, direct.direct_views, failed=True)
    drawn = list(chain.from_iterable(direct.strokes.values()))
    seen = list(chain.from_iterable(found.strokes.values()))
    matched, errors, _ = match(drawn, seen, covered=1.0)
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


def main() -> None:
    """Print the table, or what was read of other material."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--parts", type=int, default=len(SAMPLES), help="samples first, then chance"
    )
    parser.add_argument("--only", nargs="*", default=[], metavar="PART")
    parser.add_argument("--styles", nargs="*", default=STYLES, metavar="STYLE")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="folder for misread sheets and their pictures")
    parser.add_argument("--keep-below", type=float, default=0.97)
    parser.add_argument("--worst", type=int, default=12)
    parser.add_argument("--json", type=Path, help="file for the figures of every sheet")
    parser.add_argument("--finder", choices=[finder.value for finder in Finder], default="ridges")
    parser.add_argument("--median", type=int, choices=(0, 3, 5, 7), default=MEDIAN_KERNEL)
    parser.add_argument("--data", type=Path, help="folder of other sheets, read without a truth")
    options = parser.parse_args()
    cv2.setNumThreads(1)
    if options.data is not None:
        read_folder(options)
        return
    results: list[Result] = []
    for done in _mapped(list(jobs_of(options)), options.jobs):
        results += done
        worst = min(done, key=lambda row: row.score)
        print(f"{done[0].part:24} worst {worst.style} {worst.score:.3f}", file=sys.stderr)
    print_table(results)
    print_worst(results, options.worst)
    if options.json is not None:
        rows = [{**asdict(row), "errors": None, "score": row.score} for row in results]
        options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")


def _mapped(jobs: list[Job], workers: int) -> Iterator[list[Result]]:
    if workers == 1:
        yield from map(run, jobs)
        return
    start = partial(ProcessPoolExecutor, mp_context=get_context("spawn"))
    with start(workers) as pool:
        yield from pool.map(run, jobs)


if __name__ == "__main__":
    main()

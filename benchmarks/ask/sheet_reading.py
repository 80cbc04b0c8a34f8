"""How exactly are sheets read: strokes, ends, boxes, roles and projection?

Parts (the samples and parts by chance) are drawn in every style, with roles and projection changing
from part to part, written to files, and read with nothing told.

Precision and recall are shares of length: a point of a stroke counts where a stroke of the same
linetype passes within 1 px in the same direction.  Hidden lines under the ink of visible ones do
not count.  The position error is the distance of matched points across the true stroke.  ``ends``
is the share of true strokes' ends with a vertex of the views on their shared axes within 1 px,
``vertices`` the same of those ends whose place the drawing shows: strokes meet there at 12 degrees
at least, and no other vertex or parallel stroke is within 4 px.  ``box px`` is the largest error of
a corner in nine of ten sheets.  ``views`` is the share of views with their right names, ``proj``
of sheets with the right projection, ``or`` of those where it was at least kept as an alternative.

The styles ``foreign`` and ``foreign-dimensioned`` are sheets as other programs draw them.
"""

import argparse
import json
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field
from functools import partial
from itertools import chain
from multiprocessing import get_context
from pathlib import Path

import cv2
import numpy as np

from benchmarks.judge.reading_found import Found, drawn_over, read
from benchmarks.judge.stroke_matching import (
    Marks,
    Matched,
    corners_of,
    ends_of,
    match,
    nearness,
    overlap,
    total,
)
from benchmarks.run.arguments import tell
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.styled_sheets import FOREIGN, STYLES, Drawn, Job, drawn_in, jobs_of, style_of
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import Sheet
from gaussiancad_core.errors import GaussianCadError, UsageError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.samples import SAMPLES
from gaussiancad_core.sheet.reading_options import MEDIAN_KERNEL, Finder

MINUTES = 20


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
    vertices: int = 0
    vertices_found: int = 0
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
    sheet: Sheet, covered: float, found: Found, about: tuple[str, str, float]
) -> tuple[Result, "Marks"]:
    """A sheet's figures, and what to mark on its picture.

    Hidden lines within ``covered`` px of a visible one's centre line do not show.
    """
    drawn = [stroke for view in sheet.views for stroke in view.strokes]
    seen = list(chain.from_iterable(found.strokes.values()))
    matched, errors, marks = match(drawn, seen, covered)
    ends, corners = ends_of(drawn, covered), corners_of(drawn, covered)
    near = nearness(corners, found.vertices)
    marks.missed.append(corners[~near])
    right = [role for role in sheet_roles(sheet) if role in found.boxes]
    named = [role for role in right if overlap(sheet[role].box, found.boxes[role]) > 0.5]
    result = Result(
        *about,
        matched[Linetype.VISIBLE],
        matched[Linetype.HIDDEN],
        tuple(errors.tolist()),
        len(ends),
        int(nearness(ends, found.vertices).sum()),
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


def read_in_styles(job: Job) -> list[Result]:
    """Draw and read a part in all styles."""
    lines, projection = job.lines()
    results = []
    for text in job.styles:
        drawn = drawn_in(lines, projection, text, job)
        sheet, suffix = drawn.sheet, "png" if drawn.quality >= 95 else "jpg"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{job.name}-{text.replace(',', '-').replace('=', '')}.{suffix}"
            write_image(sheet.image, path, drawn.quality, sheet.dpi)
            result, marks, found = _read_and_compare(path, drawn, job, text)
            results.append(result)
            if job.keep is not None and (result.failure or result.score < job.keep_below):
                job.keep.mkdir(parents=True, exist_ok=True)
                (job.keep / path.name).write_bytes(path.read_bytes())
                picture = drawn_over(sheet.image, found, marks)
                write_image(picture, job.keep / f"{path.stem}-read.png")
    return results


def _read_and_compare(
    path: Path, drawn: Drawn, job: Job, text: str
) -> tuple[Result, Marks, Found | None]:
    names, sheet, covered = (job.name, text), drawn.sheet, drawn.covered
    started = time.perf_counter()
    try:
        found = read(path, job.reading)
    except GaussianCadError as error:
        strokes = [stroke for view in sheet.views for stroke in view.strokes]
        lost, _, _ = match(strokes, [], covered)
        result = Result(
            *names,
            time.perf_counter() - started,
            lost[Linetype.VISIBLE],
            lost[Linetype.HIDDEN],
            ends=len(ends_of(strokes, covered)),
            vertices=len(corners_of(strokes, covered)),
            box_error=float("inf"),
            views=len(sheet.views),
            failure=error.code,
        )
        return result, Marks(), None
    result, marks = compare(sheet, covered, found, (*names, time.perf_counter() - started))
    return result, marks, found


def print_table(results: Sequence[Result]) -> None:
    """A row for each style and one for all."""
    styles = defaultdict(list)
    for result in results:
        styles[result.style].append(result)
    width = max(map(len, styles)) + 2
    print(
        f"{'style':{width}}{'sheets':>7}{'failed':>7}{'vis P':>8}{'vis R':>8}{'hid P':>8}"
        f"{'hid R':>8}{'med px':>8}{'95% px':>8}{'vertices':>9}{'ends':>8}{'box px':>8}{'views':>7}"
        f"{'proj':>7}{'or':>7}{'s':>7}"
    )
    for style, rows in (*styles.items(), ("all", results)):
        print(f"{style:{width}}" + "".join(_cells(rows)))


def _cells(rows: Sequence[Result]) -> Iterator[str]:
    yield f"{len(rows):7}{sum(bool(row.failure) for row in rows):7}"
    for kind in ("visible", "hidden"):
        lengths = total([getattr(row, kind) for row in rows])
        yield f"{lengths.precision:8.4f}{lengths.recall:8.4f}"
    errors = np.concatenate([np.array(row.errors) for row in rows])
    middle, most = np.percentile(errors, (50, 95)) if len(errors) else (np.nan, np.nan)
    yield f"{middle:8.3f}{most:8.3f}"
    for name, width in (("vertices", 9), ("ends", 8)):
        asked = sum(getattr(row, name) for row in rows)
        found = sum(getattr(row, f"{name}_found") for row in rows)
        yield f"{found / max(asked, 1):{width}.4f}"
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
            f"vertices {row.vertices_found}/{row.vertices} "
            f"ends {row.ends_found}/{row.ends} box {row.box_error:.1f} "
            f"views {row.views_named}/{row.views} "
            f"projection {'right' if row.projection else 'wrong'} {row.failure}"
        )


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument(
        "--parts", type=int, default=len(SAMPLES), help="samples first, then chance"
    )
    parser.add_argument("--skip", type=int, default=0, help="how many of them to leave out first")
    parser.add_argument("--only", nargs="*", default=[], metavar="PART")
    parser.add_argument("--styles", nargs="*", default=STYLES, metavar="STYLE")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="folder for misread sheets and their pictures")
    parser.add_argument("--keep-below", type=float, default=0.97)
    parser.add_argument("--worst", type=int, default=12)
    parser.add_argument("--json", type=Path, help="file for the figures of every sheet")
    parser.add_argument("--finder", choices=[finder.value for finder in Finder], default="ridges")
    parser.add_argument("--median", type=int, choices=(0, 3, 5, 7), default=MEDIAN_KERNEL)


def run(options: argparse.Namespace) -> Outcome:
    """Draw and read; print the table."""
    try:
        for text in options.styles:
            style_of(text)
    except GaussianCadError as error:
        raise UsageError("unknown-style", f"{error}, {' or '.join(FOREIGN)}") from error
    cv2.setNumThreads(1)
    results: list[Result] = []
    for done in _mapped(list(jobs_of(options)), options.workers):
        results += done
        worst = min(done, key=lambda row: row.score)
        tell(f"{done[0].part:24} worst {worst.style} {worst.score:.3f}")
    print_table(results)
    print_worst(results, options.worst)
    if options.json is not None:
        rows = [{**asdict(row), "errors": None, "score": row.score} for row in results]
        options.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    figures = (
        Figure(f"{kind} {name}", round(getattr(lengths, name), 3))
        for kind in ("visible", "hidden")
        for lengths in [total([getattr(row, kind) for row in results])]
        for name in ("precision", "recall")
    )
    return Outcome(tuple(figures))


def _mapped(jobs: list[Job], workers: int) -> Iterator[list[Result]]:
    if workers == 1:
        yield from map(read_in_styles, jobs)
        return
    start = partial(ProcessPoolExecutor, mp_context=get_context("spawn"))
    with start(workers) as pool:
        yield from pool.map(read_in_styles, jobs)

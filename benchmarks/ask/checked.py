"""Does ``check`` tell a right model from a wrong one, and does the judge hold to the truth?

Each sheet is read once. Its true part, and the same part with one thing wrong (a hole filled, moved
by 2 mm, drilled where none is; a face moved by a tenth of its way; a block put on; 3 % longer;
mirrored), are judged against the reading, in any position. With ``--made DIR``, the folder that
``published --keep`` or ``foreign --keep`` filled, so is the solid that a run made.

DIR has SOURCE/NAME.pdf, .png, .jpg or .dxf beside SOURCE/NAME.step. The table counts, by source:
sheets that were read; verdicts on the true part (agrees, differs, cannot tell); wrong parts and the
verdicts on them (differs, agrees, cannot tell); ``dearer``: wrong parts that explain less of the
sheet than the truth; ``held``: sheets on which the truth explains no less than what was made, of
those with both. Seconds are of the processor, of one check after the reading, median and 95th
percentile.

Whose fault a part is that came out wrong: the reader's where the truth leaves more than a fiftieth
of the lines unexplained, the judge's where the truth explains less than what was made, else the
search's. Exit code 0.
"""

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from benchmarks.parts.wrong_parts import KINDS
from benchmarks.run.arguments import add_data, add_running, is_chosen
from benchmarks.run.outcome import Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.sheets.published import sheets_of
from benchmarks.tasks.checked_work import MADE, TRUTH, Task, worked

MINUTES = 40

COLUMNS = ("sheets", "read", "truth agrees", "differs", "cannot", "wrong", "differ", "agree")
COLUMNS += ("cannot", "dearer", "made", "held", "s", "p95")

_MARGIN = 1e-3
"""Share of the lines by which one model has to explain more than another."""

_READ = 0.02
"""Share of the lines that the truth leaves unexplained at most where a sheet was read rightly."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_data(parser)
    add_running(parser, limit_s=200.0)
    parser.add_argument("--made", type=Path, metavar="DIR", help="with the solids of a run")


def run(options: argparse.Namespace) -> Outcome:
    """Check the models; print the table."""
    tasks = [
        Task(sheet, _made(options.made, sheet), options.limit)
        for sheet in sheets_of(options.data)
        if is_chosen(sheet, options.only)
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    sources = dict.fromkeys(row["source"] for row in rows)
    groups = [(source, [row for row in rows if row["source"] == source]) for source in sources]
    cells = as_cells([_counted(*group) for group in (*groups, ("all", rows))])
    print("\n".join([as_table(("", *COLUMNS), cells), "", *_by_kind(rows), *_faults(rows)]))
    truths, wrong = [_verdict(row, TRUTH) for row in rows], [v for row in rows for v in _wrong(row)]
    figures = (
        share("true parts agree", truths.count("agrees"), len(rows)),
        share("true parts differ", truths.count("differs"), len(rows)),
        share("wrong parts differ", wrong.count("differs"), len(wrong)),
        share("wrong parts agree", wrong.count("agrees"), len(wrong)),
        share("wrong parts explain less than the truth", *_dearer(rows)),
        share("the truth explains no less than what was made", *_held(rows)),
    )
    return Outcome(figures, False, ("", *COLUMNS), cells)


def _made(folder: Path | None, sheet: Path) -> Path | None:
    if folder is None:
        return None
    solid = folder / sheet.parent.name / sheet.stem / "solid.step"
    return solid if solid.is_file() else None


def in_words(row: Row) -> str:
    """A row in some words."""
    wrong = Counter(_wrong(row))
    stated = ", ".join(f"{count} {verdict}" for verdict, count in wrong.most_common())
    return f"{row['source']}/{row['name']}: truth {_verdict(row, TRUTH)}; wrong: {stated}"


def _verdict(row: Row, model: str) -> str:
    return str(row.get("models", {}).get(model, {}).get("verdict", "cannot-tell"))


def _wrong(row: Row) -> list[str]:
    return [_verdict(row, kind) for kind in KINDS if kind in row.get("models", {})]


def _costs(row: Row, models: Sequence[str]) -> Iterator[float]:
    """What models leave unexplained; infinite where their extents fit in no pose."""
    for model in models:
        if model in row.get("models", {}):
            value = row["models"][model]["share"]
            yield np.inf if value is None else float(value)


def _dearer(rows: Sequence[Row]) -> tuple[int, int]:
    """Wrong parts that leave more unexplained than the truth, and all on sheets that were read."""
    pairs = [
        (truth, wrong)
        for row in rows
        for truth in _costs(row, [TRUTH])
        for wrong in _costs(row, KINDS)
        if np.isfinite(truth)
    ]
    return sum(wrong > truth + _MARGIN for truth, wrong in pairs), len(pairs)


def _held(rows: Sequence[Row]) -> tuple[int, int]:
    """Sheets on which the truth leaves no more unexplained than what was made, and all of them."""
    pairs = [
        (truth, made)
        for row in rows
        for truth in _costs(row, [TRUTH])
        for made in _costs(row, [MADE])
    ]
    return sum(truth <= made + _MARGIN for truth, made in pairs), len(pairs)


def _counted(name: str, rows: Sequence[Row]) -> tuple[object, ...]:
    truths, wrong = Counter(_verdict(row, TRUTH) for row in rows), Counter[str]()
    for row in rows:
        wrong.update(_wrong(row))
    seconds = [model["seconds"] for row in rows for model in row.get("models", {}).values()]
    dearer, compared = _dearer(rows)
    held, made = _held(rows)
    median, late = np.percentile(seconds, [50, 95]) if seconds else (0.0, 0.0)
    return (
        name,
        len(rows),
        sum(bool(row.get("read")) for row in rows),
        truths["agrees"],
        truths["differs"],
        truths["cannot-tell"],
        wrong.total(),
        wrong["differs"],
        wrong["agrees"],
        wrong["cannot-tell"],
        f"{dearer}/{compared}",
        made,
        held,
        f"{median:.2f}",
        f"{late:.1f}",
    )


def _by_kind(rows: Sequence[Row]) -> Iterator[str]:
    for kind in KINDS:
        found = Counter(_verdict(row, kind) for row in rows if kind in row.get("models", {}))
        yield f"{kind}: " + ", ".join(f"{count} {name}" for name, count in found.most_common())


def _faults(rows: Sequence[Row]) -> Iterator[str]:
    """Whose fault the solids are that differ from the truth in the judge's eyes."""
    found: Counter[str] = Counter()
    for row in rows:
        for truth in _costs(row, [TRUTH]):
            for made in _costs(row, [MADE]):
                if truth > _READ:
                    found["reader"] += 1
                elif truth > made + _MARGIN:
                    found["judge"] += 1
                elif made > truth + _MARGIN:
                    found["search"] += 1
                else:
                    found["none"] += 1
    if found:
        yield "whose fault: " + ", ".join(f"{name} {count}" for name, count in found.most_common())

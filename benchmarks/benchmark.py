"""The tables of the GaussianCAD paper on material that ships with this project, or on any other.

Parts are drawn on sheets (clean, scanned, and with ends too long or too short in five strengths)
and made into models by five methods; all are measured against the parts' solids under the protocols
``gaussiancad``, ``deepcad`` and ``engineering``.  Then come ablations: median kernel and Hough
transforms, distance of the cameras, wrong masks.  One HTML page has all tables, charts, pictures.

    .venv/bin/python benchmarks/benchmark.py [--output DIR] [--workers N] [--limit S] [--quick]
    .venv/bin/python benchmarks/benchmark.py --data DIR [--projection first|third]

The paper's recipe is scaled down: preset ``draft`` has 2,000 Gaussians at the start, images of
240 px and 300 iterations, where the paper has 1920 px and 10,000.  Exact solid and default surface
are one run of ``gaussiancad reconstruct``, which takes longer than either; the longest extent is
told.  Plain hull and sweep-and-cut are made of the same reading of the sheet.

``--data`` takes a folder of STEP files; where a sheet of the same stem (PNG, JPEG, TIFF, BMP, WebP,
PDF, SVG, DXF) lies beside one, that sheet is read instead, told the longest extent, too, and the
solid is turned to fit.  No ablations are run.

Every finished task is kept in the output folder at once: a run that was stopped goes on where it
was.  Another version of the code, or another setting, is another set of results.
"""

import argparse
import os
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from benchmark_ablations import AblationTask, ablation_tasks, run_ablation
from benchmark_page import PUBLISHED, Content, benchmark_page
from benchmark_parts import (
    SAMPLE_NAMES,
    USUAL_CLASSES,
    Part,
    SheetKind,
    given_parts,
    shipped_parts,
)
from benchmark_records import Table, records_of
from benchmark_runs import SCRATCH, Effort, Run, RunTask, run_task
from benchmark_store import Store, fingerprint, rows_of, tell_on_stderr, write_atomically
from benchmark_tables import failure_table, part_table, result_tables
from benchmark_tables_ablations import ablation_tables
from workers import Row, Work

from gaussiancad_core.model.axes import Projection
from gaussiancad_core.modes import Preset
from gaussiancad_core.processes.library_behaviour import prepare_environment, silence_opencascade
from gaussiancad_core.samples.classed import PartClass

_PICTURED = (SheetKind.CLEAN, SheetKind.ENDS_3, SheetKind.GIVEN)
_QUICK_KINDS = (SheetKind.CLEAN, SheetKind.ENDS_2)

Task = RunTask | AblationTask


@dataclass(frozen=True)
class Plan:
    """What is to be done.

    Attributes:
        tasks: all of them.
        folder: of finished tasks, and of what they need.
        workers: child processes.
        settings: what was asked for, by name.
    """

    tasks: tuple[Task, ...]
    folder: Path
    workers: int
    settings: dict[str, str]


def work(task: Task) -> Iterator[Row]:
    """What becomes known of a task: what a child does."""
    return run_task(task) if isinstance(task, RunTask) else run_ablation(task)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what is asked for; write the page and print the tables."""
    options = parser().parse_args(arguments)
    prepare_environment()
    silence_opencascade()
    plan = plan_of(options)
    if not plan.tasks:
        print(f"{options.data} holds no STEP files: name a folder of parts", file=sys.stderr)
        return 2
    try:
        rows = carry_out(plan, work, tell_on_stderr)
    except KeyboardInterrupt:
        print("\nstopped: the same command goes on from here", file=sys.stderr)
        return 130
    content = content_of(plan, rows)
    page = options.output / "benchmark.html"
    write_atomically(page, benchmark_page(content))
    for table in (PUBLISHED, *content.tables, *content.ablations):
        print(f"{table.as_text()}\n")
    print(f"All of this with charts and pictures: {page}")
    return 0


def carry_out(plan: Plan, job: Work, tell: Callable[[str], None]) -> list[Row]:
    """The rows of all tasks in the order of the plan; what was finished before is not done again.

    Args:
        plan: what is to be done.
        job: what a child does with a task.
        tell: takes text about the progress.
    """
    plan.folder.mkdir(parents=True, exist_ok=True)
    store = Store(plan.folder / "tasks")
    try:
        rows = rows_of(plan.tasks, store, job, plan.workers, tell)
        found = {task.name: row for task, row in rows}
    finally:
        # Processes that were ended at their limit could not tidy up.
        shutil.rmtree(plan.folder / SCRATCH, ignore_errors=True)
    return [found[task.name] for task in plan.tasks]


def plan_of(options: argparse.Namespace) -> Plan:
    """What the options ask for."""
    effort = Effort(options.limit, options.points, options.preset, options.seed)
    settings = {
        **{name: str(getattr(value, "value", value)) for name, value in asdict(effort).items()},
        "quick": str(options.quick),
    }
    code = fingerprint(repr(sorted(settings.items())))
    folder = options.output / code
    folder.mkdir(parents=True, exist_ok=True)
    parts = _parts(options, folder)
    tasks: list[Task] = []
    for part in parts:
        kinds = [kind for kind in part.kinds if not options.quick or kind in _QUICK_KINDS]
        for kind in kinds or part.kinds:
            for run in Run:
                pictured = kind in _PICTURED
                tasks.append(RunTask(part, kind, run, effort, folder, pictured))
    if options.data is None:
        tasks += ablation_tasks(options.limit, quick=options.quick)
    told = {
        "parts": ", ".join(part.case.name for part in parts),
        "sheets": ", ".join(
            dict.fromkeys(task.kind.value for task in tasks if isinstance(task, RunTask))
        ),
        "points a side": f"{effort.points}",
        "seed": f"{effort.seed} of training and samples; noise has each part's own",
        "preset": f"{effort.preset.value} of the default surface, draft of the paper's recipe",
        "limit": f"{effort.limit:g} s to make the models of one run",
        "workers": f"{options.workers}, one thread each",
        "code and settings": code,
    }
    return Plan(tuple(tasks), folder, options.workers, told)


def _parts(options: argparse.Namespace, folder: Path) -> tuple[Part, ...]:
    if options.data is not None:
        parts = tuple(given_parts(options.data, options.projection))
        return parts[:2] if options.quick else parts
    if options.quick:
        few = [PartClass.PLANES]
        return tuple(shipped_parts(SAMPLE_NAMES[:1], few, 1, options.seed, folder))
    classes = [PartClass(name) for name in options.classes]
    return tuple(shipped_parts(SAMPLE_NAMES, classes, options.parts, options.seed, folder))


def content_of(plan: Plan, rows: Sequence[Row]) -> Content:
    """The tables of the rows."""
    records = records_of(row for row in rows if "run" in row)
    ablations: list[Table] = []
    if any(isinstance(task, AblationTask) for task in plan.tasks):
        ablations += ablation_tables([row for row in rows if "ablation" in row])
    sheets = dict.fromkeys(record.input for record in records)
    tables = [
        *result_tables(records),
        failure_table(records),
        *(part_table(records, sheet) for sheet in sheets),
    ]
    return Content(plan.settings, tables, ablations, records)


def parser() -> argparse.ArgumentParser:
    """The options."""
    found = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    found.add_argument("--output", type=Path, default=Path("build/benchmark"))
    found.add_argument("--data", type=Path, help="folder of STEP files, or of sheets beside them")
    found.add_argument(
        "--projection",
        type=Projection,
        default=Projection.THIRD,
        choices=list(Projection),
        metavar="first|third",
        help="of the sheets beside STEP files",
    )
    found.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    found.add_argument(
        "--limit", type=float, default=Effort.limit, help="s for the models of a run"
    )
    found.add_argument("--points", type=int, default=Effort.points, help="surface points a side")
    found.add_argument(
        "--preset",
        type=Preset,
        default=Effort.preset,
        choices=list(Preset),
        metavar="draft|standard|fine",
        help="of the default surface",
    )
    found.add_argument(
        "--classes",
        nargs="*",
        default=[kind.value for kind in USUAL_CLASSES],
        choices=[kind.value for kind in PartClass],
        metavar="NAME",
        help="of parts by chance beside the samples",
    )
    found.add_argument("--parts", type=int, default=1, help="of each class")
    found.add_argument("--seed", type=int, default=0)
    found.add_argument("--quick", action="store_true", help="two parts, two sheets, few settings")
    return found


if __name__ == "__main__":
    # Many tasks side by side: threads of one would only slow down the others.
    for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    sys.exit(main())

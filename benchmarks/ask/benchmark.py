"""How do five methods compare on many sheets, and what does each of their settings do?

Parts are drawn on sheets (clean, scanned, and with ends too long or too short in five strengths)
and made into models by five methods; all are measured against the parts' solids under the protocols
``gaussiancad``, ``deepcad`` and ``engineering``.  Then come ablations: median kernel and Hough
transforms, distance of the cameras, wrong masks.  One HTML page has all tables, charts, pictures.

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
import hashlib
import os
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import benchmarks
import gaussiancad_core
from benchmarks.methods.benchmark_ablations import AblationTask, ablation_tasks, run_ablation
from benchmarks.methods.benchmark_page import PUBLISHED, Content, benchmark_page
from benchmarks.methods.benchmark_records import Table, records_of
from benchmarks.methods.benchmark_runs import SCRATCH, Effort, Method, Run, RunTask, run_task
from benchmarks.methods.benchmark_tables import failure_table, part_table, result_tables
from benchmarks.methods.benchmark_tables_ablations import ablation_tables
from benchmarks.run.arguments import existing_folder, tell
from benchmarks.run.outcome import Figure, Outcome, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row, Work
from benchmarks.sheets.benchmark_parts import (
    SAMPLE_NAMES,
    USUAL_CLASSES,
    Part,
    SheetKind,
    given_parts,
    shipped_parts,
)
from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.library_behaviour import prepare_environment, silence_opencascade
from gaussiancad_core.samples.classed import PartClass
from gaussiancad_protocol.modes import Preset

MINUTES = 27

_PICTURED = (SheetKind.CLEAN, SheetKind.ENDS_3, SheetKind.GIVEN)
_QUICK_KINDS = (SheetKind.CLEAN, SheetKind.ENDS_2)
_SHOWN = ("benchmark_page", "benchmark_tables", "benchmark_records", "figures_page")

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


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--output", type=Path, default=Path("build/benchmark"))
    parser.add_argument(
        "--data",
        type=existing_folder,
        metavar="DIR",
        help="folder of STEP files, or of sheets beside them",
    )
    parser.add_argument(
        "--projection",
        type=Projection,
        default=Projection.THIRD,
        choices=list(Projection),
        metavar="first|third",
        help="of the sheets beside STEP files",
    )
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument(
        "--limit", type=float, default=Effort.limit, help="s for the models of a run"
    )
    parser.add_argument("--points", type=int, default=Effort.points, help="surface points a side")
    parser.add_argument(
        "--preset",
        type=Preset,
        default=Effort.preset,
        choices=list(Preset),
        metavar="draft|standard|fine",
        help="of the default surface",
    )
    parser.add_argument(
        "--classes",
        nargs="*",
        default=[kind.value for kind in USUAL_CLASSES],
        choices=[kind.value for kind in PartClass],
        metavar="NAME",
        help="of parts by chance beside the samples",
    )
    parser.add_argument("--parts", type=int, default=1, help="of each class")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--quick", action="store_true", help="two parts, two sheets, few settings")


def run(options: argparse.Namespace) -> Outcome:
    """Run what is asked for; write the page and print the tables."""
    prepare_environment()
    silence_opencascade()
    plan = plan_of(options)
    if not plan.tasks:
        message = f"{options.data} holds no STEP files: name a folder of parts"
        raise UsageError("no-parts", message)
    rows = carry_out(plan, work)
    content = content_of(plan, rows)
    page = options.output / "benchmark.html"
    page.write_bytes(benchmark_page(content))
    for table in (PUBLISHED, *content.tables, *content.ablations):
        print(f"{table.as_text()}\n")
    print(f"All of this with charts and pictures: {page}")
    models = [record for record in content.records if record.method is Method.SOLID]
    figures = (
        share("exact solids", sum(bool(model.entry.get("exact")) for model in models), len(models)),
        Figure("falsely verified", sum(model.falsely_verified for model in models)),
    )
    return Outcome(figures)


def carry_out(plan: Plan, job: Work, say: Callable[[str], None] = tell) -> list[Row]:
    """The rows of all tasks in the order of the plan; what was finished before is not done again.

    Args:
        plan: what is to be done.
        job: what a child does with a task.
        say: takes lines about the progress.
    """
    running = Running(plan.workers, plan.folder / "rows.jsonl", resume=True)
    try:
        return rows_of(plan.tasks, job, running, lambda row: row.get("failure", "done"), say)
    finally:
        # Processes that were ended at their limit could not tidy up.
        shutil.rmtree(plan.folder / SCRATCH, ignore_errors=True)


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
    stated = {
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
    return Plan(tuple(tasks), folder, options.workers, stated)


def fingerprint(settings: str) -> str:
    """Of the code that makes and measures, and of what it was asked for: others are other rows."""
    digest = hashlib.sha256(settings.encode("utf-8"))
    for folder in (Path(gaussiancad_core.__file__).parent, Path(benchmarks.__file__).parent):
        for path in sorted(folder.rglob("*.py")):
            # How results are shown does not change them.
            if not path.name.startswith(_SHOWN):
                digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


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

"""One part, one kind of drawing: draw, solve, measure; in a process that can be ended."""

import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median

from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import (
    EXACT_IOU,
    closeness,
    mirrored_alike,
    solid_iou,
)
from benchmarks.parts.exact_cases import Case
from benchmarks.run.outcome import Figure, share
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.exact_inputs import InputKind, make_input
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_protocol.modes import Status

CLOSE_IOU = 0.98
"""From here on a solid with the right number of faces is the truth but for its measures."""

_PREPARING_S = 400.0
"""s for drawing and reading a sheet."""

_MEASURING_S = 120.0
"""s for Booleans with the truth."""


@dataclass(frozen=True)
class Task:
    """What a process gets.

    Attributes:
        case: the part.
        kind: of its drawing.
        cache: folder of lines that were drawn.
        limit: s of wall clock for the solver.
    """

    case: Case
    kind: InputKind
    cache: Path
    limit: float

    @property
    def name(self) -> tuple[str, str, str]:
        """What tells it from other tasks."""
        return self.case.group, self.case.name, self.kind.value

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return dict(zip(("group", "name", "input"), self.name, strict=True))

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _PREPARING_S, SOLVE: self.limit, "measure": _MEASURING_S}


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a task, bit by bit; each bit tells the stage that comes next."""
    truth = task.case.truth()
    yield {"true_faces": len(faces_of(truth))}
    drawing = make_input(task.case, truth, task.kind, task.cache)
    strokes = sum(len(drawn) for drawn in drawing.views.strokes.values())
    yield {"strokes": strokes, "source": drawing.source}
    yield {"stage": SOLVE}
    started, processor = time.perf_counter(), time.process_time()
    result = drawing.solved()
    spent = {
        "seconds": time.perf_counter() - started,
        "processor": time.process_time() - processor,
    }
    yield {**_told(result), **spent, "stage": "measure"}
    yield from _measured(result, truth)


def _told(result: ExactResult) -> Row:
    return {
        "status": result.status.value,
        "reasons": [code for code, _ in result.reasons],
        "message": result.reasons[0][1] if result.reasons else "",
        "laps": {name: round(value, 3) for name, value in result.seconds.items()},
        "alternatives": len(result.alternatives),
    }


def _measured(result: ExactResult, truth: TopoDS_Shape) -> Iterator[Row]:
    if result.shape is None:
        return
    close = closeness(result.shape, truth)
    yield {**asdict(close), "exact": close.exact}
    if close.exact:
        return
    row: Row = {"mirrored": mirrored_alike(result.shape, truth)}
    others = (solid_iou(other, truth) for other in result.alternatives)
    row["in_alternatives"] = any((iou or 0.0) >= EXACT_IOU for iou in others)
    yield row


def solved(row: Row) -> bool:
    """Whether a row counts: valid, and the truth."""
    return bool(row.get("exact"))


def close(row: Row) -> bool:
    """Whether a row counts but for its measures: as many faces as the truth, nearly its volume."""
    alike = row.get("valid") and row["faces"] == row["true_faces"]
    return solved(row) or bool(alike and row["iou"] >= CLOSE_IOU)


def falsely_verified(row: Row) -> bool:
    """Whether a solid was called verified that is not the truth."""
    return row.get("status") == Status.VERIFIED.value and not solved(row)


def causes(row: Row) -> list[str]:
    """Why a row is not the truth, in codes."""
    if solved(row):
        return []
    if "failure" in row:
        return [row["failure"]]
    found = list(row.get("reasons", [])) or ["verified-but-wrong"]
    if row.get("mirrored"):
        found.append("mirrored")
    return found


def in_words(row: Row) -> str:
    """A row in a line, for whoever waits."""
    verdict = "exact" if solved(row) else ", ".join(causes(row))
    status = ", ".join([row.get("status", ""), *(row["reasons"] if solved(row) else ())])
    iou = f" IoU {row['iou']:.4f}" if "iou" in row else ""
    return (
        f"{row['name']} {row['input']}: {verdict} ({status}){iou} "
        f"faces {row.get('faces', '-')}/{row.get('true_faces', '-')} "
        f"{row.get('seconds', float('nan')):.2f} s"
    )


def counted(rows: Sequence[Row]) -> tuple[Figure, ...]:
    """The headline figures: exact, verified, falsely verified, seconds."""
    total, seconds = len(rows), [row["seconds"] for row in rows if "seconds" in row]
    verified = sum(row.get("status") == Status.VERIFIED.value for row in rows)
    figures = (
        share("exact", sum(map(solved, rows)), total),
        share("verified", verified, total),
        Figure("falsely verified", sum(map(falsely_verified, rows))),
    )
    return (*figures, Figure("median", round(median(seconds), 2), "s")) if seconds else figures

"""The figures of ``benchmark`` in tables: by protocol, by verdict, and of ablations."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import partial

from benchmarks.methods.benchmark_records import NONE, Record, Table, cell, median
from benchmarks.methods.benchmark_runs import Method
from gaussiancad_core.comparison.deepcad import DeepCadResult, summarise_deepcad
from gaussiancad_core.comparison.distances import IouMethod, VolumeIou
from gaussiancad_protocol.modes import Status

_PAPER = ("chamfer", "hausdorff", "emd")


def result_tables(records: Sequence[Record]) -> Iterator[Table]:
    """By sheet and method: the three protocols, and what was said of the results."""
    yield _by_method(
        "Protocol gaussiancad",
        "Medians over the parts with a model; box of 5, registered. Floor: two samples of the "
        "truth; equal models have about as much. p2s is the distance to the exact surface.",
        ("models", "CD", "HD", "EMD", "p2s", "floor CD", "floor HD", "floor EMD"),
        records,
        _paper_cells,
    )
    yield _by_method(
        "Protocol deepcad",
        "Unit cube, squared distances times 1000, nothing registered. Over the valid models; "
        "invalid counts those that are missing, too.",
        ("models", "mean CD", "median CD", "median floor", "mean IoU", "invalid %"),
        records,
        _deepcad_cells,
    )
    yield _by_method(
        "Protocol engineering",
        "Medians over the parts with a model, nothing scaled. Agree: share of the surface within "
        "1/1000 of the longest edge with normals within 20 degrees, the worse way. Volume and "
        "area: sizes of the differences.",
        ("models", "agree %", "mean mm", "rms mm", "farthest mm", "volume %", "area %", "IoU"),
        records,
        _engineering_cells,
    )
    yield _by_method(
        "Verdicts and times",
        "Exact: closed, with a volume IoU of .999 at least; solids in place and valid, too. False: "
        "called verified and not exact. Surfaces, hulls and swept outlines are never called more "
        "than approximate. Seconds of the clock with all workers busy.",
        ("verified", "approximate", "failed", "exact", "false", "median s", "most s"),
        records,
        _verdict_cells,
    )


def part_table(records: Sequence[Record], sheet: str) -> Table:
    """Every part by itself: the distance to the truth's surface and the verdict."""
    of_sheet = [record for record in records if record.input == sheet]
    parts = list(dict.fromkeys(record.part for record in of_sheet))
    cells = {(record.part, record.method): _short(record) for record in of_sheet}
    rows = tuple((part, *(cells.get((part, method), NONE) for method in Method)) for part in parts)
    return Table(
        f"Each part, sheet: {sheet}",
        "p2s and volume IoU, each model scaled to the box of 5; v: verified, e: exact unscaled.",
        ("part", *(method.value for method in Method)),
        rows,
    )


def failure_table(records: Sequence[Record]) -> Table:
    """Why there is no model, counted."""
    counts = Counter(
        (record.input, record.method.value, record.failure or "not measured")
        for record in records
        if not record.entry.get("comparison")
    )
    rows = tuple((*names, str(count)) for names, count in sorted(counts.items()))
    note = "What is named over-time was ended at its limit; no-model: the method found none."
    return Table("No model, or not measured", note, ("sheet", "method", "why", "parts"), rows)


def _by_method(
    title: str,
    note: str,
    head: tuple[str, ...],
    records: Sequence[Record],
    cells: Callable[[Sequence[Record]], tuple[str, ...]],
) -> Table:
    rows = []
    for sheet in dict.fromkeys(record.input for record in records):
        for method in Method:
            rs = [r for r in records if r.input == sheet and r.method is method]
            if rs:
                rows.append((sheet, method.value, *cells(rs)))
    return Table(title, note, ("sheet", "method", *head), tuple(rows))


def _count(records: Sequence[Record]) -> str:
    return f"{sum('comparison' in record.entry for record in records)}/{len(records)}"


def _paper_cells(records: Sequence[Record]) -> tuple[str, ...]:
    paths = [(name,) for name in (*_PAPER, "point_to_surface")]
    paths += [("floor", name) for name in _PAPER]
    return _count(records), *(cell(median(r.figure(*path) for r in records)) for path in paths)


def _deepcad_cells(records: Sequence[Record]) -> tuple[str, ...]:
    summary = summarise_deepcad([_deepcad_of(record) for record in records])
    floor = median(r.figure("protocols", "deepcad", "floor", "chamfer_x1000") for r in records)
    values = (summary.mean_x1000, summary.median_x1000, floor, summary.mean_iou)
    return _count(records), *map(cell, values), f"{100.0 * summary.invalid_ratio:.0f}"


def _deepcad_of(record: Record) -> DeepCadResult | None:
    comparison = record.entry.get("comparison")
    if comparison is None:
        return None
    found = comparison["protocols"]["deepcad"]
    return DeepCadResult(
        found["chamfer_x1000"],
        found["floor"]["chamfer_x1000"],
        VolumeIou(found["volume_iou"], IouMethod(found["volume_iou_method"])),
        found["invalid_reason"],
        found["points"],
        found["seed"],
    )


def _engineering_cells(records: Sequence[Record]) -> tuple[str, ...]:
    figure = partial(_engineering, records)
    both = [
        median(max(values, default=None) for values in figure(name))
        for name in ("mean_absolute_mm", "rms_mm")
    ]
    farthest = median(
        max((abs(value) for value in values), default=None)
        for values in map(_joined, zip(figure("least_mm"), figure("greatest_mm"), strict=True))
    )
    differences = [
        median(
            None if value is None else 100.0 * abs(value)
            for value in (r.figure("protocols", "engineering", name) for r in records)
        )
        for name in ("volume_difference_share", "area_difference_share")
    ]
    agreement = median(r.figure("protocols", "engineering", "agreement") for r in records)
    iou = median(r.figure("protocols", "engineering", "volume_iou") for r in records)
    share = None if agreement is None else 100.0 * agreement
    return (
        _count(records),
        cell(share, 1),
        *map(cell, (*both, farthest)),
        *(cell(value, 2) for value in differences),
        cell(iou),
    )


def _joined(pair: tuple[list[float], list[float]]) -> list[float]:
    return pair[0] + pair[1]


def _engineering(records: Sequence[Record], name: str) -> list[list[float]]:
    """Both ways' number of each record; none where there is no model."""
    ways = ("result_to_reference", "reference_to_result")
    figures = [[r.figure("protocols", "engineering", way, name) for way in ways] for r in records]
    return [[value for value in pair if value is not None] for pair in figures]


def _verdict_cells(records: Sequence[Record]) -> tuple[str, ...]:
    statuses = Counter(record.status for record in records)
    seconds = [record.entry["seconds"] for record in records if "seconds" in record.entry]
    exact = sum(bool(record.entry.get("exact")) for record in records)
    false = sum(record.falsely_verified for record in records)
    counts = (*(statuses[status.value] for status in Status), exact, false)
    return (
        *map(str, counts),
        cell(median(seconds), 1),
        cell(max(seconds, default=None), 1),
    )


def _short(record: Record) -> str:
    if "comparison" not in record.entry:
        return record.failure or NONE
    marks = "v" * (record.status == Status.VERIFIED.value) + "e" * bool(record.entry.get("exact"))
    p2s, iou = record.figure("point_to_surface"), record.figure("volume_iou")
    return f"{cell(p2s)} {cell(iou, 3)} {marks}".rstrip()

"""The ablations of ``benchmark`` in tables."""

from collections.abc import Iterator, Sequence

from benchmarks.methods.benchmark_ablations import PARALLEL, Ablation
from benchmarks.methods.benchmark_records import NONE, Table, cell
from benchmarks.run.workers import Row

_KINDS = ("visible", "hidden")


def ablation_tables(rows: Sequence[Row]) -> Iterator[Table]:
    """The ablations, each as far as it was run."""
    of = {each: [row for row in rows if row["ablation"] == each.value] for each in Ablation}
    readings = of[Ablation.READING]
    head = ("finder, kernel", *(f"{s} {k}" for s in ("clean", "noisy") for k in _KINDS))
    yield Table(
        "Ablation: median kernel and Hough transforms",
        f"Precision/recall of the lines of {_part(readings)}; noisy: thin lines and short dashes "
        "on a bad scan. The paper's way is hough 3.",
        head,
        tuple((row["setting"], *_reading_cells(row)) for row in readings),
    )
    distances = of[Ablation.DISTANCE]
    yield Table(
        "Ablation: camera distance",
        f"{_part(distances)}, the paper's recipe at 240 px and {_said(distances, 'iterations')} "
        "iterations. Size: longest edge of the result, the paper's units; shape: its distance from "
        "the truth, both in a box of 5; lens: the same with a longer lens at each distance, so "
        "that the part keeps its size; parallel: with orthographic cameras.",
        ("distance", "size", "shape", "lens", "parallel"),
        tuple((row["setting"], *_distance_cells(row)) for row in distances),
    )
    masks = of[Ablation.MASKS]
    names = list(dict.fromkeys(name for row in masks for name in row.get("figures", {})))
    yield Table(
        "Ablation: masks",
        f"{_part(masks)}, masks disturbed, preset {_said(masks, 'preset')}. p2s in a box of 5 / "
        "what the surface's shadows and the masks do not share. Free: no anchor, faster positions.",
        ("masks", *names),
        tuple((row["setting"], *_mask_cells(row, names)) for row in masks),
    )


def _part(rows: Sequence[Row]) -> str:
    return rows[0]["part"] if rows else "no part"


def _said(rows: Sequence[Row], key: str) -> str:
    return str(rows[0][key]) if rows else NONE


def _reading_cells(row: Row) -> tuple[str, ...]:
    if "figures" not in row:
        return (row.get("failure", NONE),) * 4
    return tuple(
        found["failure"] or f"{found[kind]['precision']:.3f}/{found[kind]['recall']:.3f}"
        for found in row["figures"].values()
        for kind in _KINDS
    )


def _distance_cells(row: Row) -> tuple[str, ...]:
    figures = row.get("figures", {})
    if not figures:
        return (row.get("failure", NONE),) * 4
    return tuple(cell(figures.get(name)) for name in ("size", "shape", "lens", PARALLEL))


def _mask_cells(row: Row, names: Sequence[str]) -> tuple[str, ...]:
    figures = row.get("figures", {})
    missing = row.get("failure", NONE)
    return tuple(
        f"{figures[name][0]:.4f} / {figures[name][1]:.4f}" if name in figures else missing
        for name in names
    )

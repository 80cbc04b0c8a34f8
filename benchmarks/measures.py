"""How well the measures of solids are known, and whether that is what is said of them.

Small parts whose measures are hundredths of a millimetre, textbook parts with such measures, and
parts of the classes with round ones are drawn as pictures, with and without dimensions, and as
scans; each face of the solid that comes out is put beside the part, and each of the part's faces
beside the solid.

    .venv/bin/python benchmarks/measures.py [--groups NAME ...] [--inputs KIND ...] [--parts N]
        [--workers N] [--json FILE] [--resume] [--csv FILE]

Counted are solids of the right shape: as many faces as the part, none of them farther than two
pixels from where it belongs.  ``within`` is the share of their faces, of all together, that lie
within ``uncertainty_mm``, and should be 95 % at least; ``least`` the share of the solid for which
it is the smallest.  ``bound`` is that uncertainty, in px, in the median; ``faces`` what 95 % of all
faces keep, ``needed`` the same as a share of their solid's bound: far below 1 where bounds are
needlessly wide.  Exit code 1 if less than 95 % of the faces of a row lie within their bounds.
"""

import argparse
import csv
import os
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np
from exact_inputs import InputKind
from measures_work import Group, Task, worked
from resumable import resumed
from textbook_work import FAMILIES as TEXTBOOK
from twin_parts import FAMILIES as TWINS
from workers import Row

from gaussiancad_core.samples.classed import PartClass

INPUTS = (
    InputKind.FOREIGN,
    InputKind.FOREIGN_DIMENSIONED,
    InputKind.CLEAN,
    InputKind.SCAN,
    InputKind.DIMENSIONED,
)

_RIGHT_PX = 2.0
"""px that a face is displaced by at most if it is the one that was drawn."""

_ASKED = 0.95

_FEWEST = 100
"""Faces from which a row can be wrong."""

_LINE = "{:10} {:20} {:>7} {:>6} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8}"
_HEAD = _LINE.format(
    "", "", "sheets", "right", "faces", "95 % px", "bound px", "within", "least", "needed"
)


def main() -> int:
    """Run what is asked for; print the table."""
    options = _parser().parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    tasks = list(_tasks(options))
    rows: list[Row] = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        _tell(row, len(rows), len(tasks))
    if options.csv is not None:
        write_csv(rows, options.csv)
    print(table(rows))
    return 1 if any(_is_wrong(own) for _, own in _grouped(rows)) else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    groups, kinds = [own.value for own in Group], [own.value for own in INPUTS]
    parser.add_argument("--groups", nargs="*", default=groups, choices=groups, metavar="NAME")
    parser.add_argument("--inputs", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--parts", type=int, default=2, help="of each family or class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds for each sheet")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a sheet")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    parser.add_argument("--csv", type=Path, help="file for a row a sheet, lengths in px")
    return parser


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    families = {
        Group.TWINS: tuple(TWINS),
        Group.TEXTBOOK: tuple(TEXTBOOK),
        Group.CLASSED: tuple(own.value for own in PartClass),
    }
    for seed in range(options.seed, options.seed + options.parts):
        for group in map(Group, options.groups):
            for family in families[group]:
                for kind in options.inputs:
                    yield Task(group, family, seed, InputKind(kind), options.limit)


def is_right(row: Row) -> bool:
    """Whether a solid has the shape that was drawn, whatever its measures are."""
    if not row.get("displaced") or row["faces"] != row["true_faces"]:
        return False
    return bool(row["valid"]) and row["farthest"] <= _RIGHT_PX * row["px_mm"]


def table(rows: Iterable[Row]) -> str:
    """A line for each group of parts and kind of sheet, then for each kind of sheet, then for all;
    and by where the measures are from."""
    lines = [_HEAD]
    lines += [_line(name, own) for name, own in _grouped(list(rows))]
    return "\n".join(lines)


def _grouped(rows: list[Row]) -> Iterator[tuple[tuple[str, str], list[Row]]]:
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        found.setdefault((row["group"], row["input"]), []).append(row)
    for row in rows:
        found.setdefault(("all", row["input"]), []).append(row)
    for row in rows:
        if "measures_source" in row:
            found.setdefault(("all", f"by {row['measures_source']}"), []).append(row)
    found["all", ""] = rows
    yield from found.items()


def _within(rows: Iterable[Row]) -> np.ndarray:
    """(n,) displacements of all faces of right solids as shares of their bounds."""
    told = [row for row in rows if is_right(row) and row.get("uncertainty_mm")]
    shares = [np.array(row["displaced"]) / row["uncertainty_mm"] for row in told]
    return np.concatenate([np.zeros(0), *shares])


def _is_wrong(rows: list[Row]) -> bool:
    shares = _within(rows)
    return len(shares) >= _FEWEST and float((shares <= 1.0).mean()) < _ASKED


def _line(name: tuple[str, str], rows: list[Row]) -> str:
    right = [row for row in rows if is_right(row)]
    faces = [np.array(row["displaced"]) / row["px_mm"] for row in right]
    shares = _within(rows)
    told = [row for row in right if row.get("uncertainty_mm")]
    each = [float((np.array(r["displaced"]) <= r["uncertainty_mm"]).mean()) for r in told]
    bounds = [row["uncertainty_mm"] / row["px_mm"] for row in told]
    count = sum(map(len, faces))
    return _LINE.format(
        *name,
        len(rows),
        len(right),
        count,
        f"{np.quantile(np.concatenate(faces), _ASKED):.3f}" if count else "",
        f"{np.median(bounds):.3f}" if told else "",
        f"{100.0 * (shares <= 1.0).mean():.1f} %" if told else "",
        f"{100.0 * min(each):.0f} %" if told else "",
        f"{np.quantile(shares, _ASKED):.2f}" if told else "",
    )


_PLAIN = (
    *("group", "family", "seed", "input", "px_mm", "noise", "rounding", "rounding_step"),
    *("spread", "misfit", "apart", "status", "reasons", "explains", "neat"),
    *("numbers", "digit", "places", "beside", "nominal", "step_mm", "step_moved", "step_reach"),
    *("odd", "unread", "likely_step_mm", "likely_moved", "likely_odd"),
    *("residual_x", "residual_y", "residual_z", "iou", "faces", "true_faces"),
    *("uncertainty_mm", "measures_source", "failure"),
)


def write_csv(rows: Iterable[Row], path: Path) -> None:
    """A row a sheet; lengths in px but where the name says mm."""
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow([*_PLAIN, "right", "d50", "d90", "d95", "d100"])
        for row in rows:
            plain = [_text(row.get(name, "")) for name in _PLAIN]
            faces = np.array(row.get("displaced") or ()) / row.get("px_mm", 1.0)
            shares = [f"{np.quantile(faces, q):.4f}" if len(faces) else "" for q in _SHARES]
            writer.writerow([*plain, is_right(row), *shares])


_SHARES = (0.5, 0.9, 0.95, 1.0)


def _text(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.5g}"
    if isinstance(value, list | tuple):
        return " ".join(_text(own) for own in value)
    return str(value)


def _tell(row: Row, number: int, total: int) -> None:
    """A line about a sheet, for who waits."""
    what = row.get("failure") or ", ".join([row.get("status", ""), *row.get("reasons", ())])
    faces = np.array(row.get("displaced") or ()) / row.get("px_mm", 1.0)
    off = f", faces off by up to {np.quantile(faces, _ASKED):.3f} px" if len(faces) else ""
    name = f"{row['family']}-{row['seed']} {row['input']}"
    print(f"{number}/{total} {name}: {what}{off}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())

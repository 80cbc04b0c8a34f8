"""Which stages of making strokes of a view are needed, and for what?

Sheets are drawn (as by sheet_reading.py, textbook_parts.py and exact_solid.py) or published (as by
real_pictures.py), and read once, with what the strokes of each view were made of kept in DIR.  Then
the strokes are made again with each stage of ``classify_strokes`` left out: what changes strokes
gives them back as it got them, what finds strokes finds none, a question is answered with no.
``--off`` leaves out several at once, and may be given again.

For each, the table tells on how many views it did anything and on how many strokes differ, and by
set the change, in thousandths, of precision and recall of visible and hidden lines and of the share
of corners that were found, from those of all stages.
"""

import argparse
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import cv2

from benchmarks.judge.stroke_matching import total
from benchmarks.run.arguments import existing_folder, tell
from benchmarks.run.checkout import commit
from benchmarks.run.outcome import Outcome, share
from benchmarks.sheets.stage_cases import Case, Figures, kept_cases
from benchmarks.sheets.styled_sheets import STYLES
from benchmarks.tasks.textbook_work import FAMILIES
from gaussiancad_core.sheet.reading_options import MEDIAN_KERNEL, Finder
from gaussiancad_core.sheet.tracing import ink_strokes

MINUTES = 30

Neutral = Callable[..., Any]
"""What a stage's arguments become without it."""


def _given(index: int) -> Neutral:
    return lambda *arguments: list(arguments[index])


def _none(*_arguments: object) -> list[Any]:
    return []


def _no(*_arguments: object) -> bool:
    return False


_CHANGES = (
    "without_shadows", "ended_where_lines_touch", "ended_before_slants", "_refitted",
    "with_fitted_slants", "with_close_fits", "parted_at_corners",
    "with_short_legs", "with_corners_reached", "with_bows", "with_ends_behind_edges",
    "with_met_ends", "with_changes_at_junctions",
)  # fmt: skip
_FINDS = (
    "find_remaining_dashes", "find_corner_dashes", "find_jogs", "find_rungs", "find_slanted_rungs",
    "find_fillets", "find_hidden_fillets", "find_short_strokes",
    "trace_remainder",
)  # fmt: skip
_ASKS = (
    "is_next_dash", "joins_arcs", "has_square_corner", "is_closed_by_others",
)  # fmt: skip

STAGES: dict[str, Neutral] = {
    **dict.fromkeys(_CHANGES, _given(0)),
    **dict.fromkeys(_FINDS, _none),
    **dict.fromkeys(_ASKS, _no),
    "own_runs": _given(1),
    "run_odds": lambda _sheet, _shape, runs, _pens: [(run, 0.0) for run in runs],
    "with_nearby_dashes": _given(2),
    "labelled_linetypes": lambda _shape, runs, *_: [odds for _, odds in runs],
    "with_dashes_led_to": _given(3),
    "bridged": _given(2),
    "_closed": _given(1),
    "up_to_tangents": lambda _shape, piece, *_: piece,
    "with_chamfers": _given(1),
}
"""Of the module ``strokes``, with what each gives where it is left out."""


class Switches:
    """The stages, some of which are off.

    Attributes:
        off: names of those.
        fired: names of the others that did anything.
    """

    def __init__(self) -> None:
        self.off: frozenset[str] = frozenset()
        self.fired: set[str] = set()

    @contextmanager
    def wired(self) -> Iterator[None]:
        """Stages obey while this lasts."""
        kept = {name: getattr(ink_strokes, name) for name in STAGES}
        for name, function in kept.items():
            setattr(ink_strokes, name, self._switched(name, function))
        try:
            yield
        finally:
            for name, function in kept.items():
                setattr(ink_strokes, name, function)

    def _switched(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def stage(*arguments: object) -> object:
            neutral = STAGES[name](*arguments)
            if name in self.off:
                return neutral
            result = function(*arguments)
            if result != neutral:
                self.fired.add(name)
            return result

        return stage


@dataclass(frozen=True)
class Change:
    """What a sheet is without some stages.

    Attributes:
        group: of the sheet.
        name: of the sheet.
        off: the stages, joined by spaces; empty for the sheet with all.
        fired: views on which one of them does anything.
        differ: views whose strokes differ.
        figures: of the sheet.
    """

    group: str
    name: str
    off: str
    fired: int
    differ: int
    figures: Figures


def changes(case: Case, groups: Sequence[Sequence[str]], switches: Switches) -> Iterator[Change]:
    """A sheet with all stages, and without each group of them."""
    whole, fired = [], []
    switches.off = frozenset()
    for shapes in case.shapes:
        switches.fired = set()
        whole.append(ink_strokes.classify_strokes(*shapes))
        fired.append(switches.fired)
    base = case.figures(tuple(whole))
    yield Change(case.group, case.name, "", 0, 0, base)
    for group in groups:
        switches.off = frozenset(group)
        # What did nothing changes nothing where it is left out.
        hit = [not switches.off.isdisjoint(item) for item in fired]
        made = [
            ink_strokes.classify_strokes(*shapes) if on else item
            for shapes, item, on in zip(case.shapes, whole, hit, strict=True)
        ]
        differ = sum(one != other for one, other in zip(made, whole, strict=True))
        figures = case.figures(tuple(made)) if differ else base
        yield Change(case.group, case.name, " ".join(group), sum(hit), differ, figures)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--cases", type=Path, required=True, metavar="DIR")
    parser.add_argument("--parts", type=int, default=0, help="drawn ones")
    parser.add_argument("--skip", type=int, default=0, help="how many of them to leave out first")
    parser.add_argument("--only", nargs="*", default=[], metavar="PART")
    parser.add_argument("--styles", nargs="*", default=STYLES, metavar="STYLE")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--families", nargs="*", default=[], choices=[*FAMILIES], metavar="NAME")
    parser.add_argument("--classed", type=int, default=0, help="parts of each class of exact_solid")
    parser.add_argument("--data", type=existing_folder, help="published sheets, SOURCE/NAME.pdf")
    parser.add_argument("--sheets", nargs="*", default=[""], help="parts of their paths")
    parser.add_argument("--off", nargs="+", action="append", choices=[*STAGES], metavar="STAGE")
    parser.add_argument("--groups-only", action="store_true", help="not each stage alone")
    parser.add_argument("--json", type=Path, help="file for the figures of every sheet")
    parser.set_defaults(keep=None, keep_below=0.0, median=MEDIAN_KERNEL, finder=Finder.RIDGES.value)


def run(options: argparse.Namespace) -> Outcome:
    """Read what is not kept yet; leave stages out; print the table."""
    cv2.setNumThreads(1)
    alone = [] if options.groups_only else [(name,) for name in STAGES]
    groups = [*alone, *(options.off or ())]
    switches, rows = Switches(), []
    for number, case in enumerate(kept_cases(options), start=1):
        with switches.wired():
            rows += changes(case, groups, switches)
        tell(f"{number} {case.group} {case.name}")
        if options.json is not None:
            found = {"commit": commit(), "rows": [asdict(row) for row in rows]}
            options.json.write_text(json.dumps(found), encoding="utf-8")
    print("\n".join(table(rows)))
    needed = {row.off for row in rows if row.off and row.differ}
    return Outcome((share("stages that change a view", len(needed), len(groups)),))


def table(rows: Sequence[Change]) -> list[str]:
    """The figures of each set with all stages, then the changes without."""
    sets = list(dict.fromkeys(row.group for row in rows))
    base = {this_set: _shares(_of(rows, this_set, "")) for this_set in sets}
    lines = [
        f"{this_set}: {len(_of(rows, this_set, ''))} sheets " + _told(base[this_set], "{:.4f}")
        for this_set in sets
    ]
    lines.append(
        f"{'without':28} fired differ  " + "  ".join(f"{this_set:>37}" for this_set in sets)
    )
    for off in dict.fromkeys(row.off for row in rows if row.off):
        every = [row for row in rows if row.off == off]
        cells = []
        for item in sets:
            shares = _shares(_of(rows, item, off))
            change = [1e3 * (new - old) for new, old in zip(shares, base[item], strict=True)]
            cells.append(_told(change, "{:+7.2f}"))
        counts = f"{sum(row.fired for row in every):5} {sum(row.differ for row in every):6}"
        lines.append(f"{off:28} {counts}  " + "  ".join(cells))
    return lines


def _of(rows: Sequence[Change], group: str, off: str) -> list[Figures]:
    return [row.figures for row in rows if (row.group, row.off) == (group, off)]


def _shares(figures: Sequence[Figures]) -> list[float]:
    """Precision and recall of visible and hidden lines, share of corners that were found."""
    visible, hidden = (
        total([getattr(figure, kind) for figure in figures]) for kind in ("visible", "hidden")
    )
    corners = sum(figure.corners_found for figure in figures) / max(
        sum(figure.corners for figure in figures), 1
    )
    return [visible.precision, visible.recall, hidden.precision, hidden.recall, corners]


def _told(values: Sequence[float], form: str) -> str:
    return " ".join(form.format(value) for value in values)

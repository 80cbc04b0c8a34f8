"""docs/figures.md, written from the recorded results alone."""

import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from benchmarks.run.catalogue import Entry, entries
from benchmarks.run.checkout import ROOT
from benchmarks.run.results import RESULTS, Result, results_of

PAGE = ROOT / "docs" / "figures.md"

CHAPTERS: Mapping[str, tuple[str, ...]] = {
    "Drawings of other people": ("published", "foreign", "pictures", "checked", "faultless"),
    "Generated drawings": ("exact_solid", "practice", "verified", "measures", "features"),
    "Surfaces": ("surface",),
    "Seconds and memory": ("seconds",),
}
"""The benchmarks in the page's order; those that are in none come last."""

_WHOLE = re.compile(r"`[^`]*`|\[[^\]]*\]\([^)]*\)")
_GLUE = "\N{NO-BREAK SPACE}"

_WIDTH = 130
"""Characters of a line, as in the other pages."""

_HEAD = (
    "Every figure here was recorded by a command of this repository, with the options and at the "
    "commit that stand beside it. `DIR` is a folder of other people's drawings, which the "
    "repository does not have. Absolute times are those of two cores that drift; compare figures "
    "of one run only.",
    "`python -m benchmarks --list` has the questions.",
)

_WRITTEN = "<!-- `python -m benchmarks --write-figures` writes this from benchmarks/results. -->"


def figures_page(folder: Path = RESULTS) -> str:
    """The page of the results in a folder."""
    known = {entry.name: entry for entry in entries()}
    placed = {name for names in CHAPTERS.values() for name in names}
    chapters = {**CHAPTERS, "Others": tuple(name for name in known if name not in placed)}
    parts = ["\n\n".join(["# Figures", _WRITTEN, *map(_wrapped, _HEAD)]) + "\n"]
    for title, names in chapters.items():
        sections = [
            _section(known[name], found) for name in names if (found := results_of(name, folder))
        ]
        parts += [f"## {title}\n", *sections] if sections else []
    return "\n".join(parts)


def _section(entry: Entry, results: tuple[Result, ...]) -> str:
    method = f"{entry.method} (`python -m benchmarks {entry.name}`)"
    paragraphs = [f"### {_markdown(entry.question)}", _wrapped(_markdown(method))]
    for result in results:
        paragraphs += _result(result)
    return "\n\n".join(paragraphs) + "\n"


def _result(result: Result) -> Iterator[str]:
    """What was measured, by which options and when; the figures; what qualifies them."""
    options = f"`{result.options}`" if result.options else ""
    run = "; ".join(filter(None, (options, f"{result.commit}, {result.date}", result.machine)))
    figures = "; ".join(map(str, result.figures))
    parts = [f"**{result.about}** ({run}){f': {figures}' if figures else ''}."]
    table = map(_row, (result.head, ["---"] * len(result.head), *result.rows))
    if result.head:
        yield from (_wrapped(parts[0]), "\n".join(table))
    parts = [result.limits] if result.head else [*parts, result.limits]
    yield from map(_wrapped, filter(None, [" ".join(parts).strip()]))


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _markdown(text: str) -> str:
    return text.replace("``", "`")


def _wrapped(text: str) -> str:
    """Lines of a paragraph; code and links stay in one line."""
    whole = _WHOLE.sub(lambda found: found[0].replace(" ", _GLUE), text)
    lines = textwrap.fill(whole, _WIDTH, break_long_words=False, break_on_hyphens=False)
    return lines.replace(_GLUE, " ")

"""A comparison's numbers as a table for spreadsheets."""

import csv
import io
from collections.abc import Iterator

from freecad.gaussiancad.engine.report import Comparison


def comparison_csv(comparison: Comparison) -> str:
    """Every number of a report, a line each: its place in ``comparison.json``, and its value."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\r\n")
    writer.writerow(("measure", "value"))
    writer.writerows(_leaves(comparison.values, ""))
    return stream.getvalue()


def _leaves(value: object, place: str) -> Iterator[tuple[str, object]]:
    if isinstance(value, dict):
        for key, entry in value.items():
            yield from _leaves(entry, f"{place}.{key}" if place else str(key))
    elif isinstance(value, list):
        for number, entry in enumerate(value):
            yield from _leaves(entry, f"{place}.{number}")
    else:
        yield place, "" if value is None else value

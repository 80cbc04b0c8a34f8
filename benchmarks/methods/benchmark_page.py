"""The page of ``benchmark``: one HTML file that needs nothing beside itself."""

import base64
import os
import platform
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from pathlib import Path

import numpy as np
import psutil

from benchmarks.methods.benchmark_records import NONE, Record, Table, medians
from benchmarks.methods.benchmark_runs import Method
from benchmarks.run.charts import Chart, Series, write_chart
from benchmarks.sheets.benchmark_parts import SheetKind
from gaussiancad_core import __version__
from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions

_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"

_PARTS_SHOWN = 3
"""Parts with pictures of their models."""

_STYLE = """
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(30rem, 100%), 1fr));
  gap: 1rem; }
.gallery { display: grid; grid-template-columns: repeat(5, minmax(0, 1fr)); gap: 1rem; }
@media (max-width: 44rem) { .gallery { grid-template-columns: repeat(2, minmax(0, 1fr)); } }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
td { font-variant-numeric: tabular-nums; white-space: nowrap; padding-right: 1.4rem; }
th { white-space: nowrap; padding-right: 1.4rem; }
.facts td + td { white-space: normal; overflow-wrap: anywhere; }
tr.first td { border-top: 2px solid #8a949e; }
"""

PUBLISHED = Table(
    "Published: the GaussianCAD paper, 2,981 sheets of Sub-Fusion360",
    "Comparable with the table below: the definitions of CD and HD, the box of 5, the "
    "registration. Not comparable: the parts, and the number of points, which the paper does not "
    "give.",
    ("", "CD", "HD", "EMD"),
    (
        ("vanilla GaussianObject", "1.359", "2.375", "1.017"),
        ("Photo2CAD", "1.011", "1.652", "0.849"),
        ("GaussianCAD", "0.307", "0.589", "0.353"),
    ),
)


@dataclass(frozen=True)
class Content:
    """What the page shows.

    Attributes:
        settings: what was asked for, by name.
        tables: of the results.
        ablations: their tables.
        records: for charts and pictures.
    """

    settings: Mapping[str, str]
    tables: Sequence[Table]
    ablations: Sequence[Table]
    records: Sequence[Record]


def benchmark_page(content: Content) -> bytes:
    """The page, UTF-8."""
    style = files("gaussiancad_core.comparison").joinpath("assets/page.css").read_text("utf-8")
    body = "\n".join(_body(content))
    text = (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>GaussianCAD benchmark</title>\n<style>{style}{_STYLE}</style></head>\n"
        f"<body>\n{body}\n</body></html>\n"
    )
    return text.encode("utf-8")


def machine_facts() -> dict[str, str]:
    """Machine and versions, by name."""
    memory = psutil.virtual_memory().total / 2**30
    return {
        "machine": f"{_processor()}, {os.cpu_count()} cores, {memory:.0f} GiB",
        "system": platform.platform(),
        "engine": __version__,
        "Python": platform.python_version(),
        "packages": ", ".join(
            f"{name} {version}" for name, version in installed_versions(ENGINE_PACKAGES).items()
        ),
    }


def _processor() -> str:
    known = Path("/proc/cpuinfo")
    if known.is_file():
        for line in known.read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def _body(content: Content) -> Iterator[str]:
    yield "<h1>GaussianCAD benchmark</h1>"
    facts = Table("Run", "", ("", ""), tuple((content.settings | machine_facts()).items()))
    yield f'<div class="facts">{_table_html(facts)}</div>'
    for table in (PUBLISHED, *content.tables):
        yield _table_html(table)
    charts = list(_charts(content.records))
    if charts:
        yield "<h2>Ends too long or too short</h2>"
        yield (
            '<p class="note">Every end of every line that has one lies too far out or too far in, '
            "by up to so many 1/600 of the longest extent, but at most an eighth of the line. "
            "Medians over the parts that have a model; where some have none the dot is a ring, and "
            "what is left may be the plainest ones.</p>"
        )
        yield '<div class="charts">'
        yield "".join(f"<figure>{chart}</figure>" for chart in charts)
        yield "</div>"
    pictures = list(_pictures(content.records))
    if pictures:
        yield "<h2>Models, coloured by their deviation</h2>"
        yield (
            '<p class="note">Red lies outside of the truth, blue inside, each full where it is so '
            "many mm as the number below says.</p>"
        )
        yield from pictures
    yield from map(_table_html, content.ablations)


def _table_html(table: Table) -> str:
    numbers = [all(_is_number(row[k]) for row in table.rows) for k in range(len(table.head))]
    kinds = [' class="number"' if number else "" for number in numbers]
    head = "".join(
        f"<th{kind}>{escape(name)}</th>" for kind, name in zip(kinds, table.head, strict=True)
    )
    grouped = len({row[0] for row in table.rows}) < len(table.rows)
    lines = []
    before = None
    for row in table.rows:
        # The rows of one sheet belong together.
        first = ' class="first"' if before is not None and row[0] not in (before, "") else ""
        cells = "".join(
            f"<td{kind}>{escape(text)}</td>" for kind, text in zip(kinds, row, strict=True)
        )
        lines.append(f"<tr{first if grouped else ''}>{cells}</tr>")
        before = row[0]
    note = f'<p class="note">{escape(table.note)}</p>' if table.note else ""
    head = f"<thead><tr>{head}</tr></thead>" if any(table.head) else ""
    empty = '<p class="note">None.</p>' if not table.rows else ""
    return (
        f"<h2>{escape(table.title)}</h2>{note}\n"
        f'<div class="wide"><table>{head}<tbody>{"".join(lines)}</tbody></table></div>{empty}'
    )


def _is_number(text: str) -> bool:
    """Whether a cell is a number, a count of several, or nothing."""
    return text == NONE or text.replace(".", "").replace("/", "").isdigit()


def _charts(records: Sequence[Record]) -> Iterator[str]:
    """Measures over the strength by which ends are wrong."""
    present = {record.input for record in records}
    kinds = [SheetKind.CLEAN, *(kind for kind in SheetKind if kind.wrong_px is not None)]
    sheets = [kind for kind in kinds if kind.value in present]
    if len(sheets) < 2:
        return
    ticks = [f"{kind.wrong_px or 0:g} px" for kind in sheets]
    names = [kind.value for kind in sheets]
    for title, path in (
        ("median CD, box of 5", ("chamfer",)),
        ("median distance to the exact surface, box of 5", ("point_to_surface",)),
        ("median volume IoU", ("volume_iou",)),
    ):
        lines = [
            Series(
                item.value,
                medians(records, names, item, *path),
                [_some_missing(records, name, item) for name in names],
            )
            for item in Method
        ]
        lines = [line for line in lines if np.isfinite(line.values).any()]
        if lines:
            yield _chart_html(Chart(title, ticks, lines))
    shares = [
        Series(item.value, [_exact_share(records, name, item) for name in names]) for item in Method
    ]
    yield _chart_html(Chart("share of all parts whose model is exact", ticks, shares))


def _exact_share(records: Sequence[Record], sheet: str, method: Method) -> float:
    rs = [r for r in records if r.input == sheet and r.method is method]
    return sum(bool(r.entry.get("exact")) for r in rs) / len(rs) if rs else float("nan")


def _some_missing(records: Sequence[Record], sheet: str, method: Method) -> bool:
    rs = [r for r in records if r.input == sheet and r.method is method]
    return any(not r.entry.get("comparison") for r in rs)


def _chart_html(chart: Chart) -> str:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "chart.png"
        write_chart(chart, path)
        content = base64.b64encode(path.read_bytes()).decode("ascii")
    return f'<img alt="{escape(chart.title)}" src="data:image/png;base64,{content}">'


def _pictures(records: Sequence[Record]) -> Iterator[str]:
    """A row of models for each sheet of the first few parts."""
    shown = [record for record in records if "picture" in record.entry]
    parts = list(dict.fromkeys(record.part for record in shown))[:_PARTS_SHOWN]
    order = {method: number for number, method in enumerate(Method)}
    for part in parts:
        for sheet in dict.fromkeys(record.input for record in shown if record.part == part):
            this_records = [
                record for record in shown if (record.part, record.input) == (part, sheet)
            ]
            yield f"<h3>{escape(part)}, {escape(sheet)}</h3>"
            yield '<div class="gallery">'
            for record in sorted(this_records, key=lambda each: order[each.method]):
                name = escape(f"{record.method.value}, {record.entry['range_mm']:.3g} mm")
                picture = f"data:image/jpeg;base64,{record.entry['picture']}"
                image = f'<img alt="{escape(part)}, {escape(sheet)}: {name}" src="{picture}">'
                yield f"<figure>{image}<figcaption>{name}</figcaption></figure>"
            yield "</div>"

"""``index.html``: the sheets of a batch with their pictures, for a browser without a network."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from gaussiancad_core.batches.batch_table import BatchRow
from gaussiancad_core.report.html_pages import html_page
from gaussiancad_protocol.modes import Status

PAGE_FILE = "index.html"

_PICTURES = ("preview.png", "overlay.png")


def page_bytes(rows: Sequence[BatchRow]) -> bytes:
    """The page, UTF-8.

    Args:
        rows: of the batch; their pictures are beside the page, in the folders of their names.
    """
    counts = Counter(row.status for row in rows)
    return html_page(
        __package__,
        "batch.html",
        lines=[_line(row) for row in rows],
        counts={status.value: counts[status.value] for status in Status},
        seconds=sum(row.seconds for row in rows),
    )


def _line(row: BatchRow) -> dict[str, Any]:
    known = {status.value for status in Status}
    return {
        "kind": row.status if row.status in known else Status.FAILED.value,
        "folder": quote(row.name),
        "name": row.name,
        "sheet": row.sheet,
        "status": row.status,
        "message": row.message,
        "measures_mm": row.measures_mm,
        "pictures": [_picture(row, name) for name in _PICTURES],
    }


def _picture(row: BatchRow, name: str) -> str:
    """Where a picture of a row is, from the page; empty where there is none."""
    if row.exit_code or not (Path(row.folder) / name).is_file():
        return ""
    return f"{quote(row.name)}/{name}"

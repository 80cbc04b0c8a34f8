"""The checkout that a benchmark runs in."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

SAMPLES = ROOT / "resources" / "samples"
"""Folder of the sheets and solids that ship with the product."""


def commit() -> str:
    """What the checkout is at, with ``+`` where it was changed since; empty without git."""
    name, changed = (
        subprocess.run(
            ["git", *command], cwd=ROOT, capture_output=True, text=True, check=False
        ).stdout.strip()
        for command in (("rev-parse", "--short", "HEAD"), ("status", "--porcelain", "-uno"))
    )
    return name + ("+" if changed else "")

"""``construction.json``: how the solid is put together, beside it in the output folder."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gaussiancad_core.storage.outputs import os_error

CONSTRUCTION_FILE = "construction.json"


def write_construction(construction: Mapping[str, Any], folder: Path) -> None:
    """Write :data:`CONSTRUCTION_FILE` into a folder.

    Args:
        construction: plain values.
        folder: that exists.

    Raises:
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    path = folder / CONSTRUCTION_FILE
    try:
        path.write_text(json.dumps(construction, indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise os_error(path, error) from error

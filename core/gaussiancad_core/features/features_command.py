"""Find the features of a solid in a file: what ``gaussiancad features`` does."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from OCP.TopAbs import TopAbs_ShapeEnum

from gaussiancad_core.features.as_json import FEATURES_FILE, SCHEMA, solid_values
from gaussiancad_core.features.build123d_script import SCRIPT_FILE, script_of
from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.feature_model import FeatureList
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.features.thread_notes import ThreadNote
from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.kernel.brep_files import read_solid, write_step
from gaussiancad_core.storage.outputs import REPORT_FILE, OutputFolder
from gaussiancad_core.writing.callouts import NoteKind, thread_name


def write_features(solid: Path, output: Path, *, find: bool = True) -> list[FeatureList]:
    """Write ``features.json``, ``features.py`` and the bases that features stand over.

    Args:
        solid: STEP or BREP; each solid in it has its own features.
        output: folder.
        find: whether features are looked for; else each solid is a base without any.

    Returns:
        The features of each solid.

    Raises:
        UnreadableError: the file is no solid.
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    solids = subshapes(read_solid(solid), TopAbs_ShapeEnum.TopAbs_SOLID)
    numbers = numbers_of_report(solid)
    found = [features_of(one) if find else FeatureList((), one) for one in solids]
    _write(found, numbers, output)
    return found


def numbers_of_report(solid: Path) -> Numbers:
    """The numbers of the drawing, where a run's report lies beside the solid; none elsewhere."""
    try:
        report = json.loads((solid.parent / REPORT_FILE).read_bytes())
        measures = report["measures"]
        if measures is None:
            return Numbers()
        entries = [*report["dimensions"], *report["notes"]]
        values = [entry["value_mm"] for entry in entries if entry["value_mm"] is not None]
        threads = tuple(_threads(report["notes"]))
        known = Numbers(tuple(float(value) for value in values), threads=threads)
        return replace(known, near=max(known.near, float(measures["uncertainty_mm"])))
    except (OSError, ValueError, KeyError, TypeError):
        return Numbers()


def _threads(notes: Sequence[dict[str, Any]]) -> Iterator[ThreadNote]:
    """The threads among a report's notes."""
    for note in notes:
        name = thread_name(note["text"]) if note["kind"] == NoteKind.THREAD.value else None
        if name is not None and note["value_mm"] is not None:
            depth = None if note["depth_mm"] is None else float(note["depth_mm"])
            yield ThreadNote(name, float(note["value_mm"]), int(note["count"]), depth)


def _write(found: Sequence[FeatureList], numbers: Numbers, output: Path) -> None:
    bases = [_base_name(k, features) for k, features in enumerate(found, 1)]
    owned = FEATURES_FILE, SCRIPT_FILE, *(f"base-{k}.step" for k in range(1, len(found) + 1))
    folder = OutputFolder(output, owned, FEATURES_FILE)
    try:
        for name, features in zip(bases, found, strict=True):
            if name is not None and features.base is not None:
                write_step(features.base, folder.staging / name)
        solids = [
            solid_values(feature_list, numbers, name)
            for feature_list, name in zip(found, bases, strict=True)
        ]
        values: dict[str, Any] = {"schema": SCHEMA, "solids": solids}
        text = json.dumps(values, indent=1) + "\n"
        (folder.staging / FEATURES_FILE).write_text(text, encoding="utf-8")
        (folder.staging / SCRIPT_FILE).write_text(script_of(solids), encoding="utf-8")
        folder.commit()
    except BaseException:
        folder.discard()
        raise


def _base_name(number: int, features: FeatureList) -> str | None:
    return None if features.base is None else f"base-{number}.step"

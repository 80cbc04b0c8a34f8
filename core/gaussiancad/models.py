"""Solids and meshes: compared with each other, and drawn on a sheet."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gaussiancad.engine_call import Progress, Watch, run_command
from gaussiancad.options import PathLike, options, path_of
from gaussiancad.part_result import SOLID_FILE, Result
from gaussiancad_core.errors import UnreadableError
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_MESH_FILES = ("surface.stl", "hull.stl")
"""What is compared of a result without a solid, the first that is there."""


_FEATURES_FILE = "features.json"


class Comparison(Mapping[str, Any]):
    """How far a model is from a reference; the keys are those of ``comparison.json``.

    Args:
        values: the file's content.
    """

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = MappingProxyType(dict(values))

    def __getitem__(self, name: str) -> Any:  # noqa: ANN401
        return self._values[name]

    def __iter__(self) -> Any:  # noqa: ANN401
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    @property
    def volume_iou(self) -> float | None:
        """Shared volume over the volume of both together, 0 to 1; None where one is open."""
        value = self._values.get("volume_iou")
        return None if value is None else float(value)

    @property
    def chamfer(self) -> float:
        """Chamfer distance in the protocol's normalised box."""
        return float(self._values["chamfer"])

    @property
    def hausdorff(self) -> float:
        """Hausdorff distance in the protocol's normalised box."""
        return float(self._values["hausdorff"])

    def __repr__(self) -> str:
        return f"<Comparison: volume IoU {self.volume_iou}, chamfer {self.chamfer:.4g}>"


def compare(
    result: Result | PathLike,
    reference: Result | PathLike,
    *,
    points: int | None = None,
    seed: int = 0,
    protocol: str | None = None,
    register: str | None = None,
    progress: Progress | None = None,
) -> Comparison:
    """Compare a part with a reference.

    Args:
        result: what a sheet gave, or a file: STEP, BREP, STL, PLY or OBJ.
        reference: the truth, likewise.
        points: that are sampled on each surface.
        seed: of the samples.
        protocol: ``gaussiancad``, ``deepcad``, ``engineering`` or ``all``.
        register: how the two are laid over each other: ``none``, ``axes``, ``icp``, ``global``.
        progress: called twice a second; an exception in it stops the comparison.

    Raises:
        UnreadableError: a file is missing, or no model; a result without a model.
        EngineError: the extra ``compare`` is not installed.
    """
    stated_options = options(
        points=points, seed=seed, protocol=protocol, register=register, json=True
    )
    ended = run_command(
        ["compare", model_file(result), model_file(reference), *stated_options], Watch(progress)
    )
    if ended.exit_code != ExitCode.DONE:
        raise ended.error()
    return Comparison(json.loads(ended.printed))


def draw(
    solid: Result | PathLike,
    sheet: PathLike,
    *,
    views: Sequence[str] = ("front", "top", "right"),
    projection: str = "third",
    style: str | None = None,
    tangent_edges: str | None = None,
    seed: int = 0,
) -> Path:
    """Draw a sheet of a solid.

    Args:
        solid: STEP or BREP file, or what a sheet gave.
        sheet: the picture to write, such as ``sheet.png``.
        views: roles in any order: front, top, right, left, bottom, rear.
        projection: ``third`` or ``first`` angle.
        style: a named style and its changes, as of ``gaussiancad draw --style``.
        tangent_edges: lines where faces meet smoothly: ``drawn`` as other edges, ``thin``, or
            ``left-out``; None as the style says, whose usual is ``left-out``.
        seed: of what the style leaves to chance.

    Returns:
        The path of the sheet.

    Raises:
        UnreadableError: there is no such solid.
        UsageError: an option has no such value, or the sheet cannot be written.
    """
    stated_options = options(
        views=",".join(views),
        projection=projection,
        style=style,
        tangent_edges=tangent_edges,
        seed=seed,
    )
    ended = run_command(["draw", model_file(solid), path_of(sheet), *stated_options])
    if ended.exit_code != ExitCode.DONE:
        raise ended.error()
    return Path(sheet)


def features(
    solid: Result | PathLike, output: PathLike, *, progress: Progress | None = None
) -> Mapping[str, Any]:
    """Find the sketches, pads, pockets and holes that make up a solid.

    Args:
        solid: STEP or BREP file, or what a sheet gave.
        output: folder for ``features.json`` and ``features.py``, a build123d script.
        progress: called twice a second; an exception in it stops the search.

    Returns:
        The content of ``features.json``.

    Raises:
        UnreadableError: there is no such solid.
        UsageError: the folder cannot be written.
    """
    folder = path_of(output)
    ended = run_command(["features", model_file(solid), f"--output={folder}"], Watch(progress))
    if ended.exit_code != ExitCode.DONE:
        raise ended.error()
    values = json.loads((Path(folder) / _FEATURES_FILE).read_text(encoding="utf-8"))
    return MappingProxyType(values)


def model_file(model: Result | PathLike) -> str:
    """The file of a model."""
    if not isinstance(model, Result):
        return path_of(model)
    names = (SOLID_FILE, *_MESH_FILES)
    found = next((model.folder / name for name in names if (model.folder / name).is_file()), None)
    if found is None:
        raise UnreadableError(
            Code.NO_MODEL_FILE,
            "the result has no model: its status is {status}",
            status=model.status,
        )
    return str(found)

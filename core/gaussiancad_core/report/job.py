"""What a ``reconstruct`` run is asked to do."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from gaussiancad_core.files.file_opening import head_of
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.storage.foreign_files import check_no_foreign
from gaussiancad_core.storage.outputs import check_writable
from gaussiancad_core.storage.resume_check import sha256
from gaussiancad_protocol.modes import Device, Preset, Recipe, ResultKind, SolidWay

_CORRECTIONS = ".corrections.json"
"""Ends the name of the file beside a sheet, after the sheet's whole name, and the page where that
is not the first: ``set.pdf.page-2.corrections.json``."""


def corrections_file_of(sheet: Path, page: int = 1) -> Path | None:
    """The corrections beside a sheet, if there are some."""
    if not sheet.name:
        # Such as the folder that one is in.
        return None
    name = sheet.name if page == 1 else f"{sheet.name}.page-{page}"
    path = sheet.with_name(name + _CORRECTIONS)
    return path if path.is_file() else None


@dataclass(frozen=True)
class Job:
    """One run.

    Attributes:
        sheet: the drawing.
        output: folder for the results.
        reading: what the user says about the sheet.
        page: of a multi-page file, from 1.
        result: which models are asked for.
        recipe: cameras and training.
        preset: amount of work.
        seed: of all chance.
        device: where to train.
        resume: keep the results of an earlier run of the same job, or go on with its training.
        given: a ``reading.json`` that is taken instead of reading the sheet.
        corrections: a ``corrections.json`` that is applied to what was read.
        overwrite: whether files that no run made are replaced.
        transforms: whether the cameras are written for nerfstudio, too.
        way: in which an exact solid is looked for.
        surface_left_out: whether the solid alone is made only because the extra ``surface`` is not
            installed, so that a warning tells.
        scale_down: the edges of the images that are trained on are divided by this.
    """

    sheet: Path
    output: Path
    reading: ReadingOptions = field(default_factory=ReadingOptions)
    page: int = 1
    result: ResultKind = ResultKind.BOTH
    recipe: Recipe = Recipe.ORTHOGRAPHIC
    preset: Preset = Preset.STANDARD
    seed: int = 0
    device: Device = Device.AUTO
    resume: bool = False
    scale_down: int = 1
    transforms: bool = False
    given: Path | None = None
    corrections: Path | None = None
    overwrite: bool = False
    way: SolidWay = SolidWay.ALL
    surface_left_out: bool = False

    def check(self, names: Iterable[str] = ()) -> None:
        """Tell what is wrong with the paths before anything is loaded.

        Args:
            names: of the files that will be written.

        Raises:
            UnreadableError: the sheet is missing, empty, or of a kind that is not read.
            UsageError: ``output-not-writable``, ``foreign-files``.
        """
        head_of(self.sheet)
        check_writable(self.output)
        if not self.overwrite:
            check_no_foreign(self.output, names)

    def settings(self) -> dict[str, Any]:
        """What determines the result beside the sheet, as JSON values."""
        reading = self.reading
        adjacent = {
            name: sha256(path)
            for name, path in (
                ("reading_sha256", self.given),
                ("corrections_sha256", self.corrections),
            )
            if path is not None and path.is_file()
        }
        return {
            **adjacent,
            "projection": reading.projection.value if reading.projection else "auto",
            "views": {role.value: list(box) for role, box in reading.views},
            "lengths": {axis.name.lower(): length for axis, length in reading.lengths},
            "unit": reading.unit.value if reading.unit else None,
            "mm_per_pixel": reading.mm_per_pixel,
            "colour": "#{:02x}{:02x}{:02x}".format(*reading.colour),
            "median_kernel": reading.median_kernel,
            "page": self.page,
            "result": self.result.value,
            "recipe": self.recipe.value,
            "preset": self.preset.value,
            "seed": self.seed,
            "scale_down": self.scale_down,
            "transforms": self.transforms,
        }

"""What the user asks of the engine, as data, and as the engine's arguments."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

from freecad.gaussiancad.engine.protocol import Preset, Recipe, ResultKind

MODULE_ARGUMENTS = ("-I", "-u", "-m", "gaussiancad_core")
"""How the engine's interpreter is told to run the engine, isolated and unbuffered."""

VECTOR_SUFFIXES = ("pdf", "svg", "svgz", "dxf")
"""Files that the engine draws at 200 dpi of their paper."""

SHEET_SUFFIXES = ("png", "jpg", "jpeg", "tif", "tiff", "bmp", "webp", *VECTOR_SUFFIXES)
"""Files that the engine reads."""

PAGED_SUFFIXES = (".pdf", ".tif", ".tiff", ".dxf")
"""Ends of the names of files that may have pages."""


class Projection(Enum):
    """How the views are arranged on the sheet."""

    AUTO = "auto"
    FIRST = "first"
    THIRD = "third"


class ScaleKind(Enum):
    """What is known about the size of the part."""

    UNKNOWN = "unknown"
    LENGTH_X = "x"
    LENGTH_Y = "y"
    LENGTH_Z = "z"
    MM_PER_PIXEL = "mm-per-pixel"


@dataclass(frozen=True)
class Scale:
    """The size of the part.

    Attributes:
        kind: what is known.
        value: mm along the axis, or mm per pixel; unused where nothing is known.
    """

    kind: ScaleKind = ScaleKind.UNKNOWN
    value: float = 0.0

    def arguments(self) -> list[str]:
        """The engine's options."""
        if self.kind is ScaleKind.UNKNOWN:
            return []
        if self.kind is ScaleKind.MM_PER_PIXEL:
            return ["--mm-per-pixel", f"{self.value:.10g}"]
        return ["--length", f"{self.kind.value}={self.value:.10g}"]

    def text(self) -> str:
        """The same for people and for the document."""
        if self.kind is ScaleKind.UNKNOWN:
            return self.kind.value
        return f"{self.kind.value} = {self.value:.10g}"


@dataclass(frozen=True)
class ReconstructJob:
    """One sheet to be reconstructed.

    Attributes:
        sheet: path of the drawing.
        output: folder for the engine's files.
        projection, preset, outcome, recipe, scale: see their types.
        colour: of the part, ``#RRGGBB``.
        page: of a PDF, TIFF or DXF file, from 1.
        seed: of everything random.
        scale_down: the edges of the images that train the Gaussians are divided by this.
        reading, corrections: files that say what is on the sheet, or empty; of one sheet, so that
            no batch takes them.
        thickness: a length along the axis that the only view of the sheet does not show; unknown
            of all other sheets.
    """

    sheet: str
    output: str
    projection: Projection = Projection.AUTO
    preset: Preset = Preset.STANDARD
    outcome: ResultKind = ResultKind.BOTH
    recipe: Recipe = Recipe.ORTHOGRAPHIC
    scale: Scale = Scale()
    colour: str = "#78a0d2"
    page: int = 1
    seed: int = 0
    scale_down: int = 1
    reading: str = ""
    corrections: str = ""
    thickness: Scale = Scale()

    @classmethod
    def from_report(cls, sheet: str, output: str, settings: Mapping[str, Any]) -> "ReconstructJob":
        """The job that a report tells of; what it does not tell is as usual.

        Args:
            sheet: path of the drawing.
            output: folder of the engine's files.
            settings: ``settings`` of the report.

        Raises:
            ValueError: a setting has no such value.
        """
        usual = cls(sheet, output)
        lengths, mm_per_pixel = settings.get("lengths"), settings.get("mm_per_pixel")
        given = lengths.items() if isinstance(lengths, Mapping) else ()
        known = [Scale(ScaleKind(axis), float(length)) for axis, length in given]
        if mm_per_pixel is not None:
            known.insert(0, Scale(ScaleKind.MM_PER_PIXEL, float(mm_per_pixel)))
        scale, thickness, *_ = [*known, usual.scale, usual.thickness]
        return replace(
            usual,
            projection=Projection(settings.get("projection", usual.projection)),
            preset=Preset(settings.get("preset", usual.preset)),
            outcome=ResultKind(settings.get("result", usual.outcome)),
            recipe=Recipe(settings.get("recipe", usual.recipe)),
            scale=scale,
            colour=str(settings.get("colour", usual.colour)),
            page=int(settings.get("page", usual.page)),
            seed=int(settings.get("seed", usual.seed)),
            scale_down=int(settings.get("scale_down", usual.scale_down)),
            thickness=thickness,
        )

    @classmethod
    def kept(cls, sheet: str, output: str, settings: Mapping[str, str]) -> "ReconstructJob":
        """The job whose :meth:`settings` a document keeps; what is damaged there is as usual.

        Args:
            sheet: path of the drawing.
            output: folder of the engine's files.
            settings: one text a setting.
        """
        stated: dict[str, Any] = dict(settings)
        stated["lengths"] = {}
        for name in ("scale", "thickness"):
            kind, _, value = stated.pop(name, "").partition(" = ")
            if kind == ScaleKind.MM_PER_PIXEL.value:
                stated["mm_per_pixel"] = value
            elif value:
                stated["lengths"][kind] = value
        stated["scale_down"] = stated.pop("scale-down", cls.scale_down)
        try:
            return cls.from_report(sheet, output, stated)
        except ValueError:
            return cls(sheet, output)

    def arguments(self) -> list[str]:
        """``reconstruct --output DIR ... -- SHEET``, whose name may begin with a dash."""
        return [
            "reconstruct",
            "--output",
            self.output,
            *self.options(),
            *(("--reading", self.reading) if self.reading else ()),
            *(("--corrections", self.corrections) if self.corrections else ()),
            "--events",
            "--",
            self.sheet,
        ]

    def options(self) -> list[str]:
        """The options that say what is to be made, without the paths."""
        return [
            *("--projection", self.projection.value),
            *("--preset", self.preset.value),
            # All that the engine is installed for needs no word: it says what it left out.
            *(() if self.outcome is ResultKind.BOTH else ("--result", self.outcome.value)),
            *("--recipe", self.recipe.value),
            *("--colour", self.colour),
            *("--page", str(self.page)),
            *("--seed", str(self.seed)),
            *("--scale-down", str(self.scale_down)),
            *(self.scale.arguments() if self.scale.kind is not self.thickness.kind else ()),
            *self.thickness.arguments(),
        ]

    def settings(self) -> dict[str, str]:
        """The same for people and for the document: one text a setting."""
        thick = self.thickness.kind is not ScaleKind.UNKNOWN
        return {
            "projection": self.projection.value,
            "preset": self.preset.value,
            "result": self.outcome.value,
            "recipe": self.recipe.value,
            "scale": self.scale.text(),
            **({"thickness": self.thickness.text()} if thick else {}),
            "colour": self.colour,
            "page": str(self.page),
            "seed": str(self.seed),
            "scale-down": str(self.scale_down),
        }


@dataclass(frozen=True)
class BatchLimits:
    """How many sheets at a time, and what each may take; the engine's own where it is None.

    Attributes:
        workers: sheets at a time.
        memory: GB of a sheet.
        seconds: of a sheet.
    """

    workers: int | None = None
    memory: float | None = None
    seconds: float | None = None

    def arguments(self) -> list[str]:
        """The engine's options."""
        stated = {"--workers": self.workers, "--memory": self.memory, "--seconds": self.seconds}
        return [
            word
            for name, value in stated.items()
            if value is not None
            for word in (name, f"{value:.10g}")
        ]


@dataclass(frozen=True)
class BatchJob:
    """Many sheets to be reconstructed.

    Attributes:
        sheets: files, folders, patterns and tables.
        output: folder of the batch.
        settings: of all sheets; its paths are not used.
        limits: of the sheets.
        resume: whether what an earlier batch finished is kept.
    """

    sheets: tuple[str, ...]
    output: str
    settings: ReconstructJob
    limits: BatchLimits = BatchLimits()
    resume: bool = False

    def arguments(self) -> list[str]:
        """``batch --output DIR ... -- SHEETS``."""
        return [
            "batch",
            "--output",
            self.output,
            *self.settings.options(),
            *self.limits.arguments(),
            *(["--resume"] if self.resume else []),
            "--events",
            "--",
            *self.sheets,
        ]


@dataclass(frozen=True)
class CompareJob:
    """A result to be measured against a reference.

    Attributes:
        result, reference: paths of STEP, BREP, STL, PLY or OBJ files.
        output: folder for ``comparison.json``, ``comparison.html`` and ``deviation.ply``.
        points: samples on each side, or None for the engine's default.
        seed: of the samples.
    """

    result: str
    reference: str
    output: str
    points: int | None = None
    seed: int = 0

    def arguments(self) -> list[str]:
        """``compare RESULT REFERENCE --output DIR ...``."""
        points = [] if self.points is None else ["--points", str(self.points)]
        return [
            "compare",
            self.result,
            self.reference,
            "--output",
            self.output,
            *("--protocol", "all"),
            *points,
            "--seed",
            str(self.seed),
        ]

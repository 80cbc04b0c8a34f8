"""What is asked of ``gaussiancad check``, as data, and as the engine's arguments."""

from dataclasses import dataclass

from freecad.gaussiancad.engine.job import Projection, Scale, ScaleKind

CHECK_FILE, CHECK_PICTURE = "check.json", "check.png"
"""What the engine leaves in the job's folder, whatever the verdict."""

_UNKNOWN = Scale()


@dataclass(frozen=True)
class CheckJob:
    """A model to be held against a drawing.

    Attributes:
        sheet: path of the drawing; corrections beside it are taken.
        model: path of a STEP, BREP, STL, PLY or OBJ file.
        output: folder for the engine's files.
        page: of a PDF, TIFF or DXF file, from 1.
        projection: how the views are arranged.
        scale: what is known of the size that the drawing shows.
        thickness: a length along the axis that the only view of the sheet does not show.
        corrections: a file that is taken instead of the one beside the sheet, or empty.
    """

    sheet: str
    model: str
    output: str
    page: int = 1
    projection: Projection = Projection.AUTO
    scale: Scale = _UNKNOWN
    thickness: Scale = _UNKNOWN
    corrections: str = ""

    def arguments(self) -> list[str]:
        """``check --output DIR ... -- SHEET MODEL``, whose names may begin with a dash."""
        thickness, scale = self.thickness, self.scale
        is_same = scale.kind is thickness.kind and scale.kind is not ScaleKind.UNKNOWN
        return [
            "check",
            *("--output", self.output),
            *("--page", str(self.page)),
            *("--projection", self.projection.value),
            *(() if is_same else scale.arguments()),
            *thickness.arguments(),
            *(("--corrections", self.corrections) if self.corrections else ()),
            "--events",
            "--",
            self.sheet,
            self.model,
        ]

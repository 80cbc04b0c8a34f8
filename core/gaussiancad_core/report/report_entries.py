"""The entries of ``report.json``: plain data, each named as the part of the report that it is."""

from dataclasses import asdict, dataclass, field
from typing import Any

from gaussiancad_core.lines.line_agreement import Agreement


@dataclass(frozen=True)
class Remark:
    """A reason or a warning: a kebab-case code and a sentence for a person.

    Values travel with a sentence that is a :class:`.Message`.
    """

    code: str
    message: str


Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Unused:
    """Something on the sheet that was not used.

    Attributes:
        kind: what it is: one of :class:`.SpecialKind`, ``lines`` or ``frame``.
        box: around it, px of the sheet.
        why: and what that means.
    """

    kind: str
    box: Box
    why: str


@dataclass(frozen=True)
class Assumption:
    """Something that was taken to be so, as nothing on the sheet says otherwise.

    Attributes:
        code: kebab-case.
        message: what was assumed; values travel with it as with a :class:`Remark`.
        at: where on the sheet, a box in px; None where that is the whole sheet.
        alternative: what else might be.
        places: boxes of all that it speaks of, where these are several things alike.
    """

    code: str
    message: str
    at: Box | None
    alternative: str
    places: tuple[Box, ...] = ()


@dataclass(frozen=True)
class PlaneReport:
    """Where a section cuts the part.

    Attributes:
        axis: of the part, that the plane is square to.
        at_mm: along it.
        source: how that is known.
    """

    axis: str
    at_mm: float
    source: str = "trace"


@dataclass(frozen=True)
class SectionReport:
    """A section.

    Attributes:
        label: its letters; empty where it has no title.
        role: the direction in which it looks; empty where that was not found.
        box: around it, px of the sheet.
        plane: where it cuts; None where that is not known, or the cut is no plane.
        line_recall, line_precision: shares of the sheet's lines and of the solid's, cut alike, that
            the other has; None where there is no solid or the section was not used.
        area_agreement: hatched and cut area, what is common by what is in either.
    """

    label: str
    role: str
    box: Box
    plane: PlaneReport | None = None
    line_recall: float | None = None
    line_precision: float | None = None
    area_agreement: float | None = None


@dataclass(frozen=True)
class NoteReport:
    """A note at a feature.

    Attributes:
        text: as it was read.
        kind: what it speaks of.
        value_mm: the length that it gives; degrees of an angle.
        at: around it, px of the sheet.
        count: of how many features it speaks.
        depth_mm: how deep they are.
        through: whether it says that they go through.
        used: whether something was made from it that the solid has as the note says.
    """

    text: str
    kind: str
    value_mm: float | None
    at: Box
    count: int = 1
    depth_mm: float | None = None
    through: bool = False
    used: bool = False


@dataclass(frozen=True)
class Disagreement:
    """A stretch of line that the sheet and the solid do not share.

    Attributes:
        view: its role.
        at: px of the sheet, a point of it.
        length_mm: of the stretch.
        missing: whether the solid lacks it; otherwise the sheet does.
        kind: ``visible`` or ``hidden``, of the line.
        line: px of the sheet, its ends where it is straight.
    """

    view: str
    at: tuple[float, float]
    length_mm: float
    missing: bool
    kind: str
    line: tuple[tuple[float, float], tuple[float, float]] | None


@dataclass(frozen=True)
class MeasuresReport:
    """How well the places of the solid's faces are known.

    Attributes:
        uncertainty_mm: a bound that 95 % of all faces' places keep.
        source: ``numbers``, ``drawing`` or ``mixed``.
        by_axis_mm: the same along x, y and z.
    """

    uncertainty_mm: float
    source: str
    by_axis_mm: dict[str, float]


@dataclass(frozen=True)
class ViewReport:
    """One view.

    Attributes:
        box: around its lines, px of the sheet.
        agreement: of the result's lines, once it was drawn again.
        hidden_lines: ``drawn`` if it has some, ``none`` otherwise.
    """

    box: Box
    agreement: Agreement | None = None
    hidden_lines: str | None = None

    def as_json(self) -> dict[str, Any]:
        """JSON values."""
        entry: dict[str, Any] = {"box": [round(value, 2) for value in self.box]}
        if self.hidden_lines:
            entry["hidden_lines"] = self.hidden_lines
        if self.agreement:
            entry.update({k: round(v, 4) for k, v in asdict(self.agreement).items()})
        return entry


@dataclass(frozen=True)
class SolidReport:
    """The solid.

    Attributes:
        alternatives: number of others that fit the sheet as well.
        source: ``lines`` if it was found from all lines, ``sketch`` if it is the part of slabs that
            explains them best.
        agreement: share of all lines, the sheet's and the solid's, that agree.
    """

    valid: bool
    closed: bool
    faces: int
    volume_mm3: float
    bounding_box_mm: tuple[float, float, float]
    alternatives: int
    source: str = "lines"
    agreement: float = 1.0


@dataclass(frozen=True)
class AlternativeReport:
    """Another solid that fits the sheet.

    Attributes:
        file: in the output folder.
        projection: under which the sheet was read.
        faces, volume_mm3: of the solid.
        agreement: share of all lines, the sheet's and the solid's, that agree.
    """

    file: str
    projection: str
    faces: int
    volume_mm3: float
    agreement: float


@dataclass(frozen=True)
class ConflictReport:
    """A line that contradicts others.

    Attributes:
        view: its role.
        drawn: ``visible``, ``hidden``, or None where nothing is drawn.
        suspect: whether all others agree without it.
        fitting: how a suspect would have to be drawn, None for not at all.
        box: around it, px of the sheet.
    """

    view: str
    drawn: str | None
    suspect: bool
    fitting: str | None
    box: tuple[float, float, float, float]


@dataclass(frozen=True)
class HullReport:
    """The hull on which the Gaussians start.

    Attributes:
        carved_from: status of the exact solid whose depths carved it; None if it is the masks' own.
        regions: of all views, that were carved.
        doubted: regions that were not, as the sheet lacks the lines that bound them.
        refused: why a carved hull was not taken: ``outline-lost``, ``lines-worse`` or
            ``not-watertight``; empty otherwise.
    """

    carved_from: str | None = None
    regions: int = 0
    doubted: int = 0
    refused: str = ""


@dataclass(frozen=True)
class SurfaceReport:
    """The surface.

    Attributes:
        nearer: what has the outlines of the views better: ``gaussians``, whose Poisson mesh this
            is, or the ``hull`` on which they started, which is written beside it then.
        outline_difference: of the shadows of either from the masks, as a share of these.
    """

    vertices: int
    triangles: int
    watertight: bool
    volume_mm3: float
    nearer: str = "gaussians"
    outline_difference: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class GaussiansReport:
    """The trained Gaussians.

    Attributes:
        loss: the last one.
        settled: whether the training ended because the loss fell no more.
        image_px: width and height of the images that were trained on.
        resumed: iterations that were made by an earlier run.
        residuals: by role, how much of the mask differs, and where, boxes in px of the sheet.
    """

    count: int
    iterations: int
    loss: float
    settled: bool = False
    image_px: tuple[int, int] = (0, 0)
    resumed: int = 0
    residuals: dict[str, Any] = field(default_factory=dict)

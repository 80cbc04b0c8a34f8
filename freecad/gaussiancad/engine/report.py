"""``report.json`` and ``comparison.json`` as data.

Missing fields read as nothing, since fields may be added and older engines lack some; a file that
is no report at all is an error.
"""

import json
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

_NO_ONE_SCALE = ("photographed-at-a-slant", "views-disagree")
"""Reasons and warnings which say that no scale is that of all views."""

ViewBox = tuple[float, float, float, float]


@dataclass(frozen=True)
class Remark:
    """A reason or a warning.

    Attributes:
        code: kebab-case, for machines.
        message: the engine's own sentence, English.
        args: the values in it.
    """

    code: str
    message: str
    args: dict[str, Any] = field(default_factory=dict)

    @property
    def words(self) -> str:
        """For people, in their language."""
        return worded(self.code, self.message, self.args)

    def __str__(self) -> str:
        return f"{self.code}: {self.words}" if self.message else self.code


@dataclass(frozen=True)
class ViewReport:
    """A view of the sheet.

    Attributes:
        role: front, top, right, left, bottom or rear.
        box: (x0, y0, x1, y1) in sheet pixels, y down; None if it was not told.
        agreement: recall and precision of the result's lines against the sheet's, 0 to 1; keys
            ``visible_recall``, ``visible_precision``, ``hidden_recall``, ``hidden_precision``.
    """

    role: str
    box: ViewBox | None
    agreement: dict[str, float]


@dataclass(frozen=True)
class AlternativeReport:
    """Another solid that has the sheet's lines.

    Attributes:
        agreement: share of all lines, both ways, that agree, 0 to 1.
        projection: first or third; empty if it was not told.
    """

    agreement: float
    projection: str


@dataclass(frozen=True)
class Report:
    """A run's report.

    Attributes:
        text: the file as it is.
        values: the file's JSON.
        status: verified, approximate or failed.
        reasons, warnings: see :class:`Remark`.
        views: in the order of the file.
        mm_per_pixel: scale, or None.
        seconds: duration of each stage.
        alternatives: of the solid, best first; those of which nothing is told are left out.
    """

    text: str
    values: dict[str, Any]
    status: Status
    reasons: tuple[Remark, ...]
    warnings: tuple[Remark, ...]
    views: tuple[ViewReport, ...]
    mm_per_pixel: float | None
    seconds: dict[str, float]
    alternatives: tuple[AlternativeReport, ...] = ()

    @property
    def agreement(self) -> float | None:
        """Share of all lines, both ways, on which the exact solid and the sheet agree."""
        return as_number(self.group("solid").get("agreement"))

    @property
    def sketched(self) -> bool:
        """Whether the solid is the stack of slabs that explains the lines best."""
        return self.group("solid").get("source") == "sketch"

    @property
    def is_size_known(self) -> bool:
        """Whether anything tells how large the part is."""
        return is_size_known(self.values)

    def word(self, key: str) -> str:
        """A top-level field as text, empty if it is missing."""
        value = self.values.get(key)
        return "" if value is None else str(value)

    def group(self, key: str) -> dict[str, Any]:
        """A top-level object, empty if it is missing or null."""
        value = self.values.get(key)
        return value if isinstance(value, dict) else {}


def is_size_known(values: dict[str, Any]) -> bool:
    """Whether anything tells how large the part of a report's JSON is: that a drawing on paper
    shows it full scale is nothing that anybody told."""
    if values.get("scale_source") == "default":
        return False
    return not any(
        value.get("code") == "full-scale-assumed" and value.get("args", {}).get("case") != "file"
        for value in values.get("warnings", ())
    )


def are_measures_told(values: dict[str, Any]) -> bool:
    """Whether the views of a report's JSON fit one scale, so that a bound of the measures can be
    stated."""
    remarks = (*values.get("reasons", ()), *values.get("warnings", ()))
    return not any(remark.get("code") in _NO_ONE_SCALE for remark in remarks)


def read_report(path: Path) -> Report:
    """Read a run's ``report.json``.

    Raises:
        WorkbenchError: the file is missing, or is no report.
    """
    text, values = read_object(path)
    try:
        return parse_report(text, values)
    except ValueError as error:
        raise unreadable(path, str(error)) from error


def parse_report(text: str, values: dict[str, Any]) -> Report:
    """The report in a file's JSON.

    Args:
        text: the file as it is.
        values: its JSON.

    Raises:
        ValueError: it has no status.
    """
    status = Status(values.get("status"))
    return Report(
        text,
        values,
        status,
        as_remarks(values.get("reasons")),
        as_remarks(values.get("warnings")),
        _views(values.get("views")),
        as_number(values.get("scale_mm_per_pixel")),
        _numbers(values.get("seconds")),
        _alternatives(values.get("alternatives")),
    )


@dataclass(frozen=True)
class Histogram:
    """Share of a result's surface by its deviation.

    Attributes:
        edges: mm, one more than there are shares.
        shares: of the surface, 0 to 1.
    """

    edges: tuple[float, ...]
    shares: tuple[float, ...]


@dataclass(frozen=True)
class WorstPoint:
    """A place where the models are far apart.

    Attributes:
        of_result: whether it lies on the result's surface, else on the reference's.
        place: mm, in the reference's coordinates.
        deviation: mm, negative inside the other model.
    """

    of_result: bool
    place: tuple[float, float, float]
    deviation: float


@dataclass(frozen=True)
class Comparison:
    """A comparison's report.

    Attributes:
        text: the file as it is.
        values: the file's JSON.
        distances: ``chamfer``, ``hausdorff``, ``emd``, ``point_to_surface``, ``volume_iou`` as far
            as they were told.
        floor: what two samplings of the same reference give, same keys.
        warnings: what to know before believing the numbers.
        histogram: share of the surface by its deviation, or None.
        worst: the farthest points, the worst first.
        engineering: the block of that protocol, empty where it was not told.
    """

    text: str
    values: dict[str, Any]
    distances: dict[str, float]
    floor: dict[str, float]
    warnings: tuple[Remark, ...] = ()
    histogram: Histogram | None = None
    worst: tuple[WorstPoint, ...] = ()
    engineering: dict[str, Any] = field(default_factory=dict)


COMPARED = ("chamfer", "hausdorff", "emd", "point_to_surface", "volume_iou")


def read_comparison(path: Path) -> Comparison:
    """Read a ``comparison.json``.

    Raises:
        WorkbenchError: the file is missing, or is no comparison.
    """
    text, values = read_object(path)
    try:
        return parse_comparison(text, values)
    except ValueError as error:
        raise unreadable(path, str(error)) from error


def parse_comparison(text: str, values: dict[str, Any]) -> Comparison:
    """The comparison in a file's JSON.

    Args:
        text: the file as it is.
        values: its JSON.

    Raises:
        ValueError: it has no distances.
    """
    distances = _numbers({key: values.get(key) for key in COMPARED})
    if not distances:
        raise ValueError("no distances")
    return Comparison(
        text,
        values,
        distances,
        _numbers(values.get("floor")),
        as_remarks(values.get("warnings")),
        _histogram(values.get("deviation")),
        _worst(values.get("deviation")),
        _engineering(values.get("protocols")),
    )


def _histogram(deviation: object) -> Histogram | None:
    values = deviation.get("histogram") if isinstance(deviation, dict) else None
    if not isinstance(values, dict):
        return None
    edges, shares = (as_numbers(values.get(key)) for key in ("edges_mm", "shares"))
    if not shares or len(edges) != len(shares) + 1:
        return None
    return Histogram(edges, shares)


def _worst(deviation: object) -> tuple[WorstPoint, ...]:
    values = deviation.get("worst") if isinstance(deviation, dict) else None
    found = []
    for value in values if isinstance(values, list) else ():
        place = as_numbers(value.get("point_mm")) if isinstance(value, dict) else ()
        amount = as_number(value.get("deviation_mm")) if len(place) == 3 else None
        if amount is not None:
            found.append(WorstPoint(value.get("of") == "result", place, amount))
    return tuple(found)


def _engineering(protocols: object) -> dict[str, Any]:
    block = protocols.get("engineering") if isinstance(protocols, dict) else None
    return block if isinstance(block, dict) else {}


def as_numbers(values: object) -> tuple[float, ...]:
    """A list of numbers; empty if it is none."""
    if not isinstance(values, list):
        return ()
    numbers = [as_number(value) for value in values]
    return () if None in numbers else tuple(numbers)


def read_object(path: Path) -> tuple[str, dict[str, Any]]:
    """A file of the engine as it is, and its JSON.

    Raises:
        WorkbenchError: the file is missing, or holds no JSON object.
    """
    try:
        text = path.read_text(encoding="utf-8")
        values = json.loads(text)
    except (OSError, ValueError) as error:
        raise unreadable(path, str(error)) from error
    if not isinstance(values, dict):
        raise unreadable(path, "not an object")
    return text, values


def unreadable(path: Path, reason: str) -> WorkbenchError:
    """The error of a file that is not what the engine writes."""
    message = translate(
        "GaussianCAD",
        "The engine's report {path} cannot be read ({reason}). Run it again; if that does not "
        "help, choose GaussianCAD > Check Engine.",
    )
    return WorkbenchError(ErrorCode.RESULT_UNREADABLE, message.format(path=path, reason=reason))


def as_remarks(values: object) -> tuple[Remark, ...]:
    """Reasons or warnings; none where the value is no list."""
    if not isinstance(values, list):
        return ()
    return tuple(
        Remark(str(value.get("code", "")), str(value.get("message", "")), _args(value.get("args")))
        for value in values
        if isinstance(value, dict)
    )


def _args(value: object) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


def _alternatives(values: object) -> tuple[AlternativeReport, ...]:
    if not isinstance(values, list):
        return ()
    return tuple(
        AlternativeReport(
            as_number(value.get("agreement")) or 0.0, str(value.get("projection", ""))
        )
        for value in values
        if isinstance(value, dict)
    )


def _views(values: object) -> tuple[ViewReport, ...]:
    if not isinstance(values, dict):
        return ()
    return tuple(
        ViewReport(str(role), _box(view.get("box")), _numbers(view))
        for role, view in values.items()
        if isinstance(view, dict)
    )


def _box(value: object) -> ViewBox | None:
    if not isinstance(value, list) or len(value) != 4:
        return None
    numbers = [as_number(entry) for entry in value]
    x0, y0, x1, y1 = numbers
    if None in numbers or not (x0 < x1 and y0 < y1):
        return None
    return (x0, y0, x1, y1)


def _numbers(values: object) -> dict[str, float]:
    if not isinstance(values, dict):
        return {}
    numbers = {str(key): as_number(value) for key, value in values.items()}
    return {key: value for key, value in numbers.items() if value is not None}


def as_number(value: object) -> float | None:
    """A finite number; None where the value is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if math.isfinite(value) else None

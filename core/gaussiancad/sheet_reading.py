"""What was read of a sheet, as plain data that can be looked at, corrected and solved."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from gaussiancad.options import PathLike


@dataclass(frozen=True)
class Stroke:
    """A stroke of a sheet; px of the sheet as stored (y down), radians from x to y.

    Attributes:
        id: by which corrections name it.
        kind: what it stands for: ``visible``, ``hidden``, ``centre``, ``dimension``, ...
        line: its two ends, of a straight one.
        arc: centre, radius, start and sweep, of an arc.
        ellipse: centre, semi-axes (the larger first), rotation, start and sweep of the parameter.
        confidence: how sure the kind is, 0 to 1.
    """

    id: str
    kind: str
    line: tuple[tuple[float, float], tuple[float, float]] | None = None
    arc: tuple[float, ...] | None = None
    ellipse: tuple[float, ...] | None = None
    confidence: float = 1.0


@dataclass(frozen=True)
class View:
    """A view, or another drawing on the sheet.

    Attributes:
        id: by which strokes and corrections name it.
        role: ``front``, ``top``, ``right``, ``section``, ``detail``, ...
        box: x0, y0, x1, y1 around its lines, px of the sheet as stored.
        used: whether the part follows from it.
        strokes: its lines.
    """

    id: str
    role: str
    box: tuple[float, float, float, float]
    used: bool = True
    strokes: tuple[Stroke, ...] = ()


@dataclass(frozen=True)
class Problem:
    """What is in doubt or missing, and what may help.

    Attributes:
        code: in kebab-case, stable.
        message: a sentence.
        severity: ``refused`` where no part follows, ``doubt``, or ``warning``.
        offers: corrections that may help, by their ``op``.
    """

    code: str
    message: str
    severity: str
    offers: tuple[str, ...] = ()


@dataclass(frozen=True)
class Reading:
    """What was read of a sheet.

    Attributes:
        sheet: the file.
        data: ``reading.json`` as it is, see the documentation.
        page: of the file, from 1.
        folder: that of ``reading.json``, its pictures and ``lines.dxf``, if they were written.
    """

    sheet: Path
    data: Mapping[str, Any]
    page: int = 1
    folder: Path | None = None

    @classmethod
    def load(cls, path: PathLike, sheet: PathLike) -> "Reading":
        """What ``gaussiancad read`` or :meth:`save` wrote.

        Raises:
            OSError: the file cannot be read.
            ValueError: it is no JSON object.
        """
        data = json.loads(Path(path).read_bytes())
        if not isinstance(data, dict):
            raise ValueError(f"{path} is no reading.json")
        page = int(data.get("sheet", {}).get("page", 1))
        return cls(Path(sheet), MappingProxyType(data), page, Path(path).parent)

    @property
    def views(self) -> Mapping[str, View]:
        """The views by their roles; several of one role by role and id, as ``section v3``."""
        found: dict[str, View] = {}
        for entry in self.data.get("views", ()):
            view = View(
                str(entry["id"]),
                str(entry["role"]),
                tuple(entry["box"]),
                bool(entry.get("used", True)),
                tuple(
                    _stroke(stroke)
                    for stroke in self.data.get("strokes", ())
                    if stroke.get("view") == entry["id"]
                ),
            )
            found[view.role if view.role not in found else f"{view.role} {view.id}"] = view
        return MappingProxyType(found)

    @property
    def strokes(self) -> tuple[Stroke, ...]:
        """All strokes, those of no view too."""
        return tuple(_stroke(entry) for entry in self.data.get("strokes", ()))

    @property
    def problems(self) -> tuple[Problem, ...]:
        """What is in doubt or missing."""
        return tuple(
            Problem(
                str(entry["code"]),
                str(entry["message"]),
                str(entry["severity"]),
                tuple(entry.get("offers", ())),
            )
            for entry in self.data.get("problems", ())
        )

    @property
    def projection(self) -> str:
        """``first`` or ``third``."""
        return str(self.data["projection"]["value"])

    def save(self, path: PathLike) -> None:
        """Write ``reading.json``; the file appears when it is whole.

        Raises:
            UsageError: it cannot be written there.
            LimitError: ``disk-full``.
        """
        from gaussiancad_core.storage.single_file import write_whole

        write_whole(Path(path), self.as_json())

    def as_json(self) -> bytes:
        """The content of ``reading.json``, in UTF-8."""
        return json.dumps(dict(self.data), ensure_ascii=False, indent=1).encode("utf-8")

    def __repr__(self) -> str:
        views = ", ".join(self.views) or "no view"
        return (
            f"<Reading of {self.sheet.name}: {views}; {len(self.data.get('strokes', ()))} strokes>"
        )


def _stroke(entry: Mapping[str, Any]) -> Stroke:
    line, arc, ellipse = (entry.get(name) for name in ("line", "arc", "ellipse"))
    return Stroke(
        str(entry["id"]),
        str(entry["kind"]),
        (tuple(line[0]), tuple(line[1])) if line else None,
        tuple(arc) if arc else None,
        tuple(ellipse) if ellipse else None,
        float(entry.get("confidence", 1.0)),
    )

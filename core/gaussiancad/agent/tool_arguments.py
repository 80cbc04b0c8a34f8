"""What each tool may be called with; the schemas that an agent sees are made from these types."""

import json
from collections.abc import Mapping
from math import isfinite
from typing import Annotated, Any, Literal, TypeVar

import msgspec
from msgspec import Meta, Struct

from gaussiancad_core.errors import UsageError
from gaussiancad_core.readings.correction_operations import Operation
from gaussiancad_core.readings.reading_schema import Box, Point, Size
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import StrokeKind

MOST_STROKES = 200
"""That one answer lists."""

_MOST_OPERATIONS = 1000
"""Of one call."""

Name = Annotated[str, Meta(min_length=1, max_length=1000)]
PartRole = Literal["front", "top", "right", "left", "bottom", "rear"]

_SHEET = (
    "The drawing: PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF, relative to the server's folder."
)
_OUTPUT = (
    "Subfolder for the files, such as `parts/bracket`; a new one below `gaussiancad-mcp` where "
    "left out."
)
_READING = "An id that `read` or `correct` gave."
_PICTURE = "Whether the answer has the picture; without it the answer is small."


class SheetArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is known of a sheet; leave out what the sheet says itself."""

    page: Annotated[
        int, Meta(ge=1, le=100_000, description="Of a file that has several, from 1.")
    ] = 1
    projection: Annotated[
        Literal["first", "third"] | None, Meta(description="First or third angle.")
    ] = None
    views: Annotated[
        dict[PartRole, Box] | None,
        Meta(
            description="Boxes around views by role (front, top, right, left, bottom, rear): x0, "
            "y0, x1, y1 in px, y down."
        ),
    ] = None
    length: Annotated[
        dict[Literal["x", "y", "z"], Size] | None,
        Meta(description='Extents of the part in mm by axis, such as {"x": 80}: the scale.'),
    ] = None
    mm_per_pixel: Annotated[Size | None, Meta(description="The scale.")] = None
    unit: Annotated[
        Literal["mm", "cm", "m", "in", "ft"] | None,
        Meta(description="Of a file that does not say its own."),
    ] = None

    def options(self) -> dict[str, Any]:
        """Keyword arguments of :func:`gaussiancad.read`."""
        return {name: getattr(self, name) for name in SheetArguments.__struct_fields__}


class ReadArguments(SheetArguments, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``read``."""

    sheet: Annotated[Name, Meta(description=_SHEET, examples=["l-bracket.png"])]
    output: Annotated[Name | None, Meta(description=_OUTPUT)] = None
    picture: Annotated[bool, Meta(description=_PICTURE)] = True


class LookArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``look``."""

    reading_id: Annotated[Name, Meta(description=_READING)]
    view: Annotated[Name | None, Meta(description="Role or id of a view, such as `top`.")] = None
    box: Annotated[
        Box | None, Meta(description="x0, y0, x1, y1 in px of the sheet, y down; or a view.")
    ] = None
    kinds: Annotated[
        tuple[StrokeKind, ...], Meta(description="Lists strokes of these kinds only.")
    ] = ()
    doubtful_first: Annotated[
        bool, Meta(description="Lists the strokes whose kind is least sure first.")
    ] = False
    offset: Annotated[
        int, Meta(ge=0, le=10_000_000, description="Strokes to skip: `next_offset` of an answer.")
    ] = 0
    limit: Annotated[int, Meta(ge=0, le=MOST_STROKES, description="Strokes to list.")] = 50
    picture: Annotated[bool, Meta(description=_PICTURE)] = True


class CorrectArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``correct``."""

    reading_id: Annotated[Name, Meta(description=f"{_READING} It stays as it is.")]
    operations: Annotated[
        tuple[Operation, ...],
        Meta(
            min_length=1,
            max_length=_MOST_OPERATIONS,
            description="What is wrong, one operation after another.",
            examples=[[{"op": "kind", "target": {"id": "s12"}, "to": "hidden"}]],
        ),
    ]
    output: Annotated[Name | None, Meta(description=_OUTPUT)] = None
    picture: Annotated[bool, Meta(description=_PICTURE)] = True


class ReconstructArguments(SheetArguments, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``reconstruct``."""

    sheet: Annotated[Name | None, Meta(description=f"{_SHEET} Either this or a reading.")] = None
    reading_id: Annotated[
        Name | None,
        Meta(description=f"{_READING} What is known of the sheet is in it, so name that no more."),
    ] = None
    result: Annotated[
        Literal["solid", "surface", "both"],
        Meta(description="The exact solid; the mesh of trained Gaussians, which takes minutes."),
    ] = "solid"
    preset: Annotated[
        Literal["draft", "standard", "fine"] | None,
        Meta(description="How long Gaussians are trained."),
    ] = None
    seed: Annotated[int, Meta(ge=0, le=2**31 - 1, description="Of all chance.")] = 0
    output: Annotated[Name | None, Meta(description=_OUTPUT)] = None
    pictures: Annotated[bool, Meta(description=_PICTURE)] = True


class ExplainArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``explain``."""

    id: Annotated[Name, Meta(description="A reading's or a part's: `reading_id`, `result_id`.")]
    at: Annotated[
        Point | None, Meta(description="x, y in px of the sheet: what is known of that place.")
    ] = None
    view: Annotated[
        Name | None, Meta(description="Role of a view: what is known of it; or a place.")
    ] = None


class CompareArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``compare``."""

    result: Annotated[
        Name, Meta(description="A `result_id`, or a STEP, BREP, STL, PLY or OBJ file.")
    ]
    reference: Annotated[Name, Meta(description="The truth, likewise.")]
    points: Annotated[
        Annotated[int, Meta(ge=100, le=200_000)] | None,
        Meta(description="That are sampled on each surface."),
    ] = None


class CheckArguments(SheetArguments, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``check``."""

    sheet: Annotated[Name, Meta(description=_SHEET)]
    solid: Annotated[
        Name, Meta(description="A `result_id`, or a STEP, BREP, STL, PLY or OBJ file.")
    ]
    output: Annotated[Name | None, Meta(description=_OUTPUT)] = None
    picture: Annotated[bool, Meta(description=_PICTURE)] = True


class FeaturesArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``features``."""

    solid: Annotated[Name, Meta(description="A `result_id`, or a STEP or BREP file.")]
    output: Annotated[Name | None, Meta(description=_OUTPUT)] = None


class FilesArguments(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Of ``files``."""

    offset: Annotated[
        int, Meta(ge=0, le=10_000_000, description="Files to skip: `next_offset` of an answer.")
    ] = 0


Arguments = TypeVar("Arguments", bound=Struct)


def decoded(tool: str, kind: type[Arguments], values: Mapping[str, Any]) -> Arguments:
    """The arguments of a call.

    Args:
        tool: its name.
        kind: of its arguments.
        values: as the client sent them; some send lists and objects as text.

    Raises:
        UsageError: ``wrong-usage``, with the place and what is expected there.
    """
    try:
        found = msgspec.convert({name: _plain(value) for name, value in values.items()}, kind)
    except (msgspec.ValidationError, RecursionError) as error:
        raise UsageError(
            Code.WRONG_USAGE,
            "{tool} cannot be called so: {reason}; its input schema says what it takes",
            tool=tool,
            reason=error,
        ) from error
    for name in found.__struct_fields__:
        if not _is_finite(getattr(found, name)):
            raise UsageError(Code.WRONG_USAGE, f"{tool}: {name} has a number that is not finite")
    return found


def _plain(value: Any) -> Any:  # noqa: ANN401
    if isinstance(value, str) and value[:1] in ("[", "{"):
        try:
            return json.loads(value)
        except (ValueError, RecursionError):
            return value
    return value


def _is_finite(value: object) -> bool:
    if isinstance(value, float):
        return isfinite(value)
    if isinstance(value, Struct):
        return all(_is_finite(getattr(value, name)) for name in value.__struct_fields__)
    if isinstance(value, Mapping):
        return all(map(_is_finite, value.values()))
    return all(map(_is_finite, value)) if isinstance(value, tuple) else True

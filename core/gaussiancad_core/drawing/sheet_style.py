"""How a sheet looks: named presets, each value of which can be overridden by name."""

import re
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from enum import Enum
from typing import Any

from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.model.tangent_policies import TangentPolicy, drawn_policy
from gaussiancad_protocol.codes import Code

Colour = tuple[int, int, int]


class Cap(Enum):
    """How a solid stroke ends: round, or cut off square at its end point."""

    ROUND = "round"
    BUTT = "butt"


class TextPlace(Enum):
    """Where a dimension's text stands: above its line (ISO 129-1) or in it (ASME Y14.5)."""

    ABOVE = "above"
    INLINE = "inline"


class Inset(Enum):
    """What is drawn beside the views: it belongs to none of them."""

    DETAIL = "detail"
    AUXILIARY = "auxiliary-view"
    OTHER_PART = "other-part"


@dataclass(frozen=True)
class SheetStyle:
    """The look of a sheet; lengths and widths in sheet pixels unless another unit is named.

    Defects come in the order in which a sheet meets them: the pen (``bleed``, ``fade``), paper and
    glass (``specks``), optics (``blur``), copier (``contrast``), light (``light``, ``shadow``),
    sensor (``noise``, ``salt``), file (``jpeg_quality``).  Each is off at 0, ``contrast`` at 1.

    Attributes:
        width, height: the sheet.
        visible_width, hidden_width: line widths of visible and hidden strokes.
        dash, gap: nominal rhythm of hidden strokes; it is stretched a little to fit each stroke.
        margin: least blank border around all views.
        view_gap: blank distance between the boxes of neighbouring views.
        ink, paper: RGB, 0 to 255.
        mm_per_pixel: scale of the drawing; None fits the views to the sheet.
        cap: ends of visible strokes.
        antialiasing: grey edges of strokes; without it every pixel is ink or paper.
        tangent_edges: whether smooth edges are drawn as other edges are, as thin continuous lines
            where they are visible (width ``annotation_width``), or left out.
        hidden: draw hidden lines; most drawings of practice leave them out.
        skew: degrees by which the drawing is turned on the sheet, counter-clockwise.
        blur: standard deviation of a Gaussian blur, as of a scanner's optics.
        noise: standard deviation of the grey noise, in levels of 255.
        jpeg_quality: 1 to 100, for JPEG and WebP files.
        annotations: dimensions and notes (ISO 129-1).
        frame: border with its zones, title block and projection symbol (ISO 5457, ISO 7200).
        centre_lines: centre lines and centre marks of circles, axes of holes (ISO 128).
        picture: an isometric picture in a free corner, if there is one.
        inset: what else is drawn in a free corner, if there is one, or None.
        symbol: the projection symbol in the title block, where there is a frame.
        section: the view that is cut open and hatched, or None.
        section_kind: how much of it.
        broken: the view that a piece of is left out of, or None; its length stays as drawn.
        half: the view that is drawn up to its centre line alone, or None.
        threads: thread symbols on bores and shafts (ISO 6410-1).
        hatch_pitch: from line to line of the hatching.
        annotation_width: line width of all of these but the border and the picture.
        text_height: height of capitals and digits; arrows and distances follow from it.
        text_place: ``above`` dimension lines and along them, or ``inline`` and level.
        bleed: how far ink creeps to either side of a stroke.
        fade: share of the ink that pale regions lack, 0 to 1.
        specks: number of specks of dust and spots without ink per million pixels.
        contrast: steepness of a copier's tone curve, 1 to 10, which also frays edges.
        light: share of the light that the darkest part of the sheet lacks, 0 to 1.
        shadow: width of the dark border that a copier's lid leaves at the left and at the top.
        salt: share of pixels, 0 to 1, that are black or white whatever was there.
    """

    width: int = 1920
    height: int = 1080
    visible_width: float = 3.0
    hidden_width: float = 2.0
    dash: float = 12.0
    gap: float = 6.0
    margin: float = 80.0
    view_gap: float = 90.0
    ink: Colour = (0, 0, 0)
    paper: Colour = (255, 255, 255)
    mm_per_pixel: float | None = None
    cap: Cap = Cap.ROUND
    antialiasing: bool = True
    tangent_edges: TangentPolicy = TangentPolicy.LEFT_OUT
    hidden: bool = True
    skew: float = 0.0
    blur: float = 0.0
    noise: float = 0.0
    jpeg_quality: int = 95
    annotations: bool = False
    frame: bool = False
    centre_lines: bool = False
    picture: bool = False
    inset: Inset | None = None
    symbol: bool = True
    section: Role | None = None
    section_kind: SectionKind = SectionKind.FULL
    broken: Role | None = None
    half: Role | None = None
    threads: bool = False
    hatch_pitch: float = 14.0
    annotation_width: float = 1.5
    text_height: float = 18.0
    text_place: TextPlace = TextPlace.ABOVE
    bleed: float = 0.0
    fade: float = 0.0
    specks: float = 0.0
    contrast: float = 1.0
    light: float = 0.0
    shadow: float = 0.0
    salt: float = 0.0


_PHOTOCOPY = SheetStyle(
    ink=(26, 26, 26),
    paper=(250, 250, 250),
    margin=110.0,
    skew=3.0,
    bleed=0.5,
    fade=0.12,
    specks=60.0,
    blur=0.8,
    contrast=2.5,
    light=0.12,
    shadow=30.0,
    noise=3.0,
    salt=2e-4,
    jpeg_quality=80,
)
"""A dark copy of a faint original, laid on the glass askew."""

PRESETS: dict[str, SheetStyle] = {
    "clean": SheetStyle(),
    "thin": SheetStyle(visible_width=2.0, hidden_width=1.2, dash=10.0, gap=5.0),
    "thick": SheetStyle(visible_width=5.0, hidden_width=3.0, dash=18.0, gap=8.0),
    # ISO 128-2: narrow lines have half the width, dashes 12 and gaps 3 of the narrow width.
    "iso": SheetStyle(visible_width=4.0, hidden_width=2.0, dash=24.0, gap=6.0),
    "even": SheetStyle(visible_width=2.0, hidden_width=2.0),
    "binary": SheetStyle(antialiasing=False),
    "blueprint": SheetStyle(ink=(255, 255, 255), paper=(24, 58, 120)),
    "scan": SheetStyle(
        ink=(40, 40, 44),
        paper=(246, 244, 238),
        skew=0.4,
        blur=0.7,
        noise=4.0,
        jpeg_quality=85,
    ),
    "photocopy": _PHOTOCOPY,
    "dimensioned": SheetStyle(
        margin=130.0,
        view_gap=170.0,
        annotations=True,
        frame=True,
        centre_lines=True,
    ),
    # What comes back from a workshop: a copy of a dimensioned sheet.
    "workshop": replace(
        _PHOTOCOPY,
        margin=150.0,
        view_gap=170.0,
        annotations=True,
        frame=True,
        centre_lines=True,
    ),
    # ASME Y14.2: thin lines have half the width of thick ones, hidden and centre lines alike.
    "ansi": SheetStyle(
        visible_width=3.6,
        hidden_width=1.8,
        annotation_width=1.8,
        dash=9.0,
        gap=4.0,
        cap=Cap.BUTT,
        centre_lines=True,
        text_place=TextPlace.INLINE,
    ),
    "jpeg30": SheetStyle(jpeg_quality=30),
}
"""The named styles of ``--style``."""


def parse_style(text: str) -> SheetStyle:
    """Read ``NAME``, ``KEY=VALUE,...`` or ``NAME,KEY=VALUE,...``.

    The keys are the attributes of :class:`SheetStyle`, with ``-`` or ``_`` between words.  Colours
    are ``#RRGGBB``, switches ``on`` or ``off``, and ``mm-per-pixel=fit`` fits the sheet.

    Raises:
        UsageError: ``style-unknown``, ``style-key-unknown``, ``style-value-bad``.
    """
    style = PRESETS["clean"]
    for index, part in enumerate(part.strip() for part in text.split(",")):
        if "=" in part:
            style = _overridden(style, part)
        elif index == 0 and part in PRESETS:
            style = PRESETS[part]
        else:
            names = ", ".join(PRESETS)
            raise UsageError(
                Code.STYLE_UNKNOWN,
                f"{part!r} is no style: use one of {names}, or KEY=VALUE",
            )
    return checked_style(style)


def _overridden(style: SheetStyle, part: str) -> SheetStyle:
    key, _, value = part.partition("=")
    name = key.strip().replace("-", "_")
    known = {field.name for field in fields(SheetStyle)}
    if name not in known:
        keys = ", ".join(sorted(known))
        raise UsageError(Code.STYLE_KEY_UNKNOWN, f"{key!r} is no style key: use one of {keys}")
    try:
        return replace(style, **{name: _parser(name)(value.strip())})
    except ValueError as error:
        raise UsageError(Code.STYLE_VALUE_BAD, f"style {part!r}: {error}") from error


def _parser(name: str) -> Callable[[str], Any]:
    special: dict[str, Callable[[str], Any]] = {
        "width": int,
        "height": int,
        "jpeg_quality": int,
        "ink": _colour,
        "paper": _colour,
        "mm_per_pixel": lambda value: None if value == "fit" else float(value),
        "cap": Cap,
        "text_place": TextPlace,
        "antialiasing": _switch,
        "tangent_edges": drawn_policy,
        "hidden": _switch,
        "annotations": _switch,
        "frame": _switch,
        "centre_lines": _switch,
        "picture": _switch,
        "symbol": _switch,
        "inset": lambda value: None if value == "none" else Inset(value),
        "section": lambda value: None if value == "none" else Role(value),
        "broken": lambda value: None if value == "none" else Role(value),
        "half": lambda value: None if value == "none" else Role(value),
        "threads": _switch,
        "section_kind": SectionKind,
    }
    return special.get(name, float)


def _colour(text: str) -> Colour:
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", text):
        raise ValueError("a colour is #RRGGBB")
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def _switch(text: str) -> bool:
    if text in ("on", "true", "1", "yes"):
        return True
    if text in ("off", "false", "0", "no"):
        return False
    raise ValueError("a switch is on or off")


_LIMITS: dict[str, tuple[float, float]] = {
    "width": (64, 20000),
    "height": (64, 20000),
    "visible_width": (0.3, 100),
    "hidden_width": (0.3, 100),
    "dash": (1, 1000),
    "gap": (1, 1000),
    "margin": (0, 5000),
    "view_gap": (0, 5000),
    "hatch_pitch": (4, 500),
    "skew": (-45, 45),
    "blur": (0, 50),
    "noise": (0, 100),
    "jpeg_quality": (1, 100),
    "annotation_width": (0.3, 100),
    "text_height": (4, 500),
    "bleed": (0, 20),
    "fade": (0, 1),
    "specks": (0, 5000),
    "contrast": (1, 10),
    "light": (0, 1),
    "shadow": (0, 1000),
    "salt": (0, 1),
}


def checked_style(style: SheetStyle) -> SheetStyle:
    """The style itself, if all its values make sense.

    Raises:
        UsageError: ``style-value-bad``.
    """
    for name, (low, high) in _LIMITS.items():
        value = getattr(style, name)
        if not low <= value <= high:
            raise UsageError(
                Code.STYLE_VALUE_BAD,
                f"style {name} = {value}: choose a value from {low} to {high}",
            )
    scale = style.mm_per_pixel
    if scale is not None and not 0.0 < scale < float("inf"):
        raise UsageError(
            Code.STYLE_VALUE_BAD,
            f"style mm_per_pixel = {scale}: choose a positive number, or fit",
        )
    return style

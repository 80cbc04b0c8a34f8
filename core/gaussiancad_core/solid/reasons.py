"""Why a solid is not verified: codes, and a sentence for each."""

from collections.abc import Sequence

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.evidence.ink_offsets import InkOffset
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role, mutually_orthogonal
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.verify import Verification
from gaussiancad_protocol.codes import Code

Reason = tuple[str, str]
"""A kebab-case code, and a sentence: a :class:`.Message` where it has values."""

ASSUMED = Code.ASSUMED
"""Code of what rests on something that no line says."""

NONE: Reason = Code.NO_SOLID_FITS, "no solid has these lines: they contradict each other"
UNBUILT: Reason = (
    Code.NO_VALID_SOLID,
    "the cells that fit the lines best bound no closed solid: lines are missing or wrong",
)
UNFINISHED: Reason = (
    Code.SEARCH_UNFINISHED,
    "the search for solids with these lines was not completed",
)
GUARDED: Reason = (
    Code.SEARCH_UNFINISHED,
    Message(
        "the clock ended the search, after many times as long as it takes on an ordinary machine: "
        "run the sheet again where less else is running",
        case="clock",
    ),
)
UNDRAWN: Reason = (
    ASSUMED,
    "no view has a hidden line: that nothing lies within the part that no view shows was assumed",
)


def undrawn_in(roles: Sequence[Role]) -> Reason:
    """That another solid has all lines if some views, which have no hidden line, draw none."""
    template = (
        "the {views} view{have} no hidden line: that none was left out there was assumed; "
        "otherwise another solid has all lines, too: see alternatives/"
    )
    names = " and ".join(role.value for role in roles)
    have = "s have" if len(roles) > 1 else " has"
    return ASSUMED, Message(template, case="views", views=names, have=have)


_RETOLD: Reason = (
    Code.LINETYPES_RETOLD,
    "hidden lines no longer than a dash look like visible ones: some are taken for the other kind, "
    "as the other views have it",
)
_ASKEW: Reason = (
    Code.LINES_APART,
    Message(
        "a short line of the sheet runs in a direction that no line of the solid near it has: a "
        "small rounding or chamfer may be missing",
        case="direction",
    ),
)
_THIN: Reason = (
    Code.FACES_THIN,
    "long faces narrower than two pixels, which no view can show: they may be left between lines "
    "that belong together",
)


def has_hidden_lines(views: DrawnViews) -> bool:
    """Whether any view has a hidden line: where none has, hidden lines may not be drawn at all."""
    return any(
        stroke.linetype is Linetype.HIDDEN for curves in views.strokes.values() for stroke in curves
    )


def reasons_of(
    verification: Verification, agreeing: int, complete: bool, views: DrawnViews
) -> list[Reason]:
    """Why a solid is not certain to be the part.

    Args:
        verification: of the solid.
        agreeing: how many solids have all lines.
        complete: whether all solids that there may be were looked at.
        views: that it was made from.
    """
    reasons: list[Reason] = []
    if len(views.roles) > 1 and not mutually_orthogonal(views.roles):
        reasons.append(
            (Code.TWO_VIEWS, "only two directions of view: what a third would show is not known")
        )
    if not verification.sound:
        reasons.append((Code.SOLID_UNSOUND, "the solid is not one valid closed body"))
    if verification.flaws:
        reasons.append(_unexplained(verification))
    if verification.relaxed_linetypes:
        reasons.append(_RETOLD)
    if verification.apart:
        reasons.append(_apart(verification))
    elif verification.askew:
        reasons.append(_ASKEW)
    if verification.thin:
        reasons.append(_THIN)
    if not has_hidden_lines(views):
        reasons.append(UNDRAWN)
    if agreeing > 1:
        reasons.append(
            (
                Code.AMBIGUOUS,
                Message(
                    "{count} different solids have these lines: see alternatives/", count=agreeing
                ),
            )
        )
    if not complete:
        reasons.append(UNFINISHED)
    return reasons


def ink_off_line(offset: InkOffset, pixel: float) -> Reason:
    """That the ink runs off a line of the solid.

    Args:
        offset: where, and how far.
        pixel: mm per px.
    """
    right, up = offset.place
    return (
        Code.LINES_APART,
        Message(
            "the ink lies {distance_mm:.2g} mm off the solid's line at ({right:.1f}, {up:.1f}) "
            "mm of the {view} view: a curve may have been misread there",
            case="ink",
            distance_mm=offset.offset * pixel,
            right=right,
            up=up,
            view=offset.role,
        ),
    )


def _unexplained(verification: Verification) -> Reason:
    worst = verification.flaws[0]
    others = len(verification.flaws) - 1
    right, up = worst.place
    return (
        Code.LINES_UNEXPLAINED,
        Message(
            "the solid {what} a line of {length_mm:.1f} mm that the {view} view {has}, at "
            "({right:.1f}, {up:.1f}) mm{more}",
            case="missing" if worst.missing else "beyond",
            what="does not show" if worst.missing else "shows",
            length_mm=worst.length,
            view=worst.role,
            has="has" if worst.missing else "has not",
            right=right,
            up=up,
            more=f", and {others} more" if others else "",
            count=others + 1,
        ),
    )


def _apart(verification: Verification) -> Reason:
    spread, misfit = verification.spread, verification.misfit
    if misfit > spread:
        case, where = (
            "extent",
            "the views reach up to {distance_mm:.2g} mm beyond the solid, or less far",
        )
    else:
        case, where = "line", "a line of the sheet lies {distance_mm:.2g} mm off the solid's"
    template = where + ": a small step may be missing"
    return Code.LINES_APART, Message(template, case=case, distance_mm=max(misfit, spread))

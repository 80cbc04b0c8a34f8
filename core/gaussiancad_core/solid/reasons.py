"""Why a solid is not verified: codes, and a sentence for each."""

from collections.abc import Sequence

from gaussiancad_core.axes import Role, mutually_orthogonal
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.solid.verify import Verification
from gaussiancad_core.verification.ink_offsets import InkOffset
from gaussiancad_core.views import Linetype

Reason = tuple[str, str]
"""A kebab-case code, and a sentence."""

ASSUMED = "assumed"
"""Code of what rests on something that no line says."""

NONE: Reason = "no-solid-fits", "no solid has these lines: they contradict each other"
UNBUILT: Reason = (
    "no-valid-solid",
    "the cells that fit the lines best bound no closed solid: lines are missing or wrong",
)
LOOSE: Reason = (
    "lines-apart",
    "lines miss each other by more than they should: those that are close by were taken to meet, "
    "so that small steps may be missing",
)
UNFINISHED: Reason = (
    "search-unfinished",
    "the search for solids with these lines was not completed",
)
GUARDED: Reason = (
    "search-unfinished",
    "the clock ended the search, after many times as long as it takes on an ordinary machine: run "
    "the sheet again where less else is running",
)
UNDRAWN: Reason = (
    ASSUMED,
    "no view has a hidden line: that nothing lies within the part that no view shows was assumed",
)


def undrawn_in(roles: Sequence[Role]) -> Reason:
    """That another solid has all lines if some views, which have no hidden line, draw none."""
    names = " and ".join(role.value for role in roles)
    return (
        ASSUMED,
        f"the {names} view{'s have' if len(roles) > 1 else ' has'} no hidden line: that none was "
        "left out there was assumed; otherwise another solid has all lines, too: see alternatives/",
    )


_RETOLD: Reason = (
    "linetypes-retold",
    "hidden lines no longer than a dash look like visible ones: some are taken for the other kind, "
    "as the other views have it",
)
_THIN: Reason = (
    "faces-thin",
    "long faces narrower than two pixels, which no view can show: they may be left between lines "
    "that belong together",
)


def has_hidden_lines(views: DrawnViews) -> bool:
    """Whether any view has a hidden line: where none has, hidden lines may not be drawn at all."""
    return any(
        stroke.linetype is Linetype.HIDDEN for own in views.strokes.values() for stroke in own
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
    if not mutually_orthogonal(views.roles):
        reasons.append(
            ("two-views", "only two directions of view: what a third would show is not known")
        )
    if not verification.sound:
        reasons.append(("solid-unsound", "the solid is not one valid closed body"))
    if verification.flaws:
        reasons.append(_unexplained(verification))
    if verification.retold:
        reasons.append(_RETOLD)
    if verification.apart:
        reasons.append(_apart(verification))
    if verification.thin:
        reasons.append(_THIN)
    if not has_hidden_lines(views):
        reasons.append(UNDRAWN)
    if agreeing > 1:
        reasons.append(
            ("ambiguous", f"{agreeing} different solids have these lines: see alternatives/")
        )
    if not complete:
        reasons.append(UNFINISHED)
    return reasons


def beside_ink(offset: InkOffset, pixel: float) -> Reason:
    """That the ink runs beside a line of the solid.

    Args:
        offset: where, and how far.
        pixel: mm per px.
    """
    right, up = offset.place
    return (
        "lines-apart",
        f"the ink lies {offset.offset * pixel:.2g} mm beside the solid's line at ({right:.1f}, "
        f"{up:.1f}) mm of the {offset.role.value} view: a curve may have been misread there",
    )


def _unexplained(verification: Verification) -> Reason:
    worst = verification.flaws[0]
    what = "does not show" if worst.missing else "shows"
    others = len(verification.flaws) - 1
    more = f", and {others} more" if others else ""
    return (
        "lines-unexplained",
        f"the solid {what} a line of {worst.length:.1f} mm that the {worst.role.value} "
        f"view has{'' if worst.missing else ' not'}, at ({worst.place[0]:.1f}, "
        f"{worst.place[1]:.1f}) mm{more}",
    )


def _apart(verification: Verification) -> Reason:
    spread, misfit = verification.spread, verification.misfit
    if misfit > spread:
        where = f"the views reach up to {misfit:.2g} mm beyond the solid, or less far"
    else:
        where = f"a line of the sheet lies {spread:.2g} mm beside the solid's"
    return "lines-apart", f"{where}: a small step may be missing"

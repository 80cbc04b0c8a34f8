"""A solid that has all lines of a sheet, compared with the ink that these were read from."""

from gaussiancad_core.evidence.ink_offsets import ink_offsets
from gaussiancad_core.evidence.projected_reading import APART_PX
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.reasons import ink_off_line
from gaussiancad_protocol.modes import Status


def compared_with_ink(
    result: ExactResult, registered: RegisteredSheet, sheet: OpenedSheet
) -> ExactResult:
    """The same, in doubt if the ink runs off a line of the solid.

    Views whose lines are those of a file are not asked: their ink was drawn from them.

    Args:
        result: the solid of the sheet.
        registered: its views.
        sheet: as stored and upright.
    """
    if result.status is not Status.VERIFIED:
        return result
    found = [
        offset
        for view in registered.drawn
        if view.source is StrokesSource.RASTER
        for offset in ink_offsets(
            view.role,
            result.checked.lines[view.role],
            registered.placements[view.role],
            sheet.clean,
        )
    ]
    worst = max(found, key=lambda offset: offset.offset, default=None)
    if worst is None or worst.offset <= APART_PX:
        return result
    return result.doubted(ink_off_line(worst, registered.mm_per_pixel))

"""Where a sheet has ink, whatever anybody took it for."""

from collections.abc import Mapping
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.judging.faceted_solids import Floats
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionRole
from gaussiancad_core.sheet.registration.view_registration import Placement

_NEAR_PX = 2.0
"""px from ink within which a line lies on it."""


@dataclass(frozen=True, eq=False)
class SheetInk:
    """The ink of a sheet, and where its views lie on it.

    Attributes:
        away: (h, w) float32 px to the nearest ink, of the upright sheet.
        placements: of each view on it.
    """

    away: npt.NDArray[np.float32]
    placements: Mapping[Role | SectionRole, Placement]

    def covers(self, role: Role | SectionRole, places: Floats) -> npt.NDArray[np.bool_]:
        """(n,) whether there is ink at places of a view.

        Args:
            role: of the view.
            places: (n, 2) mm in its plane (right, up).
        """
        if not len(places):
            return np.zeros(0, bool)
        height, width = self.away.shape
        x, y = np.floor(self.placements[role].to_sheet(places)).astype(np.int64).T
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        away = self.away[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]
        return inside & (away <= _NEAR_PX)


def placements_of(reading: ProjectedReading) -> dict[Role | SectionRole, Placement]:
    """Where the views of a reading, and the sections beside them, lie on the sheet."""
    found: dict[Role | SectionRole, Placement] = {}
    found.update(reading.registered.placements.items())
    found.update((role, section.place) for role, section in reading.adjacent_sections.items())
    return found


def distance_to_ink(ink: npt.NDArray[np.bool_]) -> npt.NDArray[np.float32]:
    """(h, w) px from each pixel to the nearest with ink."""
    blank = np.where(ink, 0, 255).astype(np.uint8)
    return np.asarray(cv2.distanceTransform(blank, cv2.DIST_L2, 3), dtype=np.float32)

"""A sheet as it was stored, and upright: how it lies, and its ink where anybody asks for it.

The strokes of a file tell how it lies, and what it shows, without a look at their picture.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.sheet.image.deskew import Turn, file_directions, find_turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.reading_options import MEDIAN_KERNEL
from gaussiancad_core.structure.arrowheads import Head, arrowheads


@dataclass(frozen=True, eq=False)
class OpenedSheet:
    """A sheet as it was stored and upright.

    Attributes:
        image: as stored.
        median_kernel: side in px of the filter that takes specks off its ink; 0 for none.
    """

    image: SheetImage
    median_kernel: int = MEDIAN_KERNEL

    @cached_property
    def turn(self) -> Turn:
        """By which it is turned to be upright, and px of the sheet as stored per px of it.

        The strokes of a file tell it where they are all there is on the sheet, or all that is as
        long: then its pictures, such as a logo, say less of it.

        Raises:
            NoModelError: as of :attr:`clean`, which is asked where no strokes tell it.
        """
        return self._by_strokes or self.clean.turn

    @property
    def clean(self) -> CleanSheet:
        """The ink of the upright sheet, told from its paper.

        Raises:
            NoModelError: there is no ink, or too much of it for a line drawing.
        """
        found = self._cleaned
        if isinstance(found, NoModelError):
            # A new one each time: one that is raised keeps all that its callers hold.
            raise NoModelError(found.code, found.message)
        return found

    @cached_property
    def _cleaned(self) -> CleanSheet | NoModelError:
        """The ink, or why there is none: that takes as long to find."""
        # What reads pixels is compiled: a sheet whose strokes are known waits for none of it.
        from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet

        try:
            ink = clean_sheet(self.image.grey, self.median_kernel)
            found = upright_sheet(ink, self._by_strokes)
        except NoModelError as error:
            return NoModelError(error.code, error.message)
        return replace(found, turn=self._scaled(found.turn))

    @cached_property
    def heads(self) -> tuple[Head, ...]:
        """The arrowheads that its file draws, px of the sheet as stored."""
        drawing = self.image.vectors
        return arrowheads(drawing.strokes) if drawing is not None else ()

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the upright sheet, px."""
        height, width = self.image.grey.shape
        return height, width

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the sheet as stored, px."""
        height, width = self.image.grey.shape
        return round(width * self.image.reduction), round(height * self.image.reduction)

    @property
    def picture(self) -> tuple[npt.NDArray[np.uint8], float]:
        """(h, w) uint8, and px of the sheet as stored per px of it."""
        return self.image.grey, self.image.reduction

    @cached_property
    def _by_strokes(self) -> Turn | None:
        drawing = self.image.vectors
        if drawing is None or not drawing.strokes:
            return None
        directions, lengths = file_directions(drawing)
        if not drawing.complete and _longest_pictured(drawing) >= max(lengths, default=0.0):
            return None
        return self._scaled(find_turn(directions, lengths, self.shape))

    def _scaled(self, turn: Turn) -> Turn:
        return replace(turn, scale=self.image.reduction)


def _longest_pictured(drawing: VectorDrawing) -> float:
    """px of a line that what a page shows besides strokes may have at most."""
    sides = [(box[2] - box[0], box[3] - box[1]) for box in drawing.pictures]
    return max((float(np.hypot(*side)) for side in sides), default=np.inf)

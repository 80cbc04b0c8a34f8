"""What an opened sheet keeps of what was asked of it."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet.image import clean_ink
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage


def test_why_there_is_no_ink_is_found_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    real = clean_ink.clean_sheet

    def counted(grey: np.ndarray, kernel: int) -> object:
        asked.append(kernel)
        return real(grey, kernel)

    monkeypatch.setattr(clean_ink, "clean_sheet", counted)
    blank = OpenedSheet(SheetImage(Path("sheet.png"), np.full((300, 400), 255, np.uint8), ""))
    errors = []
    for _ in range(3):
        with pytest.raises(NoModelError) as stated:
            _ = blank.clean
        errors.append(stated.value)
    assert [error.code for error in errors] == ["blank-sheet"] * 3
    assert len(asked) == 1 and len(set(map(id, errors))) == 3


@pytest.mark.parametrize("pictures", [(), ((0.0, 0.0, 90.0, 90.0),), ((0.0, 0.0, 350.0, 200.0),)])
def test_lines_longer_than_what_pictures_show_tell_how_a_sheet_lies(
    pictures: tuple[Box, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A logo says less than a frame; a scan that fills its sheet has to be seen, and what the file
    does not say where it is."""
    seen = Turn(0.01, (200.0, 150.0))
    monkeypatch.setattr(OpenedSheet, "clean", SimpleNamespace(turn=seen))
    angle = 0.02
    end = (20.0 + 300.0 * np.cos(angle), 30.0 + 300.0 * np.sin(angle))
    drawing = VectorDrawing(
        (VectorStroke(LineSegment((20.0, 30.0), end), 2.0),), (), complete=False, pictures=pictures
    )
    paper = np.full((300, 400), 255, np.uint8)
    turn = OpenedSheet(SheetImage(Path("sheet.pdf"), paper, "", vectors=drawing)).turn
    stated = bool(pictures) and pictures[0][2] < 100.0
    assert turn.angle == pytest.approx(angle if stated else seen.angle)

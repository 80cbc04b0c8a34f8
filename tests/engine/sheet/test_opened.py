"""What an opened sheet keeps of what was asked of it."""

from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet import opened
from gaussiancad_core.sheet.opened import OpenedSheet
from gaussiancad_core.sheet.read import SheetImage


def test_why_there_is_no_ink_is_found_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    real = opened.clean_sheet

    def counted(grey: np.ndarray, kernel: int) -> object:
        asked.append(kernel)
        return real(grey, kernel)

    monkeypatch.setattr(opened, "clean_sheet", counted)
    blank = OpenedSheet(SheetImage(Path("sheet.png"), np.full((300, 400), 255, np.uint8), ""))
    errors = []
    for _ in range(3):
        with pytest.raises(NoModelError) as told:
            _ = blank.clean
        errors.append(told.value)
    assert [error.code for error in errors] == ["blank-sheet"] * 3
    assert len(asked) == 1 and len(set(map(id, errors))) == 3

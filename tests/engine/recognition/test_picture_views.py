"""What a picture is asked before its ink is labelled."""

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.recognition import picture_views


def test_more_pieces_of_ink_than_any_drawing_has_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_views, "_MOST_PIECES", 12)
    ink = np.zeros((40, 40), dtype=bool)
    ink[:24:8, :32:8] = True
    picture_views._check_pieces(ink)
    ink[32, 0] = True
    with pytest.raises(NoModelError, match="13 separate strokes, at most 12") as caught:
        picture_views._check_pieces(ink)
    assert caught.value.code == "part-too-complex"

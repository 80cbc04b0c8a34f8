"""Ellipses fitted again to their ink."""

import numpy as np

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ellipse_fits import refit_ellipse


def test_without_strokes_an_ellipse_stays_as_it_is() -> None:
    grey = np.full((200, 200), 255, np.uint8)
    grey[20:180, 20:24] = grey[20:180, 176:180] = 0
    ellipse = WholeEllipse((100.0, 100.0), 60.0, 40.0, 0.1)
    assert refit_ellipse(clean_sheet(grey), ellipse, []) is ellipse

"""What the labels of pixels say of hidden against visible ink."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.log_odds import OF_A_POINT

TOLD = 2.0
"""Log-odds from which ink is hidden, or visible, whatever its length says."""


def label_odds(sheet: CleanSheet, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """(n,) log-odds of hidden at points (n, 2) px; 0 where no labels told."""
    if sheet.hidden_odds is None:
        return np.zeros(len(points))
    return np.clip(values_at(sheet.hidden_odds, points).astype(np.float64), -OF_A_POINT, OF_A_POINT)

"""What the network learns from: a piece of a picture, and what each pixel of it stands for."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Bytes = npt.NDArray[np.uint8]

UNKNOWN = 255
"""Class, or extra, of a pixel of which nothing is known: it counts for nothing."""

SOME_ANNOTATION = 200
"""Class of a pixel that is annotation of some kind: published sheets do not tell which."""

ON_HIDDEN, EITHER = 1, 3
"""Lowest two bits of the extra: on a hidden line, dash or gap; on one that a visible edge covers,
which counts for nothing."""

HEAT_SHIFT, HEAT_MOST = 2, 15
"""Where in the extra the heat of corners begins, and its largest value, at a corner."""


@dataclass(frozen=True, eq=False)
class Sample:
    """A picture with the truth.

    Attributes:
        grey: (h, w) dark ink on light paper, or now and then light on dark.
        classes: (h, w) :class:`.InkClass` of each pixel, :data:`SOME_ANNOTATION` or
            :data:`UNKNOWN`.
        extra: (h, w) :data:`ON_HIDDEN` or :data:`EITHER` or 0, plus the heat of corners shifted by
            :data:`HEAT_SHIFT`; :data:`UNKNOWN` where nothing is known.
    """

    grey: Bytes
    classes: Bytes
    extra: Bytes

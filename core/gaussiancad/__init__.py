"""GaussianCAD: from an engineering drawing to a part that one can go on modelling with.

    >>> import gaussiancad
    >>> result = gaussiancad.reconstruct("sheet.png", result="solid", length={"x": 60})
    >>> result.status
    'verified'
    >>> result.report["solid"]["bounding_box_mm"]
    [60.0, 37.5, 45.0]

``reconstruct`` reads a sheet and makes the part; ``read``, ``correct`` and ``solve`` do the same in
steps; ``explain`` says why they are what they are.  ``check`` tells whether a part agrees with its
drawing, ``compare`` measures it against another, ``features`` finds what it is made of, ``draw``
draws it.  Every error is an :class:`Error` with a ``code`` and a sentence that says what to do.

The engine runs in a process of its own: importing this package loads no library beside Python's
own, and a geometry kernel that crashes raises an error here.
"""

from gaussiancad.checks import Check, check
from gaussiancad.explanations import explain
from gaussiancad.models import Comparison, compare, draw, features
from gaussiancad.part_result import Finding, Result
from gaussiancad.sheet_reading import Problem, Reading, Stroke, View
from gaussiancad.sheets import correct, read, reconstruct, solve
from gaussiancad_core import __version__
from gaussiancad_core.errors import (
    CancelledError,
    EngineError,
    LimitError,
    NoModelError,
    UnreadableError,
    UsageError,
)
from gaussiancad_core.errors import GaussianCadError as Error

__all__ = [
    "CancelledError",
    "Check",
    "Comparison",
    "EngineError",
    "Error",
    "Finding",
    "LimitError",
    "NoModelError",
    "Problem",
    "Reading",
    "Result",
    "Stroke",
    "UnreadableError",
    "UsageError",
    "View",
    "__version__",
    "check",
    "compare",
    "correct",
    "draw",
    "explain",
    "features",
    "read",
    "reconstruct",
    "solve",
]

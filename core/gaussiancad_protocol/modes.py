"""The choices of a run, as enums; the values are the names in options and files."""

from enum import Enum


class Recipe(Enum):
    """Which cameras and training: the project's default, or the GaussianCAD paper's."""

    ORTHOGRAPHIC = "orthographic"
    PAPER = "paper"


class Preset(Enum):
    """How much work is done."""

    DRAFT = "draft"
    STANDARD = "standard"
    FINE = "fine"


class ResultKind(Enum):
    """Which models are asked for."""

    BOTH = "both"
    SOLID = "solid"
    SURFACE = "surface"


class SolidWay(Enum):
    """In which ways an exact solid is looked for; one in which a library breaks down is left out,
    with all before it."""

    ALL = "all"
    SKETCH = "sketch"
    NONE = "none"

    @property
    def less(self) -> "SolidWay":
        """What is left without the first of them."""
        return SolidWay.SKETCH if self is SolidWay.ALL else SolidWay.NONE


class Device(Enum):
    """Where the Gaussians are trained."""

    AUTO = "auto"
    CPU = "cpu"
    CUDA = "cuda"


class Status(Enum):
    """How far a result can be trusted."""

    VERIFIED = "verified"
    APPROXIMATE = "approximate"
    FAILED = "failed"

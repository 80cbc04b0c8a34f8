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

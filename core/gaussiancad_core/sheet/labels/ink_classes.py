"""What ink stands for on a drawing: the classes of the labels network, and what tells them."""

from enum import Enum, IntEnum


class InkClass(IntEnum):
    """The classes in the order of the network's outputs."""

    PAPER = 0
    VISIBLE = 1
    HIDDEN = 2
    CENTRE = 3
    DIMENSION = 4
    HATCHING = 5
    TEXT = 6
    FRAME = 7
    PICTORIAL = 8
    OTHER = 9
    THIN = 10
    """Tangent edges and thread circles drawn thin or in phantom."""


class Evidence(Enum):
    """What decided what a line stands for."""

    NETWORK = "network"
    """How its ink looks."""

    PEN = "pen"
    """Its width, colour or rhythm, against the network."""

    LINE = "line"
    """The rest of the line that it is a piece of, against its own ink."""

    FIGURE = "figure"
    """The figure that it hangs together with: all of it is of a view, or of a pictorial."""

    LOOSE_END = "loose-end"
    """Its ends: edges end at edges."""

    LINETYPE = "linetype"
    """Its dashes, or its pen: it is an edge, and visible or hidden."""

    FILE = "file"
    """The file, which has it as a line of its own."""

    PERSON = "person"
    """Somebody said so."""


BY_LABELS = (
    Evidence.NETWORK,
    Evidence.PEN,
    Evidence.LINE,
    Evidence.FIGURE,
    Evidence.LOOSE_END,
)
"""What tells edges from annotation in a picture."""

PART = (InkClass.VISIBLE, InkClass.HIDDEN)
"""What shows the part's edges; all else but paper is annotation."""

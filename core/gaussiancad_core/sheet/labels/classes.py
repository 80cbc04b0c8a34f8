"""What ink stands for on a drawing: the classes of the labels network."""

from enum import IntEnum

from gaussiancad_core.drawing.annotation import AnnotationKind


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


PART = (InkClass.VISIBLE, InkClass.HIDDEN)
"""What shows the part's edges; all else but paper is annotation."""

ANNOTATION_KINDS = {
    InkClass.CENTRE: AnnotationKind.CENTRE_LINE,
    InkClass.DIMENSION: AnnotationKind.DIMENSION,
    InkClass.HATCHING: AnnotationKind.HATCHING,
    InkClass.TEXT: AnnotationKind.TEXT,
    InkClass.FRAME: AnnotationKind.FRAME,
    InkClass.PICTORIAL: AnnotationKind.PICTURE,
    InkClass.OTHER: AnnotationKind.SYMBOL,
    InkClass.THIN: AnnotationKind.TANGENT_EDGE,
}
"""What a mark of each class is."""

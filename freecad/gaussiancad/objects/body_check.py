"""Whether a body is the solid that it was made from."""

from dataclasses import dataclass

import Part

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.smooth_faces import count_faces, have_same_faces

GREATEST_SHARE = 1e-6
"""Of the solid's volume: what may lie in one of two equal solids and not in the other."""


_NOISE = 1e-5
"""Share of a volume by which FreeCAD's volumes of one solid differ, cut into faces otherwise."""


@dataclass(frozen=True)
class BodyCheck:
    """How a body compares with the exact solid.

    Attributes:
        solids: of the body; 1 of a good one.
        valid: whether the body's shape is a valid one.
        share: volume that lies in one and not in the other, as a share of the solid's.
        faces: of the body, those of one surface that touch taken together.
        expected_faces: of the solid, likewise.
    """

    solids: int
    valid: bool
    share: float
    faces: int
    expected_faces: int

    @property
    def is_equal(self) -> bool:
        """Whether nothing tells them apart."""
        return not self.words

    @property
    def words(self) -> str:
        """What tells them apart, for who uses the window; empty where nothing does."""
        if self.solids != 1 or not self.valid:
            return translate("GaussianCAD", "the features do not make one valid solid")
        if not self.share <= GREATEST_SHARE:
            text = translate("GaussianCAD", "{percent} % of the volume differ")
            return text.format(percent=f"{100.0 * self.share:.2g}")
        if self.faces != self.expected_faces:
            text = translate("GaussianCAD", "there are {found} faces instead of {expected}")
            return text.format(found=self.faces, expected=self.expected_faces)
        return ""


def check_body(made: Part.Shape, exact: Part.Shape) -> BodyCheck:
    """Compare the shape of a body with the exact solid, both in the same coordinates."""
    solids = len(made.Solids)
    valid = not made.isNull() and made.isValid()
    if solids != 1 or not valid:
        return BodyCheck(solids, valid, 1.0, len(made.Faces), len(exact.Faces))
    solid, wanted = made.Solids[0], exact.Solids[0]
    share = _difference(solid, wanted) / wanted.Volume
    return BodyCheck(solids, valid, share, count_faces(solid), count_faces(wanted))


def _difference(first: Part.Shape, second: Part.Shape) -> float:
    """Volume of what lies in one of two solids only, in mm3.

    Where two solids have all their faces in common FreeCAD may fail to cut them.  Then that they
    have tells that they are one.
    """
    least = first.Volume - second.Volume
    noise = _NOISE * second.Volume
    try:
        alone, lacking = first.cut(second).Volume, second.cut(first).Volume
        if abs(least - (alone - lacking)) <= noise and alone + lacking <= noise:
            return alone + lacking
    except Exception:  # FreeCAD raises its own types, which differ between versions
        alone = lacking = second.Volume
    if abs(least) <= noise and have_same_faces(first, second):
        return 0.0
    return max(abs(least), alone + lacking)

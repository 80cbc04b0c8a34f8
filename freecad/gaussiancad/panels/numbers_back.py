"""Bodies get the drawing's numbers again; what stands in the way is told."""

from collections.abc import Sequence

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.sheet_numbers import back_step, set_back
from freecad.gaussiancad.panels.messages import show_error


def take_back(bodies: Sequence[FreeCAD.DocumentObject]) -> None:
    """Set all numbers of bodies back to the drawing's, in one undo step."""
    try:
        count = set_back(bodies)
    except ValueError as error:
        show_error(back_step(), str(error))
        return
    if not count:
        text = translate("GaussianCAD", "No body has a number that is another than on the sheet.")
        show_error(back_step(), text)

"""What the labels of lines leave in doubt: told, and handed on to the search for the solid."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.labels.label_evidence import SheetLabels, meets
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_protocol.codes import Code

DOUBTFUL = Code.LABELS_DOUBTFUL
"""Code of lines that may be edges or annotation."""

_MOST_PLACES = 5
"""Boxes that the message names at most."""


def weighed_views(drawn: Sequence[ReadView], labels: SheetLabels) -> tuple[ReadView, ...]:
    """The views with the labels of their lines, and strokes that are as sure as these.

    Args:
        drawn: as they were read.
        labels: of the sheet; without any the views stay as they are.
    """
    if not labels.lines:
        return tuple(drawn)
    found = []
    for view in drawn:
        within = labels.within(view.box)
        found.append(replace(view, strokes=within.weighed(view.strokes), labels=within))
    return tuple(found)


def tell_doubtful_labels(
    notes: RunNotes, labels: SheetLabels, views: Mapping[Role, Box], turn: Turn
) -> None:
    """Say which lines in the views may be edges or annotation: then no solid is certain.

    Args:
        notes: told.
        labels: of the sheet.
        views: boxes, px of the upright sheet.
        turn: of the sheet.
    """
    boxes = [
        turn.box_to_stored(line.box)
        for line in labels.doubtful()
        if any(meets(line.box, view) for view in views.values())
    ]
    if not boxes:
        return
    places = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES])
    message = Message(
        "{count} line(s) may be edges of the part or annotation, at {places} px",
        boxes=boxes,
        count=len(boxes),
        places="; ".join(places),
    )
    notes.doubt(DOUBTFUL, message)

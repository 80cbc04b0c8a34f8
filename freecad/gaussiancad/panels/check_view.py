"""What a check found: the verdict, why, where both differ, and what to change.

It shows what one run left; marks in the 3D view are taken off with it, and the document stays as it
is.
"""

from pathlib import Path

import FreeCAD
from pivy import coin

from freecad.gaussiancad.engine.check_file import (
    CheckDifference,
    CheckEdit,
    DifferenceKind,
    SheetCheck,
)
from freecad.gaussiancad.engine.check_words import (
    difference_words,
    edit_words,
    size_words,
    verdict_words,
    view_words,
)
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.placing import FRAMES
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.panels.pieces_view import Colour, MarkedPieces, PiecesMark
from freecad.gaussiancad.panels.row_table import RowLook, RowTable
from freecad.gaussiancad.panels.sheet_picture import SheetPicture
from freecad.gaussiancad.qt import QtCore, QtWidgets

COLOURS: dict[DifferenceKind | None, Colour] = {
    DifferenceKind.MISSING: (0.84, 0.37, 0.0),
    DifferenceKind.EXTRA: (0.80, 0.20, 0.60),
    DifferenceKind.LINETYPE: (0.0, 0.45, 0.70),
    DifferenceKind.PLACE: (0.90, 0.62, 0.0),
    DifferenceKind.NUMBER: (0.0, 0.62, 0.45),
    DifferenceKind.NOTE: (0.0, 0.62, 0.45),
    None: (0.5, 0.5, 0.5),
}
"""Those of the engine's picture (Okabe and Ito)."""

_EDIT = (0.0, 0.62, 0.45)
"""Green of the same set."""

_TABS = 2
"""Those that are always there; the drawing comes after them."""


class CheckView(QtWidgets.QWidget):
    """The part of a panel that shows a check."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Result"))
        self._check: SheetCheck | None = None
        self._mark: PiecesMark | None = None
        self._size = 1.0
        self.verdict = _text("verdict")
        font = self.verdict.font()
        font.setBold(True)
        self.verdict.setFont(font)
        self.reasons = _text("reasons")
        self.stale = _text("stale")
        self.differences = RowTable(
            "differences",
            (
                translate("GaussianCAD", "View"),
                "mm",
                translate("GaussianCAD", "Difference"),
            ),
            self._choose_difference,
        )
        self.edits = RowTable(
            "edits",
            ("mm", translate("GaussianCAD", "Change of the model")),
            self._choose_edit,
        )
        self.edits.verticalHeader().hide()
        self.edits.setToolTip(
            translate(
                "GaussianCAD",
                "Single changes with which the model explains more of the drawing, and how many "
                "millimetres of its lines",
            )
        )
        self.tabs = QtWidgets.QTabWidget()
        self.tabs.setObjectName("checkTabs")
        self.tabs.addTab(self.differences, translate("GaussianCAD", "Differences"))
        self.tabs.addTab(self.edits, translate("GaussianCAD", "Changes"))
        layout = QtWidgets.QVBoxLayout(self)
        for widget in (self.verdict, self.stale, self.reasons, self.tabs):
            layout.addWidget(widget)
        self.clear()

    def show_check(
        self, check: SheetCheck, picture: Path, document: FreeCAD.Document, model: Source
    ) -> None:
        """Show what a run left.

        Args:
            check: of the run.
            picture: of the drawing with the differences over it.
            document: in whose 3D view places are marked.
            model: that was checked.
        """
        self.clear()
        self._check, self._size = check, _size(check, model)
        self._mark = PiecesMark(document)
        self.setEnabled(True)
        self.verdict.setText(verdict_words(check.verdict))
        sentences = [reason.words for reason in check.reasons]
        if not check.is_size_checked:
            sentences.append(size_words())
        self.reasons.setText("\n".join(f"• {sentence}" for sentence in sentences))
        self.reasons.setVisible(bool(sentences))
        self.differences.show_rows(
            [
                (view_words(each), f"{each.length:.3g}", difference_words(each)[0])
                for each in check.differences
            ],
            [RowLook(difference_words(each)[1], COLOURS[each.kind]) for each in check.differences],
        )
        self.edits.show_rows(
            [(f"{each.length:.3g}", edit_words(each)) for each in check.edits],
            [RowLook(edit_words(each)) for each in check.edits],
        )
        if picture.is_file():
            self.tabs.addTab(SheetPicture(picture), translate("GaussianCAD", "Drawing"))
        self._draw(None)

    def tell_stale(self) -> None:
        """Say that the model was changed since."""
        self.stale.setText(translate("GaussianCAD", "The model was changed since: check again."))
        self.stale.show()

    def clear(self) -> None:
        """Show nothing, and take everything off the 3D view."""
        self.take_off()
        self._check = self._mark = None
        for label in (self.verdict, self.reasons, self.stale):
            label.clear()
        self.stale.hide()
        self.differences.show_rows()
        self.edits.show_rows()
        while self.tabs.count() > _TABS:
            self.tabs.widget(_TABS).deleteLater()
            self.tabs.removeTab(_TABS)
        self.setEnabled(False)

    def take_off(self) -> None:
        """Take everything off the 3D view; touches no widget."""
        if self._mark is not None:
            self._mark.clear()

    def _choose_difference(self, number: int) -> None:
        self.edits.forget_choice()
        difference = self._check.differences[number]
        self._draw(number)
        places = [end for piece in difference.pieces for end in piece]
        self._mark.fly_to(places, self._size, self._turn(difference))

    def _choose_edit(self, number: int) -> None:
        self.differences.forget_choice()
        edit = self._check.edits[number]
        places = _places(edit)
        if not places:
            return
        self._draw(None, edit)
        self._mark.fly_to(places, self._size)

    def _draw(self, chosen: int | None, edit: CheckEdit | None = None) -> None:
        """Mark all differences, and thick the chosen one, or a change of the model."""
        marked = [MarkedPieces(each.pieces, COLOURS[each.kind]) for each in self._check.differences]
        if edit is not None:
            places = _places(edit)
            spots = tuple((place, place) for place in places)
            way = ((places[0], places[-1]),) if len(places) > 1 else ()
            chosen = len(marked)
            marked.append(MarkedPieces((*spots, *way), _EDIT))
        self._mark.show(marked, chosen)

    def _turn(self, difference: CheckDifference) -> coin.SbRotation | None:
        """The turn of a camera that sees the model as the difference's view does."""
        frame = FRAMES.get(difference.view.split(" ")[0])
        if frame is None or self._check.axes is None:
            return None
        right, up, look = (
            sum(
                (
                    FreeCAD.Vector(*axis) * share
                    for axis, share in zip(self._check.axes, way, strict=True)
                ),
                FreeCAD.Vector(),
            )
            for way in (frame.right, frame.up, frame.look)
        )
        # A camera looks against its own z.
        return coin.SbRotation(*FreeCAD.Rotation(right, up, -look, "XYZ").Q)


def _size(check: SheetCheck, model: Source) -> float:
    """mm from corner to corner of a model; of one in a file, of what is marked on it."""
    box = model.box()
    for difference in check.differences:
        for end in (end for piece in difference.pieces for end in piece):
            box.add(FreeCAD.Vector(*end))
    return max(box.DiagonalLength, 1e-6) if box.isValid() else 1.0


def _places(edit: CheckEdit) -> list[tuple[float, float, float]]:
    return [place for place in (edit.start, edit.end) if place is not None]


def _text(name: str) -> QtWidgets.QLabel:
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    return label

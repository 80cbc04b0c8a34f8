"""What a gesture leaves open, asked of a person: a role, a section, a length, a value, a depth."""

from __future__ import annotations

from functools import partial

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.canvas_view import CanvasView
from freecad.gaussiancad.canvas.kinds import ROLES, name_of
from freecad.gaussiancad.canvas.session import Session
from freecad.gaussiancad.canvas.sheet import Box, Number, Point
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


class Dialogs(QtCore.QObject):
    """Menus and boxes for numbers; the answers are corrections of the session.

    Args:
        canvas_view: the canvas, whose gestures ask.
        session: where the sheet is.
        parent: the widget over which is asked, its owner.
    """

    def __init__(
        self, canvas_view: CanvasView, session: Session, parent: QtWidgets.QWidget
    ) -> None:
        super().__init__(parent)
        self._session, self._over = session, parent
        canvas_view.asked_role.connect(self.ask_role)
        canvas_view.asked_section.connect(self.ask_section)
        canvas_view.asked_length.connect(self.ask_length)
        canvas_view.asked_value.connect(self.ask_value)
        canvas_view.asked_depth.connect(self.ask_depth)

    def ask_role(self, box: Box) -> None:
        """Which view a box is."""
        menu = QtWidgets.QMenu(self._over)
        for number, role in enumerate((*ROLES, "pictorial", "ignore"), start=1):
            # A menu that pops up knows no shortcuts, but the keys of its letters.
            key = f"&{number}  " if number <= len(ROLES) else ""
            action = menu.addAction(f"{key}{name_of(role)}")
            action.triggered.connect(partial(self._take_role, role, box))
        menu.popup(QtGui.QCursor.pos())

    def ask_section(self, line: tuple[Point, ...], in_view: str) -> None:
        """Which view shows the section along a line in another; not asked where one may only."""
        found = [section for section in self._session.sheet.sections if section.id != in_view]
        if len(found) == 1:
            self._take_section(found[0].id, line, in_view)
            return
        menu = QtWidgets.QMenu(self._over)
        for item in found:
            action = menu.addAction(name_of(item.role if item.role in ROLES else item.id))
            action.triggered.connect(partial(self._take_section, item.id, line, in_view))
        menu.popup(QtGui.QCursor.pos())

    def ask_length(self, points: tuple[Point, Point]) -> None:
        """How far two points are apart."""
        asked = translate("GaussianCAD", "Length between the two points in mm:")
        length = self._number(translate("GaussianCAD", "Scale"), asked, 100.0)
        if length is not None:
            self._session.correct(corrections.set_distance(points, length))

    def ask_thickness(self, axis: str) -> None:
        """How thick the part is along the axis that its only view does not show."""
        asked = translate("GaussianCAD", "How thick is the part, in mm?")
        thickness = self._number(translate("GaussianCAD", "Thickness"), asked, 10.0)
        if thickness is not None:
            self._session.correct(corrections.set_thickness(axis, thickness))

    def ask_value(self, number: Number) -> None:
        """What a dimension gives."""
        asked = translate("GaussianCAD", "What \u201c{0}\u201d gives, in mm:").format(number.text)
        value = self._number(translate("GaussianCAD", "Dimension"), asked, number.value)
        if value is not None:
            self._session.correct(corrections.set_value(number, value))

    def ask_depth(self, circle: corrections.Circle) -> None:
        """How deep the hole of a circle is."""
        self.ask_depths([circle])

    def ask_depths(self, circles: list[corrections.Circle]) -> None:
        """How deep the holes of circles are, all alike."""
        asked = translate("GaussianCAD", "Depth of the hole in mm:")
        depth = self._number(translate("GaussianCAD", "Hole"), asked, 10.0)
        if depth is not None:
            self._session.correct(
                [stated for circle in circles for stated in corrections.set_hole(circle, depth)]
            )

    def _take_role(self, role: str, box: Box, _checked: bool = False) -> None:
        self._session.correct(corrections.add_view(self._session.sheet, role, box))

    def _take_section(
        self, view: str, line: tuple[Point, ...], in_view: str, _checked: bool = False
    ) -> None:
        self._session.correct(corrections.set_section(view, line, in_view))

    def _number(self, title: str, asked: str, start: float) -> float | None:
        get = QtWidgets.QInputDialog.getDouble
        value, stated = get(self._over, title, asked, start, 0.001, 1e6, 3)
        return value if stated else None

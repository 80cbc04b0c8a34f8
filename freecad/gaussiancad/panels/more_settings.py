"""Rows of settings that a click folds in and out."""

from collections.abc import Callable

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class MoreSettings(QtWidgets.QWidget):
    """A heading that opens by a click, and rows below it.

    Args:
        opened: whether the rows are shown at first.
        on_toggled: is told when they are shown or hidden.
    """

    def __init__(self, opened: bool, on_toggled: Callable[[bool], None]) -> None:
        super().__init__()
        self.heading = QtWidgets.QToolButton()
        self.heading.setObjectName("moreSettings")
        self.heading.setText(translate("GaussianCAD", "More settings"))
        self.heading.setCheckable(True)
        self.heading.setAutoRaise(True)
        style = QtCore.Qt.ToolButtonStyle.ToolButtonTextBesideIcon
        self.heading.setToolButtonStyle(style)
        self._body = QtWidgets.QWidget()
        self.rows = narrow_rows()
        self.rows.setContentsMargins(0, 0, 0, 0)
        self._body.setLayout(self.rows)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.heading)
        layout.addWidget(self._body)
        self.heading.toggled.connect(self._show)
        self.heading.setChecked(opened)
        self._show(opened)
        self.heading.toggled.connect(on_toggled)

    def _show(self, opened: bool) -> None:
        arrows = QtCore.Qt.ArrowType
        self.heading.setArrowType(arrows.DownArrow if opened else arrows.RightArrow)
        self._body.setVisible(opened)


def narrow_rows() -> QtWidgets.QFormLayout:
    """Rows for a narrow panel: a field that does not fit beside its label stands below it."""
    rows = QtWidgets.QFormLayout()
    rows.setFieldGrowthPolicy(QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    rows.setRowWrapPolicy(QtWidgets.QFormLayout.RowWrapPolicy.WrapLongRows)
    return rows

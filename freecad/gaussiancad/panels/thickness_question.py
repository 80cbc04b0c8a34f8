"""The question how thick a part is of which the drawing has one view alone."""

from collections.abc import Callable

from freecad.gaussiancad.engine.job import Scale, ScaleKind
from freecad.gaussiancad.engine.process import RunResult
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtWidgets

_DEFAULT_MM = 10.0

_AXES = {kind.value: kind for kind in (ScaleKind.LENGTH_X, ScaleKind.LENGTH_Y, ScaleKind.LENGTH_Z)}


class ThicknessQuestion(QtWidgets.QWidget):
    """The question with a length and a button; hidden until it is asked.

    An answer holds for all runs of a drawing: the question stays with it until it is taken back.

    Args:
        run_again: called with the button.
    """

    def __init__(self, run_again: Callable[[], None]) -> None:
        super().__init__()
        self._axis = ScaleKind.UNKNOWN
        self._answered = False
        question = QtWidgets.QLabel(
            translate("GaussianCAD", "Only one view was found. How thick is the part?")
        )
        question.setWordWrap(True)
        # Not FreeCAD's box for lengths: Qt for Python loses that in a view that is scrolled to.
        self.length = QtWidgets.QDoubleSpinBox()
        self.length.setObjectName("thickness")
        self.length.setDecimals(3)
        self.length.setRange(0.001, 1e6)
        self.length.setValue(_DEFAULT_MM)
        self.length.setSuffix(" mm")
        self.button = QtWidgets.QPushButton(translate("GaussianCAD", "Run Again"))
        self.button.setObjectName("runWithThickness")
        self._run_again = run_again
        self.button.clicked.connect(self._answer)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for item in (question, self.length, self.button):
            layout.addWidget(item)
        self.hide()

    @property
    def thickness(self) -> Scale:
        """The length that was told; unknown where nobody told one."""
        if not self._answered:
            return Scale()
        return Scale(self._axis, self.length.value())

    def ask(self, result: RunResult) -> bool:
        """Ask if that is what a run lacked; tell whether it is."""
        args = result.verdict.args
        axis = _AXES.get(str(args.get("axis")))
        if result.code != "one-view" or axis is None or args.get("case"):
            return False
        self._axis, self._answered = axis, False
        self.show()
        return True

    def take(self, thickness: Scale) -> None:
        """Show what was told before; nothing where that is unknown."""
        self._axis, self._answered = thickness.kind, thickness.kind is not ScaleKind.UNKNOWN
        if self._answered:
            self.length.setValue(thickness.value)
        self.setVisible(self._answered)

    def _answer(self) -> None:
        self._answered = True
        self._run_again()

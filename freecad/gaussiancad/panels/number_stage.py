"""The numbers of new bodies are tried, one at a time, while the window stays alive."""

import traceback
from collections.abc import Callable, Sequence

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies import MadeBody, note_trials
from freecad.gaussiancad.objects.number_trials import NumberTrials
from freecad.gaussiancad.panels.body_words import told_body, told_numbers
from freecad.gaussiancad.panels.follow_up import FollowUp, Success
from freecad.gaussiancad.panels.run_view import RunView
from freecad.gaussiancad.qt import QtCore


class NumberStage(FollowUp):
    """Tries the numbers of bodies and notes what became of that.

    Args:
        made: the bodies.
        view: shows how far it is.
    """

    def __init__(self, made: Sequence[MadeBody], view: RunView) -> None:
        self._left, self._tried = list(made), []
        self._view = view
        self._trials: NumberTrials | None = None
        self._stopped = self._gone = False

    def start(self, done: Callable[[Success], None]) -> None:
        """Begin; each number is a turn of the window's loop."""
        self._done = done
        self._view.begin_part(translate("GaussianCAD", "Changing each number on a copy"))
        QtCore.QTimer.singleShot(0, self._turn)

    def cancel(self) -> None:
        """Leave the other numbers untried."""
        self._stopped = True

    def leave(self) -> None:
        """The same; what is known is noted."""
        self._gone = True
        while self._left:
            self._note()
        self._end()

    def _turn(self) -> None:
        if self._gone:
            return
        if not self._left:
            self._end()
            return
        if self._trials is None:
            self._trials = NumberTrials(self._left[0].body, self._left[0].numbers)
        if self._stopped or not self._goes_on():
            self._note()
        else:
            self._view.show_fraction(self._trials.fraction)
        QtCore.QTimer.singleShot(0, self._turn)

    def _goes_on(self) -> bool:
        try:
            return self._trials.step()
        except Exception:  # the body may be gone meanwhile: somebody took the step back
            FreeCAD.Console.PrintLog(traceback.format_exc())
            return False

    def _note(self) -> None:
        made, trials, self._trials = self._left.pop(0), self._trials, None
        if trials is None:
            return
        trials.close()
        try:
            self._tried.append(note_trials(made, trials.outcome))
        except ReferenceError:
            return  # as above

    def _end(self) -> None:
        headline = " ".join(told_body(each) for each in self._tried)
        lines = tuple(line for each in self._tried for line in told_numbers(each))
        FreeCAD.Console.PrintMessage(f"{headline}\n")
        self._done(Success(headline or translate("GaussianCAD", "Stopped"), lines))

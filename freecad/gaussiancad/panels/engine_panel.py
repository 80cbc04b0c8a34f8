"""A task panel that runs the engine: what *Reconstruct* and *Compare* have in common.

The engine works in a process of its own, and the window stays alive.  The document is touched when
the run has succeeded and its files are read, or with a file that is told to be final.
"""

import os
import tempfile
import traceback
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.follow_up import FollowUp, Success
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.run_view import RunView
from freecad.gaussiancad.panels.widgets import standard_buttons
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets


@dataclass(frozen=True)
class PanelTexts:
    """What a panel is called.

    Attributes:
        title: of its message boxes.
        start: on the button that starts.
        running: instead of a stage, until the engine tells one.
        icon: name of its icon.
    """

    title: str
    start: str
    running: str
    icon: str


class EnginePanel(ABC):
    """The panel; FreeCAD shows the widgets in ``form``.

    Args:
        texts: what the panel is called.
    """

    form: list[QtWidgets.QWidget]

    def __init__(self, texts: PanelTexts) -> None:
        self._texts = texts
        self.run_view = RunView(
            translate("GaussianCAD", "Run"), texts.start, self.start, self.cancel
        )
        self.run_view.destroyed.connect(self._leave)
        self._closed = False
        self._run: EngineRun | None = None
        self._follow_up: FollowUp | None = None
        self._scratch: tempfile.TemporaryDirectory[str] | None = None

    @abstractmethod
    def prepare(self, scratch: Path) -> list[str]:
        """Get everything ready for a run.

        Args:
            scratch: a folder of the run, removed after it.

        Returns:
            The engine's arguments.

        Raises:
            WorkbenchError, OSError: something is missing; told to the user.
        """

    @abstractmethod
    def absorb(self, scratch: Path) -> Success:
        """Take a finished run's files into the document.

        Raises:
            WorkbenchError: a file cannot be read; told to the user.
        """

    @abstractmethod
    def set_editable(self, editable: bool) -> None:
        """Let the user change the settings, or not."""

    def take_event(self, event: Event) -> None:
        """Show an event."""
        self.run_view.take_event(event)

    def give_up(self, reason: str) -> str:
        """Deal with what a run that did not succeed left in the document.

        Args:
            reason: why it did not.

        Returns:
            A sentence on what stays, or nothing.
        """
        return ""

    def ask(self, result: RunResult) -> bool:
        """Ask in the panel for what a run lacked, in place of a message box.

        Returns:
            Whether there is something to ask.
        """
        return False

    def has_outcome(self, result: RunResult) -> bool:
        """Whether a run left something to take in: by default, one that succeeded."""
        return result.state is RunState.DONE

    def way_out(self, result: RunResult) -> tuple[str, Callable[[], None]] | None:
        """What may help after a run that did not succeed: a button's text and what it does."""
        return None

    def follow_up(self, success: Success) -> FollowUp | None:
        """What to go on with once the result is in the document; None for nothing.

        Args:
            success: what is known so far.
        """
        return None

    @property
    def running(self) -> bool:
        """Whether the engine works for this panel."""
        return self._run is not None

    def start(self) -> None:
        """Start the engine; a user's mistake ends in a message box."""
        if self.running:
            return
        try:
            self._scratch = tempfile.TemporaryDirectory(
                prefix="gaussiancad-", ignore_cleanup_errors=True
            )
            preference = read_preferences().engine_python
            engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
            arguments = self.prepare(Path(self._scratch.name))
        except (WorkbenchError, OSError) as error:
            self._forget_run()
            self._complain(str(error))
            return
        self.set_editable(False)
        self.run_view.begin(self._texts.running)
        watcher = Watcher(self._take_event, self._take_log, self._finish)
        self._run = EngineRun(engine, arguments, watcher)
        self._run.start()

    def cancel(self) -> None:
        """Ask the engine to stop, or what follows its run."""
        if self._run is not None:
            self.run_view.say_cancelling()
            (self._follow_up or self._run).cancel()

    def dress(self) -> None:
        """Give the task boxes their icon; call it once ``form`` is complete."""
        for widget in self.form:
            widget.setWindowIcon(FreeCADGui.getIcon(self._texts.icon))

    def getStandardButtons(self) -> object:
        """A button that closes."""
        return standard_buttons(QtWidgets.QDialogButtonBox.StandardButton.Close)

    def reject(self) -> bool:
        """Close, or cancel the run first: then a second press closes."""
        if self.running:
            self.cancel()
            return False
        return True

    def isAllowedAlterDocument(self) -> bool:
        """The user may go on working."""
        return True

    def isAllowedAlterView(self) -> bool:
        """The user may look around."""
        return True

    def isAllowedAlterSelection(self) -> bool:
        """The user may select."""
        return True

    def _leave(self) -> None:
        """The panel was closed from outside: stop the engine, and touch no widget any more."""
        self._closed = True
        if self._follow_up is not None:
            self._follow_up.leave()
        elif self._run is not None:
            self._run.cancel()

    def _take_event(self, event: Event) -> None:
        if not self._closed:
            self.take_event(event)

    def _take_log(self, line: str) -> None:
        if not self._closed:
            self.run_view.take_log(line)

    def _finish(self, result: RunResult) -> None:
        if self._closed:
            self.give_up(result.words)
            self._forget_run()
            return
        success, complaint = self._outcome(result)
        self._follow_up = None if success is None else self.follow_up(success)
        if self._follow_up is not None:
            self._follow_up.start(self._end)
            return
        if success is not None:
            self._end(success)
        else:
            stopped = translate("GaussianCAD", "Stopped") if complaint else result.words
            left = self.give_up(complaint or result.words)
            self.run_view.end(f"{stopped.rstrip('.')}. {left}" if left else stopped, whole=False)
            self._forget_run()
        if complaint:
            self._help(result, complaint)

    def _end(self, success: Success) -> None:
        if not self._closed:
            self.run_view.show_report(success.lines)
            self.run_view.end(success.headline, whole=True)
        self._forget_run()

    def _help(self, result: RunResult, complaint: str) -> None:
        """Say what went wrong, with what may help."""
        offered = self.way_out(result)
        if offered is not None:
            self.run_view.offer(*offered)
        if self.ask(result):
            self.run_view.take_log(complaint)
            return
        box = show_error(self._texts.title, complaint)
        if offered is not None:
            text, called = offered
            button = box.addButton(text, QtWidgets.QMessageBox.ButtonRole.ActionRole)
            button.clicked.connect(lambda _=False: called())

    def _outcome(self, result: RunResult) -> tuple[Success | None, str]:
        """The success, or None and what to complain about; nothing if the user cancelled."""
        if result.state is RunState.CANCELLED:
            return None, ""
        if not self.has_outcome(result):
            return None, result.words
        self.run_view.say(translate("GaussianCAD", "Adding the result to the document"))
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.CursorShape.WaitCursor)
        try:
            return self.absorb(Path(self._scratch.name)), ""
        except WorkbenchError as error:
            return None, error.message
        except Exception as error:  # a window must survive what FreeCAD's importers raise
            FreeCAD.Console.PrintLog(traceback.format_exc())
            text = translate("GaussianCAD", "The result cannot be added to the document: {reason}")
            return None, text.format(reason=error)
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()

    def _forget_run(self) -> None:
        if self._scratch is not None:
            self._scratch.cleanup()
            self._scratch = None
        self._run = self._follow_up = None
        if not self._closed:
            self.set_editable(True)

    def _complain(self, text: str) -> None:
        show_error(self._texts.title, text)

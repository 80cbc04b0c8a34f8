"""What a run shows while it goes on: stage, bars, elapsed time, log, *Start* and *Cancel*."""

import time
from collections.abc import Callable, Iterable

from freecad.gaussiancad.engine.protocol import Event, EventKind
from freecad.gaussiancad.engine.wording import stage_name, worded
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.widgets import bring_into_sight
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_STEPS = 1000
_LOG_LINES = 2000


class RunView(QtWidgets.QWidget):
    """The lower part of a panel.

    Args:
        title: heading of the task box.
        start_text: on the button that starts.
        start, cancel: what the buttons do.
    """

    def __init__(
        self,
        title: str,
        start_text: str,
        start: Callable[[], None],
        cancel: Callable[[], None],
    ) -> None:
        super().__init__()
        self.setWindowTitle(title)
        self.start_button = QtWidgets.QPushButton(start_text)
        self.start_button.setObjectName("start")
        self.start_button.clicked.connect(start)
        self.cancel_button = QtWidgets.QPushButton(translate("GaussianCAD", "Cancel"))
        self.cancel_button.setObjectName("cancel")
        self.cancel_button.clicked.connect(cancel)
        self.follow_up = QtWidgets.QPushButton()
        self.follow_up.setObjectName("followUp")
        self.follow_up.clicked.connect(self._go_on)
        self.follow_up.hide()
        self._next_step: Callable[[], None] | None = None
        self.stage = _wrapped_label("stage")
        self.overall = _bar("overall")
        self.fraction = _bar("fraction")
        self.elapsed = _wrapped_label("elapsed")
        self.log = QtWidgets.QPlainTextEdit()
        self.log.setObjectName("log")
        self.log.setReadOnly(True)
        self.log.setMaximumBlockCount(_LOG_LINES)
        self.log.setFixedHeight(150)
        self._lay_out()
        self._stage_count, self._stage_index = 0, 0
        self._began, self._remaining = 0.0, None
        self._clock = QtCore.QTimer(self)
        self._clock.timeout.connect(self._show_time)
        self.forget()

    def forget(self) -> None:
        """Show nothing of an earlier run."""
        self.stage.setText(translate("GaussianCAD", "Ready"))
        self.elapsed.clear()
        self.log.clear()
        self.follow_up.hide()
        for bar in (self.overall, self.fraction):
            bar.setRange(0, _STEPS)
            bar.setValue(0)
        self._set_running(False)

    def begin(self, headline: str) -> None:
        """Show that a run has begun; how far it is is not known yet."""
        self._stage_count, self._stage_index = 0, 0
        self._began, self._remaining = time.monotonic(), None
        self.follow_up.hide()
        self.log.clear()
        self.stage.setText(headline)
        self.overall.setRange(0, 0)
        self.fraction.setRange(0, 0)
        self._set_running(True)
        self._show_time()
        self._clock.start(250)
        bring_into_sight(self)

    def take_event(self, event: Event) -> None:
        """Show a stage, a progress or a warning; other events are not shown here."""
        if event.kind is EventKind.STAGE:
            self._take_stage(event)
        elif event.kind is EventKind.PROGRESS:
            self._take_progress(event)
        elif event.kind is EventKind.WARNING:
            message = event.text("message")
            self.take_log(worded(event.text("code"), message, event.values("args")))

    def take_log(self, line: str) -> None:
        """Add a line to the log."""
        self.log.appendPlainText(line)

    def show_report(self, lines: Iterable[str]) -> None:
        """Show the outcome below the messages, from its first line."""
        if not (lines := tuple(lines)):
            return
        self.log.appendPlainText("")
        first = self.log.blockCount() - 1
        self.log.appendPlainText("\n".join(lines))
        cursor = QtGui.QTextCursor(self.log.document().findBlockByNumber(first + 1))
        self.log.setTextCursor(cursor)
        self.log.verticalScrollBar().setValue(self.log.verticalScrollBar().maximum())
        self.log.ensureCursorVisible()

    def offer(self, text: str, next_step: Callable[[], None]) -> None:
        """Show a button for what may be done with the outcome, until the next run.

        Args:
            text: on the button.
            next_step: what it does; it may close the panel.
        """
        self._next_step = next_step
        self.follow_up.setText(text)
        self.follow_up.show()

    def add_question(self, question: QtWidgets.QWidget) -> None:
        """Put a question about the outcome between the headline and the bars."""
        layout = self.layout()
        layout.insertWidget(layout.indexOf(self.follow_up), question)

    def say(self, headline: str) -> None:
        """Show a line at once, before the window is busy."""
        self.stage.setText(headline)
        self.repaint()

    def begin_part(self, headline: str) -> None:
        """Show that a run goes on with something else; how far that is is not known yet."""
        self.stage.setText(headline)
        self._remaining = None
        self._stage_count = 0
        self.fraction.setRange(0, 0)
        self.overall.setRange(0, 0)

    def show_fraction(self, fraction: float) -> None:
        """Show how far that is, from 0 to 1."""
        for bar in (self.fraction, self.overall):
            bar.setRange(0, _STEPS)
            bar.setValue(round(fraction * _STEPS))

    def say_cancelling(self) -> None:
        """Show that the engine was asked to stop."""
        self.stage.setText(translate("GaussianCAD", "Cancelling"))
        self.cancel_button.setEnabled(False)

    def end(self, headline: str, whole: bool) -> None:
        """Show the end of a run.

        Args:
            headline: instead of the stage.
            whole: whether the run came to its end.
        """
        self._clock.stop()
        self._remaining = None
        self._show_time()
        self.stage.setText(headline)
        for bar in (self.overall, self.fraction):
            bar.setRange(0, _STEPS)
            bar.setValue(_STEPS if whole else 0)
        self._set_running(False)

    def _take_stage(self, event: Event) -> None:
        index, count = event.number("index"), event.number("of")
        self._stage_index, self._stage_count = int(index or 0), int(count or 0)
        name = stage_name(event.text("name"))
        if self._stage_count > 0:
            text = translate("GaussianCAD", "Stage {index} of {count}: {name}")
            name = text.format(index=self._stage_index, count=self._stage_count, name=name)
        self.stage.setText(name)
        self._remaining = None
        self.fraction.setRange(0, 0)
        self._show_overall(0.0)

    def _take_progress(self, event: Event) -> None:
        fraction = event.number("fraction")
        if fraction is None:
            return
        fraction = min(max(fraction, 0.0), 1.0)
        self.fraction.setRange(0, _STEPS)
        self.fraction.setValue(round(fraction * _STEPS))
        self._remaining = event.number("eta_s")
        self._show_overall(fraction)

    def _show_overall(self, fraction: float) -> None:
        if self._stage_count <= 0:
            return
        done = (self._stage_index - 1 + fraction) / self._stage_count
        self.overall.setRange(0, _STEPS)
        self.overall.setValue(round(min(max(done, 0.0), 1.0) * _STEPS))

    def _show_time(self) -> None:
        seconds = int(time.monotonic() - self._began)
        text = translate("GaussianCAD", "Elapsed {time}").format(time=_clock_text(seconds))
        if self._remaining is not None:
            left = translate("GaussianCAD", "this stage needs about {time} more")
            text += ", " + left.format(time=_clock_text(int(self._remaining)))
        self.elapsed.setText(text)

    def _set_running(self, running: bool) -> None:
        self.start_button.setEnabled(not running)
        self.cancel_button.setEnabled(running)

    def _go_on(self) -> None:
        # The panel may be closed by it, and this button with it.
        QtCore.QTimer.singleShot(0, self._next_step)

    def _lay_out(self) -> None:
        buttons = QtWidgets.QHBoxLayout()
        buttons.addWidget(self.start_button)
        buttons.addWidget(self.cancel_button)
        bars = QtWidgets.QFormLayout()
        bars.addRow(translate("GaussianCAD", "Stage"), self.fraction)
        bars.addRow(translate("GaussianCAD", "Overall"), self.overall)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addLayout(buttons)
        layout.addWidget(self.stage)
        layout.addWidget(self.follow_up)
        layout.addLayout(bars)
        layout.addWidget(self.elapsed)
        layout.addWidget(QtWidgets.QLabel(translate("GaussianCAD", "Messages")))
        layout.addWidget(self.log)


def _wrapped_label(name: str) -> QtWidgets.QLabel:
    """A label with room for two lines: a task box does not grow with a text that wraps."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setMinimumHeight(2 * label.fontMetrics().lineSpacing())
    return label


def _bar(name: str) -> QtWidgets.QProgressBar:
    bar = QtWidgets.QProgressBar()
    bar.setObjectName(name)
    bar.setRange(0, _STEPS)
    bar.setValue(0)
    bar.setTextVisible(False)
    bar.setMaximumHeight(14)
    return bar


def _clock_text(seconds: int) -> str:
    return f"{seconds // 60}:{seconds % 60:02d}"

"""How a batch in the console is stopped."""

import signal

from freecad.gaussiancad.engine.process import EngineRun, RunResult


class BatchStopped(Exception):
    """Somebody stopped the batch before something was whole."""


class StopOnSignals:
    """SIGINT and SIGTERM end all runs of the engine; FreeCAD itself leaves them alone.

    A document that is being made is finished, while the engine stops already, unless it waits for
    the engine itself.

    Attributes:
        asked: whether a signal came.

    Args:
        run: what is stopped; not started yet.
    """

    def __init__(self, run: EngineRun) -> None:
        self.asked = False
        self._runs = [run]
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._stop)

    def start(self) -> None:
        """Start the run; a signal that came before is not lost."""
        self._start(self._runs[0])

    def wait_for(self, run: EngineRun) -> RunResult:
        """Run something else of the engine to its end.

        Raises:
            BatchStopped: a signal came before.
        """
        self._runs.append(run)
        try:
            self._start(run)
            result = run.wait()
        finally:
            self._runs.remove(run)
        if self.asked:
            raise BatchStopped
        return result

    def _start(self, run: EngineRun) -> None:
        run.start()
        if self.asked:
            run.cancel()

    def _stop(self, *_arguments: object) -> None:
        self.asked = True
        for run in self._runs:
            run.cancel()
            run.flush()

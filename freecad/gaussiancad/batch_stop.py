"""How a batch in the console is stopped."""

import signal

from freecad.gaussiancad.engine.process import EngineRun


class StopOnSignals:
    """SIGINT and SIGTERM end a run of the engine; FreeCAD itself leaves them alone.

    Nothing is raised: a document that is being made is finished, while the engine stops already.

    Attributes:
        asked: whether a signal came.

    Args:
        run: what is stopped; not started yet.
    """

    def __init__(self, run: EngineRun) -> None:
        self.asked = False
        self._run = run
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._stop)

    def start(self) -> None:
        """Start the run; a signal that came before is not lost."""
        self._run.start()
        if self.asked:
            self._run.cancel()

    def _stop(self, *_arguments: object) -> None:
        self.asked = True
        self._run.cancel()
        self._run.flush()

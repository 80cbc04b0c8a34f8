"""Comparing again on its own, once an object has changed; the engine works in its own process."""

import os
import tempfile
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparison import (
    CompareRequest,
    load_comparison,
    prepare_comparison,
    request_of,
    update_comparison,
)
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.qt import QtCore

_PAUSE_MILLISECONDS = 600
"""After the last change: who drags a dimension changes it often."""


class Refresh:
    """Keeps one comparison up to date.

    Args:
        group: the comparison.
    """

    def __init__(self, group: FreeCAD.DocumentObject) -> None:
        self._group = group
        self._run: EngineRun | None = None
        self._scratch: tempfile.TemporaryDirectory[str] | None = None
        self._request: CompareRequest | None = None
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._start)

    @property
    def busy(self) -> bool:
        """Whether it waits or works."""
        return self._run is not None or self._timer.isActive()

    def soon(self) -> None:
        """Compare again after a pause; a run whose models have changed meanwhile is repeated."""
        self._timer.start(_PAUSE_MILLISECONDS)

    def _start(self) -> None:
        if self._run is not None:
            self.soon()
            return
        try:
            self._request = request_of(self._group)
            if self._request is None or not self._group.Stale:
                return
            self._scratch = tempfile.TemporaryDirectory(
                prefix="gaussiancad-", ignore_cleanup_errors=True
            )
            self._run = self._engine_run(Path(self._scratch.name))
        except ReferenceError:
            return  # the document was closed in the meantime
        except (WorkbenchError, OSError) as error:
            self._end(str(error))
            return
        self._run.start()

    def _engine_run(self, scratch: Path) -> EngineRun:
        preference = read_preferences().engine_python
        engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
        job = prepare_comparison(self._request, scratch)
        return EngineRun(engine, job.arguments(), Watcher(on_finished=self._finish))

    def _finish(self, result: RunResult) -> None:
        if result.state is not RunState.DONE:
            self._end(result.words)
            return
        try:
            scratch = Path(self._scratch.name)
            loaded = load_comparison(scratch / "comparison", scratch)
            update_comparison(self._group, loaded, self._request)
        except ReferenceError:
            self._end("")
        except Exception as error:  # a window must survive what FreeCAD's importers raise
            self._end(str(error))
        else:
            self._end("")

    def _end(self, complaint: str) -> None:
        if complaint:
            text = translate("GaussianCAD", "The comparison is out of date: {reason}")
            FreeCAD.Console.PrintWarning(text.format(reason=complaint) + "\n")
        if self._scratch is not None:
            self._scratch.cleanup()
        self._scratch = self._run = None


def refresh_soon(group: FreeCAD.DocumentObject) -> None:
    """Bring a comparison up to date, in a while."""
    proxy = group.Proxy
    if getattr(proxy, "refresh", None) is None:
        proxy.refresh = Refresh(group)
    proxy.refresh.soon()

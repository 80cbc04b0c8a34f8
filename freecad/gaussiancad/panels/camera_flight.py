"""The camera of a 3D view that moves, step by step, to where something is to be seen."""

from collections.abc import Callable
from dataclasses import dataclass

from pivy import coin

from freecad.gaussiancad.qt import QtCore

_STEPS = 12
_STEP_MILLISECONDS = 25

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Goal:
    """What is to be seen.

    Attributes:
        place: mm, in the middle.
        height: mm that the view shows from below to above.
        away: mm from the place to the camera.
        turn: of the camera; None to look as before.
    """

    place: Point
    height: float
    away: float
    turn: coin.SbRotation | None = None


class CameraFlight:
    """Flies one camera at a time.

    Args:
        is_open: whether the document of the view is open still.
    """

    def __init__(self, is_open: Callable[[], bool]) -> None:
        self._is_open = is_open
        self._view: object = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._step)
        self._path: list[tuple[coin.SbVec3f, coin.SbRotation, float]] = []

    def start(self, view: object, goal: Goal) -> None:
        """Begin; a flight that goes on ends where it is."""
        self._view = view
        camera = view.getCameraNode()
        first = coin.SbRotation(*camera.orientation.getValue().getValue())
        last = goal.turn or first
        looks = last.multVec(coin.SbVec3f(0.0, 0.0, -1.0))
        end = coin.SbVec3f(*goal.place) - looks * goal.away
        start = coin.SbVec3f(camera.position.getValue())
        tall = camera.height.getValue() if hasattr(camera, "height") else 0.0
        self._path = []
        for number in range(1, _STEPS + 1):
            time = number / _STEPS
            share = time * time * (3.0 - 2.0 * time)
            height = tall * (goal.height / tall) ** share if tall > 0.0 else 0.0
            turn = coin.SbRotation.slerp(first, last, share)
            self._path.append((start + (end - start) * share, turn, height))
        camera.focalDistance = goal.away
        self._timer.start(_STEP_MILLISECONDS)

    def stop(self) -> None:
        """End where it is."""
        self._timer.stop()

    def _step(self) -> None:
        if not self._path or not self._is_open():
            self._timer.stop()
            return
        position, turn, height = self._path.pop(0)
        camera = self._view.getCameraNode()
        camera.position.setValue(position)
        camera.orientation.setValue(turn)
        if height > 0.0:
            camera.height = height
        camera.nearDistance, camera.farDistance = 0.001, 1e6
        self._view.redraw()

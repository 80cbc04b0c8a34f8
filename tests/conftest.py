"""Which tests are slow, in which order they run, what was skipped; a part that is quick to solve.

``durations.json`` has the seconds of each test that took :data:`KEPT_S` or more when they were last
recorded (``make durations``).  Tests that took :data:`SLOW_S` or more are marked ``slow``; a test
that nobody has recorded counts as quick.  Files with the most seconds begin first, so that
processes side by side end at about the same time.
"""

import json
from collections import defaultdict
from pathlib import Path

import pytest

DURATIONS = Path(__file__).with_name("durations.json")

SLOW_S = 0.25
"""Seconds from which a test is none to run after each change."""

KEPT_S = 0.1
"""Seconds of the quickest tests that are recorded."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--record-durations", action="store_true", help="into tests/durations.json")
    parser.addoption("--skipped-to", type=Path, help="file for what was skipped, and why")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(_Recorder(), "gaussiancad-recorder")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    seconds: dict[str, float] = json.loads(DURATIONS.read_text(encoding="utf-8"))
    of_file: dict[str, float] = defaultdict(float)
    for item in items:
        spent = seconds.get(item.nodeid, 0.0)
        of_file[_file(item)] += spent
        if spent >= SLOW_S:
            item.add_marker(pytest.mark.slow)
    items.sort(key=lambda item: (-of_file[_file(item)], _file(item)))


def _file(item: pytest.Item) -> str:
    return item.nodeid.partition("::")[0]


class _Recorder:
    """Seconds of each test, its fixtures among them, and why tests were skipped."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self.skipped: dict[str, str] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] += report.duration
        if report.skipped and isinstance(report.longrepr, tuple):
            self.skipped[report.nodeid] = report.longrepr[2].removeprefix("Skipped: ")

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if hasattr(session.config, "workerinput"):
            return
        path: Path | None = session.config.getoption("skipped_to")
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            lines = (f"{name}: {why}\n" for name, why in sorted(self.skipped.items()))
            path.write_text("".join(lines), encoding="utf-8")
        if session.config.getoption("record_durations"):
            kept = {name: round(s, 2) for name, s in sorted(self.seconds.items()) if s >= KEPT_S}
            DURATIONS.write_text(json.dumps(kept, indent=0) + "\n", encoding="utf-8")


_PLAIN_OUTLINES = (
    ((0, 0), (40, 0), (40, 10), (15, 10), (15, 30), (0, 30)),
    ((60, 0), (80, 0), (80, 30), (60, 30)),
    ((0, 50), (40, 50), (40, 70), (0, 70)),
)
_PLAIN_EDGES = (((60, 10), (80, 10)), ((15, 50), (15, 70)))
_PLAIN_BORE = (28, 60), 5
_PLAIN_HIDDEN = (23, 33, 65, 75)
"""Front, right and top view of an L of 40 x 20 x 30 mm with a bore: nine faces, verified; mm."""


@pytest.fixture(scope="session")
def plain_sheet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A drawing file of the plain part, in millimetres."""
    import ezdxf

    document = ezdxf.new(setup=True)
    document.header["$INSUNITS"] = 4
    lines = document.modelspace()
    for corners in _PLAIN_OUTLINES:
        lines.add_lwpolyline(corners, close=True)
    for start, end in _PLAIN_EDGES:
        lines.add_line(start, end)
    lines.add_circle(*_PLAIN_BORE)
    for x in _PLAIN_HIDDEN:
        lines.add_line((x, 0), (x, 10), dxfattribs={"linetype": "DASHED"})
    path = tmp_path_factory.mktemp("plain") / "block.dxf"
    document.saveas(path)
    return path


@pytest.fixture(scope="session")
def plain_picture(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A picture of the plain part, 5 px a millimetre."""
    import cv2
    import numpy as np

    def px(x: float, y: float) -> tuple[int, int]:
        return round(60 + 5 * x), round(420 - 5 * y)

    grey = np.full((480, 520), 255, np.uint8)
    for corners in _PLAIN_OUTLINES:
        cv2.polylines(grey, [np.array([px(*corner) for corner in corners])], True, 0, 3)
    for start, end in _PLAIN_EDGES:
        cv2.line(grey, px(*start), px(*end), 0, 3)
    cv2.circle(grey, px(*_PLAIN_BORE[0]), 5 * _PLAIN_BORE[1], 0, 3, cv2.LINE_AA)
    for x in _PLAIN_HIDDEN:
        for dash in range(4):
            cv2.line(grey, px(x, 2.6 * dash), px(x, 2.6 * dash + 1.6), 0, 2)
    path = tmp_path_factory.mktemp("plain") / "block.png"
    cv2.imwrite(str(path), grey)
    return path


@pytest.fixture(scope="session")
def plain_step(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The plain part itself."""
    from gaussiancad_core.kernel.brep_files import write_step
    from gaussiancad_core.model.axes import Axis
    from sample_parts.modelling import cut, cylinder, prism

    path = tmp_path_factory.mktemp("plain") / "block.step"
    bore = cylinder(Axis.Z, (28, 10), _PLAIN_BORE[1], -1, 11)
    write_step(cut(prism(Axis.Y, _PLAIN_OUTLINES[0], 0, 20), bore), path)
    return path

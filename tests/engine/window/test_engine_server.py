"""One engine for several sheets: each gets its own answers, and breaks off only what it asked."""

import gc
import time
import weakref
from collections.abc import Callable
from pathlib import Path

import pytest

from freecad.gaussiancad.canvas.engine_server import Engine, Program, Server
from freecad.gaussiancad.qt import QtCore, QtWidgets

_ENGINE = """\
import json, os, sys, time
for line in sys.stdin:
    asked = json.loads(line)
    if asked["do"] == "die":
        print("out of luck", file=sys.stderr, flush=True)
        os._exit(3)
    print(json.dumps({"event": "stage", "name": asked["do"]}), flush=True)
    if asked["do"] == "hang":
        time.sleep(60)
    answer = {"event": "answer", "id": asked["id"], "process": os.getpid(), **asked}
    print(json.dumps(answer), flush=True)
"""

Waiting = Callable[[Callable[[], object]], None]


@pytest.fixture
def wait(application: QtWidgets.QApplication) -> Waiting:
    def until(condition: Callable[[], object]) -> None:
        end = time.monotonic() + 20.0
        while not condition():
            assert time.monotonic() < end, "no answer came"
            application.processEvents()
            time.sleep(0.01)

    return until


@pytest.fixture
def engine(tmp_path: Path, application: QtWidgets.QApplication) -> Engine:
    script = tmp_path / "engine.py"
    script.write_text(_ENGINE, encoding="utf-8")
    return Engine(Program(("python3", str(script))))


@pytest.fixture
def two(engine: Engine) -> tuple[Server, Server]:
    """Two sheets that share the engine."""
    parent = QtCore.QObject()
    servers = Server(engine, parent), Server(engine, parent)
    yield servers
    for server in servers:
        server.close()


def test_one_process_answers_both(two: tuple[Server, Server], wait: Waiting) -> None:
    answers: list[dict] = []
    stages: list[tuple[int, str]] = []
    for number, server in enumerate(two):
        server.stage.connect(lambda name, number=number: stages.append((number, name)))
        server.ask("read", answers.append, sheet=str(number))
    wait(lambda: len(answers) == 2)
    assert [answer["sheet"] for answer in answers] == ["0", "1"]
    assert len({answer["process"] for answer in answers}) == 1
    assert stages == [(0, "read"), (1, "read")]
    assert not any(item.busy for item in two)


def test_breaking_off_takes_nothing_from_others(two: tuple[Server, Server], wait: Waiting) -> None:
    first, second = two
    answers: list[dict] = []
    first.ask("hang", answers.append)
    second.ask("read", answers.append)
    first.stop()
    assert not first.busy
    assert second.busy
    wait(lambda: answers)
    assert [answer["do"] for answer in answers] == ["read"]


def test_what_only_waits_is_dropped_without_an_end(
    two: tuple[Server, Server], wait: Waiting
) -> None:
    first, second = two
    answers: list[dict] = []
    first.ask("read", answers.append)
    wait(lambda: answers)
    first.ask("read", answers.append)
    second.ask("read", answers.append)
    second.stop()
    wait(lambda: not first.busy)
    assert len(answers) == 2
    assert answers[0]["process"] == answers[1]["process"]


def test_one_that_dies_is_told_once_and_serves_the_others(
    two: tuple[Server, Server], wait: Waiting
) -> None:
    first, second = two
    stated: list[dict] = []
    answers: list[dict] = []
    first.ask("die", stated.append)
    first.ask("read", stated.append)
    second.ask("read", answers.append)
    wait(lambda: answers)
    assert [item["error"]["code"] for item in stated] == ["engine-broke-off"]
    assert "out of luck" in stated[0]["error"]["message"]
    assert not first.busy


def test_it_ends_with_the_last_sheet(
    engine: Engine, two: tuple[Server, Server], wait: Waiting
) -> None:
    first, second = two
    answers: list[dict] = []
    first.ask("read", answers.append)
    wait(lambda: answers)
    first.close()
    second.ask("read", answers.append)
    wait(lambda: len(answers) == 2)
    assert answers[0]["process"] == answers[1]["process"]
    second.close()
    assert engine._process is None


def test_one_that_does_not_start_keeps_nothing_alive(
    tmp_path: Path, application: QtWidgets.QApplication, wait: Waiting
) -> None:
    """Its process, which is still to be destroyed, would destroy it with itself."""
    engine, parent = Engine(Program((str(tmp_path / "none"),))), QtCore.QObject()
    server = Server(engine, parent)
    answers: list[dict] = []
    server.ask("read", answers.append)
    wait(lambda: answers)
    server.close()
    known = weakref.ref(engine)
    del engine, server, parent
    gc.collect()
    assert known() is None
    application.sendPostedEvents(None, int(QtCore.QEvent.Type.DeferredDelete.value))


def test_an_engine_ends_when_the_application_quits(
    two: tuple[Server, Server], application: QtWidgets.QApplication
) -> None:
    answers: list[dict] = []
    two[0].ask("hang", answers.append)
    assert two[0].busy
    application.aboutToQuit.emit()
    assert not two[0].busy
    assert not answers

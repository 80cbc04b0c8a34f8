"""How the server ends, and how calls are cancelled: seen from outside of its process."""

import json
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import psutil
import pytest

from gaussiancad_core.cli import main
from gaussiancad_core.storage.extras import MODULES, Extra

CHECKOUT = Path(__file__).resolve().parents[3]
SAMPLES = CHECKOUT / "resources" / "samples"

SECONDS = 30.0
"""That anything here takes at most."""


class Wire:
    """A server, and a client that writes the protocol by hand.

    Args:
        folder: that the server works in.
    """

    def __init__(self, folder: Path) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "gaussiancad_core", "mcp", "--folder", str(folder)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env={"PYTHONPATH": str(CHECKOUT / "core"), "PATH": "/usr/bin:/bin"},
        )
        self.seen = psutil.Process(self.process.pid)
        self.send(
            "initialize",
            1,
            protocolVersion="2025-06-18",
            capabilities={},
            clientInfo={"name": "test", "version": "1"},
        )
        assert self.answer(1)["serverInfo"]["name"] == "gaussiancad"
        self.send("notifications/initialized")

    def send(self, method: str, number: int | None = None, /, **params: object) -> None:
        """Write a request, or a notice where it has no number."""
        message: dict[str, Any] = {"jsonrpc": "2.0", "method": method, "params": params}
        self.write(json.dumps(message if number is None else {**message, "id": number}))

    def write(self, line: str) -> None:
        """Write a line."""
        assert self.process.stdin is not None
        self.process.stdin.write(line.encode() + b"\n")
        self.process.stdin.flush()

    def call(self, number: int, tool: str, **arguments: object) -> None:
        """Call a tool; nobody waits for the answer."""
        self.send("tools/call", number, name=tool, arguments=arguments)

    def answer(self, number: int) -> dict[str, Any]:
        """The result of a request; whatever else comes is left out, but it is the protocol."""
        assert self.process.stdout is not None
        for line in self.process.stdout:
            message = json.loads(line)
            assert message["jsonrpc"] == "2.0"
            if message.get("id") == number:
                return dict(message["result"])
        raise AssertionError("the server ended")

    def runs(self) -> list[psutil.Process]:
        """Processes of the engine that go on."""
        return [process for process in self.seen.children(recursive=True) if process.is_running()]


@pytest.fixture
def wire(tmp_path: Path) -> Iterator[Wire]:
    """A server in a folder with a drawing and a model."""
    for name in ("l-bracket.png", "l-bracket.step"):
        shutil.copy(SAMPLES / name, tmp_path)
    found = Wire(tmp_path)
    yield found
    found.process.kill()
    found.process.wait()
    for stream in (found.process.stdin, found.process.stdout, found.process.stderr):
        if stream is not None:
            with suppress(OSError):
                stream.close()


def becomes(condition: Callable[[], bool]) -> bool:
    """Whether something comes true in time."""
    end = time.monotonic() + SECONDS
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


@pytest.mark.parametrize(
    ("tool", "arguments"),
    [
        ("reconstruct", {"sheet": "l-bracket.png"}),
        # It sends no events.
        ("compare", {"result": "l-bracket.step", "reference": "l-bracket.step"}),
    ],
)
def test_a_cancelled_call_stops_its_run(
    wire: Wire, tmp_path: Path, tool: str, arguments: dict[str, str]
) -> None:
    wire.call(7, tool, **arguments)
    assert becomes(lambda: bool(wire.runs()))
    started = wire.runs()
    wire.send("notifications/cancelled", requestId=7, reason="enough")
    assert becomes(lambda: not any(process.is_running() for process in started))
    wire.call(8, "files")
    assert "l-bracket.png" in wire.answer(8)["content"][0]["text"]
    # It took along the folder that was made for it.
    assert becomes(lambda: not list((tmp_path / "gaussiancad-mcp").glob("*")))


def test_two_runs_go_on_at_a_time(wire: Wire) -> None:
    for number in (7, 8, 9):
        wire.call(number, "compare", result="l-bracket.step", reference="l-bracket.step")
    assert becomes(lambda: len(wire.seen.children()) == 2)
    first = set(wire.seen.children())
    time.sleep(1.0)
    assert set(wire.seen.children()) == first
    # One that waits is cancelled as well; what needs no run does not wait.
    wire.send("notifications/cancelled", requestId=9)
    wire.call(10, "files")
    wire.answer(10)
    wire.send("notifications/cancelled", requestId=8)
    wire.send("notifications/cancelled", requestId=7)
    assert becomes(lambda: not wire.seen.children())


@pytest.mark.parametrize(("by_signal", "code"), [(False, 0), (True, 130)])
def test_the_server_and_its_runs_end_with_the_client_and_by_a_signal(
    wire: Wire, by_signal: bool, code: int
) -> None:
    wire.call(7, "reconstruct", sheet="l-bracket.png")
    assert becomes(lambda: bool(wire.runs()))
    started = wire.runs()
    assert wire.process.stdin is not None and wire.process.stderr is not None
    wire.process.terminate() if by_signal else wire.process.stdin.close()
    assert wire.process.wait(SECONDS) == code
    assert becomes(lambda: not any(process.is_running() for process in started))
    assert b"Traceback" not in wire.process.stderr.read()


def test_a_client_that_never_reads_does_not_hold_the_server(wire: Wire) -> None:
    for number in range(10, 40):
        wire.send("tools/list", number)
    time.sleep(1.0)
    assert wire.process.stdin is not None
    wire.process.stdin.close()
    assert wire.process.wait(SECONDS) == 0


def test_what_is_no_request_is_answered_or_left_out(wire: Wire) -> None:
    for line in ("nonsense", "{}", "[1, 2]", '{"jsonrpc": "2.0"}', "\x00", "\u2028"):
        wire.write(line)
    wire.send("tools/call", 5, name=["files"], arguments=3)
    wire.call(6, "files", nonsense=1)
    assert wire.answer(6)["isError"]
    wire.call(9, "files")
    assert not wire.answer(9).get("isError", False)


def test_without_the_extra_it_says_what_installs_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(MODULES, Extra.MCP, {"no_such_module": ("nothing",)})
    assert main(["mcp"]) == 6
    printed = capsys.readouterr()
    assert printed.out == ""
    assert 'pip install "gaussiancad-core[mcp]" [extra-missing]' in printed.err


def test_a_folder_that_is_none_is_refused(tmp_path: Path) -> None:
    ended = subprocess.run(
        [sys.executable, "-m", "gaussiancad_core", "mcp", "--folder", str(tmp_path / "none")],
        capture_output=True,
        text=True,
        check=False,
        env={"PYTHONPATH": str(CHECKOUT / "core"), "PATH": "/usr/bin:/bin"},
    )
    assert ended.returncode == 2
    assert ended.stdout == ""
    assert ended.stderr.endswith("[path-not-usable]\n")
    assert ended.stderr.count("\n") == 1

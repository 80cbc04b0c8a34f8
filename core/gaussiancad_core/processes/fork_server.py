"""A process that has imported what sheets need, and forks one process for each of them.

``python -m gaussiancad_core.processes.fork_server FD MODULE...`` imports the modules and then reads
requests from a socket: a line of JSON (``number``, ``file`` bytes at most, ``arguments``) with
three file descriptors, standard input, output and error of the process to be made.  It answers with
lines of JSON: ``number`` and ``pid`` once the process runs, ``number`` and ``code`` once it has
ended.

A process that has threads must not be forked: what locks they hold stays locked.  The modules start
none; should one do so, the server ends, and its client starts interpreters instead.
"""

import array
import contextlib
import json
import os
import select
import signal
import socket
import sys
import traceback
from importlib import import_module
from pathlib import Path
from typing import Any

from gaussiancad_core.processes.limited_child import limit_itself

_LARGEST_REQUEST = 1 << 20
"""Bytes."""

_UNLIMITED = 1 << 50
"""Bytes of a file that the server itself never reaches: it writes none."""


def main(channel: socket.socket, modules: list[str]) -> None:
    """Serve until the client is gone."""
    for name in modules:
        import_module(name)
    if _threads() != 1:
        return
    wake, stated = os.pipe()
    os.set_blocking(wake, False)
    os.set_blocking(stated, False)
    signal.signal(signal.SIGCHLD, _nothing)
    signal.set_wakeup_fd(stated, warn_on_full_buffer=False)
    # Ctrl-C is the client's: it ends its processes one by one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _send(channel, {"ready": True})
    running: dict[int, int] = {}
    while True:
        ready, _, _ = select.select([channel.fileno(), wake], [], [])
        if wake in ready:
            with contextlib.suppress(BlockingIOError):
                os.read(wake, 4096)
        _reap(channel, running)
        if channel.fileno() in ready:
            request = _request(channel)
            if request is None:
                return
            head, files = request
            pid = os.fork()
            if pid == 0:
                channel.close()
                _become(head, files)
            for file in files:
                os.close(file)
            running[pid] = head["number"]
            _send(channel, {"number": head["number"], "pid": pid})


def _nothing(*_: object) -> None:
    """Of a signal only that it came is of interest."""


def _threads() -> int:
    try:
        return len(list(Path("/proc/self/task").iterdir()))
    except OSError:
        return 0


def _send(channel: socket.socket, message: dict[str, Any]) -> None:
    channel.sendall(json.dumps(message).encode("ascii") + b"\n")


def _request(channel: socket.socket) -> tuple[dict[str, Any], list[int]] | None:
    """What the client asks for, and its files; nothing once it is gone."""
    text = b""
    files: list[int] = []
    while not text.endswith(b"\n"):
        part, ancillary, _, _ = channel.recvmsg(_LARGEST_REQUEST, socket.CMSG_SPACE(3 * 4))
        if not part:
            return None
        text += part
        for level, kind, data in ancillary:
            if (level, kind) == (socket.SOL_SOCKET, socket.SCM_RIGHTS):
                this_array = array.array("i")
                this_array.frombytes(data[: len(data) - len(data) % this_array.itemsize])
                files += this_array
    return json.loads(text), files


def _reap(channel: socket.socket, running: dict[int, int]) -> None:
    """Tell of processes that ended."""
    while running:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        if pid == 0:
            return
        number = running.pop(pid, None)
        if number is not None:
            _send(channel, {"number": number, "code": os.waitstatus_to_exitcode(status)})


def _become(head: dict[str, Any], files: list[int]) -> None:
    """Be the process that was asked for, to its end."""
    code = 6
    try:
        os.setsid()
        signal.set_wakeup_fd(-1)
        for number in (signal.SIGCHLD, signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_DFL)
        for target, source in enumerate(files):
            os.dup2(source, target)
        os.closerange(3, 256)
        # The server may have ended before the death of a parent could be told.
        if os.getppid() == 1:
            os._exit(code)
        limit_itself(int(head["file"]))
        from gaussiancad_core.processes.command_entry import run_command

        signal.signal(signal.SIGINT, signal.default_int_handler)
        sys.argv = ["gaussiancad", *head["arguments"]]
        code = run_command(list(head["arguments"]))
    except SystemExit as error:
        code = error.code if isinstance(error.code, int) else 1
    except BaseException:
        traceback.print_exc()
    finally:
        with contextlib.suppress(Exception):
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(int(code))


if __name__ == "__main__":
    limit_itself(_UNLIMITED)
    main(socket.socket(fileno=int(sys.argv[1])), sys.argv[2:])

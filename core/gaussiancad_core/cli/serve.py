"""``gaussiancad serve``: an engine that stays, for a window: requests and answers as JSON lines."""

import argparse
import sys
import threading
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from gaussiancad_core.cli.reconstruct import greet
from gaussiancad_core.errors import CancelledError, GaussianCadError, is_out_of_memory, out_of_files
from gaussiancad_core.messages import Message, event_fields, on_one_line
from gaussiancad_core.processes.events import Listener, stop_main_thread
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_END = ""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser(
        "serve", help="stay, and answer requests on stdin (JSON lines), for a window"
    )
    parser.set_defaults(run=run, events=True, serves=True)


@dataclass(frozen=True)
class _Numbered:
    """A listener whose events say to which request they belong."""

    listener: Listener
    number: int | None = None

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Take one event."""
        self.listener.send(event, **fields, id=self.number)


def run(_options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Answer requests until stdin ends; its end, and a line ``cancel``, stop one that goes on."""
    greet(listener)
    lines: SimpleQueue[str] = SimpleQueue()
    busy = threading.Event()
    threading.Thread(target=_listen, args=(lines, busy), name="stdin", daemon=True).start()

    import msgspec

    from gaussiancad_core.run.serving import Request, RequestHandler

    handler = RequestHandler()
    listener.send("ready")
    while (line := lines.get()) != _END:
        try:
            request = msgspec.json.decode(line, type=Request)
        # Bytes that are no text are none of it either.
        except (msgspec.MsgspecError, UnicodeError, RecursionError) as error:
            message = Message("this is no request: {reason}", reason=error)
            listener.send("answer", id=None, **_refusal(Code.UNKNOWN_REQUEST, message))
            continue
        numbered = _Numbered(listener, request.id)
        busy.set()
        try:
            answer = handler.answer(request, numbered)
        except CancelledError:
            raise
        except GaussianCadError as error:
            known = out_of_files(error) or error
            answer = _refusal(known.code, known.message)
        except Exception as error:
            answer = _failed(error, Path(request.sheet))
        finally:
            # Who has the answer may end stdin: then nothing goes on any more.
            busy.clear()
        numbered.send("answer", **answer)
    return ExitCode.DONE


def _failed(error: Exception, sheet: Path) -> dict[str, Any]:
    """The answer where a request met what nobody foresaw: the next one may go well."""
    if (no_files := out_of_files(error)) is not None:
        return _refusal(no_files.code, no_files.message)
    if is_out_of_memory(error):
        return _refusal(Code.OUT_OF_MEMORY, "the memory does not suffice: use a smaller file")

    from gaussiancad_core.storage.crash_reports import unforeseen

    found = unforeseen(error, [sheet])
    return _refusal(found.code, found.message)


def _refusal(code: str, message: str) -> dict[str, Any]:
    return {"error": event_fields(code, on_one_line(message))}


def _listen(lines: "SimpleQueue[str]", busy: threading.Event) -> None:
    """Take lines from stdin; what stops everything is not left waiting behind a request."""
    for line in sys.stdin:
        if line.strip() == "cancel":
            stop_main_thread()
            return
        if line.strip():
            lines.put(line)
    if busy.is_set():
        stop_main_thread()
    lines.put(_END)

"""The server: tools of the Model Context Protocol over standard input and output.

Runs of the engine go on in threads, two at a time; a call that the client cancels, and the end of
the client, stop them.  Nothing but the protocol is written to standard output.
"""

import json
import os
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import anyio
import anyio.abc
from anyio import to_thread
from mcp import types
from mcp.server.context import ServerRequestContext
from mcp.server.lowlevel.server import Server
from mcp.server.stdio import stdio_server

from gaussiancad.agent.agent_tools import AgentTools, Answer
from gaussiancad.agent.allowed_paths import WorkFolder
from gaussiancad.agent.tool_arguments import decoded
from gaussiancad.agent.tool_list import INSTRUCTIONS, TOOLS, AgentTool
from gaussiancad_core import __version__
from gaussiancad_core.errors import (
    CancelledError,
    GaussianCadError,
    LimitError,
    UsageError,
    is_out_of_memory,
    out_of_files,
)
from gaussiancad_core.messages import on_one_line
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_MOST_RUNS = 2
"""Runs of the engine at once; others wait."""

_SECONDS_BETWEEN = 1.0
"""Notices of progress."""

_SECONDS_TO_END = 2.0
"""That the streams have to close; a client that reads no more may hold them."""


@dataclass
class _Run:
    """One call, as its thread and the server's loop see it.

    Attributes:
        call: what it does, told how far it is.
        stopped: whether nobody waits for its answer any more.
        running: the stage, and the fraction of it that is done.
    """

    call: Callable[[Callable[[str, float], None]], Answer]
    stopped: threading.Event = field(default_factory=threading.Event)
    running: tuple[str, float] | None = None

    def answer(self) -> Answer:
        """Do it, in a thread."""
        return self.call(self._progress)

    def _progress(self, stage: str, fraction: float) -> None:
        if self.stopped.is_set():
            raise CancelledError(Code.CANCELLED, "the client cancelled the call")
        self.running = stage, fraction


@dataclass
class _Handlers:
    """What the server does when it is asked.

    Attributes:
        tools: of the folder.
        runs: limits runs of the engine.
    """

    tools: AgentTools
    runs: anyio.CapacityLimiter

    async def list_tools(
        self, _context: ServerRequestContext[Any], _params: types.PaginatedRequestParams | None
    ) -> types.ListToolsResult:
        """All tools, on one page."""
        return types.ListToolsResult(tools=[tool.described() for tool in TOOLS.values()])

    async def call_tool(
        self, context: ServerRequestContext[Any], params: types.CallToolRequestParams
    ) -> types.CallToolResult:
        """The answer of a tool, or its error: whatever is asked, the server goes on."""
        try:
            tool = TOOLS.get(params.name)
            if tool is None:
                raise UsageError(
                    Code.UNKNOWN_REQUEST,
                    "there is no tool {name}; there are: {known}",
                    name=params.name[:100],
                    known=", ".join(TOOLS),
                )
            return _content(await self._answer(tool, params.arguments or {}, context))
        except Exception as error:
            return _refusal(_meaning(error))

    async def _answer(
        self, tool: AgentTool, values: dict[str, Any], context: ServerRequestContext[Any]
    ) -> Answer:
        arguments = decoded(tool.name, tool.arguments, values)
        run = _Run(partial(getattr(self.tools, tool.name), arguments))
        failure: Exception | None = None
        answer = Answer("")
        async with anyio.create_task_group() as group:
            group.start_soon(_report, run, context)
            try:
                limiter = self.runs if tool.runs_engine else None
                # It ends with the thread, so that a run that is being stopped counts as one.
                answer = await to_thread.run_sync(run.answer, limiter=limiter)
            except Exception as error:
                failure = error
            group.cancel_scope.cancel()
        if failure is not None:
            raise failure
        return answer


async def _report(run: _Run, context: ServerRequestContext[Any]) -> None:
    """Tell the client how far a run is; a call that is cancelled takes its run with it."""
    began = time.monotonic()
    try:
        while True:
            await anyio.sleep(_SECONDS_BETWEEN)
            stage, fraction = run.running or ("waiting", 0.0)
            # How long all stages take nobody knows before: what grows is the time.
            seconds = round(time.monotonic() - began, 1)
            message = f"{stage}, {fraction:.0%}" if fraction else stage
            await context.session.report_progress(seconds, message=message)
    finally:
        run.stopped.set()


def _content(answer: Answer) -> types.CallToolResult:
    text = answer.values
    if not isinstance(text, str):
        text = json.dumps(text, ensure_ascii=False, separators=(",", ":"))
    # No structured content beside it: some clients then drop the pictures.
    return types.CallToolResult(
        content=[
            types.TextContent(type="text", text=text),
            *(
                types.ImageContent(type="image", data=picture.base64, mime_type=picture.kind)
                for picture in answer.pictures
            ),
        ]
    )


def _refusal(error: GaussianCadError) -> types.CallToolResult:
    values = {"code": str(error.code), "message": on_one_line(error.message)}
    text = json.dumps({"error": values}, ensure_ascii=False)
    return types.CallToolResult(content=[types.TextContent(type="text", text=text)], is_error=True)


def _meaning(error: Exception) -> GaussianCadError:
    """What an agent is told of an error."""
    known = out_of_files(error) or (error if isinstance(error, GaussianCadError) else None)
    if known is not None:
        return known
    if is_out_of_memory(error):
        return LimitError(Code.OUT_OF_MEMORY, "the memory does not suffice: use a smaller file")
    from gaussiancad_core.storage.crash_reports import unforeseen

    return unforeseen(error)


def serve(folder: Path) -> int:
    """Serve until the client ends the input, or a signal ends the server.

    Args:
        folder: that it works in.

    Returns:
        The exit code.

    Raises:
        UsageError: ``path-not-usable``.
    """
    return anyio.run(_serve, WorkFolder.at(folder))


async def _serve(work: WorkFolder) -> int:
    handlers = _Handlers(AgentTools(work), anyio.CapacityLimiter(_MOST_RUNS))
    server: Server[Any] = Server(
        "gaussiancad",
        version=__version__,
        title="GaussianCAD",
        instructions=INSTRUCTIONS,
        on_list_tools=handlers.list_tools,
        on_call_tool=handlers.call_tool,
    )
    ended = ExitCode.DONE
    async with stdio_server() as (incoming, outgoing), anyio.create_task_group() as group:
        signalled = anyio.Event()
        group.start_soon(_end_on_signal, group.cancel_scope, signalled)
        try:
            await server.run(incoming, outgoing, server.create_initialization_options())
        finally:
            # All runs have ended.
            ended = ExitCode.CANCELLED if signalled.is_set() else ExitCode.DONE
            _end_soon(int(ended))
            group.cancel_scope.cancel()
    return int(ended)


async def _end_on_signal(scope: anyio.CancelScope, signalled: anyio.Event) -> None:
    with anyio.open_signal_receiver(signal.SIGTERM, signal.SIGINT) as signals:
        async for _number in signals:
            signalled.set()
            scope.cancel()


def _end_soon(exit_code: int) -> None:
    """End the process, also where a stream to or from the client does not close."""
    timer = threading.Timer(_SECONDS_TO_END, os._exit, (exit_code,))
    timer.daemon = True
    timer.start()

"""The ``gaussiancad`` command.

Each subcommand has a module of its own that adds its parser and runs it; heavy libraries are only
imported once a command runs.
"""

import sys
from collections.abc import Sequence

from gaussiancad_core.cli.libraries import prepare_environment
from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.errors import (
    CancelledError,
    ExitCode,
    GaussianCadError,
    is_out_of_memory,
)
from gaussiancad_core.events import (
    Cancellation,
    Listener,
    Silence,
    cancel_on_stdin,
    open_event_stream,
)
from gaussiancad_core.messages import Message, on_one_line, told


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    options = build_parser().parse_args(arguments)
    options.arguments = list(sys.argv[1:] if arguments is None else arguments)
    prepare_environment()
    listener: Listener = Silence()
    cancellation = Cancellation()
    try:
        if options.events:
            listener = open_event_stream()
            if not options.serves:
                cancel_on_stdin()
        return int(options.run(options, listener))
    except GaussianCadError as error:
        return _tell(listener, error.code, error.message, error.exit_code)
    except (SystemError, ImportError) as error:
        # A compiled function or a module that is interrupted says only that it failed.
        cancelled = cancellation.raised
        if cancelled is not None:
            return _tell(listener, cancelled.code, cancelled.message, cancelled.exit_code)
        if isinstance(error, SystemError):
            raise
        message = Message(
            "the engine is incomplete ({reason}): run `gaussiancad doctor`", reason=error
        )
        return _tell(listener, "engine-incomplete", message, ExitCode.ENGINE)
    except KeyboardInterrupt:
        return _tell(listener, "cancelled", "stopped by SIGINT", CancelledError.exit_code)
    except Exception as error:
        if not is_out_of_memory(error):
            raise
        message = "the memory does not suffice: use --preset draft or a smaller file"
        return _tell(listener, "out-of-memory", message, ExitCode.LIMIT)
    finally:
        cancellation.end()


def _tell(listener: Listener, code: str, message: str, exit_code: ExitCode) -> int:
    """One line on stderr, one event, and the exit code."""
    line = on_one_line(message)
    print(f"gaussiancad: {line} [{code}]", file=sys.stderr, flush=True)
    listener.send("error", **told(code, line), exit_code=int(exit_code))
    return int(exit_code)

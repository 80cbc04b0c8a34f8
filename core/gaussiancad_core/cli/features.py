"""``gaussiancad features``: a solid to the sketches, pads, pockets and holes that make it."""

import argparse

from gaussiancad_core.cli import values
from gaussiancad_core.cli.streams import say
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.messages import on_one_line
from gaussiancad_core.processes.events import Listener
from gaussiancad_protocol.exit_codes import ExitCode

_USUAL_MEMORY, _USUAL_SECONDS = 8.0, 120.0
"""GB and s within which features are looked for, unless other limits are given."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("features", help="find the features that make up a solid")
    parser.add_argument("solid", type=named_path, metavar="SOLID", help="STEP or BREP")
    parser.add_argument(
        "--output",
        type=named_path,
        required=True,
        metavar="DIR",
        help="folder for features.json and features.py (build123d)",
    )
    parser.add_argument(
        "--memory", type=values.positive, default=_USUAL_MEMORY, metavar="GB", help="at most"
    )
    parser.add_argument(
        "--seconds", type=values.positive, default=_USUAL_SECONDS, metavar="S", help="at most"
    )
    parser.add_argument("--unlimited", action="store_true", help=argparse.SUPPRESS)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Find features in a limited process; what takes too long stays a base without any."""
    from gaussiancad_core.processes.library_behaviour import silence_opencascade

    broken_off = ""
    if not options.unlimited:
        from gaussiancad_core.processes.supervisor import ProcessLimits, run_limited

        limits = ProcessLimits(int(options.memory * 2**30), options.seconds)
        command, *rest = options.arguments
        ended = run_limited([command, "--unlimited", *rest], limits)
        if ended.exit_code == 0:
            print(ended.output.decode("utf-8", "replace"), end="")
            return ExitCode.DONE
        broken_off = ended.message
    silence_opencascade()
    from gaussiancad_core.features.features_command import write_features

    found = write_features(options.solid, options.output, find=options.unlimited)
    name = on_one_line(str(options.output))
    count = sum(len(features.features) for features in found)
    whole = sum(features.is_whole for features in found)
    if broken_off:
        say(f"gaussiancad: warning: features were not looked for to the end: {broken_off}")
    print(f"{name}: {count} features; {whole} of {len(found)} solids by features alone")
    return ExitCode.DONE

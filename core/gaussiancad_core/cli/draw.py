"""``gaussiancad draw``: a solid to a three-view sheet."""

import argparse
from dataclasses import replace
from functools import partial

from gaussiancad_core.cli import values
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.messages import on_one_line
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.processes.events import Listener
from gaussiancad_protocol.exit_codes import ExitCode


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("draw", help="draw a three-view sheet of a solid")
    parser.add_argument("solid", type=named_path, metavar="SOLID", help="STEP or BREP")
    parser.add_argument(
        "sheet", type=named_path, metavar="SHEET", help="image to write, e.g. sheet.png"
    )
    parser.add_argument(
        "--views",
        type=values.roles,
        default=(Role.FRONT, Role.TOP, Role.RIGHT),
        metavar="ROLE,ROLE,ROLE",
        help="front, top, right, left, bottom, rear",
    )
    parser.add_argument(
        "--projection",
        type=partial(values.choice, Projection),
        default=Projection.THIRD,
        metavar="third|first",
    )
    parser.add_argument(
        "--style", default="clean", metavar="NAME,KEY=VALUE", help="a named style and its changes"
    )
    parser.add_argument(
        "--tangent-edges",
        type=values.tangent_policy,
        default=None,
        metavar="drawn|thin|left-out",
        help="lines where faces meet smoothly: as other edges, thin, or none (the default)",
    )
    parser.add_argument("--seed", type=values.whole, default=0, metavar="N")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Draw a solid."""
    from gaussiancad_core.drawing.draw_command import draw_file
    from gaussiancad_core.drawing.sheet_style import parse_style
    from gaussiancad_core.processes.library_behaviour import silence_opencascade

    silence_opencascade()
    style = parse_style(options.style)
    if options.tangent_edges is not None:
        style = replace(style, tangent_edges=options.tangent_edges)
    drawn = draw_file(
        options.solid,
        options.sheet,
        options.views,
        options.projection,
        style,
        seed=options.seed,
    )
    name = on_one_line(str(options.sheet))
    print(f"{name}: {len(drawn.views)} views, {drawn.mm_per_pixel:.6g} mm per px")
    return ExitCode.DONE

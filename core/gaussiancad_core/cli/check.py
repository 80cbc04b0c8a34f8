"""``gaussiancad check``: does a model agree with its drawing?"""

import argparse
import json
from typing import Any

from gaussiancad_core.cli.pages import add_page_option
from gaussiancad_core.cli.reconstruct import (
    add_events_option,
    add_overwrite_option,
    add_reading_files,
    add_reading_options,
    greet,
    reading_of,
)
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.messages import on_one_line
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.processes.garbage import uncollected
from gaussiancad_core.report.job import Job, corrections_file_of
from gaussiancad_core.storage.outputs import CHECK_FILES
from gaussiancad_protocol.exit_codes import ExitCode

_EXITS = {
    "agrees": ExitCode.DONE,
    "differs": ExitCode.NO_MODEL,
    "cannot-tell": ExitCode.LIMIT,
}

_MOST_ROWS = 12
"""Differences that are printed."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("check", help="tell whether a model agrees with its drawing")
    parser.add_argument(
        "sheet",
        type=named_path,
        metavar="SHEET",
        help="PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF",
    )
    parser.add_argument(
        "solid", type=named_path, metavar="SOLID", help="STEP, BREP, STL, PLY or OBJ"
    )
    parser.add_argument("--output", type=named_path, required=True, metavar="DIR")
    parser.add_argument("--json", action="store_true", help="print check.json")
    add_page_option(parser)
    add_reading_options(parser)
    add_reading_files(parser)
    add_overwrite_option(parser)
    add_events_option(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Check one model against one page; the exit code tells the verdict."""
    greet(listener)
    job = Job(
        sheet=options.sheet,
        output=options.output,
        reading=reading_of(options),
        page=options.page,
        given=options.reading,
        corrections=options.corrections or corrections_file_of(options.sheet, options.page),
        overwrite=options.overwrite,
    )
    with uncollected():
        from gaussiancad_core.processes.library_behaviour import silence_opencascade
        from gaussiancad_core.run.sheet_check import check_to_folder

    silence_opencascade()
    job.check(CHECK_FILES)
    found = check_to_folder(job, options.solid, listener)
    path = (options.output / CHECK_FILES[0]).resolve()
    listener.send("result", path=str(path), verdict=found.verdict.value)
    if options.json:
        print(json.dumps(found.values))
    elif not options.events:
        print("\n".join(_sentences(found.values, str(path))))
    return _EXITS[found.verdict.value]


def _sentences(values: dict[str, Any], path: str) -> list[str]:
    verdict = values["verdict"].replace("-", " ")
    rows = [f"{verdict}: {on_one_line(path)}"]
    rows += [f"  {on_one_line(each['message'])} [{each['code']}]" for each in values["reasons"]]
    differences = values["differences"]
    for each in differences[:_MOST_ROWS]:
        (x0, y0), (x1, y1) = each["ends"]
        what = f"{each['kind']} {each['of']}, {each['length_mm']:.3g} mm"
        if each["stated"] is not None:
            text = on_one_line(each["text"])
            what = f"{each['kind']} {text}: {each['measured']} instead of {each['stated']}"
        rows.append(f"  {what}, {each['view']} view, ({x0:.0f}, {y0:.0f})-({x1:.0f}, {y1:.0f}) px")
    if len(differences) > _MOST_ROWS:
        rows.append(f"  and {len(differences) - _MOST_ROWS} more: see check.json and check.png")
    return rows

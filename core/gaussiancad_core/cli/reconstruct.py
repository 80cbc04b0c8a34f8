"""``gaussiancad reconstruct``: one sheet to a model."""

import argparse
from dataclasses import replace
from functools import partial
from pathlib import Path

from gaussiancad_core.cli import values
from gaussiancad_core.cli.pages import add_page_option, run_pages
from gaussiancad_core.cli.streams import say
from gaussiancad_core.cli.terminal import summary
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.errors import UsageError
from gaussiancad_core.messages import on_one_line
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.report.job import Job, corrections_file_of
from gaussiancad_core.sheet.reading_options import MEDIAN_KERNEL, FileUnit, ReadingOptions
from gaussiancad_core.storage.extras import Extra, lacking, result_kind
from gaussiancad_core.storage.outputs import REPORT_FILE, RUN_FILES
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.event_lines import PROTOCOL
from gaussiancad_protocol.exit_codes import ExitCode
from gaussiancad_protocol.modes import Device, Preset, Recipe, ResultKind, SolidWay

SOLID_WAY = "--solid-way"
"""The option that leaves out ways in which an exact solid is looked for."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("reconstruct", help="make a model from a sheet")
    parser.add_argument(
        "sheet",
        type=named_path,
        metavar="SHEET",
        help="PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF",
    )
    parser.add_argument("--output", type=named_path, required=True, metavar="DIR")
    add_page_option(parser)
    add_job_options(parser)
    add_reading_files(parser)
    add_events_option(parser)
    # Of whoever starts the run again after a library has ended it.
    parser.add_argument(
        SOLID_WAY,
        type=partial(values.choice, SolidWay),
        default=SolidWay.ALL,
        help=argparse.SUPPRESS,
    )
    parser.set_defaults(run=run)


def add_reading_files(parser: argparse.ArgumentParser) -> None:
    """The files that say what is on a sheet."""
    parser.add_argument(
        "--reading",
        type=named_path,
        metavar="READING.json",
        help="what `gaussiancad read` wrote, taken instead of reading the sheet",
    )
    parser.add_argument(
        "--corrections",
        type=named_path,
        metavar="FILE.json",
        help="a person's corrections; those in SHEET.corrections.json are taken anyway",
    )


def add_events_option(parser: argparse.ArgumentParser) -> None:
    """The option for who starts the engine as a process."""
    parser.add_argument(
        "--events", action="store_true", help="JSON lines on stdout; cancel on stdin stops the run"
    )
    parser.add_argument(
        "-v", "--verbose", action="store_true", help="print each stage with its seconds, on stderr"
    )


def add_reading_options(parser: argparse.ArgumentParser) -> None:
    """Options that say how sheets are read."""
    parser.add_argument(
        "--projection",
        choices=("auto", "first", "third"),
        default="auto",
        help="first or third angle",
    )
    parser.add_argument(
        "--view",
        type=values.view_box,
        action="append",
        default=[],
        metavar="ROLE=X0,Y0,X1,Y1",
        help="name a view by a box around it in px; repeat for each",
    )
    parser.add_argument(
        "--unit",
        type=partial(values.choice, FileUnit),
        metavar="|".join(member.value for member in FileUnit),
        help="of a file that does not say its own, and of its numbers (mm, in)",
    )
    parser.add_argument(
        "--length",
        type=values.axis_length,
        action="append",
        metavar="AXIS=MM",
        help="the part's extent on x, y or z; y is the thickness of a plate in one view; repeat "
        "for a plate whose scale is not known",
    )
    parser.add_argument("--mm-per-pixel", type=values.length, metavar="S")
    parser.add_argument(
        "--median",
        type=int,
        choices=(0, 3, 5, 7),
        default=MEDIAN_KERNEL,
        help="side in px of the filter that tells noise from ink; 0 for none",
    )


def add_overwrite_option(parser: argparse.ArgumentParser) -> None:
    """The option for who wants other files than those of earlier runs replaced."""
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace files of the same names in the output folder that no run made, too",
    )


def add_job_options(parser: argparse.ArgumentParser) -> None:
    """Options that say how sheets are read and reconstructed."""
    add_reading_options(parser)
    for option, kind, default in (
        # What is installed for, where nothing is asked for.
        ("--result", ResultKind, None),
        ("--recipe", Recipe, Recipe.ORTHOGRAPHIC),
        ("--preset", Preset, Preset.STANDARD),
        ("--device", Device, Device.AUTO),
    ):
        parser.add_argument(
            option,
            type=partial(values.choice, kind),
            default=default,
            metavar="|".join(member.value for member in kind),
        )
    parser.add_argument("--colour", type=values.colour, default=(120, 160, 210), metavar="#RRGGBB")
    parser.add_argument("--seed", type=values.whole, default=0, metavar="N")
    parser.add_argument(
        "--scale-down",
        type=values.count,
        default=1,
        metavar="N",
        help="train on images whose edges are N times shorter",
    )
    parser.add_argument(
        "--transforms",
        action="store_true",
        help="write cameras/transforms.json for nerfstudio, too",
    )
    add_overwrite_option(parser)
    parser.add_argument(
        "--resume",
        action="store_true",
        help="keep a finished result of the same sheet and options, or go on with its training",
    )


def reading_of(options: argparse.Namespace) -> ReadingOptions:
    """What the options say of the sheet.

    Raises:
        UsageError: ``view-repeated`` if two boxes name one role, ``length-repeated`` if two
            lengths name one axis.
    """
    named = [role for role, _ in options.view]
    if len(set(named)) < len(named):
        raise UsageError(Code.VIEW_REPEATED, "--view: each role can be named once only")
    lengths = tuple(options.length or ())
    if len({axis for axis, _ in lengths}) < len(lengths):
        raise UsageError(Code.LENGTH_REPEATED, "--length: each axis can be named once only")
    return ReadingOptions(
        projection=None if options.projection == "auto" else Projection(options.projection),
        views=tuple(options.view),
        lengths=lengths,
        mm_per_pixel=options.mm_per_pixel,
        unit=options.unit,
        median_kernel=options.median,
    )


def job_of(options: argparse.Namespace, sheet: Path, output: Path) -> Job:
    """The job that the options describe.

    Raises:
        UsageError: ``view-repeated`` if two boxes name one role, ``length-repeated`` if two
            lengths name one axis.
    """
    return Job(
        sheet=sheet,
        output=output,
        reading=replace(reading_of(options), colour=options.colour),
        page=options.page,
        result=result_kind(options.result),
        surface_left_out=options.result is None and bool(lacking(Extra.SURFACE)),
        recipe=options.recipe,
        preset=options.preset,
        seed=options.seed,
        device=options.device,
        resume=options.resume,
        scale_down=options.scale_down,
        transforms=options.transforms,
        overwrite=options.overwrite,
    )


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Reconstruct one sheet, or each page of a file."""
    from gaussiancad_core.batches.batch_folder_names import folder_names

    (name,) = folder_names([options.sheet])
    greet(listener, name=name)
    return run_pages(options, listener, _run_page)


def _run_page(options: argparse.Namespace, listener: Listener) -> ExitCode:
    job = replace(
        job_of(options, options.sheet, options.output),
        given=options.reading,
        corrections=options.corrections or corrections_file_of(options.sheet, options.page),
        way=options.solid_way,
    )
    job.check((*RUN_FILES, REPORT_FILE))

    from gaussiancad_core.processes.library_behaviour import silence_opencascade
    from gaussiancad_core.run.pipeline import reconstruct

    silence_opencascade()
    report = reconstruct(job, listener)
    path = (options.output / REPORT_FILE).resolve()
    listener.send("result", path=str(path), status=report.status.value)
    if not options.events:
        print("\n".join(summary(report, path, job.sheet)))
        for warning in report.warnings:
            line = on_one_line(warning.message)
            say(f"gaussiancad: warning: {line} [{warning.code}]")
    return ExitCode.DONE


def greet(listener: Listener, **fields: str) -> None:
    """The first event: the protocol, and the versions of all that counts."""
    from gaussiancad_core import __version__
    from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions

    versions = {"gaussiancad": __version__, **installed_versions(ENGINE_PACKAGES)}
    listener.send("hello", protocol=PROTOCOL, versions=versions, **fields)

"""How many seconds and how much memory does reading take at which size of sheet?

Each sheet is drawn and read in processes of their own, whose largest memory is told.  Lines grow
with the sheet up to 8 px, as those of a scanned sheet would.
"""

import argparse
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

from benchmarks.run.outcome import Figure, Outcome
from gaussiancad_core.report.run_report import peak_memory_mb

MINUTES = 5

WIDTHS = (1920, 4000, 8000, 12000)

USUAL = 1920
"""px: width of the sheet that the styles' line widths are for."""

WIDEST_LINE = 8.0
"""px of lines that are read."""

STAGES = ("file", "clean", "views", "lines", "axes")


def draw(connection: Connection, name: str, width: int, path: Path) -> None:
    """Draw a sample on a sheet of a width and write it; send how many strokes it has."""
    from gaussiancad_core.drawing.draw_command import write_image
    from gaussiancad_core.drawing.drawn_sheet import draw_sheet
    from gaussiancad_core.drawing.sheet_style import PRESETS
    from gaussiancad_core.model.axes import Projection, Role
    from gaussiancad_core.samples import sample

    style = PRESETS["clean"]
    factor = width / USUAL
    lines = min(factor, WIDEST_LINE / style.visible_width)
    look = replace(
        style,
        width=width,
        height=round(style.height * factor),
        margin=style.margin * factor,
        view_gap=style.view_gap * factor,
        visible_width=style.visible_width * lines,
        hidden_width=style.hidden_width * lines,
        dash=style.dash * lines,
        gap=style.gap * lines,
    )
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    sheet = draw_sheet(sample(name).build(), roles, Projection.THIRD, look)
    write_image(sheet.image, path)
    connection.send(sum(len(view.strokes) for view in sheet.views))


def read(connection: Connection, path: Path) -> None:
    """Read a sheet; send seconds of the stages, MB before and at most, and strokes."""
    import cv2

    from gaussiancad_core.recognition.sheet_views import sheet_views
    from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
    from gaussiancad_core.sheet.image.sheet_files import read_sheet
    from gaussiancad_core.sheet.reading_options import ReadingOptions
    from gaussiancad_core.sheet.sheet_stages import read_views, register_views

    cv2.setNumThreads(1)
    marks = [time.perf_counter()]
    before = peak_memory_mb()
    image = read_sheet(path)
    marks.append(time.perf_counter())
    sheet = OpenedSheet(image)
    _ = sheet.clean
    marks.append(time.perf_counter())
    seen = sheet_views(sheet)
    marks.append(time.perf_counter())
    drawn = read_views(seen.separated.part, seen.layout)
    marks.append(time.perf_counter())
    register_views(drawn, ReadingOptions())
    marks.append(time.perf_counter())
    seconds = [after - start for start, after in pairwise(marks)]
    connection.send((seconds, before, peak_memory_mb(), sum(len(v.strokes) for v in drawn)))


def apart(work: Callable[..., None], *arguments: object) -> object:
    """What a function sends from a process of its own."""
    context = get_context("spawn")
    here, there = context.Pipe(duplex=False)
    process = context.Process(target=work, args=(there, *arguments))
    process.start()
    there.close()
    try:
        return here.recv()
    except EOFError as error:
        raise ChildProcessError("the sheet was not read: see above") from error
    finally:
        process.join()


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--part", default="u-bracket")
    parser.add_argument("--widths", type=int, nargs="*", default=WIDTHS)


def run(options: argparse.Namespace) -> Outcome:
    """Print a row for each width."""
    print(f"{'width':>7}{'Mpx':>7}" + "".join(f"{name:>8}" for name in STAGES), end="")
    print(f"{'s':>8}{'us/px':>8}{'MB':>8}{'B/px':>7}{'strokes':>9}")
    figures = []
    with tempfile.TemporaryDirectory() as folder:
        # The first reading compiles kernels that later ones take from their cache.
        path = Path(folder) / "sheet.png"
        apart(draw, options.part, USUAL, path)
        apart(read, path)
        for width in options.widths:
            drawn = apart(draw, options.part, width, path)
            seconds, before, peak, strokes = apart(read, path)
            pixels = width * width * 9 / 16
            print(
                f"{width:7}{pixels / 1e6:7.1f}"
                + "".join(f"{value:8.2f}" for value in seconds)
                + f"{sum(seconds):8.2f}{sum(seconds) / pixels * 1e6:8.2f}{peak:8.0f}"
                f"{(peak - before) * 1e6 / pixels:7.0f}{strokes:5}/{drawn}",
                flush=True,
            )
            figures += [Figure(f"{width} px wide", round(sum(seconds), 2), "s")]
            figures += [Figure(f"{width} px wide", round(peak), "MB")]
    return Outcome(tuple(figures))

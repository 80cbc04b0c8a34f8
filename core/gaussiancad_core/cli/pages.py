"""``--page all``: each page of a file as a sheet of its own, in a folder ``page-N``."""

import argparse
from collections.abc import Callable
from typing import Any

from gaussiancad_core.cli import values
from gaussiancad_core.cli.streams import say
from gaussiancad_core.errors import (
    GaussianCadError,
    LimitError,
    NoModelError,
    UnreadableError,
    UsageError,
)
from gaussiancad_core.messages import event_fields, on_one_line
from gaussiancad_core.processes.events import Listener
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

ALL_PAGES = "all"

OfOnePage = (NoModelError, UnreadableError, LimitError)
"""Errors that end a page, and leave the others to be tried."""


def add_page_option(parser: argparse.ArgumentParser) -> None:
    """The option for commands that may be asked for all pages."""
    parser.add_argument(
        "--page",
        type=_page,
        default=1,
        metavar="N|all",
        help="page of a file that has several; all makes a folder page-N of each",
    )


def run_pages(
    options: argparse.Namespace,
    listener: Listener,
    run: Callable[[argparse.Namespace, Listener], ExitCode],
) -> ExitCode:
    """Run a command for the page that its options name, or for each page.

    Args:
        options: with ``sheet``, ``output``, ``page``, ``reading`` and ``corrections``.
        listener: told of each page with the event ``page``.
        run: the command, for one page.

    Returns:
        Of all pages: done if each is, and that some failed if one at least is.

    Raises:
        UsageError: ``one-page-only`` where a file is given that speaks of one page.
        GaussianCadError: as of the command; what the first page raised, where none is done.
    """
    if options.page != ALL_PAGES:
        return run(options, listener)
    if options.reading is not None or options.corrections is not None:
        raise UsageError(
            Code.ONE_PAGE_ONLY,
            "--reading and --corrections speak of one page: name it with --page N",
        )

    from gaussiancad_core.sheet.image.sheet_files import read_sheet

    count = read_sheet(options.sheet).pages
    failed: list[GaussianCadError] = []
    for number in range(1, count + 1):
        entry: dict[str, Any] = {**vars(options), "page": number}
        entry["output"] = options.output / f"page-{number}"
        listener.send("page", number=number, of=count)
        try:
            run(argparse.Namespace(**entry), listener)
        except OfOnePage as error:
            failed.append(error)
            line = on_one_line(error.message)
            say(f"gaussiancad: page {number}: {line} [{error.code}]")
            listener.send("warning", **event_fields(error.code, line), page=number)
    if len(failed) == count:
        raise failed[0]
    return ExitCode.SOME_SHEETS_FAILED if failed else ExitCode.DONE


def _page(text: str) -> int | str:
    """A page counted from 1, or all of them."""
    return ALL_PAGES if text == ALL_PAGES else values.count(text)

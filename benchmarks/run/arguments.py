"""Options that benchmarks share, and a parser whose errors are one line."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

USAGE = 2
"""Exit code of a command that was called wrongly."""


class OneLineParser(argparse.ArgumentParser):
    """A parser that reports what is wrong with a command in one line."""

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and end with 2."""
        self.exit(USAGE, f"{self.prog}: {message}\n")


def existing_folder(text: str) -> Path:
    """The path of a folder that is there."""
    path = Path(text)
    if not path.is_dir():
        raise argparse.ArgumentTypeError(f"there is no folder {text}")
    return path


def add_running(parser: argparse.ArgumentParser, limit_s: float | None = None) -> None:
    """How tasks are run: workers, the file of rows, and seconds for each task."""
    parser.add_argument("--workers", type=int, default=1, help="processes side by side")
    parser.add_argument("--json", type=Path, help="file of rows: a JSON object a line, one a task")
    parser.add_argument("--resume", action="store_true", help="run only what the file lacks")
    if limit_s is not None:
        parser.add_argument("--limit", type=float, default=limit_s, help="seconds for each task")


def add_data(parser: argparse.ArgumentParser, *, required: bool = True) -> None:
    """A folder of sheets, and which of them count."""
    parser.add_argument("--data", type=existing_folder, required=required, metavar="DIR")
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")


def is_chosen(path: Path, only: Sequence[str]) -> bool:
    """Whether a path has one of some texts in it, or there are none."""
    return not only or any(text in str(path) for text in only)


def tell(text: str) -> None:
    """Write a line for whoever waits."""
    print(text, file=sys.stderr, flush=True)

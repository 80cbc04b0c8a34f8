"""Which benchmarks there are: the modules of ``benchmarks/ask``, each with its question."""

import argparse
import ast
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Protocol, cast

from benchmarks import ask
from benchmarks.run.outcome import Outcome

_FOLDER = Path(ask.__file__).parent


class Benchmark(Protocol):
    """What a module of ``benchmarks/ask`` has.

    Attributes:
        __doc__: the question, a paragraph on the method, and what the output means.
        MINUTES: about how many minutes it takes with its usual options on two cores.
    """

    __doc__: str
    MINUTES: float

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Declare its options."""

    @staticmethod
    def run(options: argparse.Namespace) -> Outcome:
        """Ask, print what is found, and return the figures."""


@dataclass(frozen=True)
class Entry:
    """A benchmark as it is listed.

    Attributes:
        name: of its module.
        question: that it answers.
        method: how, in a few sentences.
        minutes: that it takes.
    """

    name: str
    question: str
    method: str
    minutes: float


def entries() -> tuple[Entry, ...]:
    """All benchmarks by name, found without importing what they need."""
    paths = sorted(_FOLDER.glob("*.py"))
    return tuple(_entry(path) for path in paths if path.stem != "__init__")


def _entry(path: Path) -> Entry:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    question, method, *_ = [*(ast.get_docstring(tree) or "").split("\n\n"), ""]
    (minutes,) = (
        float(ast.literal_eval(node.value))
        for node in tree.body
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "MINUTES"
    )
    return Entry(path.stem, " ".join(question.split()), " ".join(method.split()), minutes)


def load(name: str) -> Benchmark:
    """The module of a benchmark."""
    return cast(Benchmark, import_module(f"{ask.__name__}.{name}"))

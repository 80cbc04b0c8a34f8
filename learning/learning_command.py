"""``python -m learning``: from parts to a trained labels network."""

import argparse
import os
import sys
from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from gaussiancad_core.errors import EngineError, GaussianCadError, UsageError
from gaussiancad_core.processes.library_behaviour import prepare_environment
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_DESCRIPTION = """\
Draw parts, compose sheets of them, train the labels network on them, calibrate and check it on
sheets of other makers, and write DIR/labels.onnx with its digest, DIR/weights.pt to start from
again, and DIR/labels.json, the card. The last line printed is the card's path. With --steps and
the same number of workers two runs on one CPU give the same weights. A folder of sheets has
SOURCE+NAME.img.png beside SOURCE+NAME.lab.png, and LICENCES.json, which maps sources to licences.
"""

_MULTIPLE = 32
"""Px of which the sides of a crop are multiples: the network halves them five times."""

_LEAST_PX = 64

_PACKAGES = ("torch", "onnx")
"""What training takes beside the engine; `make install` brings both."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code."""
    options = _parser().parse_args(arguments)
    prepare_environment()
    try:
        _run(options)
    except GaussianCadError as error:
        print(f"gaussiancad: {error.message} [{error.code}]", file=sys.stderr, flush=True)
        return int(error.exit_code)
    except KeyboardInterrupt:
        print("gaussiancad: stopped by SIGINT [cancelled]", file=sys.stderr, flush=True)
        return int(ExitCode.CANCELLED)
    return int(ExitCode.DONE)


def _run(options: argparse.Namespace) -> None:
    _check(options)
    from learning.network_making import CARD_FILE, Generator, Order, make
    from learning.sheets import font_names, samples
    from learning.training_devices import Place
    from learning.training_parts import drawn_parts

    order = Order(
        out=options.out,
        seconds=options.seconds,
        steps=options.steps,
        parts=options.parts,
        workers=options.workers,
        place=Place(options.device),
        size=options.size,
        batch=options.batch,
        published=options.published,
        validation=options.validation,
        start=options.start,
        seed=options.seed,
    )
    draw = partial(drawn_parts, workers=options.workers)
    make(order, Generator(draw, samples, font_names()), _tell)
    print(order.out / CARD_FILE)


def _check(options: argparse.Namespace) -> None:
    """Tell of numbers that cannot be, and of packages that are not installed.

    Raises:
        EngineError: ``engine-incomplete``.
        UsageError: ``wrong-usage``.
    """
    least = {"seconds": 0, "steps": 0, "parts": 2, "workers": 1, "batch": 1, "seed": 0}
    for name, bound in least.items():
        value = getattr(options, name)
        if value is not None and not value >= bound:
            raise UsageError(
                Code.WRONG_USAGE, "--{name} is {bound} at least", name=name, bound=bound
            )
    if options.size < _LEAST_PX or options.size % _MULTIPLE:
        raise UsageError(
            Code.WRONG_USAGE,
            "--size is a multiple of {multiple} px, and {least} at least",
            multiple=_MULTIPLE,
            least=_LEAST_PX,
        )
    if missing := [name for name in _PACKAGES if find_spec(name) is None]:
        raise EngineError(
            Code.ENGINE_INCOMPLETE,
            "training needs {packages}, which is not installed: run `make install`",
            packages=", ".join(missing),
        )


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m learning", description=_DESCRIPTION)
    add = parser.add_argument
    add("--out", type=Path, required=True, metavar="DIR", help="folder to write to")
    length = parser.add_mutually_exclusive_group()
    length.add_argument("--seconds", type=float, default=520.0, metavar="S", help="of training")
    length.add_argument("--steps", type=int, metavar="N", help="of training, instead of seconds")
    add("--parts", type=int, default=731, metavar="N", help="parts to draw, %(default)s")
    workers = max(1, (os.cpu_count() or 1) - 1)
    add("--workers", type=int, default=workers, metavar="N", help="processes that make sheets")
    add("--device", choices=("auto", "cpu", "cuda"), default="auto")
    add("--size", type=int, default=640, metavar="PX", help="sides of a crop, %(default)s px")
    add("--batch", type=int, default=32, metavar="N", help="crops of a step, %(default)s")
    add("--published", type=Path, metavar="DIR", help="sheets to train on, too")
    add("--validation", type=Path, metavar="DIR", help="sheets to calibrate and check on")
    add("--start", type=Path, metavar="FILE", help="weights.pt to start from")
    add("--seed", type=int, default=0, metavar="N", help="of everything, %(default)s")
    return parser


def _tell(line: str) -> None:
    print(line, file=sys.stderr, flush=True)

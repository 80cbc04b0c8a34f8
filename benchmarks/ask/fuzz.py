"""Do damaged and hostile files lead to anything that the contract does not allow?

Good files of all formats are changed by chance (bytes flipped, pieces left out, doubled, moved,
numbers made absurd) and given to ``reconstruct`` and ``compare``.  Each has to end by itself within
its seconds, with an exit code of the contract, one line on stderr where that is not 0, and nothing
written beside its folder.

The table counts exit codes by format; every breach is listed with its seed, by which it comes
again.  Exit code 1 if there was any.
"""

import argparse
import re
import shutil
import tempfile
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import ezdxf
import numpy as np
from OCP.BRepTools import BRepTools
from PIL import Image

from benchmarks.run.arguments import tell
from benchmarks.run.engine import command
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.kernel.brep import tessellate
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.model.views import Segment
from gaussiancad_core.samples import sample

MINUTES = 60

ALLOWED = frozenset({0, 3, 4, 5})
"""Exit codes that a file alone may lead to."""

_LIMIT_S = 120.0
_TOLD_EVERY = 100
_SAG = 0.1
"""mm of the facets of meshes."""

_ABSURD = (b"0", b"-1", b"1e308", b"nan", b"99999999999999999999", b"1e-320", b"", b"65536")
_NUMBER = re.compile(rb"[-+]?\d+(?:\.\d+)?")

Lot = np.random.Generator
Mutation = Callable[[bytes, Lot], bytes]


@dataclass(frozen=True)
class Breach:
    """What a command did that it must not do."""

    seed: int
    name: str
    what: str


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--mutants", type=int, default=500)
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="folder for the files of breaches")


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    with tempfile.TemporaryDirectory() as folder:
        good = good_files(Path(folder))
        seeds = range(options.first, options.first + options.mutants)
        work = partial(tried, good, Path(folder), keep=options.keep)
        codes: dict[str, Counter[int]] = defaultdict(Counter)
        breaches: list[Breach] = []
        with ThreadPoolExecutor(options.workers) as pool:
            for count, (suffix, code, found) in enumerate(pool.map(work, seeds), start=1):
                codes[suffix][code] += 1
                breaches += found
                for breach in found:
                    print(f"BREACH {breach.seed} {breach.name}: {breach.what}", flush=True)
                if count % _TOLD_EVERY == 0:
                    tell(f"{count} of {options.mutants}")
    for suffix, counts in sorted(codes.items()):
        cells = ", ".join(f"{code}: {count}" for code, count in sorted(counts.items()))
        print(f"{suffix:6} {sum(counts.values()):6}  {cells}")
    figures = Figure("breaches", len(breaches)), Figure("mutants", options.mutants)
    return Outcome(figures, wrong=bool(breaches))


def good_files(folder: Path) -> list[Path]:
    """A file of each format: sheets of a part, and the part."""
    shape = sample("l-bracket").build()
    lines = part_lines(shape, ROLES)
    sheet = compose_sheet(lines, Projection.THIRD, parse_style("clean"), 0, title="BRACKET")
    image = Image.fromarray(sheet.image).convert("L")
    image.thumbnail((900, 900))
    write_image(np.asarray(image), folder / "good.png", 95, None)
    for suffix in ("jpg", "tif", "bmp", "webp", "pdf"):
        image.save(folder / f"good.{suffix}")
    drawing, parts = ezdxf.new(), []
    for at, strokes in enumerate(lines.views.values()):
        for stroke in strokes:
            if isinstance(stroke, Segment):
                (x0, y0), (x1, y1) = stroke.start, stroke.end
                x0, x1 = x0 + 120.0 * at, x1 + 120.0 * at
                drawing.modelspace().add_line((x0, y0), (x1, y1))
                parts.append(f'<path d="M{x0} {-y0}L{x1} {-y1}" stroke="black"/>')
    drawing.saveas(folder / "good.dxf")
    shown = "".join(parts)
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-10 -90 400 110">{shown}</svg>'
    (folder / "good.svg").write_text(svg)
    write_step(shape, folder / "good.step")
    BRepTools.Write_s(shape, str(folder / "good.brep"))
    body = make_mesh(*tessellate(shape, _SAG)).to_trimesh()
    for suffix in ("stl", "ply", "obj"):
        body.export(folder / f"good.{suffix}")
    return sorted(folder.glob("good.*"))


def mutant(content: bytes, lot: Lot) -> bytes:
    """The content with one or two changes."""
    for _ in range(int(lot.integers(1, 3))):
        change = _MUTATIONS[int(lot.integers(len(_MUTATIONS)))]
        content = change(content, lot) or b"\0"
    return content


def _flipped(content: bytes, lot: Lot) -> bytes:
    changed = bytearray(content)
    for at in lot.integers(len(content), size=int(lot.integers(1, 20))):
        changed[at] ^= 1 << int(lot.integers(8))
    return bytes(changed)


def _piece(content: bytes, lot: Lot) -> tuple[int, int]:
    start = int(lot.integers(len(content)))
    return start, min(len(content), start + int(lot.integers(1, 1 << int(lot.integers(1, 12)))))


def _left_out(content: bytes, lot: Lot) -> bytes:
    start, end = _piece(content, lot)
    return content[:start] + content[end:]


def _doubled(content: bytes, lot: Lot) -> bytes:
    start, end = _piece(content, lot)
    return content[:end] + content[start:end] * int(lot.integers(1, 50)) + content[end:]


def _moved(content: bytes, lot: Lot) -> bytes:
    start, end = _piece(content, lot)
    at = int(lot.integers(len(content)))
    return content[:at] + content[start:end] + content[at:]


def _cut(content: bytes, lot: Lot) -> bytes:
    return content[: int(lot.integers(1, len(content) + 1))]


def _absurd(content: bytes, lot: Lot) -> bytes:
    numbers = list(_NUMBER.finditer(content))
    if not numbers:
        return _flipped(content, lot)
    found = numbers[int(lot.integers(len(numbers)))]
    return (
        content[: found.start()] + _ABSURD[int(lot.integers(len(_ABSURD)))] + content[found.end() :]
    )


_MUTATIONS: Sequence[Mutation] = (_flipped, _left_out, _doubled, _moved, _cut, _absurd, _absurd)


def tried(
    good: Sequence[Path], root: Path, seed: int, keep: Path | None
) -> tuple[str, int, list[Breach]]:
    """The format, the exit code and the breaches of one mutant."""
    lot = np.random.default_rng(seed)
    source = good[seed % len(good)]
    with tempfile.TemporaryDirectory(dir=root) as temporary_directory:
        place = Path(temporary_directory)
        (place / "in").mkdir()
        path = place / "in" / source.name
        path.write_bytes(mutant(source.read_bytes(), lot))
        output = ["--output", str(place / "out")]
        if source.suffix in (".step", ".brep", ".stl", ".ply", ".obj"):
            arguments = ["compare", str(path), str(root / "good.step"), "--points", "200", *output]
            arguments += ["--seconds", "60"]
        else:
            arguments = ["reconstruct", str(path), "--result", "solid", *output]
        ended = command(*arguments, limit_s=_LIMIT_S)
        # -1: it did not end in time.
        code = -1 if ended.exit_code is None else ended.exit_code
        faults: list[str] = []
        if code not in ALLOWED:
            faults.append(f"exit code {code}")
        # Warnings have lines of their own.
        lines = [line for line in ended.stderr.splitlines() if ": warning: " not in line]
        if code and len(lines) != 1:
            faults.append(f"{len(lines)} lines on stderr: {lines[-1] if lines else ''}")
        if code == 0 and lines:
            faults.append(f"lines on stderr: {lines[0]}")
        strange = {entry.name for entry in place.iterdir()} - {"in", "out"}
        if strange or len(list((place / "in").iterdir())) != 1:
            faults.append(f"written beside its folder: {sorted(strange)}")
        if faults and keep is not None:
            keep.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, keep / f"{seed}{source.suffix}")
        return source.suffix, code, [Breach(seed, source.name, what) for what in faults]

"""The parts of ``exact_solid``: made by class, STEP files, or pairs of STEP and DXF."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import moved_to_origin, subshapes
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.samples.classed import LEVEL_FACES, PartClass, classed_part

USUAL_LEVELS = 7
"""Levels of the usual parts, up to 120 faces; the next one goes to 150, all others are huge."""


@dataclass(frozen=True)
class Case:
    """A part to be drawn and solved.

    Attributes:
        name: unique.
        group: the row of the table.
        seed, level: of a part made by class; the seed is that of noise, too.
        step: file of the solid, where it is not made by class.
        dxf: file of its drawing in third angle, where there is one.
    """

    name: str
    group: str
    seed: int = 0
    level: int = 0
    step: Path | None = None
    dxf: Path | None = None

    def truth(self) -> TopoDS_Shape:
        """The solid, its box starting at the origin; faces that continue each other are one."""
        if self.step is None:
            return classed_part(PartClass(self.group), self.seed, self.level)
        unifier = ShapeUpgrade_UnifySameDomain(read_solid(self.step), True, True, False)
        unifier.Build()
        solids = subshapes(unifier.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
        return moved_to_origin(solids[0] if len(solids) == 1 else unifier.Shape())


def classed_cases(
    classes: list[PartClass], parts: int, seed: int, large: int, huge: int = 0
) -> Iterator[Case]:
    """Parts of all usual levels in turn; large ones with planes, and huge ones of all classes."""
    for kind in classes:
        for number in range(seed, seed + parts):
            level = number % USUAL_LEVELS
            yield Case(f"{kind.value}-{number}", kind.value, number, level)
    if PartClass.PLANES in classes:
        for number in range(seed, seed + large):
            name = f"{PartClass.PLANES.value}-large-{number}"
            yield Case(name, PartClass.PLANES.value, number, USUAL_LEVELS)
    levels = range(USUAL_LEVELS + 1, len(LEVEL_FACES))
    for kind in classes:
        for number in range(seed, seed + huge):
            level = levels[number % len(levels)]
            yield Case(f"{kind.value}-huge-{number}", kind.value, number, level)


def folder_cases(folder: Path, parts: int) -> Iterator[Case]:
    """STEP files of a folder; as pairs where DXF files of the same names lie beside them.

    Of a folder with pairs only the pairs are taken, and only even numbers where names are numbers:
    the odd ones are somebody else's test.
    """
    steps = sorted(path for path in folder.iterdir() if path.suffix.lower() in (".step", ".stp"))
    pairs = [(path, path.with_suffix(".dxf")) for path in steps]
    pairs = [(step, dxf) for step, dxf in pairs if dxf.exists() and not _odd(step.stem)]
    if pairs:
        for number, (step, dxf) in enumerate(pairs[:parts]):
            yield Case(step.stem, folder.name, number, step=step, dxf=dxf)
        return
    for number, step in enumerate(steps[:parts]):
        yield Case(step.stem, folder.name, number, step=step)


def _odd(name: str) -> bool:
    return name.isdecimal() and int(name) % 2 == 1

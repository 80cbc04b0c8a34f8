"""Parts of benchmarks: made by class, or STEP files."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import moved_to_origin, subshapes
from gaussiancad_core.kernel.brep_files import read_solid
from sample_parts.classed import PartClass, classed_part

USUAL_LEVELS = 7
"""Levels of the parts in turn: up to 120 faces."""


@dataclass(frozen=True)
class Case:
    """A part to be drawn and solved.

    Attributes:
        name: unique.
        group: the row of the table.
        seed, level: of a part made by class; the seed is that of noise, too.
        step: file of the solid, where it is not made by class.
    """

    name: str
    group: str
    seed: int = 0
    level: int = 0
    step: Path | None = None

    def truth(self) -> TopoDS_Shape:
        """The solid, its box starting at the origin; faces that continue each other are one."""
        if self.step is None:
            return classed_part(PartClass(self.group), self.seed, self.level)
        unifier = ShapeUpgrade_UnifySameDomain(read_solid(self.step), True, True, False)
        unifier.Build()
        solids = subshapes(unifier.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
        return moved_to_origin(solids[0] if len(solids) == 1 else unifier.Shape())


def classed_cases(classes: Sequence[PartClass], parts: int, seed: int) -> Iterator[Case]:
    """So many parts of each class from a seed on, of all levels in turn."""
    for kind in classes:
        for number in range(seed, seed + parts):
            level = number % USUAL_LEVELS
            yield Case(f"{kind.value}-{number}", kind.value, number, level)

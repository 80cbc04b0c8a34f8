"""Space with labels: which points are material."""

from dataclasses import dataclass

from gaussiancad_core.cells.cell_complex import CellComplex
from gaussiancad_core.labelling.clauses import Labels
from gaussiancad_core.model.axes import Axis, Vector


@dataclass(frozen=True)
class LabelledComplex:
    """Cells and their labels.

    Attributes:
        space: the cells.
        labels: True is material; cells that nothing is said about are void.
    """

    space: CellComplex
    labels: Labels

    def is_material(self, point: Vector) -> bool:
        """Whether a point (units) that lies on no surface is in the material."""
        cell = self.space.cell_at(point)
        return cell is not None and self.labels.get(cell, False)

    def stretches(self, normal: Axis, a: float, b: float) -> list[tuple[float, float]]:
        """(low, high) depths of material along the line through (a, b) of a plane, ascending."""
        found: list[tuple[float, float]] = []
        start: float | None = None
        for crossing in self.space.column(normal, a, b):
            solid = crossing.after is not None and self.labels.get(crossing.after, False)
            if solid and start is None:
                start = crossing.depth
            elif not solid and start is not None:
                if crossing.depth > start:
                    found.append((start, crossing.depth))
                start = None
        return found

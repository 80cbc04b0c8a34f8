"""What notes say of round holes (ISO 129-1, ASME Y14.5): they go through, or how deep they are."""

from dataclasses import dataclass, field

from gaussiancad_core.model.axes import Role


@dataclass(frozen=True)
class HoleStep:
    """A cylinder of a hole.

    Attributes:
        diameter: mm, as it is drawn.
        depth: mm from the face that the hole is drawn on; None where it goes through.
        notes: boxes of the notes that say so, px of the upright sheet.
    """

    diameter: float
    depth: float | None = None
    notes: tuple[tuple[float, float, float, float], ...] = field(default=(), compare=False)


@dataclass(frozen=True)
class NotedHole:
    """A hole of which a note speaks.

    Attributes:
        role: the view that shows its circle.
        centre: (2,) mm in the view's plane (right, up).
        steps: from the smallest diameter to the largest; those of which the note says nothing more
            than the diameter are left out.
        text: of the note.
    """

    role: Role
    centre: tuple[float, float]
    steps: tuple[HoleStep, ...]
    text: str = ""

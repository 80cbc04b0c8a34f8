"""What a sample part is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape


@dataclass(frozen=True)
class SamplePart:
    """A part modelled in code.

    Attributes:
        name: kebab-case, unique.
        description: what it is and what makes it a test, in a few words.
        build: makes the solid in mm, its bounding box starting at the origin.
    """

    name: str
    description: str
    build: Callable[[], "TopoDS_Shape"]

"""What is asked of ``gaussiancad features``, as data, and as the engine's arguments."""

from dataclasses import dataclass


@dataclass(frozen=True)
class FeaturesJob:
    """A solid whose features are to be found.

    Attributes:
        solid: path of a STEP file.
        output: folder for the engine's files.
    """

    solid: str
    output: str

    def arguments(self) -> list[str]:
        """``features SOLID --output DIR``."""
        return ["features", self.solid, "--output", self.output]

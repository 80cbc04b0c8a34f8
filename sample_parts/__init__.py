"""Sample parts, modelled in code: what the project's tests, pictures and demos start from."""

from sample_parts.part import SamplePart
from sample_parts.plates import PLATES
from sample_parts.shaped import SHAPED

SAMPLES: tuple[SamplePart, ...] = (*PLATES, *SHAPED)
"""All sample parts, simple ones first."""


def sample(name: str) -> SamplePart:
    """The sample part of a name.

    Raises:
        KeyError: there is no such part.
    """
    return {part.name: part for part in SAMPLES}[name]


__all__ = ["SAMPLES", "SamplePart", "sample"]

"""Sample parts, drawn and solved once."""

from collections.abc import Callable
from functools import cache

import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling.cell_labelling import Effort, Search
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.labelled_cells import LabelledComplex

Labelled = tuple[PartModel, LabelledComplex]


@pytest.fixture(scope="session")
def labelled(sample_views: Callable[[str], DrawnViews]) -> Callable[[str], Labelled]:
    """The cells of the sample part of a name, and their labels."""

    def find(name: str) -> Labelled:
        part = model_part(sample_views(name))
        labels = Search(part.rules, Effort()).best(relaxed=False).labels
        assert labels is not None
        return part, LabelledComplex(part.space, labels)

    return cache(find)


@pytest.fixture(scope="session")
def solved(sample_views: Callable[[str], DrawnViews]) -> Callable[[str], ExactResult]:
    """What is found for the sample part of a name."""
    return cache(lambda name: exact_solid(sample_views(name)))

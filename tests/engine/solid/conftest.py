"""Sample parts, drawn and solved once."""

from collections.abc import Callable
from functools import cache

import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.solid.exact import ExactResult, exact_solid


@pytest.fixture(scope="session")
def solved(sample_views: Callable[[str], DrawnViews]) -> Callable[[str], ExactResult]:
    """What is found for the sample part of a name."""
    return cache(lambda name: exact_solid(sample_views(name)))

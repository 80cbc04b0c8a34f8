"""What judges features: built again they are the solid, and their sketches are fixed."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.as_json import kind_of
from gaussiancad_core.features.feature_model import Feature, FeatureList
from gaussiancad_core.features.feature_search import features_of

Found = tuple[FeatureList, list[str]]


@pytest.fixture(scope="session")
def found() -> Callable[[TopoDS_Shape], Found]:
    """The features of a solid, and their kinds, after they were built again."""
    from benchmarks.tasks.feature_changes import rebuilt
    from gaussiancad_core.features.difference import difference

    def find(solid: TopoDS_Shape) -> Found:
        features = features_of(solid)
        made = rebuilt(features.features, features.base)
        assert made is not None
        assert difference(solid, made).is_none
        return features, [kind_of(feature) for feature in features.features]

    return find


@pytest.fixture(scope="session")
def edges_in() -> Callable[[Feature], list[int]]:
    """How many edges each outline of a feature has."""

    def count(feature: Feature) -> list[int]:
        return [len(loop) for loop in feature.sketch.loops]

    return count

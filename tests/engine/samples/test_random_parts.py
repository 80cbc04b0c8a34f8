import numpy as np
import pytest

from gaussiancad_core.kernel.brep import bounding_box, soundness
from sample_parts.random_parts import random_part


@pytest.mark.parametrize("seed", range(12))
def test_a_part_is_one_valid_closed_solid_at_the_origin(seed: int) -> None:
    part = random_part(seed)
    sound = soundness(part)
    assert (sound.valid, sound.closed, sound.solids) == (True, True, 1)
    low, high = bounding_box(part)
    np.testing.assert_allclose(low, 0.0, atol=1e-5)
    assert (high > 5.0).all() and (high < 250.0).all()
    assert 0.02 * np.prod(high) < sound.volume_mm3 < 1.0001 * np.prod(high)


def test_the_seed_is_the_part() -> None:
    one, same, other = (soundness(random_part(seed)) for seed in (5, 5, 6))
    assert (one.volume_mm3, one.faces) == (same.volume_mm3, same.faces)
    assert one.volume_mm3 != other.volume_mm3


def test_steps_are_features() -> None:
    faces = [soundness(random_part(4, steps=steps)).faces for steps in (0, 1, 5)]
    # The body alone: a wedge is a prism over five corners.
    assert faces[0] == 7
    assert faces[0] < faces[1] < faces[2]

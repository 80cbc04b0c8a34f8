import numpy as np
import pytest

from gaussiancad_core.kernel.brep import bounding_box, soundness
from sample_parts.classed import LEVEL_FACES, PartClass, classed_part, surface_kinds

SOME = [(kind, seed, level) for kind in PartClass for seed, level in ((0, 0), (1, 2), (2, 4))]


@pytest.mark.parametrize(("kind", "seed", "level"), SOME)
def test_a_part_is_one_sound_solid_of_its_class_and_level(
    kind: PartClass, seed: int, level: int
) -> None:
    part = classed_part(kind, seed, level)
    sound = soundness(part)
    assert (sound.valid, sound.closed, sound.solids) == (True, True, 1)
    fewest, most = LEVEL_FACES[level]
    assert fewest <= sound.faces <= most
    low, high = bounding_box(part)
    np.testing.assert_allclose(low, 0.0, atol=1e-5)
    assert 0.02 * np.prod(high) < sound.volume_mm3 <= 1.0001 * np.prod(high)
    kinds = surface_kinds(part)
    assert kinds <= kind.allowed
    assert kinds & kind.asked


def test_seed_class_and_level_are_the_part() -> None:
    same = [soundness(classed_part(PartClass.HOLES, 3, 1)) for _ in range(2)]
    assert same[0] == same[1]
    volumes = {soundness(classed_part(kind, 3, 1)).volume_mm3 for kind in PartClass}
    assert len(volumes) == len(PartClass)


@pytest.mark.parametrize("level", range(7, len(LEVEL_FACES)))
def test_planes_go_to_320_faces(level: int) -> None:
    fewest, most = LEVEL_FACES[level]
    assert fewest <= soundness(classed_part(PartClass.PLANES, 0, level)).faces <= most
    assert LEVEL_FACES[7][0] == 121 and LEVEL_FACES[-1][1] == 320


def test_there_is_no_level_beyond_the_last() -> None:
    with pytest.raises(IndexError):
        classed_part(PartClass.PLANES, 0, len(LEVEL_FACES))

from itertools import combinations

import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Surface

from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Role
from sample_parts import SAMPLES, SamplePart, sample

PI = float(np.pi)

VOLUMES = {
    "l-bracket": (80 * 12 + 14 * 48) * 50 - PI * 100 * 12 - PI * 49 * 14,
    "bored-plate": (100 * 70 - 4 * PI * 25 - PI * 324) * 15,
    "stepped-block": (90 * 15 + 60 * 17 + 30 * 18) * 40 - 30 * 16 * 15,
    "pocket-block": 70 * 50 * 30 - 35 * 30 * 18,
    "three-axis-block": 60 * 50 * 40 - PI * (25 * 60 + 49 * 50 + 64 * 40),
    "u-bracket": (72 * 12 + 2 * 14 * 43) * 40 - 2 * PI * 64 * 14 - PI * 36 * 12,
    "t-slot-block": (80 * 45 - 36 * 14 - 16 * 15) * 60,
    "counterbored-block": 80 * 44 * 28 - 2 * PI * (36 * 18 + 121 * 10),
    "slotted-link": (80 * 40 + PI * 400 - PI * 81 - 38 * 16 - PI * 64) * 14,
    "boss-plate": (80 * 60 - 2 * PI * 25) * 12 + PI * 324 * 28 - PI * 81 * 40,
    "wedge-block": (90 * 48 - 50 * 34 / 2) * 44 - 20 * 16 * 28,
    "dovetail-block": (80 * 40 - (28 + 44) / 2 * 20) * 50,
    "vee-block": (70 * 45 - (50 + 6) / 2 * 22 - 6 * 13) * 60,
    "filleted-block": (80 * 60 - (4 - PI) * 144 - PI * 225) * 30,
    "stepped-shaft": PI * (144 * 25 + 400 * 35 + 225 * 35 + 81 * 25),
    "pulley": PI
    * (
        2 * 256 * 6 + 2 * 38**2 * 6 + 28**2 * 6
        + 2 * (38**2 + 38 * 28 + 28**2) * 6 / 3
        - 64 * 42
    ),
    "countersunk-plate": 90 * 50 * 16 - 2 * PI * (36 * 9 + (36 + 78 + 169) * 7 / 3),
    "angled-bore-block": 80 * 50 * 45 - PI * 81 * 45 * 5 / 4,
    "rib-bracket": (80 * 10 + 12 * 50) * 50 + 50 * 40 / 2 * 10 - 2 * PI * 25 * 10,
    "chamfered-block": (70 * 36 - 100 - PI * 81) * 50,
}  # fmt: skip


@pytest.mark.parametrize("part", SAMPLES, ids=lambda part: part.name)
def test_a_part_is_one_sound_solid_that_starts_at_the_origin(part: SamplePart) -> None:
    shape = part.build()
    found = soundness(shape)
    assert (found.valid, found.closed, found.solids) == (True, True, 1)
    lower, upper = bounding_box(shape)
    np.testing.assert_allclose(lower, 0.0, atol=1e-6)
    assert 40.0 <= upper.max() <= 150.0
    np.testing.assert_allclose(upper, np.round(upper), atol=1e-6)


@pytest.mark.parametrize("name", VOLUMES)
def test_the_volume_is_that_of_the_formula(name: str) -> None:
    assert soundness(sample(name).build()).volume_mm3 == pytest.approx(VOLUMES[name], rel=1e-9)


def test_a_ball_on_a_shank_has_the_volume_of_both() -> None:
    cap = 24 - np.sqrt(24**2 - 10**2)
    above = 56 - np.sqrt(24**2 - 10**2)
    ball = 4 / 3 * PI * 24**3 - PI * cap**2 * (3 * 24 - cap) / 3
    expected = PI * 100 * above + ball - PI * 25 * 30
    assert soundness(sample("ball-knob").build()).volume_mm3 == pytest.approx(expected, rel=1e-6)


def test_there_are_many_parts_with_names_and_words_of_their_own() -> None:
    assert len(SAMPLES) >= 20
    assert len({part.name for part in SAMPLES}) == len(SAMPLES)
    assert len({part.description for part in SAMPLES}) == len(SAMPLES)
    for part in SAMPLES:
        assert part.name == part.name.lower().replace(" ", "-")
        assert part.description
        assert sample(part.name) is part


def test_an_unknown_part_is_a_key_error() -> None:
    with pytest.raises(KeyError):
        sample("perpetual-motion")


def test_no_two_parts_have_the_same_drawing() -> None:
    drawings = {}
    for part in SAMPLES:
        drawing = LineDrawing(part.build())
        drawings[part.name] = tuple(
            sorted(round(stroke.length, 3) for stroke in drawing.view(role))
            for role in (Role.FRONT, Role.TOP)
        )
    for one, other in combinations(drawings.values(), 2):
        assert one != other


def test_the_parts_between_them_have_all_kinds_of_surfaces() -> None:
    kinds = {
        BRepAdaptor_Surface(face).GetType().name.removeprefix("GeomAbs_")
        for part in SAMPLES
        for face in faces_of(part.build())
    }
    assert {"Plane", "Cylinder", "Cone", "Sphere", "Torus"} <= kinds

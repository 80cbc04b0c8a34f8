"""When a solid that is called verified is false."""

from benchmarks.judge.verified_judging import judgement
from gaussiancad_core.kernel.brep import compound_of
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder

_BLOCK = box((0, 0, 0), (60, 40, 30))
_PART = cut(_BLOCK, cylinder(Axis.Z, (20, 20), 8.0, 10.0, 40))


def test_the_part_itself_is_right_but_where_another_one_looks_like_it() -> None:
    right = judgement(_PART, _PART, 0.01)
    assert not right.why and right.within == right.faces == 16
    assert judgement(_PART, _PART, 0.01, unique=False).why


def test_measures_may_be_off_by_the_bound_but_not_by_several() -> None:
    other = cut(_BLOCK, cylinder(Axis.Z, (20, 20), 8.05, 10.0, 40))
    near = judgement(other, _PART, 0.02)
    assert not near.why and near.within == 14
    assert judgement(other, _PART, 0.015).why


def test_a_small_face_that_only_one_has_makes_it_false() -> None:
    speck = cut(_PART, box((59.5, 39.5, 29.5), (61, 41, 31)))
    assert judgement(speck, _PART, 0.02).why
    assert judgement(_PART, speck, 0.02).why
    assert judgement(cut(_PART, box((30, 10, 10), (31, 11, 11))), _PART, 0.02).why


def test_what_is_no_single_solid_is_false() -> None:
    two = compound_of([_PART, box((100, 0, 0), (101, 1, 1))])
    assert judgement(two, _PART, 1.0).why == "unsound"

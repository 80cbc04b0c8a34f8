"""The kernels say of pieces what the plain functions say."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gaussiancad_core.cells.cell_complex import CellComplex
from gaussiancad_core.cells.edge_fragments import Piece, find_pieces
from gaussiancad_core.cells.sight_lines import SightLines, body_table
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling import visibility_rules
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.visibility_rules import groups_at, rules_of
from sample_parts.classed import PartClass, classed_part

_SAMPLES = ("stepped-block", "counterbored-block", "filleted-block", "countersunk-plate")
_CLASSES = (PartClass.SLANTS, PartClass.REVOLVED, PartClass.OBLIQUE)
_NEAR = 0.01

Views = Callable[[str], DrawnViews]


@pytest.fixture(scope="module", params=[*_SAMPLES, *_CLASSES])
def part(
    request: pytest.FixtureRequest, sample_views: Views, drawn: Callable[..., DrawnViews]
) -> PartModel:
    if isinstance(request.param, PartClass):
        return model_part(drawn(classed_part(request.param, 1, 1)))
    return model_part(sample_views(request.param))


def _pieces(part: PartModel) -> list[Piece]:
    return list(find_pieces(part.space, part.carriers.planes, _NEAR))


def _fresh(part: PartModel) -> CellComplex:
    return CellComplex(part.space.planes, part.space.bodies)


def test_rules_are_those_of_the_plain_functions(
    part: PartModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    pieces = _pieces(part)
    quick, plain = _fresh(part), _fresh(part)
    found = rules_of(quick, pieces)
    with monkeypatch.context() as patch:
        patch.setattr(visibility_rules, "SightLines", _NoLines)
        expected = rules_of(plain, pieces)
    assert found == expected
    assert [rule.pieces for rule in found] == [rule.pieces for rule in expected]
    # What columns have met tells of thin cells and of neighbours.
    assert list(dict.fromkeys(quick.crossed())) == list(dict.fromkeys(plain.crossed()))
    thickness = plain.thickness()
    assert quick.thickness() == pytest.approx(thickness) and thickness


class _NoLines:
    """Stands for what cannot express a space."""

    fit = False

    def __init__(self, _space: CellComplex) -> None:
        pass


def test_each_piece_is_told_by_itself(part: PartModel) -> None:
    space = _fresh(part)
    lines = SightLines(space)
    assert lines.fit
    pieces = _pieces(part)
    said = {id(piece): stated for piece, stated in lines.said(pieces)}
    for piece in pieces[::7]:
        assert (groups_at(space, piece) is not None) == (id(piece) in said)
        alone = dict(SightLines(_fresh(part)).said([piece]))
        assert alone == ({piece: said[id(piece)]} if id(piece) in said else {})


def test_views_from_behind_tell_the_groups_the_other_way_round(part: PartModel) -> None:
    opposite = {"front": "rear", "top": "bottom", "right": "left"}
    for piece in _pieces(part)[::11]:
        role = type(piece.role)(opposite[piece.role.value])
        space = _fresh(part)
        ways = [list(SightLines(space).said([replace(piece, role=r)])) for r in (piece.role, role)]
        one, other = (groups_at(space, replace(piece, role=r)) for r in (piece.role, role))
        assert (one is None) == (other is None) == (not ways[0]) == (not ways[1])
        if one is not None:
            assert one == other[::-1]


class _Strange:
    """A body that the kernels do not know."""

    def crossings(self, *_: object) -> list[tuple[float, tuple[float, float, float]]]:
        return []

    def holds(self, _: object) -> bool:
        return False

    def rims(self, _: object) -> list[object]:
        return []

    def outlines(self, _: object) -> None:
        return None


def test_what_has_no_keys_is_told_the_plain_way(part: PartModel) -> None:
    assert body_table([_Strange()]) is None
    space = CellComplex(part.space.planes, [*part.space.bodies, _Strange()])
    assert not SightLines(space).fit
    pieces = _pieces(part)
    plain = [rule.weight for rule in rules_of(space, pieces)]
    assert plain == [rule.weight for rule in rules_of(_fresh(part), pieces)]
    many = CellComplex(part.space.planes, [*part.space.bodies] * 60)
    assert SightLines(many).fit == (not part.space.bodies)

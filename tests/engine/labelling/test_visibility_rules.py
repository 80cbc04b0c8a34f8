"""What pieces of lines say, against parts whose material is known."""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
)
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopAbs import TopAbs_State
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.cells.edge_fragments import find_pieces
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.geometry.tolerances import ASIDE
from gaussiancad_core.labelling import visibility_rules
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.visibility_rules import (
    Group,
    Rule,
    drawn_under,
    groups_at,
    rules_of,
)
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import lifted, role_plane
from gaussiancad_core.model.views import Linetype

_NEAR = 0.01

_NAMES = (
    "l-bracket",
    "bored-plate",
    "stepped-block",
    "three-axis-block",
    "counterbored-block",
    "wedge-block",
    "filleted-block",
    "countersunk-plate",
    "ball-knob",
)


def _truth(part: PartModel, solid: TopoDS_Shape) -> dict[Cell, bool]:
    """Labels of all cells beside pieces: whether the part holds a point of each."""
    classifier = BRepClass3d_SolidClassifier(solid)
    labels: dict[Cell, bool] = {}
    for piece in find_pieces(part.space, part.carriers.planes, _NEAR):
        normal = role_plane(piece.role).normal
        for way in (-ASIDE, ASIDE):
            a, b = (p + way * q for p, q in zip(piece.point, piece.across, strict=True))
            for crossing, following in pairwise(part.space.column(normal, a, b)):
                cell = crossing.after
                if cell is None or cell in labels or following.depth - crossing.depth < 1e-3:
                    continue
                middle = lifted(normal, a, b, (crossing.depth + following.depth) / 2.0)
                classifier.Perform(gp_Pnt(*(x / part.carriers.scale for x in middle)), 1e-7)
                labels[cell] = classifier.State() == TopAbs_State.TopAbs_IN
    return labels


@pytest.mark.parametrize("name", _NAMES)
def test_the_truth_fulfils_every_rule(
    name: str,
    sample_solid: Callable[[str], TopoDS_Shape],
    sample_views: Callable[[str], DrawnViews],
) -> None:
    part = model_part(sample_views(name))
    labels = _truth(part, sample_solid(name))
    assert any(labels.values())
    stated = {rule.linetype for rule in part.rules}
    assert stated >= {Linetype.VISIBLE, None}
    wrong = [rule for rule in part.rules if drawn_under(rule, labels) is not rule.linetype]
    assert wrong == []


def test_a_cone_beside_the_plane_that_its_outline_sweeps_is_its_own_partner() -> None:
    # A line of the pocket runs a hair beside the bore's mouth, where its chamfer and that plane are
    # nearly one.
    solid = BRepPrimAPI_MakeBox(60.0, 40.0, 20.0).Shape()
    bore = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 20, 0), gp_Dir(0, 0, 1)), 5.0, 20.0)
    mouth = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(20, 20, 18), gp_Dir(0, 0, 1)), 5.0, 7.0, 2.0)
    pocket = BRepPrimAPI_MakeBox(gp_Pnt(40, 0, 12), 20.0, 25.01, 8.0)
    for tool in (bore, mouth, pocket):
        solid = BRepAlgoAPI_Cut(solid, tool.Shape()).Shape()
    drawing = LineDrawing(solid)
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    part = model_part(exact_views({r: drawing.view(r) for r in roles}, (60.0, 40.0, 20.0)))
    labels = _truth(part, solid)
    assert [rule for rule in part.rules if drawn_under(rule, labels) is not rule.linetype] == []


def test_pieces_that_say_the_same_are_one_rule(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    part = model_part(sample_views("stepped-block"))
    pieces = list(find_pieces(part.space, part.carriers.planes, _NEAR))
    once = rules_of(part.space, pieces)
    assert len({(rule.groups, rule.linetype) for rule in once}) == len(once)
    twice = rules_of(part.space, [*pieces, *pieces])
    assert [(r.groups, r.linetype) for r in twice] == [(r.groups, r.linetype) for r in once]
    assert [r.weight for r in twice] == pytest.approx([2.0 * r.weight for r in once])
    doubted = rules_of(part.space, [replace(piece, confidence=0.5) for piece in pieces])
    assert [r.weight for r in doubted] == pytest.approx([0.5 * r.weight for r in once])


@pytest.mark.parametrize("name", ["counterbored-block", "countersunk-plate"])
def test_columns_that_are_alike_say_what_their_groups_say(
    name: str, sample_views: Callable[[str], DrawnViews], monkeypatch: pytest.MonkeyPatch
) -> None:
    part = model_part(sample_views(name))
    pieces = list(find_pieces(part.space, part.carriers.planes, _NEAR))
    quick = [groups_at(part.space, piece) for piece in pieces]
    monkeypatch.setattr(visibility_rules, "_aligned", lambda *_: None)
    assert [groups_at(part.space, piece) for piece in pieces] == quick


_ONE: Cell = (1, 1, 1, 0)
_TWO: Cell = (1, 2, 1, 0)


def _rule(*groups: Group) -> Rule:
    return Rule(groups, None, 1.0, Role.FRONT, (0.0, 0.0))


def test_the_first_difference_from_the_viewer_decides() -> None:
    step = Group((), ((None, _ONE),), ((None, _ONE),))
    shared = Group((((None, _TWO), (None, _TWO)),), (), ((None, _TWO),))
    solid = {_ONE: True, _TWO: True}
    assert drawn_under(_rule(step), solid) is Linetype.VISIBLE
    assert drawn_under(_rule(step, shared), solid) is Linetype.VISIBLE
    assert drawn_under(_rule(shared, step), solid) is Linetype.HIDDEN
    assert drawn_under(_rule(shared, step), {_ONE: True, _TWO: False}) is Linetype.VISIBLE
    assert drawn_under(_rule(shared, step), {_ONE: False, _TWO: True}) is None
    assert drawn_under(_rule(shared), solid) is None
    assert drawn_under(_rule(), solid) is None
    # What nothing is said about is void.
    assert drawn_under(_rule(step), {}) is None


def test_a_surface_in_one_column_only_is_a_difference() -> None:
    pair = Group((((None, _ONE), (None, _TWO)),), (), ((None, _ONE), (None, _TWO)))
    assert drawn_under(_rule(pair), {_ONE: True, _TWO: False}) is Linetype.VISIBLE
    assert drawn_under(_rule(pair), {_ONE: False, _TWO: True}) is Linetype.VISIBLE
    assert drawn_under(_rule(pair), {_ONE: True, _TWO: True}) is None

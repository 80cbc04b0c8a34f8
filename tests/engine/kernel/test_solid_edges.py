import numpy as np
from OCP.TopoDS import TopoDS

from gaussiancad_core.kernel.solid_edges import edge_facts, raw_curve
from gaussiancad_core.model.axes import Axis, Role
from sample_parts import sample
from sample_parts.modelling import box, cone, cylinder, prism

LOOKS = {role: np.array(role.frame.look, dtype=float) for role in Role}


def test_all_edges_of_a_box_are_sharp() -> None:
    facts = edge_facts(box((0, 0, 0), (3, 2, 1)))
    assert len(facts) == 12
    assert not any(fact.smooth or fact.seam or fact.curved for fact in facts)
    for fact in facts:
        assert fact.normals.shape == (2, 5, 3)
        np.testing.assert_allclose(
            np.einsum("ijk,ijk->j", fact.normals[:1], fact.normals[1:]), 0.0, atol=1e-12
        )


def test_a_cylinder_s_seam_is_smooth_and_its_rims_are_not() -> None:
    facts = edge_facts(cylinder(Axis.Z, (0, 0), 5, 0, 10))
    assert [(fact.smooth, fact.seam) for fact in facts].count((True, True)) == 1
    assert [(fact.smooth, fact.seam) for fact in facts].count((False, False)) == 2
    seam = next(fact for fact in facts if fact.seam)
    # The seam lies at +X: there the cylinder turns away from who looks along Y.
    assert seam.silhouette(LOOKS[Role.FRONT])
    assert not seam.silhouette(LOOKS[Role.RIGHT])


def test_the_borders_of_fillets_are_smooth() -> None:
    facts = edge_facts(sample("filleted-block").build())
    smooth = [fact for fact in facts if fact.smooth and not fact.seam]
    assert len(smooth) == 8
    assert all(fact.curved for fact in smooth)
    # Each border grazes the look along the plane that it belongs to, and no other.
    for role in (Role.FRONT, Role.RIGHT):
        assert sum(fact.silhouette(LOOKS[role]) for fact in smooth) == 4
    assert sum(fact.silhouette(LOOKS[Role.TOP]) for fact in smooth) == 8


def test_a_dihedral_of_two_degrees_is_sharp_and_of_half_a_degree_smooth() -> None:
    for degrees, smooth in ((2.0, False), (0.5, True)):
        rise = float(np.tan(np.radians(degrees))) * 20.0
        roof = prism(Axis.Y, [(0, 0), (40, 0), (40, 10), (20, 10), (0, 10 - rise)], 0, 5)
        found = [fact.smooth for fact in edge_facts(roof)]
        assert sum(found) == (1 if smooth else 0)


def test_the_apex_of_a_cone_is_no_edge() -> None:
    facts = edge_facts(cone(Axis.Z, (0, 0), (5, 0), 0, 10))
    assert len(facts) == 2


def test_an_edge_and_its_copies_share_their_curve() -> None:
    facts = edge_facts(box((0, 0, 0), (3, 2, 1)))
    edge = facts[0].edge
    assert raw_curve(edge) is raw_curve(TopoDS.Edge(edge.Reversed()))
    assert raw_curve(edge) is not raw_curve(facts[1].edge)

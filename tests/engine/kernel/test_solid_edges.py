import numpy as np

from gaussiancad_core.kernel.solid_edges import edge_facts
from gaussiancad_core.model.axes import Axis, Role
from sample_parts import sample
from sample_parts.modelling import cylinder, prism

LOOKS = {role: np.array(role.frame.look, dtype=float) for role in Role}


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

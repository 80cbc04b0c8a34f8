import numpy as np

from gaussiancad_core.kernel.solid_edges import edge_facts
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import prism


def test_a_dihedral_of_two_degrees_is_sharp_and_of_half_a_degree_smooth() -> None:
    for degrees, smooth in ((2.0, False), (0.5, True)):
        rise = float(np.tan(np.radians(degrees))) * 20.0
        roof = prism(Axis.Y, [(0, 0), (40, 0), (40, 10), (20, 10), (0, 10 - rise)], 0, 5)
        found = [fact.smooth for fact in edge_facts(roof)]
        assert sum(found) == (1 if smooth else 0)

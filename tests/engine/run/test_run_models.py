"""Files of a run's models."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt

from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.run.run_models import SOLID_FILE, alternative_file, write_solids


def test_solids_begin_at_the_origin_however_little_they_were_off(tmp_path: Path) -> None:
    boxes = [
        BRepPrimAPI_MakeBox(gp_Pnt(*corner), 80.0, 50.0, 60.0).Shape()
        for corner in ((0.0031, -0.0023, 0.0022), (0.4, 0.0, -0.7))
    ]
    write_solids(SimpleNamespace(shape=boxes[0], alternatives=boxes[1:]), tmp_path)
    for name in (SOLID_FILE, alternative_file(1)):
        found = bounding_box(read_solid(tmp_path / name))
        assert found == pytest.approx(np.array([[0.0, 0.0, 0.0], [80.0, 50.0, 60.0]]), abs=1e-9)

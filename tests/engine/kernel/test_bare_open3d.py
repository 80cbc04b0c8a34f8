"""Open3D comes without what its pages for browsers and notebooks need."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[3]

IMPORT = """
import importlib.util, sys

HIDDEN = set(sys.argv[1].split(","))
finders = sys.meta_path[:]

class Without:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in HIDDEN:
            return None
        found = (finder.find_spec(name, path, target) for finder in finders)
        return next((spec for spec in found if spec is not None), None)

sys.meta_path[:] = [Without()]
from gaussiancad_core.kernel.bare_open3d import open3d

assert all(importlib.util.find_spec(name) is None for name in HIDDEN)
print(*sorted(HIDDEN & {name.partition(".")[0] for name in sys.modules}))
corners = open3d.utility.Vector3dVector([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
triangles = open3d.utility.Vector3iVector([[0, 1, 2]])
print(open3d.geometry.TriangleMesh(corners, triangles).get_surface_area())
"""


def test_it_is_imported_where_the_excluded_are_missing_and_nothing_stands_in_later() -> None:
    project = tomllib.loads((CHECKOUT / "core" / "pyproject.toml").read_text(encoding="utf-8"))
    hidden = {*project["tool"]["uv"]["exclude-dependencies"], "plotly", "IPython"}
    command = [sys.executable, "-c", IMPORT, ",".join(hidden)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert done.stderr == ""
    assert done.stdout.splitlines() == ["", "0.5"]


def test_all_of_the_engine_imports_it_there() -> None:
    statement = re.compile(r"^\s*(?:import open3d\b|from open3d\b)", re.MULTILINE)
    for_types = re.compile(r"^if TYPE_CHECKING:\n(?: .*\n)*", re.MULTILINE)
    found = {
        path.name
        for folder in ("core/gaussiancad_core", "benchmarks", "tests/engine")
        for path in (CHECKOUT / folder).rglob("*.py")
        if statement.search(for_types.sub("", path.read_text(encoding="utf-8")))
    }
    assert found == {"bare_open3d.py"}

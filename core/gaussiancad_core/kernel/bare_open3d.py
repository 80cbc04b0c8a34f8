"""Open3D without the web pages that it shows clouds on.

``import open3d`` imports plotly and dash, for functions that draw in a browser.  The engine calls
none of them, and the locks leave these packages out, with the web server and the notebook tools
that they need (``exclude-dependencies`` in ``pyproject.toml``).  Where one is missing, an empty
module stands in for it while Open3D is imported, and no longer.

All of the engine takes Open3D from here: ``from gaussiancad_core.kernel.bare_open3d import
open3d``.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from types import ModuleType

__all__ = ["open3d"]

_UNUSED: dict[str, tuple[str, ...]] = {
    "plotly": (),
    "plotly.graph_objects": (),
    "dash": ("html", "dcc", "Dash"),
}
"""Module -> the names that Open3D imports from it; packages come before their parts."""


@contextmanager
def _stand_ins() -> Iterator[None]:
    """Empty modules in place of the unused ones, of those whose package is not installed."""
    missing = [name for name in _UNUSED if find_spec(name.partition(".")[0]) is None]
    for name in missing:
        sys.modules[name] = ModuleType(name)
        for attribute in _UNUSED[name]:
            setattr(sys.modules[name], attribute, None)
    try:
        yield
    finally:
        for name in missing:
            del sys.modules[name]


with _stand_ins():
    import open3d

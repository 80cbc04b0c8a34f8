"""The extras of the package: what more than the plain installation each brings, and what it lacks.

Plain is what reads a sheet and makes the exact solid.  Whatever needs more asks for its extra by
:func:`demand` before it imports anything of it.
"""

from collections.abc import Mapping
from enum import Enum
from importlib.util import find_spec

from gaussiancad_core.errors import EngineError
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import ResultKind

PACKAGE = "gaussiancad-core"
"""The distribution whose extras they are."""


class Extra(Enum):
    """Names as ``pip install "gaussiancad-core[NAME]"`` takes them."""

    SURFACE = "surface"
    COMPARE = "compare"
    WINDOW = "window"
    CUDA = "cuda"
    CLUSTER = "cluster"
    MCP = "mcp"

    @property
    def command(self) -> str:
        """What installs it."""
        return f'pip install "{PACKAGE}[{self.value}]"'


_TRAINING = {"torch": ("torch",), "skimage": ("scikit-image",)}

_MESHES = {
    "open3d": ("open3d-cpu", "open3d"),
    "trimesh": ("trimesh",),
    "manifold3d": ("manifold3d",),
}

MODULES: Mapping[Extra, Mapping[str, tuple[str, ...]]] = {
    Extra.SURFACE: {**_TRAINING, **_MESHES},
    Extra.COMPARE: _MESHES,
    Extra.WINDOW: {"PySide6": ("PySide6-Essentials", "PySide6")},
    Extra.CUDA: {**_TRAINING, **_MESHES, "gsplat": ("gsplat",)},
    Extra.CLUSTER: {"distributed": ("distributed",)},
    Extra.MCP: {"mcp": ("mcp",), "anyio": ("anyio",)},
}
"""Extra -> the modules that it is there for -> the distributions that bring each, any one of them.
"""


def lacking(extra: Extra) -> tuple[str, ...]:
    """The modules of an extra that are not installed; nothing is imported for the answer."""
    return tuple(module for module in MODULES[extra] if find_spec(module) is None)


def demand(extra: Extra, purpose: str) -> None:
    """Go on only where an extra is installed.

    Args:
        extra: that is needed.
        purpose: what for, as the subject of a sentence: ``a surface``.

    Raises:
        EngineError: ``extra-missing``.
    """
    missing = lacking(extra)
    if missing:
        raise EngineError(
            Code.EXTRA_MISSING,
            '{purpose} needs the extra "{extra}", which lacks {packages}: {command}',
            purpose=purpose,
            extra=extra,
            packages=", ".join(missing),
            command=extra.command,
        )


def result_kind(asked: ResultKind | None) -> ResultKind:
    """The models that a run makes: those that were asked for, else all that are installed for."""
    if asked is not None:
        return asked
    return ResultKind.SOLID if lacking(Extra.SURFACE) else ResultKind.BOTH

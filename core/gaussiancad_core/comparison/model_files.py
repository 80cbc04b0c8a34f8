"""Models on disk: exact solids (STEP, BREP) and triangle meshes (STL, PLY, OBJ), all as a mesh."""

import io
from dataclasses import dataclass, replace
from enum import Enum
from functools import cached_property
from pathlib import Path

import numpy as np

from gaussiancad_core.comparison.closed_bodies import untangled
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.storage.plain_files import model_bytes
from gaussiancad_protocol.codes import Code

_LARGEST_FILE = 2**30

_SIZES_MM = (1e-6, 1e8)
"""Smallest longest edge and largest coordinate; beyond them single precision overflows."""


class Content(Enum):
    """What is measured of a file with exact surfaces."""

    SOLIDS = "solids"
    SEWN = "surfaces, sewn into solids"
    SURFACES = "surfaces"


@dataclass(frozen=True)
class ExactFacts:
    """What only the exact surfaces of a B-Rep tell.

    Attributes:
        valid: OpenCASCADE's own check finds nothing, and it encloses a volume.
        closed: every edge bounds two faces.
        faces: number of distinct faces.
        volume_mm3, area_mm2: of the exact surfaces; of the triangles around united solids.
        deflection_mm: largest distance of the tessellation from them.
        content: what is measured.
        united: how many solids that touch or overlap are measured as one; 0 where none do.
        left_out: faces beside the solids, which are not measured.
    """

    valid: bool
    closed: bool
    faces: int
    volume_mm3: float
    area_mm2: float
    deflection_mm: float
    content: Content = Content.SOLIDS
    united: int = 0
    left_out: int = 0


@dataclass(frozen=True, eq=False)
class Model:
    """A model as triangles, and what is exactly known of it.

    Attributes:
        mesh: welded, oriented outward, mm.
        exact: None where the file holds triangles.
    """

    mesh: TriangleMesh
    exact: ExactFacts | None = None

    @cached_property
    def closed(self) -> bool:
        """Whether its triangles are watertight."""
        return self.mesh.watertight

    def scaled(self, factor: float) -> "Model":
        """The same model, larger or smaller about the origin."""
        if factor == 1.0:
            return self
        exact = self.exact
        if exact is not None:
            exact = replace(
                exact,
                volume_mm3=exact.volume_mm3 * factor**3,
                area_mm2=exact.area_mm2 * factor**2,
                deflection_mm=exact.deflection_mm * factor,
            )
        return Model(make_mesh(self.mesh.vertices * factor, self.mesh.triangles), exact)


class ModelFormat(Enum):
    """Formats that can be compared; the values are the suffixes, in lower case."""

    STEP = (".step", ".stp")
    BREP = (".brep", ".brp")
    STL = (".stl",)
    PLY = (".ply",)
    OBJ = (".obj",)

    @property
    def is_exact(self) -> bool:
        """Whether the format holds exact surfaces instead of triangles."""
        return self in (ModelFormat.STEP, ModelFormat.BREP)


def format_of(path: Path) -> ModelFormat:
    """The format that a file's suffix names.

    Raises:
        UnreadableError: ``model-format-unknown``.
    """
    suffix = path.suffix.lower()
    for model_format in ModelFormat:
        if suffix in model_format.value:
            return model_format
    known = ", ".join(suffix for each in ModelFormat for suffix in each.value)
    raise UnreadableError(
        Code.MODEL_FORMAT_UNKNOWN,
        "{path} has no suffix of a known model format: use one of {known}",
        path=path,
        known=known,
    )


def load_model(path: Path) -> TriangleMesh:
    """Read a model as a welded mesh in the file's millimetres; see :func:`read_model`."""
    return read_model(path).mesh


def read_model(path: Path) -> Model:
    """Read a model as a welded mesh in the file's millimetres, oriented outward.

    Exact solids are tessellated to within 5e-5 of their longest edge.  STEP states its unit and is
    converted; the mesh formats have none and are taken as they are.  Where pieces of a closed
    surface touch along an edge each has vertices of its own.

    Raises:
        UnreadableError: ``file-missing``, ``file-not-readable``, ``file-too-large``,
            ``empty-file``, ``model-format-unknown``, ``not-a-solid``, ``file-damaged`` (exact
            formats), ``not-a-model`` (mesh formats), ``point-cloud``, ``empty-model``,
            ``size-out-of-range``.
    """
    if path.is_dir():
        raise UnreadableError(
            Code.FILE_NOT_READABLE,
            "cannot read {path} (it is a folder): name a model in it",
            path=path,
        )
    model_format = format_of(path)
    _check_size(path)
    if model_format.is_exact:
        from gaussiancad_core.comparison.exact_models import read_exact

        mesh, exact = read_exact(path)
    else:
        mesh, exact = _parsed(path, model_format), None
    if exact is None or not exact.united:
        mesh = _welded(mesh)
    _check_mesh(path, mesh)
    return Model(untangled(mesh).oriented_outward(), exact)


def _check_mesh(path: Path, mesh: TriangleMesh) -> None:
    if not np.isfinite(mesh.vertices).all():
        raise UnreadableError(
            Code.NOT_A_MODEL,
            "{path} holds coordinates that are not numbers: export the model again",
            path=path,
        )
    least, most = _SIZES_MM
    if len(mesh.vertices) and np.abs(mesh.vertices).max() > most:
        raise UnreadableError(
            Code.SIZE_OUT_OF_RANGE,
            "{path} has coordinates beyond {most:g} mm: export the model in millimetres, near the "
            "origin",
            path=path,
            most=most,
        )
    extent = np.ptp(mesh.vertices, axis=0).max() if len(mesh.triangles) else 0.0
    if extent <= 0.0 or mesh.area <= 0.0:
        raise UnreadableError(
            Code.EMPTY_MODEL, "{path} holds no surface: export the model with its faces", path=path
        )
    if extent < least:
        raise UnreadableError(
            Code.SIZE_OUT_OF_RANGE,
            "{path} is smaller than {least:g} mm: export the model in millimetres",
            path=path,
            least=least,
        )


def _parsed(path: Path, model_format: ModelFormat) -> TriangleMesh:
    import trimesh

    content = model_bytes(path)
    try:
        # From memory there is no folder beside it, so that materials and textures stay unread.
        # What is no number is told afterwards, in one line.
        with np.errstate(invalid="ignore", over="ignore"):
            model = trimesh.load(
                io.BytesIO(content),
                file_type=model_format.value[0][1:],
                process=False,
                skip_materials=True,
            )
        mesh = model.to_mesh() if isinstance(model, trimesh.Scene) else model
    except Exception as error:
        # The parsers raise whatever their arithmetic meets in a damaged file.
        raise _not_a_model(path, model_format) from error
    if isinstance(mesh, trimesh.PointCloud):
        raise UnreadableError(
            Code.POINT_CLOUD,
            "{path} holds points without faces: make a surface of them first",
            path=path,
        )
    if not isinstance(mesh, trimesh.Trimesh) or not len(mesh.vertices):
        raise _not_a_model(path, model_format)
    # Points of one coordinate or two are read as they are.
    if mesh.vertices.shape[1:] != (3,) or mesh.faces.shape[1:] != (3,):
        raise _not_a_model(path, model_format)
    if not len(mesh.faces):
        raise UnreadableError(
            Code.EMPTY_MODEL,
            "{path} holds no triangles: export the model with its faces",
            path=path,
        )
    if mesh.faces.min() < 0 or mesh.faces.max() >= len(mesh.vertices):
        raise _not_a_model(path, model_format)
    return make_mesh(mesh.vertices, mesh.faces)


def _check_size(path: Path) -> None:
    """Refuse what would not fit into the memory; what cannot be asked is told when it is read."""
    try:
        size = path.stat().st_size
    except OSError:
        return
    if size > _LARGEST_FILE:
        raise UnreadableError(
            Code.FILE_TOO_LARGE,
            "{path} is larger than 1 GiB: export it with fewer triangles",
            path=path,
        )


def _not_a_model(path: Path, model_format: ModelFormat) -> UnreadableError:
    return UnreadableError(
        Code.NOT_A_MODEL,
        "{path} is damaged or no {format} file: export the model again",
        path=path,
        format=model_format.name,
    )


def _welded(mesh: TriangleMesh) -> TriangleMesh:
    """Equal points become one vertex; triangles that collapse are dropped."""
    vertices, inverse = np.unique(mesh.vertices, axis=0, return_inverse=True)
    triangles = inverse.reshape(-1)[mesh.triangles]
    following = np.roll(triangles, -1, axis=1)
    return make_mesh(vertices, triangles[(triangles != following).all(axis=1)]).compacted()

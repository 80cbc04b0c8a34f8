"""Where straight lines along one axis meet the surfaces of a solid, in closed form.

Each surface takes many parallel lines at once.  Planes, cylinders, cones and spheres are solved as
polynomials of degree one and two, tori as quartics (Blinn's form); anything else is left to
OpenCASCADE's intersector, line by line.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Ax3, gp_Dir, gp_Lin, gp_Pnt, gp_Vec
from OCP.IntCurvesFace import IntCurvesFace_Intersector
from OCP.TopoDS import TopoDS_Face

from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

Array = npt.NDArray[np.float64]
_TINY = 1e-12
_FAR = 1e9


@dataclass(frozen=True)
class Crossings:
    """Points where lines meet one surface, before it is trimmed.

    Attributes:
        line: (k,) index of the line.
        depth: (k,) parameter along the line, in mm.
        parameters: (k, 2) surface parameters u, v.
        normal: (k, 3) unit normal, in the sense of ``dS/du x dS/dv``.
    """

    line: npt.NDArray[np.int64]
    depth: Array
    parameters: Array
    normal: Array


class Surface(Protocol):
    """A surface that lines can be intersected with."""

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        """All crossings of the lines through (n, 3) origins along a (3,) unit direction."""


@dataclass(frozen=True)
class _Frame:
    """Location and axes of an elementary surface."""

    origin: Array
    x: Array
    y: Array
    z: Array

    def local(self, points: Array) -> tuple[Array, Array, Array]:
        offset = points - self.origin
        return offset @ self.x, offset @ self.y, offset @ self.z

    @property
    def handedness(self) -> float:
        return float(np.sign(np.cross(self.x, self.y) @ self.z))


def _frame(position: gp_Ax3) -> _Frame:
    origin = position.Location()
    return _Frame(
        np.array([origin.X(), origin.Y(), origin.Z()]),
        *(
            np.array([axis.X(), axis.Y(), axis.Z()])
            for axis in (
                position.XDirection(),
                position.YDirection(),
                position.Direction(),
            )
        ),
    )


def _quadratic(a: Array, b: Array, c: Array) -> tuple[npt.NDArray[np.int64], Array]:
    """Real roots of a t^2 + b t + c for each row, as (row, root); double roots are left out."""
    rows: list[npt.NDArray[np.int64]] = []
    roots: list[Array] = []
    straight = np.abs(a) < _TINY
    linear = np.flatnonzero(straight & (np.abs(b) > _TINY))
    rows.append(linear)
    roots.append(-c[linear] / b[linear])
    discriminant = b * b - 4.0 * a * c
    proper = np.flatnonzero(~straight & (discriminant > 0.0))
    # The sum without cancellation, then the other root from the product of both.
    half = -0.5 * (b[proper] + np.copysign(np.sqrt(discriminant[proper]), b[proper]))
    rows += [proper, proper]
    with np.errstate(divide="ignore", invalid="ignore"):
        roots += [half / a[proper], c[proper] / half]
    row, root = np.concatenate(rows), np.concatenate(roots)
    finite = np.isfinite(root)
    return row[finite], root[finite]


@dataclass(frozen=True)
class _Plane:
    frame: _Frame

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        normal = self.frame.handedness * self.frame.z
        slope = float(direction @ normal)
        if abs(slope) < 1e-9:
            return _none()
        depth = -((origins - self.frame.origin) @ normal) / slope
        x, y, _ = self.frame.local(origins + depth[:, None] * direction)
        normals = np.broadcast_to(normal, (len(origins), 3))
        return Crossings(np.arange(len(origins)), depth, np.stack([x, y], axis=1), normals)


@dataclass(frozen=True)
class _Cylinder:
    frame: _Frame
    radius: float

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        axis = self.frame.z
        offset = origins - self.frame.origin
        flat = offset - (offset @ axis)[:, None] * axis
        across = direction - (direction @ axis) * axis
        count = len(origins)
        line, depth = _quadratic(
            np.full(count, across @ across),
            2.0 * flat @ across,
            (flat**2).sum(axis=1) - self.radius**2,
        )
        x, y, z = self.frame.local(origins[line] + depth[:, None] * direction)
        around = np.arctan2(y, x)
        normal = np.cos(around)[:, None] * self.frame.x + np.sin(around)[:, None] * self.frame.y
        return Crossings(line, depth, np.stack([around, z], axis=1), self.frame.handedness * normal)


@dataclass(frozen=True)
class _Cone:
    frame: _Frame
    radius: float
    angle: float

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        axis, cosine, sine = self.frame.z, np.cos(self.angle), np.sin(self.angle)
        apex = self.frame.origin - self.radius / np.tan(self.angle) * axis
        offset = origins - apex
        along, slope = offset @ axis, float(direction @ axis)
        count = len(origins)
        line, depth = _quadratic(
            np.full(count, slope**2 - cosine**2),
            2.0 * (along * slope - cosine**2 * (offset @ direction)),
            along**2 - cosine**2 * (offset**2).sum(axis=1),
        )
        x, y, z = self.frame.local(origins[line] + depth[:, None] * direction)
        v = z / cosine
        # Beyond the apex the surface's own radius is negative.
        sign = np.where(self.radius + v * sine < 0.0, -1.0, 1.0)
        around = np.arctan2(sign * y, sign * x)
        radial = np.cos(around)[:, None] * self.frame.x + np.sin(around)[:, None] * self.frame.y
        normal = sign[:, None] * (cosine * radial - sine * axis)
        return Crossings(line, depth, np.stack([around, v], axis=1), self.frame.handedness * normal)


@dataclass(frozen=True)
class _Sphere:
    frame: _Frame
    radius: float

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        offset = origins - self.frame.origin
        line, depth = _quadratic(
            np.ones(len(origins)),
            2.0 * offset @ direction,
            (offset**2).sum(axis=1) - self.radius**2,
        )
        points = origins[line] + depth[:, None] * direction
        x, y, z = self.frame.local(points)
        height = np.arcsin(np.clip(z / self.radius, -1.0, 1.0))
        normal = (points - self.frame.origin) / self.radius
        return Crossings(
            line,
            depth,
            np.stack([np.arctan2(y, x), height], axis=1),
            self.frame.handedness * normal,
        )


@dataclass(frozen=True)
class _Torus:
    frame: _Frame
    major: float
    minor: float

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        line, depth = self._roots(origins, direction)
        points = origins[line] + depth[:, None] * direction
        x, y, z = self.frame.local(points)
        # Where the tube is wider than the ring, its part beyond the axis has a negative radius.
        rho = np.hypot(x, y)
        misfit = [np.abs(np.hypot(sign * rho - self.major, z) - self.minor) for sign in (1.0, -1.0)]
        sign = np.where(misfit[0] <= misfit[1], 1.0, -1.0)
        around = np.arctan2(sign * y, sign * x)
        out = sign * rho - self.major
        ring = np.cos(around)[:, None] * self.frame.x + np.sin(around)[:, None] * self.frame.y
        normal = (out[:, None] * ring + z[:, None] * self.frame.z) / self.minor
        return Crossings(
            line,
            depth,
            np.stack([around, np.arctan2(z, out)], axis=1),
            self.frame.handedness * normal,
        )

    def _roots(self, origins: Array, direction: Array) -> tuple[npt.NDArray[np.int64], Array]:
        """(|p|^2 + R^2 - r^2)^2 = 4 R^2 (|p|^2 - (p.a)^2) along each line."""
        # Measured from the foot of the centre on the line, the roots are small numbers.
        offset = origins - self.frame.origin
        foot = -(offset @ direction)
        near = offset + foot[:, None] * direction
        axial, slope = near @ self.frame.z, float(direction @ self.frame.z)
        square = (near**2).sum(axis=1)
        inner = square + self.major**2 - self.minor**2
        four = 4.0 * self.major**2
        c2 = 2.0 * inner - four * (1.0 - slope**2)
        c1 = four * 2.0 * axial * slope
        c0 = inner**2 - four * (square - axial**2)
        reachable = np.flatnonzero(square <= (self.major + self.minor) ** 2)
        companion = np.zeros((len(reachable), 4, 4))
        companion[:, 1, 0] = companion[:, 2, 1] = companion[:, 3, 2] = 1.0
        for row, coefficient in enumerate((c0, c1, c2)):
            companion[:, row, 3] = -coefficient[reachable]
        roots = np.linalg.eigvals(companion) if len(reachable) else np.zeros((0, 4), complex)
        scale = self.major + self.minor
        real = np.abs(roots.imag) < 1e-7 * scale
        which, _ = np.nonzero(real)
        line = reachable[which]
        depth = roots.real[real]
        for _ in range(2):
            value = depth**4 + c2[line] * depth**2 + c1[line] * depth + c0[line]
            slope_at = 4.0 * depth**3 + 2.0 * c2[line] * depth + c1[line]
            step = np.where(np.abs(slope_at) > _TINY, value / np.where(slope_at, slope_at, 1.0), 0)
            depth = depth - np.clip(step, -1e-3 * scale, 1e-3 * scale)
        return line, depth + foot[line]


@dataclass(frozen=True)
class _AnySurface:
    intersector: IntCurvesFace_Intersector
    adaptor: BRepAdaptor_Surface

    def crossings(self, origins: Array, direction: Array) -> Crossings:
        intersector, adaptor = self.intersector, self.adaptor
        along = gp_Dir(*direction.tolist())
        found: list[tuple[int, float, float, float, Array]] = []
        for index, origin in enumerate(origins.tolist()):
            try:
                intersector.Perform(gp_Lin(gp_Pnt(*origin), along), -_FAR, _FAR)
            except KERNEL_FAILURES:
                # Rare faces of spline surfaces; the line then lacks a hit and is known as faulty.
                continue
            if not intersector.IsDone():
                continue
            for number in range(1, intersector.NbPnt() + 1):
                u, v = intersector.UParameter(number), intersector.VParameter(number)
                normal = normal_at(adaptor, u, v)
                found.append((index, intersector.WParameter(number), u, v, normal))
        if not found:
            return _none()
        return Crossings(
            np.array([entry[0] for entry in found]),
            np.array([entry[1] for entry in found]),
            np.array([entry[2:4] for entry in found]),
            np.array([entry[4] for entry in found]),
        )


def normal_at(adaptor: BRepAdaptor_Surface, u: float, v: float) -> Array:
    """(3,) unit normal ``dS/du x dS/dv``; NaN where there is none."""
    point, along_u, along_v = gp_Pnt(), gp_Vec(), gp_Vec()
    adaptor.D1(float(u), float(v), point, along_u, along_v)
    normal = along_u.Crossed(along_v)
    if normal.Magnitude() < _TINY:
        return np.full(3, np.nan)
    normal.Normalize()
    return np.array([normal.X(), normal.Y(), normal.Z()])


def _none() -> Crossings:
    return Crossings(np.zeros(0, int), np.zeros(0), np.zeros((0, 2)), np.zeros((0, 3)))


def surface_of(face: TopoDS_Face, tolerance: float) -> Surface:
    """The surface that carries a face.

    Args:
        face: the face, anywhere.
        tolerance: mm, of the general intersector.
    """
    adaptor = BRepAdaptor_Surface(face)
    kind = adaptor.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        return _Plane(_frame(adaptor.Plane().Position()))
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        cylinder = adaptor.Cylinder()
        return _Cylinder(_frame(cylinder.Position()), cylinder.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Cone:
        cone = adaptor.Cone()
        return _Cone(_frame(cone.Position()), cone.RefRadius(), cone.SemiAngle())
    if kind == GeomAbs_SurfaceType.GeomAbs_Sphere:
        sphere = adaptor.Sphere()
        return _Sphere(_frame(sphere.Position()), sphere.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Torus:
        torus = adaptor.Torus()
        return _Torus(_frame(torus.Position()), torus.MajorRadius(), torus.MinorRadius())
    return _AnySurface(IntCurvesFace_Intersector(face, tolerance, True, False), adaptor)

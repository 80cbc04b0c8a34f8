"""Two models, laid over each other and measured by the protocols that were asked for."""

from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.comparison import distances as measures
from gaussiancad_core.comparison.comparison_options import (
    Alignment,
    CompareOptions,
    Protocol,
    ScaleRule,
)
from gaussiancad_core.comparison.comparison_report import Comparison, DeviationFacts, ModelFacts
from gaussiancad_core.comparison.deepcad import DeepCadResult, measure_deepcad
from gaussiancad_core.comparison.deviation import Deviation, measure_deviation
from gaussiancad_core.comparison.engineering import (
    EngineeringAsk,
    EngineeringResult,
    area_of,
    measure_engineering,
    signed_distances,
    volume_of,
)
from gaussiancad_core.comparison.findings import WorstPoint, histogram_of, worst_points
from gaussiancad_core.comparison.global_registration import find_turn
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.comparison.model_units import unit_factor
from gaussiancad_core.comparison.normalise import (
    BOX,
    Matrix,
    inverse,
    moved_mesh,
    moved_points,
    normalising_matrix,
    scale_of,
)
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.remarks import remarks_on
from gaussiancad_core.comparison.rigid_registration import Registration, Side, refine, register
from gaussiancad_core.comparison.sampling import RandomState, random_streams, sample_surface
from gaussiancad_core.comparison.topology import topology_of
from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_protocol.codes import Code

_REGISTRATION_POINTS = 2000

_SAME_SIZE = 0.05
"""Longest edges that differ by less than this share are taken for the same size in mm."""

_STREAMS = 8

_NEARER = 0.99
"""Files as they are must lie nearer by more than chance, or the middles of the boxes decide."""

_MOST_RATIO = 1e7
"""Metres and micrometres differ by less; beyond it single precision does not do."""


@dataclass(frozen=True, eq=False)
class _Laid:
    """The result in the protocol's box, registered.

    Attributes:
        result, reference: in their boxes; the result not yet moved.
        registration: how the result has to be moved.
        normalised: (4, 4) result file -> its box, with the turn found beforehand.
        box: (4, 4) reference file -> its box.
    """

    result: Side
    reference: Side
    registration: Registration
    normalised: Matrix
    box: Matrix


def compare_models(
    result: Model, reference: Model, options: CompareOptions
) -> tuple[Comparison, Deviation]:
    """Compare two models with an extent; the deviation is in the reference's coordinates, mm.

    Raises:
        UsageError: see :meth:`CompareOptions.check`; ``sizes-too-different``.
    """
    options.check()
    result = result.scaled(options.factor)
    _check_sizes(result.mesh, reference.mesh)
    streams = random_streams(options.seed, _STREAMS)
    laid = _lay(result.mesh, reference.mesh, options, streams)
    pose = laid.registration.pose
    matrix = inverse(laid.box) @ pose @ laid.normalised
    again = sample_surface(laid.reference.surface.mesh, options.points, streams[2])
    moved = Side(
        SurfaceQueries(moved_mesh(laid.result.surface.mesh, pose)),
        moved_points(laid.result.points, pose),
    )
    placement = _placement(laid, options)
    deviation = _deviation(laid, _shown(laid, placement, options), reference.mesh)
    topologies = topology_of(result.mesh), topology_of(reference.mesh)
    mirrored = laid.registration.mirrored
    factor = unit_factor(result.mesh, reference.mesh)
    comparison = Comparison(
        distances=measures.sample_distances(moved.points, laid.reference.points),
        floor=measures.sample_distances(laid.reference.points, again),
        point_to_surface=measures.point_to_surface(
            (moved.surface, moved.points), (laid.reference.surface, laid.reference.points)
        ),
        volume_iou=measures.volume_iou(moved.surface, laid.reference.surface, streams[3]),
        matrix=matrix,
        mirrored=mirrored,
        alignment=options.alignment or Alignment.ICP,
        scale_rule=options.scale or ScaleRule.FREE,
        points=options.points,
        seed=options.seed,
        unit_mm=_unit(reference.mesh),
        deviation=_deviation_facts(deviation, laid, reference.mesh),
        result=_facts(result, topologies[0].betti),
        reference=_facts(reference, topologies[1].betti),
        warnings=remarks_on((result, reference), topologies, mirrored, factor),
        unit_factor=factor,
        protocols=options.protocols,
        deepcad=_deepcad(result, reference, options),
        engineering=_engineering((result, reference), (placement, laid.box), options, streams),
    )
    return comparison, deviation


def _check_sizes(result: TriangleMesh, reference: TriangleMesh) -> None:
    ratio = float(np.ptp(result.bounds, axis=0).max() / np.ptp(reference.bounds, axis=0).max())
    if not 1.0 / _MOST_RATIO <= ratio <= _MOST_RATIO:
        raise UsageError(
            Code.SIZES_TOO_DIFFERENT,
            "the result is {ratio:.3g} times as long as the reference: "
            "see --factor, or whether these are the right files",
            ratio=ratio,
        )


def _lay(
    result: TriangleMesh,
    reference: TriangleMesh,
    options: CompareOptions,
    streams: list[RandomState],
) -> _Laid:
    """Put both models into their boxes and register them."""
    before, mirrored = np.eye(4), False
    if options.alignment is Alignment.GLOBAL:
        turn = find_turn(result, reference, streams[4])
        before[:3, :3], mirrored = turn.rotation, turn.mirrored
    turned = moved_mesh(result, before)
    box = normalising_matrix(reference)
    this_normalising_matrix = normalising_matrix(turned)
    if options.scale is ScaleRule.FIXED:
        this_normalising_matrix = (
            np.diag([*np.full(3, scale_of(box) / scale_of(this_normalising_matrix)), 1.0])
            @ this_normalising_matrix
        )
    first = _boxed(moved_mesh(turned, this_normalising_matrix), options.points, streams[0])
    second = _boxed(moved_mesh(reference, box), options.points, streams[1])
    alignment = options.alignment or Alignment.ICP
    found = register(_thinned(first), _thinned(second), alignment)
    return _Laid(
        first,
        second,
        replace(found, mirrored=found.mirrored or mirrored),
        this_normalising_matrix @ before,
        box,
    )


def _boxed(mesh: TriangleMesh, points: int, stream: RandomState) -> Side:
    return Side(SurfaceQueries(mesh), sample_surface(mesh, points, stream))


def _thinned(side: Side) -> Side:
    """A side with as many points as registration needs."""
    return side.thinned(_REGISTRATION_POINTS)


def _unit(reference: TriangleMesh) -> float:
    """mm of the reference per unit of its box."""
    return float(np.ptp(reference.bounds, axis=0).max()) / BOX


def _placement(laid: _Laid, options: CompareOptions) -> Matrix:
    """(4, 4) result file -> the reference's box, as engineers lay it: unscaled unless asked for.

    The box of the protocol scales a result by the extent of its bounding box, so that one bump
    would shift all of it.  Who compares two models in millimetres wants them as they are.
    """
    if options.alignment is Alignment.NONE:
        # Nothing is moved: both files have the same origin.
        return laid.box
    rule = options.scale or ScaleRule.FIXED
    pose = laid.registration.pose
    unscaled = scale_of(laid.box) / scale_of(laid.normalised)
    side = laid.result.scaled(unscaled) if rule is ScaleRule.FIXED else laid.result
    if options.alignment is not Alignment.AXES:
        sides, scaling = (_thinned(side), _thinned(laid.reference)), rule is ScaleRule.FREE
        # Most files that are compared have one origin already, whatever their bounding boxes.
        unmoved = laid.box @ inverse(laid.normalised)
        if rule is ScaleRule.FIXED:
            unmoved = unmoved @ np.diag([*np.full(3, 1.0 / unscaled), 1.0])
        (pose, far), (other, near) = (
            refine(*sides, start, scaling=scaling) for start in (pose, unmoved)
        )
        if near < _NEARER * far:
            pose = other
    if rule is ScaleRule.FIXED:
        pose = pose @ np.diag([unscaled, unscaled, unscaled, 1.0])
    return pose @ laid.normalised


def _shown(laid: _Laid, placement: Matrix, options: CompareOptions) -> tuple[Matrix, float]:
    """Result file -> the reference's box for the picture, and by what it scales the result.

    The picture shows the result in its own size, unless that is so far off that nothing could be
    seen and nobody asked for it.
    """
    ratio = scale_of(laid.normalised) / scale_of(laid.box)
    if options.scale is not None or abs(ratio - 1.0) <= _SAME_SIZE:
        scale = scale_of(placement) / scale_of(laid.box)
        return placement, 1.0 if abs(scale - 1.0) < 1e-12 else scale
    return laid.registration.pose @ laid.normalised, ratio


def _deviation(laid: _Laid, shown: tuple[Matrix, float], reference: TriangleMesh) -> Deviation:
    """The result's deviation as it is shown, in the reference's coordinates, mm."""
    matrix, scale = shown
    pose = matrix @ np.linalg.inv(laid.normalised)
    placed = moved_mesh(laid.result.surface.mesh, pose)
    found = measure_deviation(placed, laid.reference.surface, _unit(reference))
    mesh = make_mesh(found.mesh.vertices + reference.bounds.mean(axis=0), found.mesh.triangles)
    return replace(found, mesh=mesh, scale=scale)


def _deviation_facts(deviation: Deviation, laid: _Laid, reference: TriangleMesh) -> DeviationFacts:
    unit = _unit(reference)
    longest = BOX * unit
    centre = reference.bounds.mean(axis=0)
    shown = make_mesh((deviation.mesh.vertices - centre) / unit, deviation.mesh.triangles)
    # Corners are where most may be missing, and no sample hits them.
    asked = np.concatenate([laid.reference.points, laid.reference.surface.mesh.vertices])
    missing = signed_distances(SurfaceQueries(shown), asked) * unit
    places = asked * unit + centre
    worst: tuple[WorstPoint, ...] = (
        *worst_points(deviation.mesh.vertices, deviation.distances, "result", longest),
        *worst_points(places, missing, "reference", longest),
    )
    return DeviationFacts(
        deviation.signed,
        deviation.limit,
        float(deviation.distances.min()),
        float(deviation.distances.max()),
        deviation.scale,
        histogram_of(deviation),
        tuple(sorted(worst, key=lambda each: -abs(each.deviation_mm))),
    )


def _facts(model: Model, betti: tuple[int, int, int] | None) -> ModelFacts:
    mesh, exact = model.mesh, model.exact
    low, high = mesh.bounds
    return ModelFacts(
        tuple(float(value) for value in high - low),
        len(mesh.triangles),
        model.closed,
        volume_of(model),
        area_of(model),
        (tuple(float(value) for value in low), tuple(float(value) for value in high)),
        betti,
        None if exact is None else exact.valid,
        None if exact is None else exact.faces,
        None if exact is None else exact.content.value,
    )


def _deepcad(result: Model, reference: Model, options: CompareOptions) -> DeepCadResult | None:
    if Protocol.DEEPCAD not in options.protocols:
        return None
    return measure_deepcad(result, reference, options.seed)


def _engineering(
    pair: tuple[Model, Model],
    placement: tuple[Matrix, Matrix],
    options: CompareOptions,
    streams: list[RandomState],
) -> EngineeringResult | None:
    if Protocol.ENGINEERING not in options.protocols:
        return None
    ask = EngineeringAsk(options.points, options.seed, options.tolerance_mm)
    return measure_engineering(pair, placement, ask, streams[5:])

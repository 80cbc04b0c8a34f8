"""What a person should know before believing a comparison's numbers."""

from gaussiancad_core.comparison.distances import encloses_volume
from gaussiancad_core.comparison.models import Model
from gaussiancad_core.comparison.topology import Topology
from gaussiancad_core.report import Remark


def remarks_on(
    pair: tuple[Model, Model],
    topologies: tuple[Topology, Topology],
    mirrored: bool,
    factor: float | None,
) -> tuple[Remark, ...]:
    """The warnings of a comparison.

    Args:
        pair: result and reference.
        topologies: theirs.
        mirrored: whether a mirror image of the result fits better.
        factor: by which the result's unit seems to differ, or None.
    """
    found: list[Remark] = []
    if mirrored:
        found.append(
            _warned("result-mirrored", "a mirror image of the result fits better: check its views")
        )
    if factor is not None:
        found.append(
            _warned(
                "unit-mismatch",
                f"the result's measures are the reference's times {1.0 / factor:.6g}: its unit "
                f"differs; compare with --factor {factor:.6g} to have it in millimetres",
            )
        )
    for name, model, topology in zip(("result", "reference"), pair, topologies, strict=True):
        found += _on_model(name, model, topology)
    first, second = (topology.betti for topology in topologies)
    if first is not None and second is not None and first != second:
        found.append(
            _warned(
                "topology-differs",
                f"the result has {_words(first)}, the reference {_words(second)}",
            )
        )
    return tuple(found)


def _on_model(name: str, model: Model, topology: Topology) -> list[Remark]:
    if model.exact is not None and not model.exact.valid:
        return [
            _warned(
                "solid-invalid",
                f"OpenCASCADE's check refuses the {name}: its volume and Booleans may be wrong",
            )
        ]
    if topology.betti is None:
        return [
            _warned(
                "model-open",
                f"the {name} is not closed ({topology.open_edges} open edges): it has no volume "
                "for certain, and distances from it have no sign",
            )
        ]
    if not encloses_volume(model.mesh):
        return [_warned("no-volume", f"the {name} is closed but encloses no volume")]
    return []


def _words(betti: tuple[int, int, int]) -> str:
    names = (("body", "bodies"), ("through hole", "through holes"), ("cavity", "cavities"))
    return ", ".join(
        f"{count} {one if count == 1 else many}"
        for count, (one, many) in zip(betti, names, strict=True)
    )


def _warned(code: str, message: str) -> Remark:
    return Remark(code, message)

"""What a person should know before believing a comparison's numbers."""

from gaussiancad_core.comparison.distances import encloses_volume
from gaussiancad_core.comparison.model_files import Content, ExactFacts, Model
from gaussiancad_core.comparison.topology import Topology
from gaussiancad_core.messages import Message
from gaussiancad_core.report.report_entries import Remark
from gaussiancad_protocol.codes import Code


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
            _warned(
                Code.RESULT_MIRRORED, "a mirror image of the result fits better: check its views"
            )
        )
    if factor is not None:
        found.append(
            _warned(
                Code.UNIT_MISMATCH,
                "the result's measures are the reference's times {ratio:.6g}: its unit differs; "
                "compare with --factor {factor:.6g} to have it in millimetres",
                ratio=1.0 / factor,
                factor=factor,
            )
        )
    for name, model, topology in zip(("result", "reference"), pair, topologies, strict=True):
        found += _on_model(name, model, topology)
    first, second = (topology.betti for topology in topologies)
    if first is not None and second is not None and first != second:
        found.append(
            _warned(
                Code.TOPOLOGY_DIFFERS,
                "the result has {result}, the reference {reference}",
                result=_words(first),
                reference=_words(second),
                **_numbered("result", first),
                **_numbered("reference", second),
            )
        )
    return tuple(found)


def _on_model(name: str, model: Model, topology: Topology) -> list[Remark]:
    exact = model.exact
    found = [] if exact is None else _on_content(name, exact)
    if exact is not None and exact.content is Content.SURFACES:
        return found
    if exact is not None and not exact.valid:
        found.append(
            _warned(
                Code.SOLID_INVALID,
                "OpenCASCADE's check refuses the {model}: its volume and Booleans may be wrong",
                model=name,
            )
        )
    elif topology.betti is None:
        count = topology.open_edges
        edges = "1 open edge" if count == 1 else f"{count} open edges"
        found.append(
            _warned(
                Code.MODEL_OPEN,
                "the {model} is not closed ({edges}): it has no volume for certain, and distances "
                "from it have no sign",
                model=name,
                edges=edges,
                count=count,
            )
        )
    elif not encloses_volume(model.mesh):
        message = "the {model} is closed but encloses no volume"
        found.append(_warned(Code.NO_VOLUME, message, model=name))
    return found


def _on_content(name: str, exact: ExactFacts) -> list[Remark]:
    """What of a STEP or BREP file is measured, where that is not just its solids."""
    found = []
    if exact.content is Content.SEWN:
        found.append(
            _warned(
                Code.SURFACES_SEWN,
                "the {model} holds surfaces and no solid: sewn together they are closed, and are "
                "measured as a solid",
                model=name,
            )
        )
    if exact.content is Content.SURFACES:
        found.append(
            _warned(
                Code.SURFACES_ONLY,
                "the {model} holds surfaces that do not close up to a solid: it has no volume for "
                "certain, and distances from it have no sign",
                model=name,
            )
        )
    if exact.united:
        found.append(
            _warned(
                Code.SOLIDS_UNITED,
                "{count} solids of the {model} touch or overlap: they are measured as one body, "
                "without the faces between them",
                count=exact.united,
                model=name,
            )
        )
    if exact.left_out:
        faces = "1 face" if exact.left_out == 1 else f"{exact.left_out} faces"
        found.append(
            _warned(
                Code.SURFACES_LEFT_OUT,
                "the {model} holds {faces} outside of its solids, which are not measured: "
                "remove them, "
                "or make solids of them",
                model=name,
                faces=faces,
                count=exact.left_out,
            )
        )
    return found


def _words(betti: tuple[int, int, int]) -> str:
    names = (("body", "bodies"), ("through hole", "through holes"), ("cavity", "cavities"))
    return ", ".join(
        f"{count} {one if count == 1 else many}"
        for count, (one, many) in zip(betti, names, strict=True)
    )


def _numbered(model: str, betti: tuple[int, int, int]) -> dict[str, int]:
    return {
        f"{model}_{name}": count
        for name, count in zip(("bodies", "holes", "cavities"), betti, strict=True)
    }


def _warned(code: str, message: str, /, **values: object) -> Remark:
    return Remark(code, Message(message, boxes=(), **values))

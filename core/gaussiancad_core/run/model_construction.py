"""How the solid of a sheet was put together, whatever put it together."""

from typing import Any

from gaussiancad_core.proposing import part_construction
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.sketch.constructing import construction_of
from gaussiancad_core.sketch.sketching import Sketch


def construction_values(model: ExactModel) -> dict[str, Any] | None:
    """What ``construction.json`` says of a solid; None of one that was not put together."""
    made_of = model.made_of
    if made_of is None:
        return None
    if isinstance(made_of, Sketch):
        return construction_of(made_of, model.reading.numbered.dimensions).as_json()
    return part_construction.construction_of(made_of)

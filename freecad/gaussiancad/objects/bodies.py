"""A part as a body with sketches and features, from the engine's ``features.json``.

In ``freecadcmd``, of a solid whose features ``gaussiancad features`` has found::

    from pathlib import Path
    from freecad.gaussiancad.objects.bodies import add_bodies
    from freecad.gaussiancad.objects.feature_file import read_features

    part = document.getObject("Part")
    add_bodies(part, read_features(Path("found/features.json")))

:func:`freecad.gaussiancad.remodelling.remodel` runs the engine as well.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import FreeCAD
import Part

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.appearance import dress_like
from freecad.gaussiancad.objects.bodies_of_parts import hide_bodies
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.body_features import add_feature
from freecad.gaussiancad.objects.body_model import (
    Condition,
    Feature,
    Holes,
    Number,
    SolidFeatures,
)
from freecad.gaussiancad.objects.body_numbers import DrivingNumber
from freecad.gaussiancad.objects.body_properties import (
    body_properties,
    made_of,
    trial_properties,
)
from freecad.gaussiancad.objects.body_supports import MadeFeature, has_expression
from freecad.gaussiancad.objects.known_sheets import reconstruction_among
from freecad.gaussiancad.objects.loading import read_shape
from freecad.gaussiancad.objects.number_trials import NumberTrials, TrialOutcome
from freecad.gaussiancad.objects.properties import add_properties
from freecad.gaussiancad.objects.solid_parts import local_shape
from freecad.gaussiancad.objects.transaction import transaction


@dataclass(frozen=True)
class MadeBody:
    """A body that is the solid.

    Attributes:
        body: in the document.
        features: number of its features.
        numbers: that drive it.
        over_base: whether the features stand over a solid that has none.
        trials: what is known of changing its numbers; nothing before they were tried.
    """

    body: FreeCAD.DocumentObject
    features: int
    numbers: tuple[DrivingNumber, ...]
    over_base: bool
    trials: TrialOutcome = field(default_factory=TrialOutcome)

    @property
    def from_sheet(self) -> tuple[str, ...]:
        """The numbers that the drawing tells."""
        return tuple(number.listed for number in self.numbers if number.on_sheet)

    @property
    def measured(self) -> tuple[str, ...]:
        """The other numbers."""
        return tuple(number.listed for number in self.numbers if not number.on_sheet)

    @property
    def breaking(self) -> tuple[str, ...]:
        """The numbers that cannot be changed alone, as far as they were tried."""
        return tuple(number.listed for number in self.trials.breaking)


def undo_step() -> str:
    """Name of the undo step, as the user reads it."""
    return translate("GaussianCAD", "To Body")


def add_bodies(
    part: FreeCAD.DocumentObject, solids: Sequence[SolidFeatures]
) -> tuple[MadeBody, ...]:
    """Add a body for each solid of a part where the part is, and hide the part, in one undo step.

    Args:
        part: a feature whose solids these are, in their order.
        solids: what makes each.

    Returns:
        What was made.

    Raises:
        WorkbenchError: a feature cannot be made, or a body is not the solid; the document is left
            as it was.
    """
    exact, name = local_shape(part), _name_of(part)
    if len(exact.Solids) != len(solids):
        text = translate("GaussianCAD", "the features are of {found} solids instead of {expected}")
        raise _failed(name, text.format(found=len(solids), expected=len(exact.Solids)))
    with transaction(part.Document, undo_step()):
        made = tuple(
            make_body(part.Document, features, name, solid)
            for features, solid in zip(solids, exact.Solids, strict=True)
        )
        hide_bodies(part)
        for each in made:
            each.body.Placement = part.getGlobalPlacement()
            add_properties(each.body, [made_of(part.Name)])
            dress_like(each.body, part)
        part.Visibility = False
        part.Document.recompute()
    return made


def make_body(
    document: FreeCAD.Document, features: SolidFeatures, name: str, exact: Part.Shape
) -> MadeBody:
    """Add a body of some features to a document, within the caller's undo step.

    Args:
        document: receives it.
        features: what makes it.
        name: the body's label.
        exact: the solid that it must be, in the body's coordinates.

    Raises:
        WorkbenchError: a feature cannot be made, or the body is not the solid.  The caller's undo
            step takes back what was added.
    """
    if not features.features:
        raise _failed(name, translate("GaussianCAD", "no features were found on it"))
    body = document.addObject("PartDesign::Body", "Body")
    body.Label = translate("GaussianCAD", "Body of {name}").format(name=name)
    if features.base is not None:
        _stand_on(body, read_shape(features.base))
    numbers: list[DrivingNumber] = []
    earlier: dict[str, MadeFeature] = {}
    for feature in features.features:
        try:
            kept = add_feature(body, feature, earlier)
        except Exception as error:  # FreeCAD raises its own types, which differ between versions
            text = translate("GaussianCAD", "{feature} cannot be made ({reason})")
            reason = text.format(feature=feature.name, reason=error)
            raise _failed(name, reason) from error
        # Its name is another where the document has one of that name already.
        made = body.Tip
        earlier[feature.name] = MadeFeature(feature, made)
        numbers.extend(
            DrivingNumber(made.Name, each.name, each.value, each.source)
            for each in _numbers_of(feature, kept, made)
        )
    check = check_body(body.Shape, exact)
    if not check.is_equal:
        raise _failed(name, check.words)
    add_properties(body, body_properties(numbers))
    over_base = features.base is not None
    return MadeBody(body, len(features.features), tuple(numbers), over_base)


def try_numbers(made: MadeBody) -> MadeBody:
    """Change each number of a body on a copy, and note in its properties which break it.

    Returns:
        The same body, with what is known of its numbers.
    """
    with NumberTrials(made.body, made.numbers) as trials:
        return note_trials(made, trials.run())


def note_trials(made: MadeBody, outcome: TrialOutcome) -> MadeBody:
    """Note what became of trials in a body's properties; that belongs to the step that made it.

    Returns:
        The same body, with what is known of its numbers.
    """
    tried = replace(made, trials=outcome)
    add_properties(made.body, trial_properties(tried.breaking, outcome.untried))
    # The shape does not follow from what is said of it.
    made.body.purgeTouched()
    return tried


def _name_of(part: FreeCAD.DocumentObject) -> str:
    """Of the drawing that a part was made from, else its own."""
    group = reconstruction_among([part])
    return part.Label if group is None else Path(group.SheetPath).stem


def _stand_on(body: FreeCAD.DocumentObject, shape: Part.Shape) -> None:
    base = body.Document.addObject("Part::Feature", "Base")
    base.Label = translate("GaussianCAD", "Base")
    base.Shape = shape
    base.Visibility = False
    body.BaseFeature = base
    body.Document.recompute()


def _numbers_of(
    feature: Feature, kept: Sequence[Condition], made: FreeCAD.DocumentObject
) -> list[Number]:
    """Those of its sketch that hold, and those of the feature itself, each once.

    A diameter in the sketch of a hole is the hole's: it counts as the sketch's.  What follows from
    other numbers is none.
    """
    drawn = [
        Number(each.name or each.kind, each.value, each.source)
        for each in kept
        if each.value is not None
    ]
    is_drawn = isinstance(feature, Holes) and any(each.kind == "diameter" for each in kept)
    ns = [n for n in feature.numbers if not (is_drawn and n.name == "Diameter")]
    return drawn + [n for n in ns if not has_expression(made, n.name)]


def _failed(name: str, reason: str) -> WorkbenchError:
    text = translate(
        "GaussianCAD", "No body was made of {name}: {reason}. The solid stays as it is."
    )
    return WorkbenchError(ErrorCode.NO_BODY, text.format(name=name, reason=reason))

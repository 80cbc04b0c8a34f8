"""What a panel says of a body that was made."""

from collections.abc import Iterator

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies import MadeBody


def told_body(made: MadeBody) -> str:
    """How many features a body has, where its numbers are from, and which of them break it."""
    text = translate(
        "GaussianCAD",
        "Features: {features}. Numbers from the sheet: {sheet}, measured: {measured}.",
    )
    sentence = text.format(
        features=made.features, sheet=len(made.from_sheet), measured=len(made.measured)
    )
    if made.over_base:
        sentence += " " + translate(
            "GaussianCAD", "They stand over a base solid, of which no features are known."
        )
    return " ".join((sentence, *_told_trials(made)))


def _told_trials(made: MadeBody) -> Iterator[str]:
    trials = made.trials
    if trials.breaking:
        text = translate(
            "GaussianCAD", "The body breaks when one of these numbers is changed: {numbers}."
        )
        yield text.format(numbers=", ".join(number.path for number in trials.breaking))
    elif trials.tried and not trials.untried:
        yield translate("GaussianCAD", "Each number can be changed.")
    if trials.untried:
        text = translate("GaussianCAD", "Numbers that were not tried: {count}.")
        yield text.format(count=trials.untried)


def told_numbers(made: MadeBody) -> Iterator[str]:
    """The numbers of a body, first those that the drawing tells, at the end those that break it."""
    headings = (
        (translate("GaussianCAD", "From the sheet:"), made.from_sheet),
        (translate("GaussianCAD", "Not on the sheet:"), made.measured),
        (translate("GaussianCAD", "Break the body when they are changed:"), made.breaking),
    )
    for heading, numbers in headings:
        if numbers:
            yield heading
            yield from numbers

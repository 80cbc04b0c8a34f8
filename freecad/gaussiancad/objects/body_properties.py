"""What a body says of itself in its properties."""

from collections.abc import Sequence

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.body_numbers import DrivingNumber
from freecad.gaussiancad.objects.properties import Access, PropertySpec

FROM_SHEET, MEASURED = "NumbersFromSheet", "NumbersMeasured"

SHEET_VALUES = "SheetValues"
"""The numbers of :data:`FROM_SHEET` without loss, mm, in the same order."""

MADE_OF = "MadeOf"
"""Internal name of the part that the body is the solid of; no link: neither follows the other."""

BREAKING, UNTRIED = "NumbersThatBreak", "NumbersNotTried"


def made_of(part: str) -> PropertySpec:
    """Which part a body was made of, by its internal name."""
    tip = QT_TRANSLATE_NOOP("App::Property", "The part that this body was made of")
    return PropertySpec("String", MADE_OF, "GaussianCAD", tip, part, Access.HIDDEN)


def body_properties(numbers: Sequence[DrivingNumber]) -> list[PropertySpec]:
    """Of a body that was just made."""
    on_sheet = [number for number in numbers if number.on_sheet]
    measured = [number.listed for number in numbers if not number.on_sheet]
    return [
        PropertySpec(
            "StringList",
            FROM_SHEET,
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "Numbers of the body that the drawing tells"),
            [number.listed for number in on_sheet],
        ),
        PropertySpec(
            "StringList",
            MEASURED,
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "Numbers of the body that are not on the drawing"),
            measured,
        ),
        PropertySpec(
            "FloatList",
            SHEET_VALUES,
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "The drawing's numbers when the body was made"),
            [number.value for number in on_sheet],
            Access.HIDDEN,
        ),
        *trial_properties((), len(numbers)),
    ]


def trial_properties(breaking: Sequence[str], untried: int) -> list[PropertySpec]:
    """What is known of changing a body's numbers."""
    return [
        PropertySpec(
            "StringList",
            BREAKING,
            "GaussianCAD",
            QT_TRANSLATE_NOOP(
                "App::Property", "Numbers that break the body if they are changed alone by 3 %"
            ),
            list(breaking),
        ),
        PropertySpec(
            "Integer",
            UNTRIED,
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "How many numbers were not tried for that"),
            untried,
        ),
    ]

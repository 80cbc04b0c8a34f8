"""Values of options, from text; argparse turns their errors into exit code 2."""

import argparse
import math
import re
from enum import Enum
from pathlib import Path
from typing import TypeVar

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.length_units import LEAST_MM, LONGEST_MM
from gaussiancad_core.model.tangent_policies import TangentPolicy, drawn_policy
from gaussiancad_core.sheet.reading_options import Box

Choice = TypeVar("Choice", bound=Enum)


def choice(kind: type[Choice], text: str) -> Choice:
    """A member of an enum by its value."""
    try:
        return kind(text)
    except ValueError:
        names = ", ".join(str(member.value) for member in kind)
        raise argparse.ArgumentTypeError(f"{text!r} is none of {names}") from None


def tangent_policy(text: str) -> TangentPolicy:
    """What a sheet does with tangent edges, by its word."""
    try:
        return drawn_policy(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def named_path(text: str) -> Path:
    """A file or folder; an empty name is that of the folder one is in, and nobody means it."""
    if not text:
        raise argparse.ArgumentTypeError("a file or folder needs a name")
    return Path(text)


def view_box(text: str) -> tuple[Role, Box]:
    """``ROLE=X0,Y0,X1,Y1``."""
    name, _, numbers = text.partition("=")
    role = choice(Role, name)
    try:
        x0, y0, x1, y1 = (float(number) for number in numbers.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not ROLE=X0,Y0,X1,Y1") from None
    if not all(map(math.isfinite, (x0, y0, x1, y1))) or x0 >= x1 or y0 >= y1:
        raise argparse.ArgumentTypeError(f"{text!r}: X0 < X1 and Y0 < Y1 are needed")
    return role, (x0, y0, x1, y1)


def axis_length(text: str) -> tuple[Axis, float]:
    """``AXIS=MM``, e.g. ``x=80``."""
    name, _, number = text.partition("=")
    if name.lower() not in ("x", "y", "z"):
        raise argparse.ArgumentTypeError(f"{text!r} is not x=MM, y=MM or z=MM")
    return Axis[name.upper()], length(number)


def length(text: str) -> float:
    """A length that something drawn can have, mm."""
    value = positive(text)
    if not LEAST_MM <= value <= LONGEST_MM:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not between {LEAST_MM:g} and {LONGEST_MM:g} mm"
        )
    return value


def positive(text: str) -> float:
    """A finite number above 0."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None
    if not math.isfinite(value) or value <= 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not above 0")
    return value


def count(text: str) -> int:
    """A whole number from 1."""
    value = whole(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is below 1")
    return value


def whole(text: str) -> int:
    """A whole number from 0."""
    if not text.isascii() or not text.isdigit():
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number")
    return int(text)


def colour(text: str) -> tuple[int, int, int]:
    """``#RRGGBB``."""
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not #RRGGBB")
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def roles(text: str) -> tuple[Role, ...]:
    """Names of views between commas."""
    return tuple(choice(Role, name.strip()) for name in text.split(","))

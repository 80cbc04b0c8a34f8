"""What a package says of its licence, in SPDX's words, and which licences are allowed.

Allowed are those under which a library may be installed beside a program of LGPL-2.1-or-later and
imported by it, with no duty for that program's own source: permissive ones, and those whose duties
end at their own files.  GPL and AGPL are not, for a program that imports such a library comes under
them as a whole; nor is a licence that nobody has read.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from locked import Lock

UNKNOWN = "unknown"

NVIDIA = "LicenseRef-NVIDIA-Proprietary"

ALLOWED = frozenset(
    {
        *("0BSD", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "CC0-1.0", "ISC", "MIT", "MIT-0"),
        *("Apache-2.0", "Apache-2.0 WITH LLVM-exception", "MIT-CMU", "MPL-2.0", "PSF-2.0", "Zlib"),
        "BSD License",
    }
)
"""SPDX's names, and one that packages use for BSD-2-Clause or BSD-3-Clause without saying which."""

ALLOWED_IN = {
    Lock.CUDA: ALLOWED | {NVIDIA},
    Lock.TESTS: ALLOWED | {"LGPL-3.0-only"},
}
"""Locks that allow more: who installs PyTorch for CUDA takes NVIDIA's libraries from NVIDIA; Qt,
in which the tests open the window without FreeCAD, stays a library of its own."""

STATEMENTS = {
    "apache 2.0": "Apache-2.0",
    "apache software license": "Apache-2.0",
    "3-clause bsd license": "BSD-3-Clause",
    "bsd 2-clause license": "BSD-2-Clause",
    "bsd": "BSD License",
    "bsd license": "BSD License",
    "isc license (iscl)": "ISC",
    "mit license": "MIT",
    "the mit license (mit)": "MIT",
    "mozilla public license 2.0 (mpl 2.0)": "MPL-2.0",
    "nvidia proprietary software": NVIDIA,
    "psf": "PSF-2.0",
    "psfl": "PSF-2.0",
    "python software foundation license": "PSF-2.0",
}
"""What packages write, in lower case -> SPDX."""

READ = {
    ("cuda-toolkit", ""): NVIDIA,
    ("pypdfium2", "BSD-3-Clause, Apache-2.0, dependency licenses"): "BSD-3-Clause AND Apache-2.0",
    ("resvg-py", ""): "MIT",
}
"""Name and what the metadata says -> what a person found in the package.  It counts as long as the
metadata says the same: the first has no files and requires NVIDIA's; the others have the texts."""

_MEANINGLESS = ("", "osi approved", "other/proprietary license", "unknown")


@dataclass(frozen=True)
class Licence:
    """A package's licence.

    Attributes:
        text: an SPDX expression, or what the package says, or ``unknown``.
        source: where that is from: ``metadata``, or ``read`` by a person in the package itself.
    """

    text: str
    source: str


def stated_licence(
    name: str, expression: str | None, field: str | None, classifiers: Sequence[str]
) -> Licence:
    """What a package's metadata tell.

    Args:
        name: of the package.
        expression, field: its ``License-Expression`` and ``License``.
        classifiers: all of its classifiers.
    """
    if expression:
        return Licence(expression, "metadata")
    said = (field or "").strip()
    if (name, said) in READ:
        return Licence(READ[name, said], "read")
    first_line, *more = said.splitlines() or [""]
    ends = [c.rpartition("::")[2] for c in classifiers if c.startswith("License ::")]
    # A whole text in place of a name says nothing by its first line, unless that is a known title.
    names = [first_line] if not more or first_line.strip().lower() in STATEMENTS else []
    found = [_translated(name) for name in (*names, *ends)]
    found = [name for name in dict.fromkeys(found) if name.lower() not in _MEANINGLESS]
    if any(name.startswith("BSD-") for name in found):
        found = [name for name in found if name != "BSD License"]
    # Whether one of several may be chosen is not told, so all of them count.
    return Licence(" AND ".join(found) or first_line.strip() or UNKNOWN, "metadata")


def is_allowed(licence: str, lock: Lock) -> bool:
    """Whether a package of this licence may be in a lock.

    Args:
        licence: an SPDX expression, or any other text, which is allowed only as a whole.
        lock: which one.
    """
    allowed = ALLOWED_IN.get(lock, ALLOWED)
    return licence in allowed or _holds(licence, allowed)


def _translated(name: str) -> str:
    return STATEMENTS.get(name.strip().lower(), name.strip())


def _holds(text: str, allowed: frozenset[str]) -> bool:
    """Whether all that an expression demands is allowed: of OR one side, of AND both.

    A text that is no expression holds nothing.
    """
    tokens = re.findall(r"[()]|[^\s()]+", text)
    found, end = _either(tokens, 0, allowed)
    return found and end == len(tokens)


def _either(tokens: list[str], at: int, allowed: frozenset[str]) -> tuple[bool, int]:
    held, at = _both(tokens, at, allowed)
    while tokens[at : at + 1] == ["OR"]:
        other, at = _both(tokens, at + 1, allowed)
        held = held or other
    return held, at


def _both(tokens: list[str], at: int, allowed: frozenset[str]) -> tuple[bool, int]:
    held, at = _one(tokens, at, allowed)
    while tokens[at : at + 1] == ["AND"]:
        other, at = _one(tokens, at + 1, allowed)
        held = held and other
    return held, at


def _one(tokens: list[str], at: int, allowed: frozenset[str]) -> tuple[bool, int]:
    if tokens[at : at + 1] == ["("]:
        held, at = _either(tokens, at + 1, allowed)
        return held and tokens[at : at + 1] == [")"], at + 1
    if tokens[at + 1 : at + 2] == ["WITH"]:
        return " ".join(tokens[at : at + 3]) in allowed, at + 3
    return "".join(tokens[at : at + 1]) in allowed, at + 1

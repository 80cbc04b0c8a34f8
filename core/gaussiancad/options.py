"""Keyword arguments of the public functions as options of the ``gaussiancad`` command."""

import os
from collections.abc import Iterator, Mapping, Sequence

PathLike = str | os.PathLike[str]

Box = Sequence[float]
"""x0, y0, x1, y1 in px of the sheet as stored, y down."""


def path_of(path: PathLike) -> str:
    """A path as an argument: absolute, so that none is taken for an option."""
    return os.path.abspath(os.fspath(path))


def options(**values: object) -> list[str]:
    """Options by their names, ``_`` for ``-``; those that are None or False are left out."""
    found: list[str] = []
    for name, value in values.items():
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            found.append(option)
        else:
            found.append(f"{option}={value}")
    return found


def reading_options(
    *,
    projection: str | None,
    views: Mapping[str, Box] | None,
    page: int,
    length: Mapping[str, float] | None,
    mm_per_pixel: float | None,
    unit: str | None,
) -> list[str]:
    """What is known of a sheet; see :func:`gaussiancad.read`."""
    return [
        *options(projection=projection, page=page, mm_per_pixel=mm_per_pixel, unit=unit),
        *(
            f"--view={role}={','.join(f'{value:g}' for value in box)}"
            for role, box in (views or {}).items()
        ),
        *_lengths(length or {}),
    ]


def _lengths(lengths: Mapping[str, float]) -> Iterator[str]:
    for axis, value in lengths.items():
        yield f"--length={axis}={value!r}"

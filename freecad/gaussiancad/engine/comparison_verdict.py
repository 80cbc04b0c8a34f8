"""What a comparison comes to, in a sentence: the same part, at another size, or another shape."""

from collections.abc import Mapping
from typing import Any

from freecad.gaussiancad.language import translate

_SAME = 0.99
"""Shared volume at one size from which two parts have one shape."""

_SIZE = 0.002
"""Share by which sizes may differ before that is told."""


def comparison_verdict(values: Mapping[str, Any]) -> str:
    """The sentence; that the run has ended where the models enclose no volume.

    Args:
        values: of ``comparison.json``: the shared volume at one size, and volume and extents of
            both models, mm.
    """
    shared = _number(values.get("volume_iou"))
    result, reference = (_of(values, name) for name in ("result", "reference"))
    volumes = [_number(item.get("volume_mm3")) for item in (result, reference)]
    if shared is None or None in volumes or min(volumes) <= 0.0:
        return translate("GaussianCAD", "Finished")
    if shared < _SAME:
        text = translate(
            "GaussianCAD",
            "Another shape: {share} % of the volume is shared where both are as large.",
        )
        return text.format(share=f"{100.0 * shared:.1f}")
    ratio = (volumes[0] / volumes[1]) ** (1.0 / 3.0)
    if abs(ratio - 1.0) <= _SIZE:
        text = translate("GaussianCAD", "The same part: {share} % of the volume is shared.")
        return text.format(share=f"{100.0 * shared:.2f}")
    if ratio > 1.0:
        text = translate("GaussianCAD", "The same shape, {ratio} times too large.")
    else:
        text = translate("GaussianCAD", "The same shape, {ratio} times too small.")
    stated = text.format(ratio=f"{max(ratio, 1.0 / ratio):.4g}")
    extent = result.get("extent_mm")
    length = _number(extent[0]) if isinstance(extent, list) and extent else None
    if length is None:
        return stated
    advice = translate("GaussianCAD", "Set Length along X to {length} mm and run it again.")
    return f"{stated} {advice.format(length=f'{length / ratio:.5g}')}"


def _of(values: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    found = values.get(name)
    return found if isinstance(found, Mapping) else {}


def _number(value: object) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value)

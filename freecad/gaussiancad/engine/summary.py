"""A report in a few lines for people."""

from collections.abc import Mapping

from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Report, are_measures_told
from freecad.gaussiancad.engine.wording import role_name
from freecad.gaussiancad.language import translate


def status_text(status: Status) -> str:
    """What a status says of the part's shape."""
    return {
        Status.VERIFIED: translate("GaussianCAD", "Shape verified."),
        Status.APPROXIMATE: translate(
            "GaussianCAD", "Shape not certain: check the part against the drawing."
        ),
        Status.FAILED: translate("GaussianCAD", "Failed: no part follows from this drawing."),
    }[status]


def verdict_text(report: Report) -> str:
    """What is known of the part: its shape, and how well its measures are."""
    shape, measures = status_text(report.status), measures_text(report)
    return f"{shape} {measures}" if measures else shape


def measures_text(report: Report) -> str:
    """How well the measures are known; empty if that is not told."""
    if report.status is not Status.FAILED and not report.is_size_known:
        return translate("GaussianCAD", "The size is not known: tell a length") + "."
    measures = report.group("measures")
    bound = measures.get("uncertainty_mm")
    if not isinstance(bound, int | float):
        exact = report.status is Status.FAILED or are_measures_told(report.values)
        return "" if exact else measures_unknown() + "."
    source = {
        "numbers": translate("GaussianCAD", "from the sheet's numbers"),
        "drawing": translate("GaussianCAD", "from the drawing"),
        "mixed": translate("GaussianCAD", "from the sheet's numbers and the drawing"),
    }.get(str(measures.get("source")), "?")
    text = translate("GaussianCAD", "Measures to ±{bound} mm ({source}).")
    return text.format(bound=f"{bound:.2g}", source=source)


def measures_unknown() -> str:
    """That no bound is known, and why."""
    return translate(
        "GaussianCAD", "How exact its measures are is not known: the views fit no one scale"
    )


def _source_name(source: str) -> str:
    """Where a scale comes from, for people."""
    return {
        "given": translate("GaussianCAD", "given"),
        "sheet": translate("GaussianCAD", "from the sheet's resolution"),
        "dimension": translate("GaussianCAD", "from a dimension"),
        "default": translate("GaussianCAD", "assumed"),
    }.get(source, source or "?")


def report_lines(report: Report) -> list[str]:
    """Reasons, warnings, scale, views, models and time, a line each."""
    lines = [f"• {remark.words}" for remark in (*report.reasons, *report.warnings)]
    if report.mm_per_pixel:
        text = translate("GaussianCAD", "Scale: {scale} mm per pixel ({source})")
        source = _source_name(report.word("scale_source"))
        lines.append(text.format(scale=f"{report.mm_per_pixel:.5g}", source=source))
    lines += [_view_line(view.role, view.agreement) for view in report.views if view.agreement]
    lines += _model_lines(report)
    if report.seconds:
        text = translate("GaussianCAD", "Time: {seconds} s")
        lines.append(text.format(seconds=f"{sum(report.seconds.values()):.1f}"))
    return lines


def _view_line(role: str, agreement: Mapping[str, float]) -> str:
    parts = []
    for linetype, name in (
        ("visible", translate("GaussianCAD", "visible lines")),
        ("hidden", translate("GaussianCAD", "hidden lines")),
    ):
        recall = agreement.get(f"{linetype}_recall")
        precision = agreement.get(f"{linetype}_precision")
        if recall is not None and precision is not None:
            text = translate("GaussianCAD", "{lines} {recall} found, {precision} right")
            shares = {"recall": f"{recall:.1%}", "precision": f"{precision:.1%}"}
            parts.append(text.format(lines=name, **shares))
    return f"{role_name(role)}: " + "; ".join(parts)


def _model_lines(report: Report) -> list[str]:
    lines = []
    solid, surface = report.group("solid"), report.group("surface")
    if solid:
        text = translate("GaussianCAD", "Solid: {faces} faces, {volume} mm³")
        lines.append(text.format(faces=solid.get("faces"), volume=_volume(solid)))
    if surface:
        text = translate(
            "GaussianCAD", "Surface of the Gaussians: {triangles} triangles, {volume} mm³"
        )
        lines.append(text.format(triangles=surface.get("triangles"), volume=_volume(surface)))
        if surface.get("nearer") == "hull":
            lines.append(
                translate(
                    "GaussianCAD",
                    "The hull on which the Gaussians started is nearer to the drawing's outlines.",
                )
            )
    return lines


def _volume(model: Mapping[str, object]) -> str:
    volume = model.get("volume_mm3")
    return f"{volume:.6g}" if isinstance(volume, int | float) else "?"

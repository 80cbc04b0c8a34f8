"""A comparison on paper: a PDF with its picture, histogram, worst points and numbers."""

from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path
from typing import Any

import FreeCAD

from freecad.gaussiancad.engine.report import Comparison
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparison import comparison_report, request_of
from freecad.gaussiancad.objects.comparison_properties import range_mm
from freecad.gaussiancad.panels.distances import distance_rows, engineering_rows
from freecad.gaussiancad.panels.histogram import paint_histogram
from freecad.gaussiancad.panels.worst_table import worst_rows
from freecad.gaussiancad.qt import QtCore, QtGui

_WIDTH = 620
"""Width of pictures in the document's pixels, of which 96 are an inch; A4 has room for 628."""

_FINE = 4
"""Pixels of the histogram's picture for one of the document's."""

_TALL = 110

_RESOLUTION = 300

_STYLE = (
    "body { font-family: sans-serif; font-size: 9pt } h1 { font-size: 15pt } h2 { font-size: 11pt }"
    "th { text-align: left; font-weight: normal } td { text-align: right }"
    "p.note { color: #555555 } .page { page-break-before: always }"
)


def write_comparison_pdf(group: FreeCAD.DocumentObject, path: Path) -> None:
    """Write the comparison that a group stores, on A4; needs a window system.

    Raises:
        OSError: the file cannot be written.
    """
    report = comparison_report(group)
    document = QtGui.QTextDocument()
    document.setDefaultStyleSheet(_STYLE)
    pictures = dict(_pictures(group, report))
    for name, picture in pictures.items():
        kind = QtGui.QTextDocument.ResourceType.ImageResource
        document.addResource(int(getattr(kind, "value", kind)), QtCore.QUrl(name), picture)
    document.setHtml(_html((group.Result, group.Reference), report, pictures))
    # Qt tells nobody what it could not write.
    path.write_bytes(b"")
    writer = QtGui.QPdfWriter(str(path))
    writer.setResolution(_RESOLUTION)
    # The document has margins of its own.
    size = QtGui.QPageSize(QtGui.QPageSize.PageSizeId.A4)
    upright = QtGui.QPageLayout.Orientation.Portrait
    writer.setPageLayout(QtGui.QPageLayout(size, upright, QtCore.QMarginsF(0, 0, 0, 0)))
    writer.setTitle(f"{group.Result} / {group.Reference}")
    writer.setCreator("GaussianCAD")
    document.print_(writer)
    del writer
    if not path.stat().st_size:
        raise OSError(f"{path}: nothing was written")


def _pictures(
    group: FreeCAD.DocumentObject, report: Comparison
) -> Iterator[tuple[str, QtGui.QImage]]:
    """What there is to see, by name."""
    shown = _image_of(getattr(group, "Picture", ""))
    if shown is not None:
        yield "picture", shown
    if report.histogram is not None:
        image = QtGui.QImage(_WIDTH * _FINE, _TALL * _FINE, QtGui.QImage.Format.Format_RGB32)
        image.fill(QtGui.QColor(255, 255, 255))
        painter = QtGui.QPainter(image)
        painter.scale(_FINE, _FINE)
        painter.setPen(QtGui.QColor(0, 0, 0))
        area = QtCore.QRect(0, 0, _WIDTH, _TALL)
        paint_histogram(painter, area, report.histogram, _range_of(group, report))
        painter.end()
        yield "histogram", image
    request = request_of(group)
    sheet = None if request is None else request.result.sheet()
    drawing = None if sheet is None else _image_of(str(sheet))
    if drawing is not None:
        yield "sheet", drawing


def _image_of(path: str) -> QtGui.QImage | None:
    """The picture in a file; None where there is none."""
    image = QtGui.QImage(path) if path else QtGui.QImage()
    return None if image.isNull() else image


def _range_of(group: FreeCAD.DocumentObject, report: Comparison) -> float:
    """mm at the ends of the picture's colours, which the user's range does not change."""
    stated = report.values.get("deviation")
    value = stated.get("range_mm") if isinstance(stated, dict) else None
    return float(value) if isinstance(value, int | float) and value > 0 else range_mm(group)


def _html(names: tuple[str, str], report: Comparison, pictures: dict[str, QtGui.QImage]) -> str:
    title = translate("GaussianCAD", "Comparison of {result} with {reference}")
    values = report.values
    parts = [f"<h1>{escape(title.format(result=names[0], reference=names[1]))}</h1>"]
    if report.warnings:
        items = "".join(f"<li>{escape(remark.words)}</li>" for remark in report.warnings)
        parts.append(f"<ul>{items}</ul>")
    if "picture" in pictures:
        parts.append(_image("picture", pictures["picture"], _WIDTH * 0.8))
    if "histogram" in pictures:
        title = translate("GaussianCAD", "Share of the surface by its deviation")
        parts.append(f"<h2>{escape(title)}</h2>{_image('histogram', pictures['histogram'])}")
    if report.engineering:
        head = ("", translate("GaussianCAD", "Result"), translate("GaussianCAD", "Reference"))
        parts.append(_table(head, engineering_rows(report.engineering)))
    if report.worst:
        head = (
            "mm",
            translate("GaussianCAD", "Result has"),
            translate("GaussianCAD", "Place"),
        )
        title = translate("GaussianCAD", "Worst points")
        parts.append(f'<h2 class="page">{escape(title)}</h2>')
        parts.append(_table(head, worst_rows(report.worst)))
    head = ("", translate("GaussianCAD", "Result"), translate("GaussianCAD", "Reference"))
    parts.append(f"<h2>{escape(translate('GaussianCAD', 'Models'))}</h2>")
    parts.append(_table(head, _model_rows(values)))
    head = ("", translate("GaussianCAD", "Value"), translate("GaussianCAD", "Floor"))
    parts.append(f"<h2>{escape(translate('GaussianCAD', 'Measures'))}</h2>")
    parts.append(_table(head, distance_rows(report)))
    stated = [
        f"{start}{values[key]}"
        for key, start in (("protocol", ""), ("emd_method", "EMD "))
        if values.get(key)
    ]
    stated += [f"{key} {values[key]}" for key in ("points", "seed") if key in values]
    parts.append(f'<p class="note">{escape("; ".join(stated))}</p>')
    if "sheet" in pictures:
        parts.append(f'<h2 class="page">{escape(translate("GaussianCAD", "Sheet"))}</h2>')
        parts.append(_image("sheet", pictures["sheet"]))
    return f"<body>{''.join(parts)}</body>"


def _model_rows(values: dict[str, Any]) -> list[tuple[str, ...]]:
    """What both files hold, as far as it was told."""
    sides = [values.get(key) or {} for key in ("result", "reference")]
    names = {
        "extent_mm": translate("GaussianCAD", "Size, mm"),
        "volume_mm3": translate("GaussianCAD", "Volume, mm³"),
        "area_mm2": translate("GaussianCAD", "Area, mm²"),
        "faces": translate("GaussianCAD", "Faces"),
        "triangles": translate("GaussianCAD", "Triangles"),
    }
    return [(name, *(_fact(side.get(key)) for side in sides)) for key, name in names.items()]


def _fact(value: object) -> str:
    if isinstance(value, list):
        return " × ".join(_fact(each) for each in value)
    if isinstance(value, bool) or not isinstance(value, int | float):
        return "–"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _image(name: str, picture: QtGui.QImage, width: float = _WIDTH) -> str:
    height = width * picture.height() / picture.width()
    return f'<p><img src="{name}" width="{round(width)}" height="{round(height)}"></p>'


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    top = "".join(
        f"<td><b>{escape(text)}</b></td>" if column else f"<th><b>{escape(text)}</b></th>"
        for column, text in enumerate(head)
    )
    lines = "".join(
        "<tr>"
        + "".join(
            f"<td>{escape(text)}</td>" if column else f"<th>{escape(text)}</th>"
            for column, text in enumerate(row)
        )
        + "</tr>"
        for row in rows
    )
    return (
        '<table width="100%" border="0.5" cellspacing="0" cellpadding="3" '
        f'style="border-style: solid; border-color: #bbbbbb"><tr>{top}</tr>{lines}</table>'
    )

"""What ``gaussiancad draw`` does: a solid's file to a sheet's file."""

import io
from pathlib import Path

from PIL import Image as PillowImage

from gaussiancad_core.drawing.degrade import Image
from gaussiancad_core.drawing.drawn_sheet import Sheet, draw_sheet
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.view_placing import check_roles
from gaussiancad_core.errors import UsageError
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection, Role, mutually_orthogonal
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_protocol.codes import Code

_FORMATS = {
    ".png": "PNG",
    ".jpg": "JPEG",
    ".jpeg": "JPEG",
    ".tif": "TIFF",
    ".tiff": "TIFF",
    ".bmp": "BMP",
    ".webp": "WEBP",
}


def draw_file(
    solid: Path,
    sheet: Path,
    roles: tuple[Role, ...],
    projection: Projection,
    style: SheetStyle,
    *,
    seed: int = 0,
) -> Sheet:
    """Draw the solid of a STEP or BREP file on a sheet and write it as an image.

    Args:
        solid: STEP or BREP file.
        sheet: image file to write; its suffix is the format.
        roles: two to six views; three or more must look along all three axes.
        projection: first or third angle.
        style: the look.
        seed: of the style's defects.

    Raises:
        UsageError: ``views-count``, ``views-repeat``, ``views-not-orthogonal``,
            ``sheet-suffix-unknown``, ``sheet-too-small``, ``output-not-writable``.
        UnreadableError: see :func:`gaussiancad_core.kernel.brep_files.read_solid`.
        LimitError: ``disk-full``.
    """
    check_roles(roles)
    if len(roles) > 2 and not mutually_orthogonal(roles):
        names = ", ".join(role.value for role in roles)
        raise UsageError(
            Code.VIEWS_NOT_ORTHOGONAL,
            f"{names} do not look along all three axes: take for example front,top,right",
        )
    image_format(sheet)
    drawn = draw_sheet(read_solid(solid), roles, projection, style, seed, title=solid.stem)
    write_image(drawn.image, sheet, style.jpeg_quality, drawn.dpi)
    return drawn


def image_format(path: Path) -> str:
    """Pillow's name of the image format that a path's suffix stands for.

    Raises:
        UsageError: ``sheet-suffix-unknown``.
    """
    try:
        return _FORMATS[path.suffix.lower()]
    except KeyError as error:
        raise UsageError(
            Code.SHEET_SUFFIX_UNKNOWN,
            f"{path.name} has no image suffix: use one of {', '.join(_FORMATS)}",
        ) from error


def write_image(image: Image, path: Path, quality: int = 95, dpi: float | None = None) -> None:
    """Write (h, w, 3) uint8 RGB by the path's suffix; the file appears only when whole.

    Args:
        image: the pixels.
        path: its suffix is the format.
        quality: 1 to 100, of JPEG and WebP.
        dpi: the resolution that the file names, in formats that can; None names none.

    Raises:
        UsageError: ``sheet-suffix-unknown``, ``output-not-writable``.
        LimitError: ``disk-full``.
    """
    stream = io.BytesIO()
    name = image_format(path)
    options: dict[str, dict[str, object]] = {
        "JPEG": {"quality": quality, "subsampling": 0},
        "WEBP": {"quality": quality},
    }
    chosen = dict(options.get(name, {}))
    if dpi is not None and name != "WEBP":
        chosen["dpi"] = (dpi, dpi)
    PillowImage.fromarray(image).save(stream, name, **chosen)
    write_whole(path, stream.getvalue())

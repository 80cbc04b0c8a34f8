"""Compare two model files: what ``gaussiancad compare`` does."""

from pathlib import Path

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions
from gaussiancad_core.comparison.comparison_page import (
    PageParts,
    comparison_page,
    overlay_of_result,
)
from gaussiancad_core.comparison.comparison_report import Comparison, comparison_json
from gaussiancad_core.comparison.deviation import Deviation, ply_bytes
from gaussiancad_core.comparison.deviation_picture import deviation_picture
from gaussiancad_core.comparison.model_files import read_model
from gaussiancad_core.pictures.png_pictures import png_bytes
from gaussiancad_core.storage.outputs import OutputFolder

COMPARISON_FILES = ("comparison.json", "comparison.html", "deviation.ply", "deviation.png")
"""What a comparison owns in its output folder."""

DEFAULT_OPTIONS = CompareOptions()


def compare_files(
    result: Path,
    reference: Path,
    output: Path | None = None,
    options: CompareOptions = DEFAULT_OPTIONS,
) -> Comparison:
    """Compare a result with a reference, each STEP, BREP, STL, PLY or OBJ.

    Args:
        result, reference: the files.
        output: folder for ``comparison.json``, ``comparison.html`` (one page that needs nothing
            else), ``deviation.ply`` (see :mod:`gaussiancad_core.comparison.deviation`) and
            ``deviation.png``; None writes none.
        options: what is asked for.

    Raises:
        UnreadableError: a file is no model; see :func:`read_model`.
        UsageError: an option cannot be used, or the folder cannot be written.
        LimitError: the disk is full.
    """
    options.check()
    pair = read_model(result), read_model(reference)
    comparison, deviation = compare_models(*pair, options)
    if output is not None:
        picture = png_bytes(deviation_picture(deviation))
        names = result.name, reference.name
        parts = PageParts(names, pair[1].mesh, picture, overlay_of_result(result))
        _write(comparison, deviation, parts, output)
    return comparison


def _write(comparison: Comparison, deviation: Deviation, parts: PageParts, output: Path) -> None:
    folder = OutputFolder(output, COMPARISON_FILES, "comparison.json")
    try:
        (folder.staging / "deviation.ply").write_bytes(ply_bytes(deviation))
        (folder.staging / "deviation.png").write_bytes(parts.picture)
        page = comparison_page(comparison, deviation, parts)
        (folder.staging / "comparison.html").write_bytes(page)
        (folder.staging / "comparison.json").write_bytes(comparison_json(comparison))
        folder.commit()
    except BaseException:
        folder.discard()
        raise

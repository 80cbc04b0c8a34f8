"""Words for first and third angle, and the sheets that have them."""

from pathlib import Path

import pytest

from gaussiancad_core.files.svg import read_svg
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.special_views.projection_note import noted_projection, projection_in


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("FIRST ANGLE PROJECTION", Projection.FIRST),
        ("3rd angle", Projection.THIRD),
        ("Third-Angle Projection", Projection.THIRD),
        ("Premier dièdre", Projection.FIRST),
        ("第三角法", Projection.THIRD),
        ("FIRST ANGLE / THIRD ANGLE", None),
        ("THIRD", None),
        ("ANGLE 30", None),
    ],
)
def test_words_for_a_projection(text: str, expected: Projection | None) -> None:
    assert projection_in(text) is expected


@pytest.mark.parametrize(
    ("notes", "expected"),
    [
        (("THIRD ANGLE",), Projection.THIRD),
        (("FIRST ANGLE", "1ST ANGLE PROJECTION"), Projection.FIRST),
        (("FIRST ANGLE", "THIRD ANGLE"), None),
        ((), None),
    ],
)
def test_notes_of_a_file_tell_it_where_they_agree(
    tmp_path: Path, notes: tuple[str, ...], expected: Projection | None
) -> None:
    file = tmp_path / "sheet.svg"
    texts = "".join(
        f'<text x="20" y="{20 + 10 * row}" font-size="4">{text}</text>'
        for row, text in enumerate(notes)
    )
    file.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" '
        f'viewBox="0 0 297 210"><path d="M50 90H250" stroke="black"/>{texts}</svg>'
    )
    content = read_svg(file, 1)
    sheet = OpenedSheet(SheetImage(file, content.grey, "", vectors=content.vectors))
    found = noted_projection(sheet)
    assert (found.projection if found else None) is expected

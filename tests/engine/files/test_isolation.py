from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from msgspec.msgpack import encode

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.files.answer import content_bytes, error_bytes, outcome_of
from gaussiancad_core.files.content import FileContent, Note
from gaussiancad_core.files.file_child import main
from gaussiancad_core.files.file_kinds import FileKind
from gaussiancad_core.files.isolation import read_isolated
from gaussiancad_core.files.pdf import read_pdf
from gaussiancad_core.files.vectors import (
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.messages import Message

PEN = (None, (), "unknown", "", "geometry", None, 0.0)
DRAWN = {
    **dict.fromkeys(("strokes", "lines", "arcs", "ellipses", "chains", "texts", "pictures"), ()),
    **dict.fromkeys(("complete", "has_paper"), True),
    **dict.fromkeys(("unit_mm", "unit_px")),
}
WHOLE = {
    "type": "_Content",
    "shape": [2, 2],
    "planes": [b"1234"],
    **dict.fromkeys(("pixels_per_inch", "vectors", "brought_together")),
    "notes": [],
    "pages": 1,
}


def test_answers_come_back_as_they_were() -> None:
    strokes = (
        VectorStroke(Chain(((0.0, 1.0), (2.0, 3.0), (0.0, 1.0))), 1.5, kind=StrokeKind.FILL),
        VectorStroke(
            LineSegment((0.5, 1.0), (np.float64(2.0), 3.0)), None, (4.0, 2.0), StrokeRole.HIDDEN
        ),
        VectorStroke(CircularArc((1.0, 2.0), 3.0, 0.25, 6.0), 0.5, layer="0", colour=(1, 2, 3)),
        VectorStroke(EllipticArc((1.0, 2.0), 5.0, 2.5, 0.5, 0.0, 1.0), 0.5, step=0.01),
        VectorStroke(LineSegment((5.0, 1.0), (2.0, 3.0)), None),
    )
    drawing = VectorDrawing(
        strokes,
        (VectorText("\u00d8 5", (1, 2, 3, 4)),),
        False,
        False,
        25.4,
        2.0,
        ((1.0, 2.0, 3.0, 4.0),),
    )
    notes = (Note("a", Message("{count} pages", count=np.int64(3)), True), Note("b", "plain"))
    grey = np.arange(12, dtype=np.uint8).reshape(3, 4)
    read = outcome_of(content_bytes(FileContent(grey, 200.0, drawing, notes, grey + 1, 3, 2)))
    assert isinstance(read, FileContent)
    assert np.array_equal(read.grey, grey) and np.array_equal(read.tint, grey + 1)
    assert read.grey.flags.writeable
    assert (read.vectors, read.notes) == (drawing, notes)
    assert dict(read.notes[0].message.args) == {"count": 3} and type(read.notes[1].message) is str
    assert (read.pixels_per_inch, read.pages, read.brought_together) == (200.0, 3, 2)
    assert outcome_of(encode(WHOLE)).vectors is None


def test_names_and_texts_that_are_no_characters_come_back() -> None:
    error = UnreadableError("not-an-image", "{path} is none", path="/sheets/text\udce9.png")
    found = outcome_of(error_bytes(error))
    assert isinstance(found, UnreadableError)
    assert (found.code, str(found)) == (error.code, str(error))
    texts = (VectorText("5 \udcd8", (1.0, 2.0, 3.0, 4.0)),)
    strokes = (VectorStroke(LineSegment((0.0, 0.0), (1.0, 1.0)), 1.0, layer="Schicht \udcfc"),)
    content = FileContent(np.zeros((2, 2), np.uint8), vectors=VectorDrawing(strokes, texts))
    read = outcome_of(content_bytes(content))
    assert isinstance(read, FileContent) and read.vectors is not None
    assert (read.vectors.texts[0].text, read.vectors.strokes[0].layer) == ("5 ?", "Schicht ?")


def test_the_child_reads_the_same(pdf: type, pdf_circle: Callable, save: Callable) -> None:
    path = save("图 a sheet.pdf", pdf(pdf_circle(300, 500, 120)).to_bytes())
    read, direct = read_isolated(FileKind.PDF, path, 1), read_pdf(path, 1)
    assert np.array_equal(read.grey, direct.grey)
    assert read.vectors == direct.vectors
    assert read.pixels_per_inch == direct.pixels_per_inch


def test_errors_come_back_with_the_name_that_was_given(
    save: Callable, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save("bad.svg", "<svg")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UnreadableError) as caught:
        read_isolated(FileKind.SVG, Path("bad.svg"), 1)
    assert caught.value.code == "damaged-svg"
    assert caught.value.message.startswith("bad.svg ")
    assert caught.value.message.args["path"] == "bad.svg"


def test_defects_of_parsers_are_told_in_one_line(
    save: Callable, monkeypatch: pytest.MonkeyPatch, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    def fail(*_: object) -> None:
        raise KeyError("two\nlines")

    path = save("a.svg", "<svg/>")
    monkeypatch.setattr("gaussiancad_core.files.svg.read_svg", fail)
    main(FileKind.SVG, path, 1)
    error = outcome_of(capfdbinary.readouterr().out)
    assert isinstance(error, UnreadableError) and error.code == "damaged-svg"
    assert "\n" not in error.message
    assert "KeyError" in error.message


@pytest.mark.parametrize(
    "answer",
    [
        b"",
        b"\x80\x04N.",
        b"\xc0",
        encode({"type": "_Content", "shape": [9, 9]}),
        encode({"type": "_Failure", "error": "SystemExit", "code": "", "message": "", "args": {}}),
        encode({**WHOLE, "planes": [b"123"]}),
        encode({**WHOLE, "vectors": {**DRAWN, "strokes": [["system", *PEN]]}}),
        encode({**WHOLE, "vectors": {**DRAWN, "strokes": [["LineSegment", *PEN]]}}),
        encode({**WHOLE, "vectors": {**DRAWN, "chains": [{"points": "x"}]}}),
        encode(WHOLE)[:-1],
    ],
)
def test_what_is_no_answer_is_refused(answer: bytes) -> None:
    with pytest.raises(ValueError, match=r".*"):
        outcome_of(answer)


def test_time_is_bounded(pdf: type, save: Callable) -> None:
    path = save("a.pdf", pdf(b"0 0 m 9 9 l S").to_bytes())
    with pytest.raises(LimitError) as caught:
        read_isolated(FileKind.PDF, path, 1, time_limit=0.01)
    assert caught.value.code == "reading-takes-too-long"


def test_crashes_and_memory_are_bounded(
    pdf: type, pdf_stream: Callable, save: Callable, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Forms that show forms that show forms: PDFium expands them while it loads the page."""
    entries = b"/Type /XObject /Subtype /Form /BBox [0 0 500 500] "
    nested = tuple(
        pdf_stream(b"/F Do " * 10, entries + b"/Resources << /XObject << /F %d 0 R >> >>" % number)
        for number in range(6, 20)
    )
    last = pdf_stream(b"0 0 m 100 100 l S", entries)
    page = b"/Resources << /XObject << /F 5 0 R >> >>"
    path = save("bomb.pdf", pdf(b"/F Do", page=page, objects=(*nested, last)).to_bytes())
    with pytest.raises((LimitError, UnreadableError)) as caught:
        read_isolated(FileKind.PDF, path, 1, time_limit=4.0)
    assert caught.value.code in ("reading-takes-too-long", "damaged-pdf", "out-of-memory")

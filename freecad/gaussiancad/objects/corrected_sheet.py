"""A drawing that a person corrects, in a document: a group with the sheet, what was read, the
corrections, and the part that follows from them.

Opening it and each correction are undo steps.  The part follows from the corrections as the result
of a recompute does: it is changed in place, and no step of its own, so that what was built on it
lives and undoing a correction brings the part of before.
"""

import hashlib
import json
import shutil
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.canvas.corrections_storage import (
    corrections_path,
    move_aside,
    operations_in,
    read_corrections,
    write_corrections,
)
from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import ResultKind
from freecad.gaussiancad.engine.report import read_report
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.objects.known_sheets import group_of, is_of
from freecad.gaussiancad.objects.loading import PartSource, load_alternatives, read_shape
from freecad.gaussiancad.objects.properties import Access, PropertySpec, add_properties
from freecad.gaussiancad.objects.reconstruction import new_reconstruction, show_solution
from freecad.gaussiancad.objects.reconstruction_features import (
    CHOICE,
    add_empty_part,
    find_part,
    put_alternatives,
)
from freecad.gaussiancad.objects.transaction import transaction

CORRECTIONS = "Corrections"
"""The property that holds a person's operations, as JSON."""

READING = "Reading"
"""The property with the file of what was read."""

SOLVED = "SolvedFrom"
"""The property with the hash of the corrections that the part follows from."""


def open_in(document: FreeCAD.Document, sheet: Path, page: int) -> FreeCAD.DocumentObject:
    """The group of a drawing in a document, added in one undo step where there is none yet.

    Args:
        document: that has the group, or gets it.
        sheet: path of the drawing; corrections beside it are taken over.
        page: of a file with pages.

    Raises:
        ValueError: the corrections beside the drawing are damaged.
    """
    known = group_of(document, sheet, page)
    if known is not None and hasattr(known, CORRECTIONS):
        return known
    _, found = read_corrections(corrections_path(sheet, page))
    with transaction(document, translate("GaussianCAD", "Open Drawing")):
        if known is None:
            job = ReconstructJob(str(sheet), "", page=page, outcome=ResultKind.SOLID)
            known = new_reconstruction(document, job)
        add_properties(known, _properties(found))
        if find_part(known) is None:
            add_empty_part(known)
        document.recompute()
        known.Proxy.show(known)
    return known


def corrections_of(group: FreeCAD.DocumentObject) -> list[dict]:
    """A person's operations; none where the text is damaged."""
    try:
        found = operations_in(json.loads(getattr(group, CORRECTIONS, "") or "[]"))
    except ValueError:
        found = None
    return found or []


def take_reading(group: FreeCAD.DocumentObject, file: Path) -> None:
    """Keep what was read, so that the document shows it without the engine."""
    setattr(group, READING, str(file))


def hand_over(group: FreeCAD.DocumentObject, folder: Path) -> tuple[Path, Path | None]:
    """Write what was read and what was corrected into a folder, for a run.

    Returns:
        The files; no second one where nothing was corrected.

    Raises:
        WorkbenchError: the drawing was not read yet.
    """
    if not group.Reading:
        text = translate("GaussianCAD", "The drawing was not read yet. Wait until it is.")
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, text)
    reading = Path(shutil.copyfile(group.Reading, folder / "reading.json"))
    sha256 = json.loads(reading.read_text(encoding="utf-8"))["sheet"]["sha256"]
    operations = corrections_of(group)
    if not operations:
        return reading, None
    corrections = folder / "corrections.json"
    write_corrections(corrections, sha256, operations)
    return reading, corrections


def kept_corrections(group: FreeCAD.DocumentObject, sheet: Path, folder: Path) -> Path | None:
    """Write what a document has corrected on its own copy of a drawing, for a run.

    Args:
        group: of the drawing.
        sheet: its path; what was corrected on a file lies beside it already.
        folder: receives the file.

    Returns:
        The file; None where the drawing is no copy, or nothing was corrected.
    """
    operations = corrections_of(group)
    if (
        not operations
        or str(sheet) != getattr(group, "Sheet", "")
        or corrections_path(sheet, 1).exists()
    ):
        return None
    corrections = folder / "corrections.json"
    write_corrections(corrections, hashlib.sha256(sheet.read_bytes()).hexdigest(), operations)
    return corrections


def take_solution(group: FreeCAD.DocumentObject, folder: Path) -> None:
    """Change the part, and what is known of it, in place; a solution that a person kept stays as
    long as the corrections do.

    Args:
        group: of the drawing.
        folder: that a run left.

    Raises:
        WorkbenchError: what the run left cannot be read.
    """
    corrections = _hash(getattr(group, CORRECTIONS))
    if getattr(group, CHOICE, "") and getattr(group, SOLVED) == corrections:
        # The same question again, which a person has answered.
        return
    if hasattr(group, CHOICE):
        setattr(group, CHOICE, "")
    report = read_report(folder / "report.json")
    shape = read_shape(folder / PartSource.SOLID.value)
    if find_part(group) is None:
        add_empty_part(group)
    show_solution(group, shape, report)
    setattr(group, SOLVED, corrections)
    group.Document.recompute()


def offer_solutions(group: FreeCAD.DocumentObject, folder: Path) -> None:
    """Put the other solids that have the drawing's lines beside the part, in one undo step; the
    next correction takes them away.

    Args:
        group: of the drawing.
        folder: that the run left.

    Raises:
        WorkbenchError: what the run left cannot be read.
    """
    report = read_report(folder / "report.json")
    shapes = load_alternatives(folder / "alternatives")
    with transaction(group.Document, translate("GaussianCAD", "Show Solutions")):
        put_alternatives(group, shapes, report)


class InDocument:
    """Keeps corrections in a document, each step an undo step of it, and a copy beside the drawing,
    where every other run finds it.

    Args:
        group: of the drawing.
        sheet: its path.
        page: of a file with pages.
    """

    has_undo = False

    def __init__(self, group: FreeCAD.DocumentObject, sheet: Path, page: int) -> None:
        self.document, self.group = group.Document.Name, group.Name
        self._sheet, self._page = sheet, page
        self._beside = corrections_path(sheet, page)
        self._sha256 = ""

    def find(self) -> FreeCAD.DocumentObject | None:
        """The group, or None where it was removed or its document closed; another drawing's may
        have got its name."""
        if self.document not in FreeCAD.listDocuments():
            return None
        found = FreeCAD.getDocument(self.document).getObject(self.group)
        if found is None or not is_of(found, self._sheet, self._page):
            return None
        return found

    @property
    def operations(self) -> list[dict]:
        """All of them, in order."""
        group = self.find()
        return corrections_of(group) if group is not None else []

    def belongs_to(self, sha256: str) -> bool:
        """Whether the corrections are of a sheet: those of a document are of the one in it.

        Those of another version of the drawing are left out, in an undo step of its own, and their
        file is moved aside.
        """
        group, self._sha256 = self.find(), sha256
        if group is None or not self.operations:
            return True
        stated, _ = read_corrections(self._beside)
        mine = not stated or stated == sha256
        if not mine:
            with transaction(group.Document, translate("GaussianCAD", "Correct Drawing")):
                setattr(group, CORRECTIONS, "[]")
            self.copy()
        return mine

    def add(self, operations: list[dict]) -> None:
        """Add operations as one undo step."""
        group = self.find()
        if group is None:
            return
        with transaction(group.Document, translate("GaussianCAD", "Correct Drawing")):
            put_alternatives(group, ())
            setattr(group, CORRECTIONS, json.dumps([*corrections_of(group), *operations]))
        self.copy()

    def undo(self) -> None:
        """Take the last step of the document back."""
        group = self.find()
        if group is not None:
            group.Document.undo()

    def redo(self) -> None:
        """Say again what was taken back last."""
        group = self.find()
        if group is not None:
            group.Document.redo()

    def copy(self) -> None:
        """Write the corrections beside the drawing, where that can be written."""
        try:
            if self._sha256:
                move_aside(self._beside, self._sha256)
            write_corrections(self._beside, self._sha256, self.operations)
        except OSError as error:
            FreeCAD.Console.PrintLog(f"GaussianCAD: no corrections beside the drawing: {error}\n")


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _properties(operations: list[dict]) -> list[PropertySpec]:
    group = "Drawing"
    return [
        PropertySpec(
            "String",
            CORRECTIONS,
            group,
            QT_TRANSLATE_NOOP("App::Property", "What was corrected by hand, as JSON"),
            json.dumps(operations),
            Access.HIDDEN,
        ),
        PropertySpec(
            "FileIncluded",
            READING,
            group,
            QT_TRANSLATE_NOOP("App::Property", "What the engine read on the drawing"),
            "",
            Access.HIDDEN,
        ),
        PropertySpec(
            "String",
            SOLVED,
            group,
            QT_TRANSLATE_NOOP("App::Property", "The corrections that the part follows from"),
            "",
            Access.HIDDEN,
        ),
    ]

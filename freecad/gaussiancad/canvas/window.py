"""The window of one sheet: what was understood, a person's corrections, and the verdict.

It stands by itself (``gaussiancad correct SHEET``) and in a dock of FreeCAD.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from freecad.gaussiancad.canvas.board import DRAWING, TOOLS, Board
from freecad.gaussiancad.canvas.desk import Desk
from freecad.gaussiancad.canvas.gaps import closing_lines, open_ends
from freecad.gaussiancad.canvas.keeping import Beside, Keeper
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES, name_of
from freecad.gaussiancad.canvas.pages import Pages
from freecad.gaussiancad.canvas.rows import Line, Rows
from freecad.gaussiancad.canvas.scene import LAYERS, Mark
from freecad.gaussiancad.canvas.serving import Program
from freecad.gaussiancad.canvas.sheet import Box, Number, Point, Row, Sheet
from freecad.gaussiancad.canvas.verdict import (
    SIGNS,
    Buttons,
    Help,
    marks_of,
    verdict_line,
    verdict_lines,
)
from freecad.gaussiancad.engine.wording import stage_name
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_PIN = 8.0
"""px of the sheet around an end that is marked."""

_BESIDE = 4.0
"""px within which a stroke runs at a place."""

_OPEN = "open-outline"
"""The engine's code for a view whose outline has a gap."""

_USUAL = {
    "scale-assumed": "scale",
    "full-scale-assumed": "scale",
    "paper-size-unknown": "scale",
    "dimensions-not-read": "scale",
    "projection-assumed": "projection",
    "told-lengths-disagree": "scale",
}
"""What helps with a warning that came up after the sheet was read."""


class SheetWindow(QtWidgets.QMainWindow):
    """The window.

    Args:
        path: of the sheet.
        page: of a file with pages.
        program: the engine.
        keeper: of the corrections; a file beside the sheet where none is given.
        parent: in FreeCAD the dock.

    Raises:
        ValueError: the corrections beside the sheet are damaged.

    Signals:
        page_asked: another page of the file.
    """

    page_asked = QtCore.Signal(int)

    def __init__(
        self,
        path: Path,
        page: int = 1,
        *,
        program: Program | None = None,
        keeper: Keeper | None = None,
        parent: QtWidgets.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.keeper = keeper or Beside(path, page)
        self.desk = Desk(path, page, program or Program(), self.keeper, self)
        self.board = Board(self)
        self.problems = Rows(self)
        self._report: dict | None = None
        self._pictured = False
        self._more_help: dict[str, Buttons] = {}
        self._left_out: list[Line] = []
        self._listen()
        self.pages = Pages(self.desk.thumbnail, lambda: not self.busy, self)
        self.pages.chosen.connect(self.page_asked)
        split = QtWidgets.QSplitter(QtCore.Qt.Orientation.Vertical)
        split.addWidget(self.board)
        split.addWidget(self.problems)
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes([600, 220])
        middle = QtWidgets.QWidget()
        layout = QtWidgets.QHBoxLayout(middle)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.pages)
        layout.addWidget(split)
        self.setCentralWidget(middle)
        self._add_tools()
        self.setWindowTitle(f"{path.name} \u2013 GaussianCAD")
        self.resize(1280, 900)

    @property
    def sheet(self) -> Sheet | None:
        """What is shown; None while the sheet is read."""
        return self.desk.sheet

    @property
    def busy(self) -> bool:
        """Whether an engine reads or solves."""
        return self.desk.reading or self.desk.solving

    @property
    def operations(self) -> list[dict]:
        """What was said."""
        return self.keeper.operations

    def start(self) -> None:
        """Read the sheet."""
        self.tell(translate("GaussianCAD", "The sheet is read\u2026"))
        self.desk.start()

    def solve(self) -> None:
        """Make the part, with what was said."""
        self.desk.solve()

    def undo(self) -> None:
        """Take the last step back."""
        self.keeper.undo()
        self.desk.refresh()

    def redo(self) -> None:
        """Say it again."""
        self.keeper.redo()
        self.desk.refresh()

    def add_action(self, text: str, called: Callable[[], None]) -> None:
        """Put a button for something else at the end of the toolbar."""
        self._add(self._bar, text, called)

    def add_help(self, code: str, text: str, called: Callable[[], None]) -> None:
        """Put a button for something else beside what a report says under a code."""
        self._more_help[code] = ((text, called),)

    def tell(self, text: str) -> None:
        """Put a sentence in place of the list."""
        self.problems.show_lines([Line(own) for own in text.splitlines() if own.strip()])

    def say_view(self, role: str, box: Box) -> None:
        """Say that a box of the sheet is a view."""
        known = self.sheet.views if self.sheet is not None else ()
        name = next((own.id for own in known if own.role == role), role)
        self.desk.say([{"op": "view", "id": name, "role": role, "box": list(box)}])

    def say_length(self, points: tuple[Point, Point], length: float) -> None:
        """Say how far two points of the sheet are apart, mm."""
        told = {"points": [list(own) for own in points], "length_mm": length}
        self.desk.say([{"op": "scale", **told}])

    def say_value(self, number: Number, value_mm: float) -> None:
        """Say what a dimension gives, mm."""
        self.desk.say([{"op": "dimension", "id": number.id, "value_mm": value_mm}])

    def say_section(self, view: str, line: tuple[Point, ...], in_view: str) -> None:
        """Say that a view shows the section along a line in another view."""
        told = {"id": view, "in_view": in_view, "line": [list(own) for own in line]}
        self.desk.say([{"op": "section", **told}])

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        """End the engines with the window."""
        self.desk.close()
        super().closeEvent(event)

    def _listen(self) -> None:
        board, desk = self.board, self.desk
        board.said.connect(desk.say)
        board.asked_role.connect(self._ask_role)
        board.asked_length.connect(self._ask_length)
        board.asked_view.connect(self.say_view)
        board.asked_value.connect(self._ask_value)
        board.asked_depth.connect(self._ask_depth)
        board.asked_section.connect(self._ask_section)
        board.asked_trace.connect(self._trace)
        board.asked_next.connect(self.problems.show_next)
        board.asked_part.connect(self.solve)
        self.problems.place_asked.connect(board.zoom_to)
        desk.pictured.connect(self._show_picture)
        desk.read.connect(self._was_read)
        desk.changed.connect(self._shown)
        desk.solved.connect(self._was_solved)
        desk.told.connect(self.tell)
        desk.working.connect(self._show_work)
        desk.stage.connect(self._show_stage)

    def _show_picture(self, path: str, size: object, pages: int) -> None:
        self.board.show_picture(path, size)
        self.pages.show_pages(pages, self.desk.page)
        if not self._pictured:
            self._pictured = True
            self.board.fit()

    def _was_read(self) -> None:
        """The first time: show the views, and tell of corrections that are not the sheet's."""
        boxes = [own.box for own in self.sheet.views if own.shown]
        if boxes:
            x0, y0, x1, y1 = zip(*boxes, strict=True)
            self.board.zoom_to((min(x0), min(y0), max(x1), max(y1)))
        belongs = getattr(self.keeper, "belongs_to", None)
        if belongs is not None and not belongs(self.desk.sheet.sha256):
            kept = translate(
                "GaussianCAD",
                "The corrections beside the sheet are of another version of it: they were left "
                "out, and will be kept as a file of their own.",
            )
            self._left_out = [Line(f"{SIGNS['doubt']} {kept}")]

    def _shown(self) -> None:
        """What was read, or said, has changed: the verdict is out of date."""
        self._report = None
        sheet = self.sheet
        self.board.show_sheet(sheet)
        self.board.show_marks(self._marks())
        self._show_rows()
        for name, value in (("projection", sheet.projection), ("unit", sheet.unit)):
            for action in self._choices[name].actions():
                action.setChecked(action.data() == value)

    def _was_solved(self, report: dict, _folder: str) -> None:
        self._report = report
        self.board.show_marks([*marks_of(report), *self._marks()])
        self._show_rows()

    def _marks(self) -> list[Mark]:
        """Places of problems; where outlines are open, of the ends that nothing meets."""
        sheet = self.sheet
        marks = [(own.box, own.message) for own in sheet.problems if own.box and own.pinned]
        if any(own.code == _OPEN for own in sheet.problems):
            text = translate("GaussianCAD", "Nothing meets this end")
            marks += [
                ((x - _PIN, y - _PIN, x + _PIN, y + _PIN), text)
                for view in sheet.views
                if view.shown
                for x, y in open_ends(sheet, view)
            ]
        return marks

    def _show_rows(self) -> None:
        """What the last run says; until there is one, what is in doubt of what was read."""
        sheet, report = self.sheet, self._report
        problems = sheet.problems if sheet is not None else ()
        if report is not None:
            offers = {code: self._buttons(code, (tool,)) for code, tool in _USUAL.items()}
            offers.update({own.code: self._help(own) for own in problems})
            offers.update(self._more_help)
            lines = verdict_lines(report, Help(self._tell_hole, offers, self._mend))
        else:
            lines = [
                Line(f"{SIGNS[own.severity]} {own.message}", own.box, self._help(own))
                for own in problems
            ]
        count = len(self.operations)
        if report is None and not count and any(own.severity == "refused" for own in problems):
            # What was read makes no part, and nothing was said yet: no run will tell it.
            lines.insert(0, verdict_line("failed"))
        lines += self._left_out
        if report is None:
            lines.append(Line(translate("GaussianCAD", "{0} correction(s) by hand").format(count)))
        self.problems.show_lines(lines)

    def _help(self, row: Row) -> Buttons:
        """Buttons for what may help with a problem."""
        return self._buttons(row.code, row.offers)

    def _buttons(self, code: str, offers: tuple[str, ...]) -> Buttons:
        """The tool of each correction that is offered."""
        take = self.board.take_tool
        known: dict[str, tuple[str, Callable[[], None]]] = {
            "view": (translate("GaussianCAD", "Box a View"), lambda: take("view")),
            "draw": (translate("GaussianCAD", "Draw a Line"), lambda: take("line")),
            "scale": (translate("GaussianCAD", "Tell a Length"), lambda: take("scale")),
            "section": (translate("GaussianCAD", "Set the Plane"), lambda: take("plane")),
            "projection": (translate("GaussianCAD", "Other Projection"), self._turn_projection),
        }
        close = translate("GaussianCAD", "Close Gaps"), self._close_gaps
        first = (close,) if code == _OPEN and self._closing() else ()
        return (*first, *(known[own] for own in offers if own in known))

    def _mend(self, own: dict) -> Buttons:
        """What may be said of a line that part and sheet do not share."""
        if not own["missing"]:
            if not own.get("line"):
                return ()
            view = next((view.id for view in self.sheet.views if view.role == own["view"]), "")
            told = {"view": view, "kind": own["kind"], "line": own["line"]}
            draw = translate("GaussianCAD", "It Belongs There")
            return ((draw, lambda: self.desk.say([{"op": "draw", **told}])),)
        stroke = self.sheet.stroke_at(tuple(own["at"]), _BESIDE) if self.sheet else None
        if stroke is None:
            return ()
        target = stroke.target()
        tangent = {"op": "kind", "target": target, "to": "tangent"}
        erase = {"op": "erase", "target": target}
        return (
            (translate("GaussianCAD", "Tangent Edge"), lambda: self.desk.say([tangent])),
            (translate("GaussianCAD", "Erase It"), lambda: self.desk.say([erase])),
        )

    def _closing(self) -> list[dict]:
        """What closes the outlines that are open."""
        sheet = self.sheet
        return [
            {"op": "draw", "view": view.id, "kind": "visible", "line": line}
            for view in sheet.views
            if view.shown and view.role in ROLES
            for line in closing_lines(sheet, view)
        ]

    def _close_gaps(self) -> None:
        self.desk.say(self._closing())

    def _turn_projection(self) -> None:
        other = {"first": "third", "third": "first"}[self.sheet.projection]
        self.desk.say([{"op": "projection", "value": other}])

    def _tell_hole(self, circle: tuple[float, float, float], through: bool) -> None:
        if through:
            self.board.tell_hole(circle, None)
        else:
            self._ask_depth(circle)

    def _show_work(self) -> None:
        if self.desk.reading:
            text = translate("GaussianCAD", "Reading\u2026")
        elif self.desk.solving:
            text = translate("GaussianCAD", "Making the part\u2026")
        else:
            text = translate("GaussianCAD", "Ready")
        self.statusBar().showMessage(text)

    def _show_stage(self, name: str) -> None:
        if self.busy:
            self.statusBar().showMessage(f"{stage_name(name)}\u2026")

    def _ask_role(self, box: tuple) -> None:
        menu = QtWidgets.QMenu(self)
        for number, role in enumerate((*ROLES, "pictorial", "ignore"), start=1):
            # A menu that pops up knows no shortcuts, but the keys of its letters.
            key = f"&{number}  " if number <= len(ROLES) else ""
            action = menu.addAction(f"{key}{name_of(role)}")
            action.triggered.connect(partial(self._take_role, role, box))
        menu.popup(QtGui.QCursor.pos())

    def _take_role(self, role: str, box: tuple, _checked: bool = False) -> None:
        self.say_view(role, box)

    def _ask_section(self, line: tuple, in_view: str) -> None:
        found = [own for own in self.sheet.sections if own.id != in_view]
        if len(found) == 1:
            self.say_section(found[0].id, line, in_view)
            return
        menu = QtWidgets.QMenu(self)
        for own in found:
            action = menu.addAction(name_of(own.role if own.role in ROLES else own.id))
            action.triggered.connect(partial(self._take_section, own.id, line, in_view))
        menu.popup(QtGui.QCursor.pos())

    def _take_section(self, view: str, line: tuple, in_view: str, _checked: bool = False) -> None:
        self.say_section(view, line, in_view)

    def _ask_length(self, points: tuple) -> None:
        asked = translate("GaussianCAD", "Length between the two points in mm:")
        length = self._number(translate("GaussianCAD", "Scale"), asked, 100.0)
        if length is not None:
            self.say_length(points, length)

    def _ask_value(self, number: Number) -> None:
        asked = translate("GaussianCAD", "What \u201c{0}\u201d gives, in mm:").format(number.text)
        value = self._number(translate("GaussianCAD", "Dimension"), asked, number.value)
        if value is not None:
            self.say_value(number, value)

    def _ask_depth(self, circle: tuple) -> None:
        asked = translate("GaussianCAD", "Depth of the hole in mm:")
        depth = self._number(translate("GaussianCAD", "Hole"), asked, 10.0)
        if depth is not None:
            self.board.tell_hole(circle, depth)

    def _number(self, title: str, asked: str, start: float) -> float | None:
        value, told = QtWidgets.QInputDialog.getDouble(self, title, asked, start, 0.001, 1e6, 3)
        return value if told else None

    def _trace(self, at: tuple) -> None:
        def done(shape: tuple[str, tuple] | None) -> None:
            if shape is None or not self.board.draw(shape, at):
                text = translate("GaussianCAD", "There is no line of a view at this place")
                self.statusBar().showMessage(text)

        self.desk.trace(at, done)

    def _set_live(self, live: bool) -> None:
        self.desk.live = live

    def _add_tools(self) -> None:
        bar = self.addToolBar("GaussianCAD")
        bar.setObjectName("GaussianCADCanvas")
        draw, kinds = QtWidgets.QMenu(self), QtWidgets.QMenu(self)
        self._add_menu(bar, translate("GaussianCAD", "Draw"), draw)
        for key, name in TOOLS.items():
            place = draw if name in DRAWING else bar
            text = f"{name_of(name)} ({key})" if place is bar else f"{name_of(name)}\t{key}"
            self._add(place, text, partial(self.board.take_tool, name))
        for key, kind in KEYS.items():
            self._add(kinds, f"{name_of(kind)}\t{key}", partial(self.board.give_kind, kind))
        self._add_menu(bar, translate("GaussianCAD", "Kind"), kinds)
        self._choices = {
            "projection": self._choice(
                bar,
                translate("GaussianCAD", "Projection"),
                (
                    ("first", translate("GaussianCAD", "First angle")),
                    ("third", translate("GaussianCAD", "Third angle")),
                ),
                lambda value: self.desk.say([{"op": "projection", "value": value}]),
            ),
            "unit": self._choice(
                bar,
                translate("GaussianCAD", "Unit"),
                (("mm", "mm"), ("in", translate("GaussianCAD", "inch"))),
                lambda value: self.desk.say([{"op": "unit", "value": value}]),
            ),
        }
        self._add_layers(bar)
        self.addToolBarBreak()
        bar = self._bar = self.addToolBar("GaussianCAD")
        bar.setObjectName("GaussianCADRuns")
        live = bar.addAction(translate("GaussianCAD", "Solve as I Go"))
        live.setCheckable(True)
        live.setChecked(True)
        live.toggled.connect(self._set_live)
        solve = self._add(bar, translate("GaussianCAD", "Solve"), self.solve)
        solve.setToolTip(translate("GaussianCAD", "Makes the part (Enter)"))
        if self.keeper.own_steps:
            # In FreeCAD these are keys of the document.
            keys = QtGui.QKeySequence.StandardKey
            undo = self._add(bar, translate("GaussianCAD", "Undo"), self.undo)
            undo.setShortcut(keys.Undo)
            redo = self._add(bar, translate("GaussianCAD", "Redo"), self.redo)
            redo.setShortcut(keys.Redo)

    def _add(self, bar: QtWidgets.QToolBar, text: str, called: Callable[[], None]) -> QtGui.QAction:
        action = bar.addAction(text)
        action.triggered.connect(lambda _=False: called())
        return action

    def _choice(
        self,
        bar: QtWidgets.QToolBar,
        title: str,
        values: tuple[tuple[str, str], ...],
        say: Callable[[str], None],
    ) -> QtWidgets.QMenu:
        """A button with a menu of values, of which one holds."""
        menu = QtWidgets.QMenu(title, self)
        for value, text in values:
            action = menu.addAction(text)
            action.setData(value)
            action.setCheckable(True)
            action.triggered.connect(lambda _=False, own=value: say(own))
        self._add_menu(bar, title, menu)
        return menu

    def _add_layers(self, bar: QtWidgets.QToolBar) -> None:
        menu = QtWidgets.QMenu(self)
        for name in LAYERS:
            action = menu.addAction(name_of(name))
            action.setCheckable(True)
            action.setChecked(True)
            action.toggled.connect(partial(self.board.set_layer, name))
        self._add_menu(bar, translate("GaussianCAD", "Show"), menu)

    def _add_menu(self, bar: QtWidgets.QToolBar, title: str, menu: QtWidgets.QMenu) -> None:
        button = QtWidgets.QToolButton()
        button.setText(title)
        button.setMenu(menu)
        button.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setFocusPolicy(QtCore.Qt.FocusPolicy.NoFocus)
        bar.addWidget(button)

"""Which buttons help with a row of the list, and what they do."""

from __future__ import annotations

from collections.abc import Callable

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.corrections import Circle
from freecad.gaussiancad.canvas.dialogs import Dialogs
from freecad.gaussiancad.canvas.gaps import OPEN, closing_lines
from freecad.gaussiancad.canvas.kinds import ROLES
from freecad.gaussiancad.canvas.session import Session
from freecad.gaussiancad.canvas.sheet import Row
from freecad.gaussiancad.canvas.verdict import Buttons, Help
from freecad.gaussiancad.language import translate

_BESIDE = 4.0
"""px within which a stroke runs at a place."""

_USUAL = {
    "scale-assumed": "scale",
    "full-scale-assumed": "scale",
    "paper-size-unknown": "scale",
    "projection-assumed": "projection",
    "told-lengths-disagree": "scale",
    "one-view:scale": "scale",
}
"""What helps with a warning that came up after the sheet was read."""


class RowActions:
    """What helps with what is said of a sheet.

    Args:
        session: where the sheet is, and what a button says is said.
        take_tool: gives the mouse a tool.
        dialogs: asks how deep holes are, and how thick the part is.
    """

    def __init__(
        self,
        session: Session,
        take_tool: Callable[[str], None],
        dialogs: Dialogs,
    ) -> None:
        self._session, self._take, self._dialogs = session, take_tool, dialogs
        self._more: dict[str, Buttons] = {}

    def add(self, code: str, text: str, called: Callable[[], None]) -> None:
        """Offer something else with what a report says under a code."""
        self._more[code] = ((text, called),)

    def with_row(self, row: Row) -> Buttons:
        """Buttons for what may help with a problem."""
        if not row.unseen_axis:
            return self._buttons(row.code, row.offers)
        text = translate("GaussianCAD", "How Thick Is the Part?")
        answer = text, lambda: self._dialogs.ask_thickness(row.unseen_axis)
        rest = tuple(offer for offer in row.offers if offer != "scale")
        return (answer, *self._buttons(row.code, rest))

    def with_report(self) -> Help:
        """Buttons for what a report says; its reasons may be problems of what was read."""
        offers = {code: self._buttons(code, (tool,)) for code, tool in _USUAL.items()}
        problems = self._session.sheet.problems if self._session.sheet is not None else ()
        offers.update({problem.code: self.with_row(problem) for problem in problems})
        offers.update(self._more)
        return Help(self._go_through, self._dialogs.ask_depths, offers, self._mend)

    def _buttons(self, code: str, offers: tuple[str, ...]) -> Buttons:
        """The tool of each correction that is offered."""
        take = self._take
        known: dict[str, tuple[str, Callable[[], None]]] = {
            "view": (translate("GaussianCAD", "Box a View"), lambda: take("view")),
            "draw": (translate("GaussianCAD", "Draw a Line"), lambda: take("line")),
            "scale": (translate("GaussianCAD", "Tell a Length"), lambda: take("scale")),
            "section": (translate("GaussianCAD", "Set the Plane"), lambda: take("plane")),
            "projection": (translate("GaussianCAD", "Other Projection"), self._turn_projection),
        }
        close = translate("GaussianCAD", "Close Gaps"), self._close_gaps
        first = (close,) if code == OPEN and self._closing() else ()
        return (*first, *(known[offer] for offer in offers if offer in known))

    def _mend(self, item: dict) -> Buttons:
        """What may be said of a line that part and sheet do not share."""
        correct, sheet = self._session.correct, self._session.sheet
        if not item["missing"]:
            if not item.get("line"):
                return ()
            view = next((view.id for view in sheet.views if view.role == item["view"]), "")
            draw = corrections.draw_stroke(view, item["kind"], ("line", item["line"]))
            return ((translate("GaussianCAD", "It Belongs There"), lambda: correct(draw)),)
        stroke = sheet.stroke_at(tuple(item["at"]), _BESIDE) if sheet is not None else None
        if stroke is None:
            return ()
        tangent, erase = (
            corrections.set_kind([stroke], "tangent"),
            corrections.erase_strokes([stroke]),
        )
        return (
            (translate("GaussianCAD", "Tangent Edge"), lambda: correct(tangent)),
            (translate("GaussianCAD", "Erase It"), lambda: correct(erase)),
        )

    def _closing(self) -> list[dict]:
        """What closes the outlines that are open."""
        sheet = self._session.sheet
        return [
            operation
            for view in sheet.views
            if view.shown and view.role in ROLES
            for line in closing_lines(sheet, view)
            for operation in corrections.draw_stroke(view.id, "visible", ("line", line))
        ]

    def _close_gaps(self) -> None:
        self._session.correct(self._closing())

    def _turn_projection(self) -> None:
        other = {"first": "third", "third": "first"}[self._session.sheet.projection]
        self._session.correct(corrections.set_option("projection", other))

    def _go_through(self, circles: list[Circle]) -> None:
        self._session.correct(
            [stated for circle in circles for stated in corrections.set_hole(circle, None)]
        )

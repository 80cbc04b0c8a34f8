"""What the report says of sections: where they cut, and how the solid's cut agrees with them."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from gaussiancad_core.evidence.projected_reading import Reading
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import Cut, SectionRole
from gaussiancad_core.report.run_report import Assumption, PlaneReport, SectionReport
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.special_views.adjacent_sections import overlap
from gaussiancad_core.writing.section_titles import NamedSection

if TYPE_CHECKING:
    from gaussiancad_core.solid.verify import Verification


def section_reports(
    reading: Reading, named: Sequence[NamedSection], turn: Turn
) -> tuple[SectionReport, ...]:
    """The sections that are used, in the order of :func:`cuts_in`, and then the others.

    Args:
        reading: the views with their cuts.
        named: sections that the sheet names.
        turn: of the sheet.
    """
    found, used = [], []
    boxes = {view.role: view.box for view in reading.registered.drawn}
    for role, cut in cuts_in(reading):
        box = boxes[role] if isinstance(role, Role) else reading.beside[role].box
        title = next((own for own in named if overlap(own.box, box)), None)
        used.append(title)
        label = title.title.label if title is not None else ""
        own = SectionReport(label, _direction(role), turn.box_to_stored(box), _plane(role, cut))
        found.append(own)
    rest = [own for own in named if not any(own is each for each in used)]
    found += [
        SectionReport(
            own.title.label,
            own.looks.value if own.looks is not None else "",
            turn.box_to_stored(own.box),
        )
        for own in rest
    ]
    return tuple(found)


def cuts_in(reading: Reading) -> Iterator[tuple[Role | SectionRole, Cut]]:
    """Views that are cut, and sections beside plain views."""
    yield from reading.cuts.items()
    yield from ((role, own.cut) for role, own in reading.beside.items())


def with_agreement(
    sections: Sequence[SectionReport], reading: Reading, verification: "Verification"
) -> tuple[SectionReport, ...]:
    """The same with how the lines and areas of the solid's cuts agree."""
    found = list(sections)
    for number, (role, _) in enumerate(cuts_in(reading)):
        agreement = verification.matched[role].agreement
        area = verification.areas.get(role)
        found[number] = replace(
            found[number],
            line_recall=agreement.visible_recall,
            line_precision=agreement.visible_precision,
            area_agreement=None if area is None else round(area, 4),
        )
    return tuple(found)


def assumed_planes(sections: Sequence[SectionReport]) -> tuple[Assumption, ...]:
    """Sections without a cutting line: where they cut was assumed."""
    return tuple(
        Assumption(
            "section-through-middle",
            Message(
                "the {view} section {label} was taken to cut through the middle of the part, as "
                "nothing tells where",
                view=own.role,
                label=own.label or "without a title",
                **({} if own.label else {"case": "untitled"}),
            ),
            own.box,
            "it cuts elsewhere: draw its cutting line",
        )
        for own in sections
        if own.plane is not None and own.plane.source == "symmetry"
    )


def _direction(role: Role | SectionRole) -> str:
    return role.value if isinstance(role, Role) else role.role.value


def _plane(role: Role | SectionRole, cut: Cut) -> PlaneReport | None:
    """The plane; nothing where the cut has several."""
    if len(cut.openings) != 1:
        return None
    (own,) = cut.openings
    return PlaneReport(role.frame.look_axis[0].name.lower(), round(own.at, 4), own.source)

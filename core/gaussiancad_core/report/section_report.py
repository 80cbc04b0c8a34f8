"""What the report says of sections: where they cut, and how the solid's cut agrees with them."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, cast

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import Cut, SectionRole
from gaussiancad_core.report.report_entries import Assumption, PlaneReport, SectionReport
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.special_views.adjacent_sections import overlap
from gaussiancad_core.writing.section_titles import NamedSection
from gaussiancad_protocol.codes import Code

if TYPE_CHECKING:
    from gaussiancad_core.solid.verify import Verification


def section_reports(
    reading: ProjectedReading, named: Sequence[NamedSection], turn: Turn
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
        box = boxes[role] if isinstance(role, Role) else reading.adjacent_sections[role].box
        title = next((section for section in named if overlap(section.box, box)), None)
        used.append(title)
        label = title.title.label if title is not None else ""
        report = SectionReport(label, _direction(role), turn.box_to_stored(box), _plane(role, cut))
        found.append(report)
    rest = [section for section in named if not any(section is each for each in used)]
    found += [
        SectionReport(
            section.title.label,
            section.looks.value if section.looks is not None else "",
            turn.box_to_stored(section.box),
        )
        for section in rest
    ]
    return tuple(found)


def cuts_in(reading: ProjectedReading) -> Iterator[tuple[Role | SectionRole, Cut]]:
    """Views that are cut, and sections beside plain views."""
    yield from reading.cuts.items()
    yield from (
        (role, adjacent_section.cut) for role, adjacent_section in reading.adjacent_sections.items()
    )


def with_agreement(
    sections: Sequence[SectionReport], reading: ProjectedReading, verification: "Verification"
) -> tuple[SectionReport, ...]:
    """The same with how the lines and areas of the solid's cuts agree."""
    found = list(sections)
    for number, (role, _) in enumerate(cuts_in(reading)):
        # Sections beside plain views stand among the views by roles of their own kind.
        agreement = verification.matched[cast(Role, role)].agreement
        area = verification.areas.get(cast(Role, role))
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
            Code.SECTION_THROUGH_MIDDLE,
            Message(
                "the {view} section {label} was taken to cut through the middle of the part, as "
                "nothing tells where",
                boxes=(),
                view=section.role,
                label=section.label or "without a title",
                **({} if section.label else {"case": "untitled"}),
            ),
            section.box,
            "it cuts elsewhere: draw its cutting line",
        )
        for section in sections
        if section.plane is not None and section.plane.source == "symmetry"
    )


def _direction(role: Role | SectionRole) -> str:
    return role.value if isinstance(role, Role) else role.role.value


def _plane(role: Role | SectionRole, cut: Cut) -> PlaneReport | None:
    """The plane; nothing where the cut has several."""
    if len(cut.openings) != 1:
        return None
    (opening,) = cut.openings
    return PlaneReport(role.frame.look_axis[0].name.lower(), round(opening.at, 4), opening.source)

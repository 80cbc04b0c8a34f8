"""Other drawings are named, and the principal views are those of the part."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.sheet_stages import read_views
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind

Kind = SpecialKind

ROLES = {Role.FRONT, Role.TOP, Role.RIGHT}


def _is_near(box: tuple, expected: tuple, px: float) -> bool:
    return bool(np.abs(np.array(box) - np.array(expected)).max() <= px)


def _all_views(found, roles: set[Role] = ROLES) -> bool:  # noqa: ANN001
    """Whether the views are where they were drawn; a turned sheet makes boxes larger."""
    assert set(found.layout.boxes) == roles
    slack = 6.0 + (45.0 if found.clean.turn.angle else 0.0)
    return all(
        _is_near(found.stored(box), found.drawn[role].box, slack)
        for role, box in found.layout.boxes.items()
    )


@pytest.mark.parametrize(
    ("part", "defects"),
    [
        ("l-bracket", "clean"),
        ("l-bracket", "photocopy"),
        ("wedge-block", "scan"),
        ("stepped-shaft", "clean"),
        ("cross-bored-pin", "scan"),
    ],
)
def test_a_pictorial_is_left_out(
    find,  # noqa: ANN001
    part: str,
    defects: str,
) -> None:
    found = find(part, f"{defects},picture=on")
    assert _all_views(found)
    (special,) = found.layout.special
    (drawn,) = [m for m in found.drawn.annotations if m.kind is AnnotationKind.PICTURE]
    assert (special.kind, special.used) == (Kind.PICTORIAL, False)
    assert _is_near(found.stored(special.box), drawn.box, 10.0 if defects != "photocopy" else 45.0)
    assert found.layout.left_out == ()


@pytest.mark.parametrize(
    ("part", "inset", "defects"),
    [
        ("l-bracket", Kind.DETAIL, "scan"),
        ("l-bracket", Kind.DETAIL, "dimensioned"),
        ("counterbored-block", Kind.AUXILIARY, "clean"),
        ("counterbored-block", Kind.AUXILIARY, "photocopy"),
        ("l-bracket", Kind.OTHER_PART, "photocopy"),
        ("l-bracket", Kind.OTHER_PART, "dimensioned"),
    ],
)
def test_what_stands_beside_the_views_is_left_out(
    find,  # noqa: ANN001
    part: str,
    inset: SpecialKind,
    defects: str,
) -> None:
    found = find(part, f"{defects},inset={inset.value},text-height=14")
    marks = [m for m in found.drawn.annotations if m.kind.value == inset.value]
    assert marks
    assert _all_views(found)
    (special,) = found.layout.special
    assert (special.kind, special.used) == (inset, False)
    x0, y0 = np.min([mark.box[:2] for mark in marks], axis=0)
    x1, y1 = np.max([mark.box[2:] for mark in marks], axis=0)
    slack = 45.0 if defects == "photocopy" else 8.0
    assert _is_near(found.stored(special.box), (x0, y0, x1, y1), slack)


@pytest.mark.parametrize(
    ("style", "kind", "roles"),
    [
        # In a direction that no other view has, and one that is needed.
        ("scan,section=right", Kind.SECTION, "right,front,top"),
        ("photocopy,section=front", Kind.SECTION, "front,top,right"),
        ("clean,section=front", Kind.SECTION, "front,top,right"),
        ("clean,section=front,section-kind=half", Kind.HALF_SECTION, "front,top,right"),
        ("photocopy,section=front,section-kind=half", Kind.HALF_SECTION, "front,top,right"),
        ("scan,section=front,section-kind=broken-out", Kind.PARTIAL_SECTION, "front,top,right"),
    ],
)
def test_what_is_cut_stands_for_its_view(
    find,  # noqa: ANN001
    style: str,
    kind: SpecialKind,
    roles: str,
) -> None:
    found = find("counterbored-block", style, roles)
    assert _all_views(found)
    (special,) = found.layout.special
    assert (special.kind, special.used) == (kind, True)
    if kind is Kind.SECTION:
        assert special.box == found.layout.boxes[Role(roles.split(",", maxsplit=1)[0])]


@pytest.mark.parametrize(
    ("roles", "projection"),
    [
        ("front,top,right,left", "third"),
        ("front,top,right,rear", "first"),
        ("front,bottom,left,right,rear", "third"),
        ("front,top,bottom,left,right,rear", "first"),
    ],
)
def test_four_five_and_six_views_are_all_used(
    find,  # noqa: ANN001
    roles: str,
    projection: str,
) -> None:
    found = find("l-bracket", "clean,view-gap=40,margin=30", roles, projection)
    assert _all_views(found, {Role(role) for role in roles.split(",")})
    assert found.layout.special == ()
    assert found.layout.left_out == ()


@pytest.mark.parametrize(
    ("part", "style"),
    [
        ("rib-bracket", "clean"),
        ("rib-bracket", "photocopy"),
        ("slotted-link", "scan"),
        ("slotted-link", "even,annotation-width=2"),
    ],
)
def test_the_halves_of_a_broken_view_are_one_view(
    find,  # noqa: ANN001
    part: str,
    style: str,
) -> None:
    found = find(part, f"{style},broken=front,margin=60,view-gap=60")
    assert _all_views(found)
    (special,) = found.layout.special
    assert (special.kind, special.used) == (Kind.BROKEN, True)
    assert special.box == found.layout.boxes[Role.FRONT]


def test_the_outline_of_a_broken_view_is_closed(find) -> None:  # noqa: ANN001
    """Its break lines are as narrow as dimensions, and stay all the same."""
    found = find("rib-bracket", "clean,broken=front,margin=60,view-gap=60")
    front = next(
        view for view in read_views(found.separated.part, found.layout) if view.role is Role.FRONT
    )
    (x0, _, x1, _), area = front.box, front.outline.mask.sum()
    whole = find("rib-bracket", "clean,margin=60,view-gap=60")
    plain = next(
        view for view in read_views(whole.separated.part, whole.layout) if view.role is Role.FRONT
    )
    assert (x0, x1) == pytest.approx((plain.box[0], plain.box[2]), abs=0.5)
    assert 0.8 < area / plain.outline.mask.sum() < 0.97

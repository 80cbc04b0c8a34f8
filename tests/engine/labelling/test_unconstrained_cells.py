"""Labels of cells that the lines say nothing about."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from gaussiancad_core.cells.cell_complex import Cell, Surface
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling.cell_labelling import Effort, Search
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.labelling.unconstrained_cells import with_unconstrained
from gaussiancad_core.labelling.visibility_rules import Group, Rule
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_FACE, _OTHER = (0, 1), (0, 2)

_SLIM = 0.15


def _cell(number: int) -> Cell:
    return number, 0, 0, 0


@dataclass(frozen=True)
class _Columns:
    """Columns of the cells 1 to 3: one surface lies on both sides of the second cell each."""

    thin: float = 1.0

    def crossed(self) -> Iterator[tuple[Cell, Cell, Surface]]:
        for place in range(3):
            # Elsewhere the face is one of the part's, and the other surface is none.
            one, other = _cell(10 + place), _cell(20 + place)
            yield one, other, _FACE
            yield one, _cell(30 + place), _OTHER
        yield _cell(1), _cell(2), _FACE
        yield _cell(2), _cell(3), _OTHER

    def thickness(self) -> dict[Cell, float]:
        return {_cell(2): self.thin}


def _labels(void: bool) -> dict[Cell, bool]:
    """Material on the side of the face that is ``void`` or not, elsewhere as here."""
    found = {_cell(1): not void, _cell(3): void}
    for place in range(3):
        found[_cell(10 + place)] = found[_cell(30 + place)] = True
        found[_cell(20 + place)] = False
    return found


@pytest.mark.parametrize("void", [True, False])
def test_a_face_goes_on_and_what_is_none_does_not(void: bool) -> None:
    assert with_unconstrained(_Columns(), (), _labels(void), _SLIM)[_cell(2)] is void


@pytest.mark.parametrize("thin", [0.01, 1.0])
def test_slim_cells_change_where_no_rule_minds(thin: float) -> None:
    labels = {**_labels(True), _cell(2): False}
    assert with_unconstrained(_Columns(thin), (), labels, _SLIM)[_cell(2)] is (thin < 0.1)


@pytest.mark.parametrize("linetype", [Linetype.VISIBLE, None])
def test_no_rule_that_holds_is_broken(linetype: Linetype | None) -> None:
    # A line at the face says that it is one; a blank piece at the other surface that it is none.
    face, other = (_cell(1), _cell(2)), (_cell(2), _cell(3))
    rule = Rule((Group((), (face,), (face,)),), linetype, 1.0, Role.FRONT, (0.0, 0.0))
    labels = {**_labels(True), _cell(2): False}
    held = linetype is None
    assert with_unconstrained(_Columns(0.01), (rule,), labels, _SLIM)[_cell(2)] is not held
    rule = Rule((Group((), (other,), (other,)),), linetype, 1.0, Role.FRONT, (0.0, 0.0))
    assert with_unconstrained(_Columns(0.01), (rule,), labels, _SLIM)[_cell(2)] is held


def test_any_label_of_a_part_follows_from_the_others(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    part = model_part(sample_views("three-axis-block"))
    labels = Search(part.rules, Effort()).best().labels
    assert labels is not None
    assert with_unconstrained(part.space, part.rules, labels, _SLIM) == labels
    for cell in labels:
        others = {other: label for other, label in labels.items() if other != cell}
        assert with_unconstrained(part.space, part.rules, others, _SLIM) == labels

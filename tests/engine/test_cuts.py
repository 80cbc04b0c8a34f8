"""Names of sections in what a person reads."""

from gaussiancad_core.axes import Role
from gaussiancad_core.cuts import SectionRole
from gaussiancad_core.messages import Message


def test_a_section_has_its_name_in_sentences() -> None:
    made = Message("a line that the {view} view has", view=SectionRole(Role.TOP, "\u0410"))
    assert made == "a line that the top \u0410-\u0410 view has"
    assert made.args == {"view": "top \u0410-\u0410"}

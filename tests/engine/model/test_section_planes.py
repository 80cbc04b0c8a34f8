"""Names of sections in what a person reads."""

from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionRole


def test_a_section_has_its_name_in_sentences() -> None:
    made = Message("a line that the {view} view has", view=SectionRole(Role.TOP, "\u0410"))
    assert made == "a line that the top \u0410-\u0410 view has"
    assert made.args == {"view": "top \u0410-\u0410"}

"""The tools that an agent is offered, in its own words."""

from collections.abc import Mapping
from dataclasses import dataclass

from mcp import types
from msgspec import Struct

from gaussiancad.agent.tool_arguments import (
    CheckArguments,
    CompareArguments,
    CorrectArguments,
    ExplainArguments,
    FeaturesArguments,
    FilesArguments,
    LookArguments,
    ReadArguments,
    ReconstructArguments,
)
from gaussiancad.agent.tool_schemas import input_schema

INSTRUCTIONS = (
    "GaussianCAD turns engineering drawings into exact solids. Read a sheet, look at the picture "
    "of what was read and at its problems, correct what is wrong, and reconstruct the part until "
    "its status is `verified` or its reasons say why not. Places are px of the sheet as stored, y "
    "down. Lengths are mm. Files lie in one folder and are named relative to it. In pictures of a "
    "reading visible edges are blue, hidden ones pink, centre lines orange, dimensions green, "
    "tangent edges light blue, threads violet."
)


@dataclass(frozen=True)
class AgentTool:
    """A tool.

    Attributes:
        name: by which it is called; also that of the method that does it.
        title: for a person.
        words: for an agent: what it does and gives.
        arguments: that it takes.
        runs_engine: whether it starts a run, of which few go on at once.
        writes: whether it writes files.
    """

    name: str
    title: str
    words: str
    arguments: type[Struct]
    runs_engine: bool = False
    writes: bool = False

    def described(self) -> types.Tool:
        """As the protocol lists it."""
        return types.Tool(
            name=self.name,
            title=self.title,
            description=self.words,
            input_schema=input_schema(self.arguments),
            annotations=types.ToolAnnotations(
                read_only_hint=not self.writes,
                destructive_hint=False,
                open_world_hint=False,
            ),
        )


_TOOLS = (
    AgentTool(
        "files",
        "List drawings",
        "List the drawings and the models (STEP, BREP, STL, PLY, OBJ) of the server's folder.",
        FilesArguments,
    ),
    AgentTool(
        "read",
        "Read a drawing",
        "Read a drawing: its views, strokes, dimensions, notes, sections, scale, projection, and "
        "what is in doubt. Gives a reading_id, a summary, the files that were written "
        "(reading.json has all of it) and the picture of the reading. Each problem has `offers`: "
        "operations for `correct` that may help; words in capitals are to be filled in.",
        ReadArguments,
        runs_engine=True,
        writes=True,
    ),
    AgentTool(
        "look",
        "Look at strokes",
        "List strokes of a view or in a box, page by page, with their ids, kinds, shapes, how sure "
        "the kind is (`confidence`, 0 to 1) and what it would be `otherwise`; and show that part "
        "of the sheet enlarged, with the ids.",
        LookArguments,
    ),
    AgentTool(
        "correct",
        "Correct a reading",
        "Say what is wrong in a reading, as a list of operations. Gives a new reading_id, summary "
        "and picture. The earlier reading stays: use its id to undo. What found no stroke or place "
        "is the problem `corrections-unmatched`.",
        CorrectArguments,
        runs_engine=True,
        writes=True,
    ),
    AgentTool(
        "reconstruct",
        "Reconstruct the part",
        "Make the part of a sheet or of a reading. Gives its status (`verified`: the shape is the "
        "only one that has these lines; `approximate` and `failed` with reasons), the solid's "
        "measures, places where its lines and the sheet's differ, the files (solid.step), and two "
        "pictures: its lines over the sheet, and the part, shaded. Takes seconds to minutes.",
        ReconstructArguments,
        runs_engine=True,
        writes=True,
    ),
    AgentTool(
        "explain",
        "Explain a result",
        "Say in sentences what was read and why, what was tried, and why a part is not verified: "
        "in all, of a view, or at a place.",
        ExplainArguments,
    ),
    AgentTool(
        "check",
        "Check a model against its drawing",
        "Tell whether a model agrees with its drawing: `agrees`, `differs` or `cannot-tell`, with "
        "reasons, the places where lines differ, the notes that it does not keep, and single "
        "changes of the model that explain the drawing better. The model may lie in any position.",
        CheckArguments,
        runs_engine=True,
        writes=True,
    ),
    AgentTool(
        "features",
        "Find features",
        "Find the sketches, pads, pockets and holes that make up a solid: features.json, and "
        "features.py, a build123d script with its numbers at the top.",
        FeaturesArguments,
        runs_engine=True,
        writes=True,
    ),
    AgentTool(
        "compare",
        "Compare two models",
        "Measure a part against a reference: volume IoU, chamfer and Hausdorff distances in a "
        "normalised box after registration, deviation in mm.",
        CompareArguments,
        runs_engine=True,
    ),
)

TOOLS: Mapping[str, AgentTool] = {tool.name: tool for tool in _TOOLS}
"""By their names."""

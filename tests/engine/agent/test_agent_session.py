"""A whole session of an agent: the client of the SDK and a server in a process of its own."""

import asyncio
import base64
import json
import shutil
import sys
from collections.abc import Awaitable, Callable
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from mcp.client.client import Client
from mcp.client.stdio import StdioServerParameters, stdio_client
from mcp.types import CallToolResult, ImageContent, TextContent
from PIL import Image

CHECKOUT = Path(__file__).resolve().parents[3]

ANSWER_BYTES = 6000
"""Of text that an answer on a small sheet has at most."""

Call = Callable[..., Awaitable[tuple[Any, list[Image.Image]]]]


def opened(result: CallToolResult) -> tuple[Any, list[Image.Image]]:
    """The values of an answer, or its text, and its pictures."""
    text, *pictures = result.content
    assert isinstance(text, TextContent)
    assert len(text.text.encode()) < ANSWER_BYTES
    shown = []
    for picture in pictures:
        assert isinstance(picture, ImageContent)
        image = Image.open(BytesIO(base64.b64decode(picture.data)))
        image.load()
        assert f"image/{str(image.format).lower()}" == picture.mime_type
        assert max(image.size) <= 1600
        shown.append(image)
    values = json.loads(text.text) if text.text.startswith("{") else text.text
    return values, shown


@pytest.fixture
def folder(tmp_path: Path, plain_picture: Path, plain_step: Path) -> Path:
    """A folder with a drawing, its part, and a drawing next to it that is nobody's."""
    work = tmp_path / "work"
    work.mkdir()
    shutil.copy(plain_picture, work)
    shutil.copy(plain_step, work)
    shutil.copy(plain_picture, tmp_path / "secret.png")
    (work / "link.png").symlink_to(tmp_path / "secret.png")
    return work


def test_an_agent_reads_corrects_reconstructs_and_compares(folder: Path) -> None:
    asyncio.run(_play(folder))
    # Nothing was written beside what the answers named.
    assert {path.name for path in folder.iterdir()} == {
        "block.png",
        "block.step",
        "link.png",
        "gaussiancad-mcp",
        "model",
    }
    assert {path.name for path in folder.parent.iterdir()} == {"work", "secret.png"}


async def _play(folder: Path) -> None:
    server = StdioServerParameters(
        command=sys.executable,
        args=["-m", "gaussiancad_core", "mcp", "--folder", str(folder)],
        env={"PYTHONPATH": str(CHECKOUT / "core")},
    )
    heard: list[str | None] = []

    async def progress(_done: float, _total: float | None, message: str | None) -> None:
        heard.append(message)

    async with Client(stdio_client(server)) as client:
        listed = (await client.list_tools()).tools
        assert [tool.name for tool in listed] == [
            *("files", "read", "look", "correct", "reconstruct", "explain"),
            *("check", "features", "compare"),
        ]
        assert all(tool.description and tool.input_schema["type"] == "object" for tool in listed)

        async def call(name: str, **arguments: object) -> tuple[Any, list[Image.Image]]:
            result = await client.call_tool(name, arguments, progress_callback=progress)
            assert not result.is_error, result.content
            return opened(result)

        async def refused(name: str, code: str, **arguments: object) -> str:
            result = await client.call_tool(name, arguments)
            assert result.is_error
            error = opened(result)[0]["error"]
            assert error["code"] == code
            assert "Traceback" not in error["message"]
            return str(error["message"])

        first = await _reads(call, folder)
        assert any(message and message.startswith("read") for message in heard)
        last = await _corrects(call, first)
        part = await _reconstructs(call, last)
        await _explains(call, part, last)
        checked, (picture,) = await call("check", sheet="block.png", solid=part)
        assert (checked["verdict"], checked["reasons"]) == ("agrees", [])
        assert picture.width > picture.height
        features, _ = await call("features", solid=part)
        assert features["solids"][0]["whole"]
        figures, _ = await call("compare", result=part, reference="block.step", points=1000)
        assert figures["volume_iou"] > 0.999
        assert figures["deviation_mm"]["greatest"] < 0.01
        await _is_refused(refused, folder, first)
        values, _ = await call("files")
        assert values["drawings"] == ["block.png"]
        assert values["models"] == ["block.step", "model/solid.step"]


async def _reads(call: Call, folder: Path) -> str:
    values, (picture,) = await call("read", sheet="block.png")
    assert {view["role"] for view in values["views"]} == {"front", "top", "right"}
    assert values["views"][0]["strokes"] == {"visible": 6, "hidden": 2}
    assert values["size_px"] == [520, 480]
    assert picture.size == (312, 288)
    # Visible lines are blue.
    assert (20, 90, 200) in {colour for _, colour in picture.convert("RGB").getcolors(1 << 22)}
    (problem,) = values["problems"]
    assert problem["code"] == "scale-assumed"
    assert problem["offers"] == [{"op": "scale", "axis": "x", "length_mm": "MM"}]
    assert all((folder / name).is_file() for name in values["files"])
    listed, (part,) = await call("look", reading_id=values["reading_id"], view="front", limit=3)
    assert (listed["count"], len(listed["strokes"]), listed["next_offset"]) == (8, 3, 3)
    assert listed["strokes"][0]["id"] == "s1"
    assert max(part.size) == 1272
    box = [125, 360, 145, 380]
    near, _ = await call("look", reading_id=values["reading_id"], box=box, kinds=["visible"])
    # Around the corner within.
    assert len(near["strokes"]) == 2
    return str(values["reading_id"])


async def _corrects(call: Call, first: str) -> str:
    scale = {"op": "scale", "axis": "x", "length_mm": 60}
    wrong = {"op": "kind", "target": {"id": "s2"}, "to": "hidden"}
    values, (picture,) = await call("correct", reading_id=first, operations=[scale, wrong])
    assert values["views"][0]["strokes"] == {"visible": 5, "hidden": 3}
    assert (values["earlier_reading_id"], values["corrections"]) == (first, 2)
    gap = next(entry for entry in values["problems"] if entry["code"] == "open-outline")
    assert gap["severity"] == "doubt"
    assert gap["offers"][0]["view"] == "front"
    assert picture.size == (312, 288)
    back = {"op": "kind", "target": {"id": "s2"}, "to": "visible"}
    # Some clients send lists as text.
    values, pictures = await call(
        "correct", reading_id=values["reading_id"], operations=json.dumps([back]), picture=False
    )
    assert values["views"][0]["strokes"] == {"visible": 6, "hidden": 2}
    assert values["scale"] == {"source": "given", "axis": "x", "length_mm": 60.0}
    assert not pictures
    return str(values["reading_id"])


async def _reconstructs(call: Call, reading: str) -> str:
    values, (overlay, preview) = await call("reconstruct", reading_id=reading, output="model")
    assert values["status"] == "verified"
    assert values["solid"]["bounding_box_mm"] == pytest.approx([60.0, 30.0, 45.0], abs=0.05)
    assert [entry["code"] for entry in values["warnings"]] == ["corrected"]
    assert "model/solid.step" in values["files"]
    assert (max(overlay.size), max(preview.size)) == (577, 1000)
    return str(values["result_id"])


async def _explains(call: Call, part: str, reading: str) -> None:
    assert (await call("explain", id=part))[0].startswith("Shape verified.")
    at_edge, _ = await call("explain", id=part, at=[160, 420])
    assert at_edge.startswith("A visible line of 200 px of the front view")
    of_view, _ = await call("explain", id=reading, view="top")
    assert "6 visible" in of_view


async def _is_refused(refused: Callable[..., Awaitable[str]], folder: Path, first: str) -> None:
    for sheet in ("../secret.png", str(folder.parent / "secret.png"), "link.png"):
        await refused("read", "outside-folder", sheet=sheet)
    await refused("read", "outside-folder", sheet="block.png", output="../elsewhere")
    await refused("read", "wrong-usage", sheet="block.png", output=".")
    await refused("read", "file-missing", sheet="nothing.png")
    await refused("read", "wrong-usage")
    await refused("read", "wrong-usage", sheet="block.png", page="first")
    await refused("read", "wrong-usage", sheet="block.png", views={"front": [9, 9, 1, 1]})
    await refused("read", "path-not-usable", sheet="a\0b.png")
    await refused("look", "unknown-id", reading_id="block-reading-99")
    await refused("look", "wrong-usage", reading_id=first, box=[9e5, 9e5, 9e5, 9e5])
    await refused("look", "unknown-view", reading_id=first, view="inside")
    erase = {"op": "erase", "target": {"id": "s999"}}
    assert "s999" in await refused("correct", "unknown-id", reading_id=first, operations=[erase])
    for operation in ({"op": "explode"}, {"op": "scale", "length_mm": -1}, "scale", None):
        await refused("correct", "wrong-usage", reading_id=first, operations=[operation])
    await refused("correct", "wrong-usage", reading_id=first, operations=[])
    await refused("reconstruct", "wrong-usage")
    await refused("reconstruct", "wrong-usage", reading_id=first, length={"x": 60})
    await refused("explain", "wrong-usage", id=first, at=[1, 2], view="front")
    await refused("compare", "outside-folder", result="model", reference="/etc/hostname")
    await refused("explode", "unknown-request")

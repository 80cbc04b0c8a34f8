"""The page of a comparison: what it holds, and what a browser makes of it."""

import base64
import importlib.util
import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import cv2
import numpy as np
import pytest
import trimesh
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox

from gaussiancad_core.comparison.compare_command import compare_files
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_page import overlay_of_result
from gaussiancad_core.comparison.deviation import measure_deviation
from gaussiancad_core.comparison.page_geometry import MOST_TRIANGLES, page_geometry
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

_SPEC = importlib.util.spec_from_file_location("browser", Path(__file__).parent / "browser.py")
browser = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(browser)

NAME = "Träger <b>& 支架.stl"


class _Elements(HTMLParser):
    """All elements of a page, and the open ones at its end."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        if tag not in ("meta", "img", "input", "rect", "line", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in ("rect", "line"):
            assert self.open.pop() == tag


@pytest.fixture(scope="module")
def page(bracket: TriangleMesh, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a bracket against its bounding box, with a sheet beside the bracket."""
    folder = tmp_path_factory.mktemp("compared ä")
    bracket.to_trimesh().export(folder / "part.stl")
    (folder / "part.stl").rename(folder / NAME)
    write_step(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape(), folder / "box.step")
    cv2.imwrite(str(folder / "overlay.png"), np.full((60, 90, 3), 200, dtype=np.uint8))
    options = CompareOptions(points=1000, protocols=tuple(Protocol))
    compare_files(folder / NAME, folder / "box.step", folder / "out", options)
    return folder / "out" / "comparison.html"


def test_the_page_is_whole_and_needs_nothing_else(page: Path) -> None:
    text = page.read_text("utf-8")
    elements = _Elements()
    elements.feed(text)
    assert elements.open == []
    for tag, attributes in elements.found:
        for name in ("src", "href", "xlink:href", "action", "data"):
            value = attributes.get(name) or ""
            assert not value or value.startswith("data:image/"), (tag, name)
    policy = next(a for _, a in elements.found if a.get("http-equiv") == "Content-Security-Policy")
    assert "default-src 'none'" in policy["content"]
    ids = [attributes["id"] for _, attributes in elements.found if "id" in attributes]
    assert len(ids) == len(set(ids))
    assert not re.search(r"https?://|@import|url\(", text)


def test_names_are_text_and_not_markup(page: Path) -> None:
    text = page.read_text("utf-8")
    assert "Träger &lt;b&gt;&amp; 支架.stl against box.step" in text
    assert "<b>&" not in text


def test_the_numbers_can_be_read_without_a_script(page: Path) -> None:
    report = json.loads((page.parent / "comparison.json").read_text("utf-8"))
    text = page.read_text("utf-8")
    assert f"{report['chamfer']:.5f}" in text
    assert f"{report['protocols']['deepcad']['chamfer_x1000']:.5f}" in text
    assert f"{100 * report['protocols']['engineering']['agreement']:.2f} %" in text
    # The whole upper part of the box is missing: it is told, with its place.
    worst = report["deviation"]["worst"][0]
    place = ", ".join(f"{value:.4g}" for value in worst["point_mm"])
    assert f"({place}) mm" in text
    assert text.count("data-point=") == len(report["deviation"]["worst"])
    assert text.count("data-middle=") == 40


def test_the_sheet_beside_the_result_is_shown(page: Path) -> None:
    assert "with its redrawn lines over it" in page.read_text("utf-8")


def test_what_is_no_picture_is_not_shown(tmp_path: Path) -> None:
    assert overlay_of_result(tmp_path / "part.stl") is None
    (tmp_path / "overlay.png").write_bytes(b"\x89PNG broken")
    assert overlay_of_result(tmp_path / "part.stl") is None


def test_a_large_sheet_is_made_smaller(tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "overlay.png"), np.full((1000, 4000, 3), 255, dtype=np.uint8))
    kind, content = overlay_of_result(tmp_path / "part.stl")
    assert kind == "image/jpeg"
    assert cv2.imdecode(np.frombuffer(content, np.uint8), 1).shape == (450, 1800, 3)


def test_large_models_are_thinned_but_their_numbers_are_not() -> None:
    ball = trimesh.creation.icosphere(subdivisions=6, radius=2.5)
    mesh = make_mesh(ball.vertices, ball.faces)
    found = measure_deviation(mesh, SurfaceQueries(make_mesh(ball.vertices * 0.9, ball.faces)), 1.0)
    assert len(found.mesh.triangles) > MOST_TRIANGLES
    thin = page_geometry(found, mesh)
    assert len(thin.result.triangles) <= MOST_TRIANGLES
    assert len(thin.reference.triangles) <= MOST_TRIANGLES
    assert len(thin.values) == len(thin.result.vertices)
    assert thin.values == pytest.approx(np.full(len(thin.values), 0.25), abs=1e-3)


def test_the_packed_arrays_give_the_geometry_back(bracket: TriangleMesh) -> None:
    fine = measure_deviation(bracket, SurfaceQueries(bracket), 1.0)
    found = replace(fine, mesh=bracket, distances=np.zeros(len(bracket.vertices)))
    geometry = page_geometry(found, bracket)
    packed = geometry.as_json(found)["result"]
    shares = np.frombuffer(base64.b64decode(packed["places"]), "<u2").reshape(-1, 3) / 65535.0
    places = shares * packed["extent"] + packed["low"]
    assert places == pytest.approx(found.mesh.vertices, abs=40 / 65535)
    triangles = np.frombuffer(base64.b64decode(packed["triangles"]), "<u4").reshape(-1, 3)
    assert (triangles == found.mesh.triangles).all()


# Frames come with the virtual clock of the waits below, and not when a busy machine has one.
_FRAMES = """<script>
window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
</script></head>"""

_SCRIPT = Path(__file__).with_name("page_probe.js").read_text("utf-8")
_PROBE = f"<script>\n{_SCRIPT}</script></body>"


def test_the_view_turns_in_a_browser(page: Path, tmp_path: Path) -> None:
    found = browser.find_browser()
    if found is None:
        pytest.skip(f"no browser: none of {', '.join(browser.NAMES)} is installed")
    probed = tmp_path / "probed page.html"
    text = page.read_text("utf-8")
    assert "</head>" in text and "</body>" in text
    text = text.replace("</head>", _FRAMES).replace("</body>", _PROBE)
    probed.write_text(text, "utf-8")
    text = browser.dump_dom(found, probed, tmp_path / "profile")
    match = re.search(r'<pre id="seen">(.*?)</pre>', text, re.DOTALL)
    assert match, "the page's script did not run to its end"
    seen = json.loads(match[1].replace("&amp;", "&"))
    assert seen["state"] == "ready"
    assert seen["still"] is True
    assert 0.05 < seen["first"][1] < 0.9
    steps = ("first", "marked", "turned", "keyed", "zoomed", "ranged", "cut", "flown")
    sums = [seen[step][0] for step in steps]
    assert len(set(sums)) == len(sums)
    assert re.fullmatch(r"[-+]?[\d.e-]+ mm at [-\d., e]+", seen["told"])
    assert seen["ticks"][0] == "+0.5 mm" and seen["ticks"][-1] == "-0.5 mm"
    report = json.loads((page.parent / "comparison.json").read_text("utf-8"))
    worst = report["deviation"]["worst"][0]["deviation_mm"]
    assert float(seen["worst"].split()[0]) == pytest.approx(worst, rel=1e-3)

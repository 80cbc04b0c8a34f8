"""What FreeCAD and its Addon Manager find."""

import ast
import sys
import unittest
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD

import freecad
from freecad.gaussiancad.paths import ADDON_ROOT, ICONS
from freecad.gaussiancad.workbench_names import MENU

PACKAGE = ADDON_ROOT / "freecad" / "gaussiancad"
SPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}


class Manifest(unittest.TestCase):
    def setUp(self) -> None:
        self.metadata = FreeCAD.Metadata(str(ADDON_ROOT / "package.xml"))

    def test_freecad_reads_every_part_of_it(self) -> None:
        self.assertEqual(self.metadata.Name, "GaussianCAD")
        self.assertEqual(self.metadata.Version, "0.1.0")
        self.assertEqual(
            self.metadata.Maintainer,
            [{"name": "GaussianCAD developers", "email": "developers@example.org"}],
        )
        network = "core/gaussiancad_core/writing/text_network/LICENSE"
        expected = [("LGPL-2.1-or-later", "LICENSE"), ("Apache-2.0", network)]
        stated = [(licence["name"], licence["file"]) for licence in self.metadata.License]
        self.assertEqual(stated, expected)
        for _, path in expected:
            self.assertTrue((ADDON_ROOT / path).is_file())
        self.assertEqual(
            sorted(depend["package"] for depend in self.metadata.Depend),
            ["mesh", "part", "points", "sketcher"],
        )
        (workbench,) = self.metadata.Content["workbench"]
        self.assertEqual(workbench.Classname, "GaussianCADWorkbench")
        self.assertTrue((ADDON_ROOT / workbench.Icon).is_file())
        self.assertTrue((ADDON_ROOT / self.metadata.Icon).is_file())
        self.assertTrue(self.metadata.supportsCurrentFreeCAD())
        types = {url["type"] for url in self.metadata.Urls}
        self.assertEqual(types, {"website", "repository", "bugtracker", "readme", "documentation"})

    def test_everything_published_is_under_example_org(self) -> None:
        root = ElementTree.parse(ADDON_ROOT / "package.xml").getroot()
        for url in root.findall("p:url", SPACE):
            self.assertTrue(url.text.startswith("https://example.org/"), url.text)
        date = root.find("p:date", SPACE).text
        self.assertRegex(date, r"^\d{4}-\d\d-\d\d$")

    def test_no_python_requirements_are_forced_on_freecad(self) -> None:
        for name in ("requirements.txt", "metadata.txt"):
            self.assertFalse((ADDON_ROOT / name).exists())


class Namespace(unittest.TestCase):
    def test_freecads_own_package_stays_in_charge(self) -> None:
        self.assertFalse((ADDON_ROOT / "freecad" / "__init__.py").exists())
        self.assertNotIn(str(ADDON_ROOT), str(freecad.__file__))
        __import__("freecad.UiTools")

    def test_nothing_heavy_and_nothing_of_the_engine_is_imported(self) -> None:
        allowed = set(sys.stdlib_module_names)
        allowed |= {
            *("FreeCAD", "FreeCADGui", "Part", "Mesh", "Points", "Sketcher", "PySide", "PySide6"),
            *("pivy", "gaussiancad_protocol"),
        }
        for path in PACKAGE.rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                names = []
                if isinstance(node, ast.Import):
                    names = [alias.name for alias in node.names]
                elif isinstance(node, ast.ImportFrom):
                    names = [node.module]
                for name in names:
                    inside = name.startswith("freecad.gaussiancad")
                    self.assertTrue(inside or name.split(".")[0] in allowed, f"{path}: {name}")

    def test_the_package_itself_imports_nothing(self) -> None:
        tree = ast.parse((PACKAGE / "__init__.py").read_text(encoding="utf-8"))
        self.assertEqual(len(tree.body), 1)


class Pictures(unittest.TestCase):
    def test_every_icon_is_a_whole_svg_without_foreign_parts(self) -> None:
        names = {path.stem for path in ICONS.glob("*.svg")}
        self.assertEqual(names, {*MENU, "GaussianCAD_Workbench", "preferences-gaussiancad"})
        for path in ICONS.glob("*.svg"):
            root = ElementTree.parse(path).getroot()
            self.assertEqual(root.get("viewBox"), "0 0 64 64")
            self.assertNotIn("http", Path(path).read_text().replace("http://www.w3.org", ""))

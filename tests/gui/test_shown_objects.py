"""A document that was saved without a window shows what is to be seen."""

import zipfile
from pathlib import Path

import FreeCAD
from window import WindowCase, spin

from freecad.gaussiancad.objects.shown_objects import GUI_FILE, gui_document


class ShownObjects(WindowCase):
    def saved_without_window(self) -> Path:
        """A document as ``freecadcmd`` saves it, with what is to be seen."""
        document = FreeCAD.newDocument("Shown")
        for name in ("Shown", "Hidden"):
            document.addObject("Part::Box", name)
        document.addObject("PartDesign::Body", "Body")
        group = document.addObject("App::DocumentObjectGroupPython", "Group")
        group.addObjects([document.Shown, document.Hidden])
        document.Hidden.Visibility = False
        document.recompute()
        saved, path = self.folder / "saved.FCStd", self.folder / "bare.FCStd"
        document.saveAs(str(saved))
        text = gui_document(document)
        FreeCAD.closeDocument(document.Name)
        with zipfile.ZipFile(saved) as source, zipfile.ZipFile(path, "w") as target:
            for name in source.namelist():
                if name == "Document.xml" or name.endswith((".brp", ".bin", ".txt")):
                    target.writestr(name, source.read(name))
            target.writestr(GUI_FILE, text)
        return path

    def test_what_is_visible_is_shown_and_nothing_else(self) -> None:
        document = FreeCAD.openDocument(str(self.saved_without_window()))
        spin(200)
        shown = {each.Name for each in document.Objects if each.ViewObject.Visibility}
        self.assertLessEqual({"Shown", "Body", "Group"}, shown)
        self.assertTrue({"Hidden", "Origin"}.isdisjoint(shown))

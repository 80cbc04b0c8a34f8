"""What a document shows when a window opens it that ``freecadcmd`` has saved.

Without a window FreeCAD saves nothing of how objects look, and a window then hides all of them.
The file that a window would have added, ``GuiDocument.xml``, is added with what is to be seen.
"""

import zipfile
from pathlib import Path
from xml.sax.saxutils import quoteattr

import FreeCAD

GUI_FILE = "GuiDocument.xml"

_HEAD = """<?xml version='1.0' encoding='utf-8'?>
<!-- What is to be seen; written without a window. -->
<Document SchemaVersion="1">
    <ViewProviderData Count="{count}">
"""

_OBJECT = """        <ViewProvider name={name} expanded="0">
            <Properties Count="{count}" TransientCount="0">
                <Property name="Visibility" type="App::PropertyBool">
                    <Bool value="{shown}"/>
                </Property>
{more}            </Properties>
        </ViewProvider>
"""

_PROXY = """                <Property name="Proxy" type="App::PropertyPythonObject">
                    <Python value="MQ==" encoded="yes" json="yes"/>
                </Property>
"""
"""The number 1 as the Python object of a view, as FreeCAD itself has it where there is none.  A
group without would be set up late, and show all that is in it."""

_TAIL = """    </ViewProviderData>
    <Camera settings=""/>
</Document>
"""


def save_shown(document: FreeCAD.Document, path: Path) -> None:
    """Save a document so that a window shows the objects that are visible, and hides the others.

    Args:
        document: is saved under that path.
        path: of the file.

    Raises:
        OSError: it cannot be written.
    """
    document.saveAs(str(path))
    if not FreeCAD.GuiUp and path.is_file():
        with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(GUI_FILE, gui_document(document))


def gui_document(document: FreeCAD.Document) -> str:
    """The text of the file that says what is to be seen."""
    objects = document.Objects
    parts = [_HEAD.format(count=len(objects))]
    for each in objects:
        # A window hides the origin of a new body.
        is_shown = each.Visibility and each.TypeId != "App::Origin"
        shown = "true" if is_shown else "false"
        more = _PROXY if hasattr(each, "Proxy") else ""
        name, count = quoteattr(each.Name), 2 if more else 1
        parts.append(_OBJECT.format(name=name, count=count, shown=shown, more=more))
    return "".join([*parts, _TAIL])

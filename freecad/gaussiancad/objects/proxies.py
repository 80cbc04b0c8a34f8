"""What all groups of this addon have in common."""

import FreeCAD

from freecad.gaussiancad.objects.appearance import dress
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.qt import QtCore


class GroupViewProxy:
    """View provider of a group: its icon.

    Args:
        view: the group's view object.
    """

    icon_name = "GaussianCAD_Workbench"

    def __init__(self, view: object) -> None:
        view.Proxy = self

    def attach(self, view: object) -> None:
        """Remember the group when the view is made or restored."""
        self.Object = view.Object

    def getIcon(self) -> object:
        """The icon in the tree: FreeCAD's own reader knows SVG even where Qt's does not."""
        import FreeCADGui

        return FreeCADGui.getIcon(self.icon_name)

    def dumps(self) -> None:
        """Store nothing (FreeCAD 0.21 and later)."""
        return

    def loads(self, state: object) -> None:
        """Restore nothing (FreeCAD 0.21 and later)."""

    def __getstate__(self) -> None:
        """Store nothing (FreeCAD 0.20)."""
        return

    def __setstate__(self, state: object) -> None:
        """Restore nothing (FreeCAD 0.20)."""


class GroupProxy:
    """Proxy of a group: it holds nothing and computes nothing.

    Args:
        target: the group.
    """

    view_proxy = GroupViewProxy

    def __init__(self, target: FreeCAD.DocumentObject) -> None:
        target.Proxy = self

    def execute(self, target: FreeCAD.DocumentObject) -> None:
        """Do nothing: the engine runs on command only, never during a recompute."""

    def show(self, target: FreeCAD.DocumentObject) -> None:
        """Make the group's view provider and its objects' looks; nothing without a window."""
        if FreeCAD.GuiUp:
            self.view_proxy(target.ViewObject)
            dress(target, texts_of(target, "Settings").get("colour"))

    def onDocumentRestored(self, target: FreeCAD.DocumentObject) -> None:
        """Dress what ``freecadcmd`` made, once the window has restored what it knows of it."""
        if FreeCAD.GuiUp:
            QtCore.QTimer.singleShot(0, lambda: self._show_if_bare(target))

    def _show_if_bare(self, target: FreeCAD.DocumentObject) -> None:
        try:
            if not isinstance(target.ViewObject.Proxy, GroupViewProxy):
                self.show(target)
                for name in getattr(target, "HiddenAtFirst", []):
                    target.Document.getObject(name).Visibility = False
        except ReferenceError:
            return  # the document was closed in the meantime

    def dumps(self) -> None:
        """Store nothing (FreeCAD 0.21 and later)."""
        return

    def loads(self, state: object) -> None:
        """Restore nothing (FreeCAD 0.21 and later)."""

    def __getstate__(self) -> None:
        """Store nothing (FreeCAD 0.20)."""
        return

    def __setstate__(self, state: object) -> None:
        """Restore nothing (FreeCAD 0.20)."""

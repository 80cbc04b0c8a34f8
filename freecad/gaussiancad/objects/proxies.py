"""What all groups of this addon have in common."""

import FreeCAD


class GroupProxy:
    """Proxy of a group: it holds nothing and computes nothing.

    Args:
        target: the group.
    """

    def __init__(self, target: FreeCAD.DocumentObject) -> None:
        target.Proxy = self

    def execute(self, target: FreeCAD.DocumentObject) -> None:
        """Do nothing: the engine runs on command only, never during a recompute."""

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

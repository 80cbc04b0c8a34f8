"""What is drawn in a document's 3D view beside its objects, and taken off again.

Nothing of it is in the document.
"""

import FreeCAD
import FreeCADGui
from pivy import coin


class ViewMark:
    """Nodes in the 3D view of a document; those who draw something derive from it.

    Args:
        document: whose view it is.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        self._document = document.Name
        self._nodes: list[coin.SoNode] = []
        self._view: object = None

    def clear(self) -> None:
        """Take the nodes off; a view that was closed has none."""
        nodes, self._nodes = self._nodes, []
        if not nodes or not self._is_open():
            return
        graph = self._view.getSceneGraph()
        for node in nodes:
            if graph.findChild(node) >= 0:
                graph.removeChild(node)

    def _is_open(self) -> bool:
        return self._document in FreeCAD.listDocuments()

    def _cleared_view(self) -> object | None:
        """The view without what was drawn before; None where there is no 3D view in front."""
        self.clear()
        view = FreeCADGui.getDocument(self._document).ActiveView
        self._view = view if hasattr(view, "getSceneGraph") else None
        return self._view

    def _put_behind(self, *nodes: coin.SoNode) -> None:
        """Draw nodes after all objects."""
        for node in nodes:
            self._view.getSceneGraph().addChild(node)
        self._nodes += nodes

    def _put_before(self, *nodes: coin.SoNode) -> None:
        """Draw nodes, in this order, before all objects, which they change."""
        for place, node in enumerate(nodes):
            self._view.getSceneGraph().insertChild(node, place)
        self._nodes += nodes


def unpickable(node: coin.SoGroup) -> coin.SoGroup:
    """An empty node whose content no click hits."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    node.addChild(style)
    return node

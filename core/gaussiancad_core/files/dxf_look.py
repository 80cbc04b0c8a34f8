"""How a DXF entity looks: layer, linetype, line weight and colour, through BYLAYER and BYBLOCK."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ezdxf import colors
from ezdxf.document import Drawing
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.ltype import Linetype

from gaussiancad_core.files.file_linetypes import role_by_name, stroke_role
from gaussiancad_core.files.vectors import Colour, StrokeKind, StrokeRole

_BY_LAYER, _BY_BLOCK = -1, -2

_BLACK: Colour = (0, 0, 0)

_UNPLOTTED = "defpoints"
"""The layer that CAD systems never print."""


@dataclass(frozen=True)
class Look:
    """The resolved look of an entity.

    Attributes:
        layer: its name.
        linetype: its name, never BYLAYER or BYBLOCK.
        dashes: units of the drawing, dash and gap in turn, empty for a solid line.
        weight: line weight in mm, or None for the default one.
        kind: of what entity it is a part.
        role: what the names say.
        inherited: what the names of the blocks around say of their solid lines, if anything.
        colour: red, green, blue, as on white paper.
    """

    layer: str = "0"
    linetype: str = "CONTINUOUS"
    dashes: tuple[float, ...] = ()
    weight: float | None = None
    kind: StrokeKind = StrokeKind.GEOMETRY
    role: StrokeRole = StrokeRole.VISIBLE
    inherited: StrokeRole | None = None
    colour: Colour = _BLACK


class Looks:
    """The layers and linetypes of a document."""

    def __init__(self, doc: Drawing) -> None:
        self._layers = {layer.dxf.name.casefold(): layer for layer in doc.layers}
        self._patterns = {
            linetype.dxf.name.casefold(): _pattern(linetype) for linetype in doc.linetypes
        }
        self._scale = float(doc.header.get("$LTSCALE", 1.0)) or 1.0

    def of(self, entity: DXFGraphic, parent: Look) -> Look:
        """The look of an entity inside ``parent``, which is the block's or the page's."""
        layer = entity.dxf.get("layer", "0")
        if layer == "0" and parent.kind is not StrokeKind.GEOMETRY:
            layer = parent.layer
        name = self._linetype(entity, layer, parent)
        pattern = self._patterns.get(name.casefold(), ())
        scale = self._scale * (float(entity.dxf.get("ltscale", 1.0)) or 1.0)
        dashes = tuple(value * scale for value in pattern)
        role = stroke_role(name, layer, dashes)
        if parent.inherited is not None and not dashes:
            role = parent.inherited
        weight = self._weight(entity, layer, parent)
        colour = self._colour(entity, layer, parent)
        return Look(layer, name, dashes, weight, parent.kind, role, parent.inherited, colour)

    def is_shown(self, entity: DXFGraphic, look: Look) -> bool:
        """Whether an entity is printed: it and its layer are on."""
        if entity.dxf.get("invisible", 0):
            return False
        if look.layer.casefold() == _UNPLOTTED:
            return False
        layer = self._layers.get(look.layer.casefold())
        if layer is None:
            return True
        return not (layer.is_off() or layer.is_frozen() or not layer.dxf.get("plot", 1))

    def is_frozen(self, look: Look) -> bool:
        """Whether a block on this layer is not shown, whatever its parts' layers."""
        layer = self._layers.get(look.layer.casefold())
        return layer is not None and layer.is_frozen()

    def _linetype(self, entity: DXFGraphic, layer: str, parent: Look) -> str:
        name = str(entity.dxf.get("linetype", "BYLAYER"))
        if name.casefold() == "byblock":
            return parent.linetype
        if name.casefold() != "bylayer":
            return name
        found = self._layers.get(layer.casefold())
        return str(found.dxf.get("linetype", "CONTINUOUS")) if found else "CONTINUOUS"

    def _weight(self, entity: DXFGraphic, layer: str, parent: Look) -> float | None:
        weight = int(entity.dxf.get("lineweight", _BY_LAYER))
        if weight == _BY_BLOCK:
            return parent.weight
        if weight == _BY_LAYER:
            found = self._layers.get(layer.casefold())
            weight = int(found.dxf.get("lineweight", -3)) if found else -3
        return weight / 100.0 if weight >= 0 else None

    def _colour(self, entity: DXFGraphic, layer: str, parent: Look) -> Colour:
        if entity.rgb is not None:
            return _rgb(entity.rgb)
        number = int(entity.dxf.get("color", colors.BYLAYER))
        if number == colors.BYBLOCK:
            return parent.colour
        if number == colors.BYLAYER:
            found = self._layers.get(layer.casefold())
            if found is not None and found.rgb is not None:
                return _rgb(found.rgb)
            number = abs(found.color) if found is not None else colors.WHITE
        # White on a screen is black on paper.
        if number == colors.WHITE or not 0 < number < colors.BYLAYER:
            return _BLACK
        return _rgb(colors.aci2rgb(number))


def _rgb(channels: Sequence[int]) -> Colour:
    """Red, green and blue as plain numbers."""
    red, green, blue = (int(value) for value in channels)
    return red, green, blue


def _pattern(linetype: Linetype) -> tuple[float, ...]:
    """Lengths of dash and gap in turn; empty for a solid line, and for one of letters or shapes."""
    lengths = [abs(float(value)) for value in linetype.simplified_line_pattern()]
    total = sum(lengths)
    # The pattern's stated length may differ from its parts' by a rounding error.
    while lengths and len(lengths) % 2 == 0 and lengths[-1] <= 1e-9 * total:
        lengths.pop()
    if len(lengths) % 2 and len(lengths) > 1:
        # It ends in a dash, with which the next repetition begins.
        lengths[0] += lengths.pop()
    return tuple(lengths) if sum(lengths[1::2]) > 0.0 else ()


def inside_block(look: Look, block: str) -> Look:
    """The look that a block's parts inherit."""
    kind = StrokeKind.BLOCK if look.kind is StrokeKind.GEOMETRY else look.kind
    return replace(look, kind=kind, inherited=role_by_name(block) or look.inherited)

"""An SVG file as a tree that can be drawn without harm: no entities, nothing from outside, bounded.

Whatever refers to another file, and whatever is not drawn (scripts, animation, filters, foreign
elements), is taken out before any other library sees the file.
"""

import base64
import binascii
import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from urllib.parse import unquote_to_bytes
from xml.etree.ElementTree import Element, ParseError

from defusedxml import DefusedXmlException
from defusedxml.ElementTree import fromstring
from PIL import Image

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.files.content import (
    LONGEST_TEXT,
    MAX_ELEMENTS,
    MAX_PIXELS,
    too_large,
    too_many_elements,
)
from gaussiancad_core.files.file_kinds import GZIP_MAGIC
from gaussiancad_protocol.codes import Code

SVG = "{http://www.w3.org/2000/svg}"
XLINK_HREF = "{http://www.w3.org/1999/xlink}href"

_MAX_BYTES = 64_000_000

_DEEPEST = 200
"""Elements in elements, reused ones included; both libraries that follow are recursive."""

_REMOVED = frozenset(
    {
        "animate",
        "animateColor",
        "animateMotion",
        "animateTransform",
        "audio",
        "cursor",
        "embed",
        "filter",
        "font",
        "font-face",
        "foreignObject",
        "handler",
        "iframe",
        "listener",
        "metadata",
        "object",
        "script",
        "set",
        "video",
    }
)

_KEPT_ASIDE = frozenset(["symbol", "marker", "mask", "clipPath", "pattern"])
"""Elements that are only drawn where others refer to them."""

_FOREIGN_URL = re.compile(r"url\(\s*+['\"]?+\s*+(?!#)[^)]*+\)", re.IGNORECASE)
_IMPORT = re.compile(r"@(?:import|font-face|namespace)[^;{]*(?:;|\{[^}]*\})", re.IGNORECASE)
_FILTER = re.compile(r"(^|[;{\s])(?:-\w+-)?filter\s*:[^;}]*", re.IGNORECASE)
_DATA_IMAGE = re.compile(r"\s*data:image/(png|jpe?g|webp|bmp)[^,]*?(;base64)?,", re.IGNORECASE)


@dataclass
class SafeSvg:
    """A tree to draw.

    Attributes:
        root: the ``svg`` element; every element is in SVG's namespace.
        external: references to other files that were taken out.
        pictures: embedded raster pictures that were left in.
    """

    root: Element
    external: int = 0
    pictures: int = 0
    _pixels: int = field(default=0, repr=False)


def load_svg(path: Path) -> SafeSvg:
    """Parse an SVG file, plain or compressed, and make it safe.

    Raises:
        UnreadableError: ``damaged-svg``, ``svg-entities``, ``image-too-large``.
        LimitError: ``drawing-file-too-large``, ``too-many-elements``.
    """
    data = _bounded_bytes(path)
    try:
        root = fromstring(data, forbid_entities=True, forbid_external=True)
    except DefusedXmlException as error:
        raise UnreadableError(
            Code.SVG_ENTITIES,
            "{path} declares XML entities, which are never expanded: save it as plain SVG",
            path=path,
        ) from error
    except (ParseError, ValueError, LookupError) as error:
        raise _damaged(path, error) from error
    if _local(root) != "svg":
        raise _damaged(path, f"its root is <{_local(root)}>")
    safe = SafeSvg(root)
    _check_shape(path, root)
    _clean_tree(path, safe)
    _drop_loops(path, root)
    return safe


def _damaged(path: Path, reason: object) -> UnreadableError:
    return UnreadableError(
        Code.DAMAGED_SVG,
        "{path} is no SVG file, or is damaged ({reason}): export the drawing again",
        path=path,
        reason=reason,
    )


def _bounded_bytes(path: Path) -> bytes:
    with path.open("rb") as file:
        data = file.read(_MAX_BYTES + 1)
    if data.startswith(GZIP_MAGIC):
        try:
            unpacker = zlib.decompressobj(wbits=31)
            data = unpacker.decompress(data, _MAX_BYTES + 1)
        except zlib.error as error:
            raise _damaged(path, error) from error
    if len(data) > _MAX_BYTES:
        raise LimitError(
            Code.DRAWING_FILE_TOO_LARGE,
            "{path} has more than {most} MB: save only the views, or export it as PNG",
            path=path,
            most=_MAX_BYTES // 1_000_000,
        )
    return data


def _local(element: Element) -> str:
    tag = element.tag if isinstance(element.tag, str) else ""
    return tag.rpartition("}")[2]


def _levels(root: Element) -> Iterator[list[Element]]:
    """The elements of each depth."""
    level = [root]
    while level:
        yield level
        level = [child for element in level for child in element]


def _check_shape(path: Path, root: Element) -> None:
    total = 0
    for depth, level in enumerate(_levels(root)):
        total += len(level)
        if total > MAX_ELEMENTS:
            raise too_many_elements(path)
        if depth > _DEEPEST:
            raise _damaged(path, f"more than {_DEEPEST} elements in each other")


def _clean_tree(path: Path, safe: SafeSvg) -> None:
    """Take out what is foreign or harmful, level by level."""
    bare = not safe.root.tag.startswith("{")
    for level in list(_levels(safe.root)):
        for element in level:
            if bare and isinstance(element.tag, str) and not element.tag.startswith("{"):
                element.tag = SVG + element.tag
            _clean_attributes(safe, element)
            if element.tag == SVG + "style" and element.text:
                element.text = _clean_css(safe, element.text)
            else:
                element.text = element.text and element.text[:LONGEST_TEXT]
            element.tail = element.tail and element.tail[:LONGEST_TEXT]
    for level in list(_levels(safe.root)):
        for element in level:
            for index, child in reversed(list(enumerate(element))):
                if not _is_kept(path, safe, child):
                    _remove(element, child)
                elif _local(child) in _KEPT_ASIDE and _local(element) != "defs":
                    aside = Element(SVG + "defs")
                    aside.tail = child.tail
                    aside.append(child)
                    element[index] = aside


def _remove(parent: Element, child: Element) -> None:
    """Take an element out; the text after it stays."""
    index = list(parent).index(child)
    if child.tail and index:
        parent[index - 1].tail = (parent[index - 1].tail or "") + child.tail
    elif child.tail:
        parent.text = (parent.text or "") + child.tail
    parent.remove(child)


def _is_kept(path: Path, safe: SafeSvg, element: Element) -> bool:
    if not (isinstance(element.tag, str) and element.tag.startswith(SVG)):
        return False
    if _local(element) in _REMOVED:
        return False
    if _local(element) != "image":
        return True
    reference = element.get("href") or element.get(XLINK_HREF) or ""
    pixels = _picture_pixels(reference)
    if pixels is None:
        return False
    safe._pixels += pixels
    if safe._pixels > MAX_PIXELS:
        raise too_large(path, "a picture of many more")
    safe.pictures += 1
    return True


def _picture_pixels(reference: str) -> int | None:
    """Pixels of an embedded picture; None if it is none of a known kind."""
    match = _DATA_IMAGE.match(reference)
    if not match:
        return None
    payload = unquote_to_bytes(reference[match.end() :])
    try:
        if match[2]:
            payload = base64.b64decode(payload)
        with Image.open(BytesIO(payload), formats=("PNG", "JPEG", "WEBP", "BMP")) as image:
            return image.width * image.height
    except (OSError, ValueError, binascii.Error, Image.DecompressionBombError):
        return None


def _clean_attributes(safe: SafeSvg, element: Element) -> None:
    for name, value in list(element.attrib.items()):
        local = name.rpartition("}")[2]
        if local == "href":
            if value.strip().startswith("#") or _DATA_IMAGE.match(value):
                continue
            # A hyperlink changes nothing of what is drawn.
            safe.external += _local(element) != "a"
            del element.attrib[name]
        elif local.lower().startswith("on") or local in ("base", "filter"):
            del element.attrib[name]
        elif local == "style" or "url(" in value.lower():
            element.set(name, _clean_css(safe, value))


def _clean_css(safe: SafeSvg, text: str) -> str:
    text, imports = _IMPORT.subn("", text)
    # Behind the last bracket nothing matches; looking for one there again and again is quadratic.
    end = text.rfind(")") + 1
    head, urls = _FOREIGN_URL.subn("none", text[:end])
    text = head + text[end:]
    safe.external += imports + urls
    return _FILTER.sub(r"\1", text)


def _drop_loops(path: Path, root: Element) -> None:
    """Take out ``use`` elements that end in themselves, and bound what the others come to."""
    by_id = {element.get("id"): element for element in root.iter() if element.get("id")}
    parents = {child: parent for parent in root.iter() for child in parent}
    sizes: dict[Element, int] = {}
    open_elements: set[Element] = set()
    looping: list[Element] = []

    def size(element: Element, depth: int) -> int:
        if element in sizes:
            return sizes[element]
        if depth > 2 * _DEEPEST:
            raise too_many_elements(path)
        open_elements.add(element)
        total = 1 + sum(size(child, depth + 1) for child in element)
        if element.tag == SVG + "use":
            target = by_id.get((element.get("href") or element.get(XLINK_HREF) or "")[1:])
            if target in open_elements:
                looping.append(element)
            elif target is not None:
                total += size(target, depth + 1)
        open_elements.discard(element)
        sizes[element] = total
        if total > MAX_ELEMENTS:
            raise too_many_elements(path)
        return total

    size(root, 0)
    for element in looping:
        _remove(parents[element], element)

"""Style sheets refer to nothing outside of the file."""

import time
from xml.etree.ElementTree import Element

import pytest

from gaussiancad_core.files.svg_safety import SafeSvg, _clean_css


def _cleaned(text: str) -> tuple[str, int]:
    safe = SafeSvg(Element("svg"))
    return _clean_css(safe, text), safe.external


@pytest.mark.parametrize(
    ("text", "clean", "external"),
    [
        ("fill:url(#a)", "fill:url(#a)", 0),
        ("fill:url(  ' #a')", "fill:url(  ' #a')", 0),
        ("fill:url(http://x/a)", "fill:none", 1),
        ("fill:URL( 'file:///a' ); stroke:url(b)", "fill:none; stroke:none", 2),
        ("fill:url(", "fill:url(", 0),
    ],
)
def test_only_parts_of_the_file_itself_are_referred_to(
    text: str, clean: str, external: int
) -> None:
    assert _cleaned(text) == (clean, external)


@pytest.mark.parametrize("piece", ["url(", "url( ", "url('", " "])
def test_what_never_ends_takes_no_longer_than_it_is(piece: str) -> None:
    # What looks ahead from each piece to the end would take hours.
    started = time.process_time()
    _cleaned("fill:url(" + piece * 200_000)
    assert time.process_time() - started < 60.0

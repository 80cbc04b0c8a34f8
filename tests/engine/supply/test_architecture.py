"""The picture of the packages is that of the contract, and every package has its place in it."""

import re
from pathlib import Path

import architecture_picture as picture

PACKAGES = {path.parent.name for path in picture.ENGINE.glob("*/__init__.py")}


def test_the_page_is_up_to_date() -> None:
    assert picture.page() == picture.PAGE.read_text(encoding="utf-8")


def test_all_packages_are_in_order_and_no_module_is_loose() -> None:
    loose = {path.stem for path in picture.ENGINE.glob("*.py")} - {"__init__", "__main__"}
    assert loose == {"errors", "messages"}
    assert set(picture.layers()) == PACKAGES | loose


def test_modules_have_names_of_their_own() -> None:
    paths = [path for path in Path(picture.ENGINE).rglob("*.py") if not path.stem.startswith("__")]
    assert len({path.stem for path in paths}) == len(paths)


def test_every_place_that_the_page_names_is_there() -> None:
    page = picture.PAGE.read_text(encoding="utf-8").partition("## Where is it decided?")[2]
    cells = re.findall(r"^\|[^|]+\|([^|]+)\|$", page, re.MULTILINE)
    places = [place for cell in cells for place in re.findall(r"`([a-z_./]+)`", cell)]
    assert len(places) > 50
    for place in places:
        if place.endswith(".py"):
            paths = [picture.CHECKOUT / place, picture.CHECKOUT / "freecad/gaussiancad" / place]
        else:
            path = picture.ENGINE.joinpath(*place.split("."))
            paths = [path, path.with_suffix(".py")]
        assert any(path.exists() for path in paths), place

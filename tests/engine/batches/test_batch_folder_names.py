"""Names of the folders of a batch."""

import itertools
from pathlib import Path, PurePosixPath, PureWindowsPath

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.batches.batch_folder_names import folder_names, safe_name

_STEMS = st.text(st.characters(codec=None), max_size=150) | st.text("aA.-~ \x00\\/:é", max_size=6)


@given(_STEMS)
def test_a_name_is_safe_and_leads_nowhere(stem: str) -> None:
    name = safe_name(stem)
    assert name.encode("utf-8") and len(name.encode("utf-8")) <= 102
    assert name[0] not in ".-~ " and name[-1] not in ". "
    for pure in (PurePosixPath, PureWindowsPath):
        assert (pure("/out") / name).parent == pure("/out")
    assert not PureWindowsPath(name).is_reserved()
    assert safe_name(name) == name


@pytest.mark.parametrize(
    ("stem", "name"),
    [
        ("Träger 1.5", "Träger 1.5"),
        ("Tra\u0308ger", "Träger"),
        ("図面", "図面"),
        ("..", "_"),
        ("", "_"),
        (".hidden", "_hidden"),
        ("-dash", "_-dash"),
        ("a/b\\c", "a_b_c"),
        ("nul", "_nul"),
        ("report.csv", "report.csv_"),
        ("a\udcff", "a_"),
    ],
)
def test_usual_names_stay_and_others_become_safe(stem: str, name: str) -> None:
    assert safe_name(stem) == name


@given(st.lists(st.text("abAB.é", min_size=1, max_size=2), max_size=10))
def test_every_sheet_has_a_folder_of_its_own_whatever_their_order(stems: list[str]) -> None:
    sheets = [Path(f"/{i}/{stem}.png") for i, stem in enumerate(stems)]
    names = dict(zip(sheets, folder_names(sheets), strict=True))
    assert len({name.casefold() for name in names.values()}) == len(stems)
    backwards = sheets[::-1]
    assert [names[sheet] for sheet in backwards] == folder_names(backwards)


def test_a_name_that_another_sheet_would_get_is_not_taken_twice() -> None:
    first, second = Path("/x/a.png"), Path("/y/a.png")
    taken = [Path(f"/z/{name}.png") for name in folder_names([first, second])]
    for sheets in itertools.permutations([first, second, *taken]):
        assert len(set(folder_names(sheets))) == 4

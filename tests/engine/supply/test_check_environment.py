"""What is missing in an environment, but for what the locks leave out."""

import check_environment
import pytest
from check_environment import problems

INSTALLED = {"a": "1.0", "b": "2.0", "c": "3.0rc1"}


@pytest.mark.parametrize(
    ("requirement", "expected"),
    [
        ("b", []),
        ("B>=2,<3", []),
        ("c>=2", []),
        ("b>=3", ["a requires b>=3, but 2.0 is installed"]),
        ("d>=1", ["a requires d>=1, which is not installed"]),
        ("left_out", []),
        ("d; python_version < '3'", []),
        ("d; extra == 'more'", []),
        ("d; python_version > '3'", ['a requires d; python_version > "3", which is not installed']),
    ],
)
def test_each_requirement_of_here_is_looked_for(requirement: str, expected: list[str]) -> None:
    found = problems(INSTALLED, {"a": [requirement]}, frozenset({"left-out"}))
    assert found == expected


def test_what_may_be_missing_must_still_fit_where_it_is() -> None:
    found = problems({"left-out": "1"}, {"a": ["left-out>=2"]}, frozenset({"left-out"}))
    assert found == ["a requires left-out>=2, but 1 is installed"]


def test_this_environment_is_complete(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert check_environment.main() == 0
    assert capsys.readouterr().out == "every requirement is met\n"
    monkeypatch.setattr(check_environment, "excluded", frozenset)
    monkeypatch.setattr(
        check_environment.metadata, "distributions", lambda: [Distribution("x", ["no-such"])]
    )
    assert check_environment.main() == 1
    assert capsys.readouterr().out == "x requires no-such, which is not installed\n"


class Distribution:
    """What the check looks at of an installed package."""

    version = "1"

    def __init__(self, name: str, requires: list[str]) -> None:
        self.metadata = {"Name": name}
        self.requires = requires

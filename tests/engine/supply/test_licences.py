"""Which licences the locked packages have, and that none comes in that is not allowed."""

import re
from importlib import metadata

import licences
import pytest
from licence_policy import ALLOWED, NVIDIA, READ, Licence, is_allowed, stated_licence
from licences import PAGE, RECORD, Record, page, read_record, record_text, rows, table
from locked import Lock, Package, canonical, read_lock
from packaging.licenses import canonicalize_license_expression

GPL = "GNU General Public License v3 or later (GPLv3+)"


@pytest.fixture(scope="module")
def record() -> Record:
    return read_record(RECORD.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def locks() -> dict[Lock, tuple[Package, ...]]:
    return {lock: read_lock(lock) for lock in Lock}


def test_every_locked_package_has_a_licence_that_is_allowed(
    locks: dict[Lock, tuple[Package, ...]], record: Record
) -> None:
    listed = rows(locks, record)
    assert [(row.name, row.version, row.licence.text) for row in listed if not row.allowed] == []
    # Each package of each lock is in the list, and the record has no other.
    of_locks = {(p.name, p.release) for packages in locks.values() for p in packages}
    assert {(row.name, row.version) for row in listed} == of_locks == set(record)


def test_the_record_says_what_the_installed_packages_say(record: Record) -> None:
    checked = 0
    for package in metadata.distributions():
        this_metadata = package.metadata
        key = canonical(this_metadata["Name"]), package.version.partition("+")[0]
        if key in record:
            classifiers = this_metadata.get_all("Classifier") or []
            fields = this_metadata.get("License-Expression"), this_metadata.get("License")
            assert record[key] == stated_licence(key[0], *fields, classifiers), key
            checked += 1
    assert checked > 50


def test_the_page_and_the_record_are_as_the_command_writes_them(
    locks: dict[Lock, tuple[Package, ...]], record: Record
) -> None:
    assert PAGE.read_text(encoding="utf-8") == page(rows(locks, record))
    assert RECORD.read_text(encoding="utf-8") == record_text(record)


def test_a_package_of_a_refused_licence_fails(record: Record) -> None:
    copyleft = {**record, ("plyfile", "1.1.5"): Licence(GPL, "metadata")}
    package = Package("plyfile", "1.1.5", "", ("a" * 64,))
    for lock in Lock:
        (row,) = rows({lock: [package]}, copyleft)
        assert not row.allowed
        assert "NOT ALLOWED" in table([row]) and "| NO |" in page([row])
        # Nobody has looked at it.
        (row,) = rows({lock: [package]}, record)
        assert (row.licence.text, row.allowed) == ("unknown", False)


def test_the_command_tells_by_its_exit_status(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert licences.main([]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert re.fullmatch(r"\d+ packages, 0 of a licence that is not allowed", lines[-1])
    assert len(lines) - 1 == int(lines[-1].split()[0])
    package = Package("unheard-of", "1", "", ("a" * 64,))
    monkeypatch.setattr(licences, "read_lock", lambda lock: (package,))
    assert licences.main([]) == 1
    assert "NOT ALLOWED" in capsys.readouterr().out


def test_only_the_lock_for_cuda_has_what_is_not_free() -> None:
    assert is_allowed(NVIDIA, Lock.CUDA)
    assert not is_allowed(NVIDIA, Lock.CPU) and not is_allowed(NVIDIA, Lock.TESTS)


@pytest.mark.parametrize(
    ("text", "allowed"),
    [
        (text, said)
        for said, texts in {
            True: (
                "MIT|MIT OR GPL-3.0-only|GPL-3.0-only OR MIT|"
                "MIT AND (GPL-3.0-only OR BSD-3-Clause)|MIT OR BSD-3-Clause AND GPL-3.0-only|"
                "Apache-2.0 WITH LLVM-exception AND MIT|BSD License"
            ),
            False: (
                "MIT AND GPL-3.0-only|(MIT OR BSD-3-Clause) AND GPL-3.0-only|"
                "GPL-3.0-only WITH Classpath-exception-2.0|AGPL-3.0-or-later|unknown||MIT AND|(MIT|"
                "MIT MIT|OR MIT"
            ),
        }.items()
        for text in texts.split("|")
    ],
)
def test_expressions_are_read_as_spdx_means_them(text: str, allowed: bool) -> None:
    assert is_allowed(text, Lock.CPU) is allowed


@pytest.mark.parametrize(
    ("expression", "field", "classifiers", "expected"),
    [
        ("MIT AND Zlib", "whatever", ["License :: OSI Approved :: BSD License"], "MIT AND Zlib"),
        (None, "Apache 2.0", [], "Apache-2.0"),
        (None, "BSD-3-Clause", ["License :: OSI Approved :: BSD License"], "BSD-3-Clause"),
        (None, None, ["License :: OSI Approved :: ISC License (ISCL)"], "ISC"),
        (None, "UNKNOWN", ["License :: OSI Approved :: MIT License"], "MIT"),
        (None, "The MIT License (MIT)\n\nCopyright (c) someone", [], "MIT"),
        (None, "Copyright\nlong", ["License :: OSI Approved :: BSD License"], "BSD License"),
        (None, "GNU GPL\nlong", ["License :: OSI Approved :: " + GPL], GPL),
        (None, "GPL-3.0-only", [], "GPL-3.0-only"),
        (None, None, [], "unknown"),
        # Several that do not say how they go together all count.
        (None, "MIT", ["License :: OSI Approved :: " + GPL], "MIT AND " + GPL),
    ],
)
def test_metadata_of_all_kinds_are_translated(
    expression: str | None, field: str | None, classifiers: list[str], expected: str
) -> None:
    assert stated_licence("x", expression, field, classifiers) == Licence(expected, "metadata")
    assert is_allowed(expected, Lock.CPU) is ("GPL" not in expected and expected != "unknown")


def test_what_a_person_read_counts_as_long_as_the_metadata_say_the_same() -> None:
    (name, said), expected = next(item for item in READ.items() if not item[0][1])
    assert stated_licence(name, None, said, []) == Licence(expected, "read")
    assert stated_licence(name, None, "Some Other Licence", []).text == "Some Other Licence"


def test_what_is_allowed_is_named_as_spdx_names_it() -> None:
    for text in ALLOWED - {"BSD License"}:
        assert canonicalize_license_expression(text) == text

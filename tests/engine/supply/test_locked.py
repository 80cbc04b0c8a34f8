"""The entries of the locks, all of them."""

import re

import pytest
from locked import Lock, Package, parse_lock, read_lock

HASHES = ("a" * 64, "b" * 64)
TEXT = f"""# made by a tool
Some_Pack.age==1.0+cpu ; sys_platform == 'win32' \\
    --hash=sha256:{HASHES[0]} \\
    --hash=sha256:{HASHES[1]}
other==2 \\
    --hash=sha256:{HASHES[1]}
"""


def test_entries_have_name_version_marker_and_hashes() -> None:
    first, second = parse_lock(TEXT)
    assert first == Package("some-pack-age", "1.0+cpu", "sys_platform == 'win32'", HASHES)
    assert first.release == "1.0"
    assert second == Package("other", "2", "", HASHES[1:])


@pytest.mark.parametrize(
    "text", ["other==2\n", "other>=2\n", "--extra-option x\n", TEXT + "-e core\n"]
)
def test_what_is_no_entry_with_a_hash_is_an_error(text: str) -> None:
    with pytest.raises(ValueError, match=r"hash|no entry"):
        parse_lock(text)


@pytest.mark.parametrize("lock", Lock)
def test_no_entry_and_no_hash_of_a_lock_is_lost(lock: Lock) -> None:
    text = lock.path.read_text(encoding="utf-8")
    packages = read_lock(lock)
    assert len(packages) == len(re.findall(r"^\w\S*==", text, re.MULTILINE)) > 10
    assert sum(len(package.hashes) for package in packages) == text.count("--hash=")
    assert sum(bool(package.marker) for package in packages) == text.count(" ; ")

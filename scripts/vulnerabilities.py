"""Asks the OSV database whether vulnerabilities of the locked packages are known.

    python scripts/vulnerabilities.py [--service ADDRESS] [--seconds N]

Names and versions of the packages are sent, and nothing else.  Exit status: 0 none is known, 1 some
are, 2 wrong usage, 3 not checked: the database did not answer, or not for all packages.  "none is
known" is said only of packages that each had an answer.
"""

import argparse
import json
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import IntEnum
from http.client import HTTPException
from typing import Any
from urllib.error import URLError
from urllib.parse import urlsplit
from urllib.request import Request, urlopen

from locked import Lock, Package, read_lock

SERVICE = "https://api.osv.dev/v1/querybatch"
"""The database: Open Source Vulnerabilities, which has the advisories of PyPA and GitHub."""

SECONDS = 30.0

_BATCH = 500
"""Packages in one request; the service takes 1000."""

_PAGES = 20
"""Requests for more of the same packages' vulnerabilities, at most."""

_LARGEST = 1 << 26
"""Bytes of an answer, at most."""

Query = tuple[str, str]
"""Name and version."""

Ask = Callable[[Mapping[str, Any]], Any]
"""Sends a question to the service and returns its answer, both as JSON has them."""


class Status(IntEnum):
    """Exit status."""

    NONE_KNOWN = 0
    SOME_KNOWN = 1
    NOT_CHECKED = 3


class NotCheckedError(Exception):
    """The database gave no answer that can be used; the message says why, in one line."""


def queries(packages: Iterable[Package]) -> tuple[Query, ...]:
    """What is asked: each name and version once, builds of one version as one."""
    return tuple(sorted({(package.name, package.release) for package in packages}))


def known(wanted: Sequence[Query], ask: Ask) -> dict[Query, tuple[str, ...]]:
    """The identifiers of the vulnerabilities of each package, sorted; empty where none is known.

    Every package has an entry: an answer that is not of all packages is an error.

    Raises:
        NotCheckedError: no answer, or one that the service's description does not admit.
    """
    found: dict[Query, tuple[str, ...]] = {}
    for start in range(0, len(wanted), _BATCH):
        found |= _known(wanted[start : start + _BATCH], ask)
    return found


def _known(wanted: Sequence[Query], ask: Ask) -> dict[Query, tuple[str, ...]]:
    found: dict[Query, set[str]] = {query: set() for query in wanted}
    pending = dict.fromkeys(wanted, "")
    for _ in range(_PAGES):
        if not pending:
            return {query: tuple(sorted(names)) for query, names in found.items()}
        answers = _answers(ask({"queries": [_question(*q) for q in pending.items()]}), len(pending))
        following = {}
        for query, answer in zip(pending, answers, strict=True):
            found[query] |= set(_identifiers(answer.get("vulns", [])))
            if answer.get("next_page_token"):
                following[query] = answer["next_page_token"]
        pending = following
    raise NotCheckedError("the answer has no end")


def _question(query: Query, page: str) -> dict[str, Any]:
    name, version = query
    question = {"package": {"name": name, "ecosystem": "PyPI"}, "version": version}
    return {**question, "page_token": page} if page else question


def _answers(answer: object, count: int) -> list[dict[str, Any]]:
    results = answer.get("results") if isinstance(answer, dict) else None
    if not isinstance(results, list) or not all(isinstance(result, dict) for result in results):
        raise NotCheckedError("the answer is of another form")
    if len(results) != count:
        raise NotCheckedError(f"{len(results)} answers to {count} questions")
    return results


def _identifiers(entries: object) -> list[str]:
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise NotCheckedError("the answer is of another form")
    found = [entry.get("id") for entry in entries]
    if not all(isinstance(identifier, str) for identifier in found):
        raise NotCheckedError("the answer is of another form")
    return found


def asking(service: str, seconds: float) -> Ask:
    """Asks by HTTP, through the proxy that the environment names.

    Args:
        service: the address.
        seconds: how long a request may wait for the service.
    """

    def ask(question: Mapping[str, Any]) -> Any:  # noqa: ANN401 - it is what JSON has
        body = json.dumps(question).encode("utf-8")
        try:
            request = Request(service, body, {"Content-Type": "application/json"})
            with urlopen(request, timeout=seconds) as response:
                return json.loads(response.read(_LARGEST))
        except (URLError, HTTPException, OSError, ValueError) as error:
            reason = getattr(error, "reason", None) or error
            raise NotCheckedError(" ".join(str(reason).split()) or type(error).__name__) from error

    return ask


def _host(address: str) -> str:
    try:
        return urlsplit(address).hostname or address
    except ValueError:
        return address


def main(arguments: list[str]) -> int:
    """The command; returns the exit status."""
    parser = argparse.ArgumentParser(description="known vulnerabilities of the locked packages")
    parser.add_argument("--service", default=SERVICE, help="another address of the OSV database")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="the wait for an answer")
    options = parser.parse_args(arguments)
    wanted = queries(package for lock in Lock for package in read_lock(lock))
    try:
        found = known(wanted, asking(options.service, options.seconds))
    except NotCheckedError as error:
        print(f"not checked: no answer from {_host(options.service)} ({error})", file=sys.stderr)
        return Status.NOT_CHECKED
    for (name, version), identifiers in found.items():
        if identifiers:
            print(f"{name} {version}: {', '.join(identifiers)}")
    concerned = sum(bool(identifiers) for identifiers in found.values())
    if concerned:
        print(f"{concerned} of {len(wanted)} packages have known vulnerabilities")
        return Status.SOME_KNOWN
    print(f"no vulnerability is known of the {len(wanted)} packages")
    return Status.NONE_KNOWN


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""The vulnerability check: what it asks, and that no answer is never taken for a good one."""

import json
import os
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import Any

import pytest
import vulnerabilities
from locked import ROOT, Lock, Package, read_lock
from vulnerabilities import NotCheckedError, Query, Status, known, queries

WANTED = (("a", "1"), ("b", "2"), ("c", "3"))

Answer = Callable[[list[dict[str, Any]]], bytes]
"""The body that answers a list of questions."""


def body(results: list[dict[str, Any]]) -> bytes:
    return json.dumps({"results": results}).encode()


@contextmanager
def served(answer: Answer, status: int = 200) -> Iterator[tuple[str, list[dict[str, Any]]]]:
    """The address of a database on this machine, and the questions that it was asked."""
    asked: list[dict[str, Any]] = []

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            content = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            asked.extend(content["queries"])
            self.send_response(status)
            self.end_headers()
            self.wfile.write(answer(content["queries"]))

        def log_message(self, *_: object) -> None:
            """Say nothing."""

    server = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.01,))
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/", asked
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


@pytest.fixture(autouse=True)
def _no_proxy_to_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("no_proxy", "NO_PROXY"):
        monkeypatch.setenv(name, "127.0.0.1")


@pytest.fixture
def closed_port() -> int:
    """A port of this machine where nobody listens."""
    with socket.socket() as this_socket:
        this_socket.bind(("127.0.0.1", 0))
        return this_socket.getsockname()[1]


def assert_not_checked(status: int, captured: object, host: str = "127.0.0.1") -> None:
    assert status == Status.NOT_CHECKED == 3
    assert captured.out == ""
    assert captured.err.startswith(f"not checked: no answer from {host} (")
    assert captured.err.count("\n") == 1


def test_every_package_of_every_lock_is_asked_for_once(capsys: pytest.CaptureFixture[str]) -> None:
    with served(lambda asked: body([{} for _ in asked])) as (address, asked):
        assert vulnerabilities.main(["--service", address]) == Status.NONE_KNOWN == 0
    expected = {(p.name, p.release) for lock in Lock for p in read_lock(lock)}
    found = [(question["package"]["name"], question["version"]) for question in asked]
    assert set(found) == expected and len(found) == len(expected)
    assert {question["package"]["ecosystem"] for question in asked} == {"PyPI"}
    assert set().union(*asked) == {"package", "version"}
    stated = capsys.readouterr()
    assert stated.out == f"no vulnerability is known of the {len(expected)} packages\n"
    assert stated.err == ""


def test_known_ones_are_told_with_their_package(capsys: pytest.CaptureFixture[str]) -> None:
    def answer(asked: list[dict[str, Any]]) -> bytes:
        torch = {"vulns": [{"id": "PYSEC-2"}, {"id": "GHSA-1"}]}
        return body([torch if item["package"]["name"] == "torch" else {} for item in asked])

    with served(answer) as (address, asked):
        assert vulnerabilities.main(["--service", address]) == Status.SOME_KNOWN == 1
    version = next(p.release for p in read_lock(Lock.CUDA) if p.name == "torch")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"torch {version}: GHSA-1, PYSEC-2"
    assert lines[1:] == [f"1 of {len(asked)} packages have known vulnerabilities"]


def test_an_address_where_nobody_answers(
    closed_port: int, capsys: pytest.CaptureFixture[str]
) -> None:
    status = vulnerabilities.main(["--service", f"http://127.0.0.1:{closed_port}/"])
    assert_not_checked(status, capsys.readouterr())


def test_a_proxy_that_is_not_reached(closed_port: int) -> None:
    """The command as `make vulnerabilities` runs it, with its own address of the database."""
    proxy = f"http://127.0.0.1:{closed_port}"
    names = ("http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY")
    environment = {k: v for k, v in os.environ.items() if k.lower() != "no_proxy"}
    done = subprocess.run(
        [sys.executable, str(ROOT / "scripts" / "vulnerabilities.py")],
        env=environment | dict.fromkeys(names, proxy),
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 3
    assert done.stdout == ""
    assert done.stderr.startswith("not checked: no answer from api.osv.dev (")


def test_a_database_that_is_silent(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        address = f"http://127.0.0.1:{silent.getsockname()[1]}/"
        status = vulnerabilities.main(["--service", address, "--seconds", "0.2"])
    assert_not_checked(status, capsys.readouterr())


@pytest.mark.parametrize("address", ["nonsense", "http://", "ftp://127.0.0.1/x", "http://[/"])
def test_an_address_that_is_none(address: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert vulnerabilities.main(["--service", address]) == Status.NOT_CHECKED
    stated = capsys.readouterr()
    assert stated.out == "" and stated.err.startswith("not checked: no answer from ")


@pytest.mark.parametrize("status", [400, 403, 429, 500, 503])
def test_a_database_that_refuses(status: int, capsys: pytest.CaptureFixture[str]) -> None:
    with served(lambda asked: body([{} for _ in asked]), status) as (address, _):
        assert_not_checked(vulnerabilities.main(["--service", address]), capsys.readouterr())


@pytest.mark.parametrize(
    "answer",
    [
        lambda asked: b"",
        lambda asked: b"<html>please log in</html>",
        lambda asked: body([{} for _ in asked])[:-1],
        lambda asked: b"{}",
        lambda asked: b"[]",
        lambda asked: b"null",
        lambda asked: b"\xff\xfe",
        lambda asked: b'{"results": null}',
        lambda asked: body([]),
        lambda asked: body([{} for _ in asked[1:]]),
        lambda asked: body([{} for _ in asked] + [{}]),
        lambda asked: json.dumps({"results": [None for _ in asked]}).encode(),
        lambda asked: body([{"vulns": [{}]} for _ in asked]),
        lambda asked: body([{"vulns": "none"} for _ in asked]),
        lambda asked: body([{"vulns": ["none"]} for _ in asked]),
        lambda asked: body([{"vulns": None} for _ in asked]),
        lambda asked: body([{"vulns": 7} for _ in asked]),
    ],
)
def test_an_answer_of_another_form(answer: Answer, capsys: pytest.CaptureFixture[str]) -> None:
    with served(answer) as (address, _):
        status = vulnerabilities.main(["--service", address])
        assert_not_checked(status, capsys.readouterr())


def test_pages_are_asked_for_until_the_last() -> None:
    asked = []

    def ask(question: Mapping[str, Any]) -> object:
        asked.append(question["queries"])
        if len(asked) == 1:
            more = {"vulns": [{"id": "V1"}], "next_page_token": "more"}
            return {"results": [{}, more, {"vulns": [{"id": "V3"}]}]}
        return {"results": [{"vulns": [{"id": "V2"}, {"id": "V1"}]}]}

    assert known(WANTED, ask) == {WANTED[0]: (), WANTED[1]: ("V1", "V2"), WANTED[2]: ("V3",)}
    package = {"name": "b", "ecosystem": "PyPI"}
    assert asked[1:] == [[{"package": package, "version": "2", "page_token": "more"}]]


def test_pages_without_end_are_no_answer() -> None:
    def ask(question: Mapping[str, Any]) -> object:
        return {"results": [{"next_page_token": "more"} for _ in question["queries"]]}

    with pytest.raises(NotCheckedError, match="no end"):
        known(WANTED, ask)


def test_many_packages_are_asked_for_in_parts() -> None:
    wanted: tuple[Query, ...] = tuple((f"p{k}", "1") for k in range(1201))
    sizes = []

    def ask(question: Mapping[str, Any]) -> object:
        sizes.append(len(question["queries"]))
        return {
            "results": [
                {"vulns": [{"id": item["package"]["name"]}]} for item in question["queries"]
            ]
        }

    assert known(wanted, ask) == {query: (query[0],) for query in wanted}
    assert sum(sizes) == 1201 and max(sizes) <= 1000


def test_builds_of_a_version_are_one() -> None:
    builds = [Package("torch", version, "", ("a" * 64,)) for version in ("2.0", "2.0+cpu")]
    assert queries(builds) == (("torch", "2.0"),)

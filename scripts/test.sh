#!/bin/sh
# Runs the suites that the arguments name, all of them whatever the others say, and sums up.
set -u
cd "$(dirname "$0")/.." || exit 1
. scripts/steps.sh

# Style, names, what the documentation names, the order of packages, types.
lint() {
    .venv/bin/ruff check . && .venv/bin/ruff format --check . && python3 scripts/lint_names.py &&
        .venv/bin/python scripts/lint_docs.py &&
        (cd core && ../.venv/bin/lint-imports --config ../.importlinter) && .venv/bin/mypy
}

run() {
    case $1 in
    lint) lint ;;
    engine) .venv/bin/python -m pytest --quiet --numprocesses 2 --dist loadfile --max-worker-restart 0 tests/engine tests/docs tests/learning ;;
    workbench | gui) python3 tests/run_freecad_suites.py "$1" ;;
    *) fail "there is no suite '$1'" ;;
    esac
}

passed=0
failed=
for suite in "$@"; do
    say "== $suite"
    started=$(date +%s)
    if (run "$suite") </dev/null; then
        passed=$((passed + 1))
        outcome=passed
    else
        failed="$failed $suite"
        outcome=FAILED
    fi
    say "== $suite $outcome in $(($(date +%s) - started)) s"
done
if [ -n "$failed" ]; then
    fail "failed:$failed"
fi
say "all $passed suites passed"

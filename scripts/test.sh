#!/bin/sh
# Runs the suites that the arguments name, all of them whatever the others say, and sums up: which
# failed, and what was skipped and why.
set -u
cd "$(dirname "$0")/.." || exit 1
. scripts/steps.sh

skipped=build/skipped
rm -rf "$skipped"

# Style, names, what the documentation names, the order of packages, types.
lint() {
    .venv/bin/ruff check . && .venv/bin/ruff format --check . && python3 scripts/lint_names.py &&
        .venv/bin/python scripts/lint_docs.py &&
        (cd core && ../.venv/bin/lint-imports --config ../.importlinter) && .venv/bin/mypy
}

# pytest_of MARKERS [MORE]: in so many processes more than there are cores.
pytest_of() {
    .venv/bin/python -m pytest --quiet --numprocesses $(($(nproc) + ${2:-0})) --dist loadfile \
        --no-loadscope-reorder --max-worker-restart 0 --skipped-to="$skipped/engine.txt" -m "$1"
}

run() {
    case $1 in
    lint) lint ;;
    quick) .venv/bin/ruff check . && pytest_of "not slow and not window and not freecad" ;;
    engine) pytest_of "not freecad" ;;
    # FreeCAD's suites wait for windows.
    all) pytest_of "" 1 ;;
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
if [ -d "$skipped" ] && [ -n "$(cat "$skipped"/*.txt)" ]; then
    say "== skipped"
    cat "$skipped"/*.txt
fi
if [ -n "$failed" ]; then
    fail "failed:$failed"
fi
say "all $passed suites passed"

#!/bin/sh
# Makes the engine's environment in .venv from the locks.  Environment variables:
#   PYTHON   the interpreter to build on; the system's own where unset
#   TORCH    cpu or cuda; where unset the CPU build if pip is offered it, otherwise CUDA
# Stamps are written last, so that the next run repairs what an interrupted one left.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

unset PYTHONHOME PYTHONPATH
export PIP_NO_INPUT=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_USER=0
made=.venv/made     # which build .venv holds, and the fingerprint of what it was made from
linked=.venv/linked # the fingerprint of the engine's pyproject.toml when it was linked into .venv

# Prints the interpreter by the name that carries its version, so that .venv stays with it when the
# system's python3 moves on.
find_python() {
    for candidate in ${PYTHON:+"$PYTHON"} /usr/bin/python3 python3 python3.13 python3.12 python3.11; do
        "$candidate" -c '
import ensurepip, os, sys, venv
if not (3, 11) <= sys.version_info < (3, 15):
    sys.exit(1)
print(os.path.realpath(sys.executable))' 2>/dev/null && return
        [ "$candidate" != "${PYTHON:-}" ] || fail "PYTHON=$PYTHON is no Python 3.11 to 3.14 with venv"
    done
    fail "found no Python 3.11 to 3.14 with its venv module: install one and name it in PYTHON"
}

# Of the environment that the build $1 asks for: another place, Python or lock means a new one.
fingerprint() {
    { pwd && .venv/bin/python -V && cat "core/locks/engine-$1.txt" core/locks/tests.txt; } 2>&1 |
        sha256sum | cut -d ' ' -f 1
}

is_made() {
    [ -f "$made" ] || return 1
    read -r build sum <"$made"
    [ "$build" = "${TORCH:-$build}" ] && [ "$sum" = "$(fingerprint "$build")" ]
}

# The entry of PyTorch in the CPU lock, asked of pip without installing: a CPU build has a version
# of its own, so where none is offered pip says so at once and downloads nothing.
offers_cpu_build() {
    mkdir -p build
    awk '/^torch==/ { on = 1 } on { print; if (!/\\$/) exit }' core/locks/engine-cpu.txt \
        >build/torch-cpu.txt
    .venv/bin/python -m pip install --quiet --dry-run --no-deps --require-hashes \
        --requirement build/torch-cpu.txt >build/torch-cpu.log 2>&1
}

pip_install() {
    name=$1
    shift
    logged "$name" .venv/bin/python -m pip install --progress-bar off "$@"
}

make_environment() {
    python=$(find_python)
    say "Environment: making .venv with $("$python" -V)"
    rm -rf .venv
    logged venv "$python" -m venv .venv
    build=${TORCH:-}
    if [ -z "$build" ]; then
        build=cuda
        ! offers_cpu_build || build=cpu
    fi
    case $build in
    cpu) say "Engine: installing with PyTorch for the CPU, 0.8 GB to download and 3.0 GB on disk" ;;
    cuda) say "Engine: installing with PyTorch for CUDA, 3.3 GB to download and 7 GB on disk (CONTRIBUTING.md tells how to get the CPU build)" ;;
    *) fail "TORCH is cpu or cuda, not '$build'" ;;
    esac
    pip_install pip-engine --require-hashes --only-binary :all: --no-deps \
        --requirement "core/locks/engine-$build.txt"
    pip_install pip-tests --require-hashes --only-binary :all: --no-deps \
        --requirement core/locks/tests.txt
    printf '%s %s\n' "$build" "$(fingerprint "$build")" >"$made"
}

link_engine() {
    say "Engine: linking core/ into .venv"
    pip_install pip-core --no-deps --no-index --no-build-isolation --editable core
    logged check-environment .venv/bin/python scripts/check_environment.py
    say "Engine: compiling its kernels"
    logged warm-up .venv/bin/gaussiancad warm-up
    sha256sum core/pyproject.toml >"$linked"
}

if [ -L .venv ]; then
    say "Environment: .venv is a link to one of your own, taken as it is."
    exit 0
fi
is_made || make_environment
sha256sum --check --status "$linked" 2>/dev/null || link_engine

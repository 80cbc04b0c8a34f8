#!/bin/sh
# Writes core/locks/*.txt anew, with tools of their own in build/, and records the licences.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

if [ ! -x build/lock-tools/bin/uv ]; then
    logged lock-venv python3 -m venv build/lock-tools
    logged lock-pip build/lock-tools/bin/python -m pip install 'uv>=0.13,<0.14' 'pip>=25'
fi
build/lock-tools/bin/python core/locks/make_locks.py "$@"
build/lock-tools/bin/python scripts/licences.py --record

#!/bin/sh
# Writes core/locks/*.txt anew, with tools of their own in build/.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

if [ ! -x build/lock-tools/bin/uv ]; then
    logged lock-venv python3 -m venv build/lock-tools
    logged lock-pip build/lock-tools/bin/python -m pip install 'uv>=0.13,<0.14'
fi
exec build/lock-tools/bin/python core/locks/make_locks.py "$@"

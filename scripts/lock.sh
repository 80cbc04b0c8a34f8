#!/bin/sh
# Writes core/locks/*.txt anew, with tools of their own in build/, and records the licences.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
. scripts/lock_tools.sh

build/lock-tools/bin/python core/locks/make_locks.py "$@"
build/lock-tools/bin/python scripts/licences.py --record

#!/bin/sh
# Records the benchmarks that need no drawings of other people, and writes the page of figures.
set -eu
cd "$(dirname "$0")/.."
for name in exact_solid practice verified measures features surface seconds; do
    .venv/bin/python -m benchmarks "$name" --record
done
.venv/bin/python -m benchmarks --write-figures

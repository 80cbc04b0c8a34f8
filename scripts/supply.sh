#!/bin/sh
# What is known of the locked packages, by tools in an environment of their own in build/lock-tools:
#   sbom             a CycloneDX bill of materials of each lock, in build/sbom/
#   vulnerabilities  asks OSV for known vulnerabilities of all locks; what it cannot answer for is a
#                    failure, never a good answer
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh
. scripts/lock_tools.sh

tools=build/lock-tools/bin
case ${1:-} in
sbom)
    mkdir -p build/sbom
    for lock in core/locks/*.txt; do
        made=build/sbom/$(basename "$lock" .txt).json
        "$tools/cyclonedx-py" requirements --pyproject core/pyproject.toml --output-reproducible \
            --output-file "$made" "$lock" 2>build/cyclonedx.log
        say "$made"
    done
    ;;
vulnerabilities)
    status=0
    for lock in core/locks/*.txt; do
        say "== $lock"
        "$tools/pip-audit" --strict --disable-pip --require-hashes --no-deps \
            --vulnerability-service osv --requirement "$lock" 2>build/pip-audit.log || {
            tail -n 1 build/pip-audit.log >&2
            status=1
        }
    done
    exit "$status"
    ;;
*) fail "usage: scripts/supply.sh sbom|vulnerabilities" ;;
esac

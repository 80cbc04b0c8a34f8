#!/bin/sh
# Installs the Debian packages of a list, system-packages.txt where none is named, that are missing;
# needs root or sudo for that.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

list=${1:-scripts/system-packages.txt}
packages=$(sed '/^#/d; s/ .*//' "$list")

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    for command in freecadcmd freecad xvfb-run python3; do
        command -v "$command" >/dev/null ||
            fail "this is no Debian: install what $list lists; $command is missing"
    done
    say "System packages: not a Debian, taken as they are."
    exit 0
fi

missing=
for package in $packages; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail "packages are missing and only root can install them: apt-get install$missing"
fi
export DEBIAN_FRONTEND=noninteractive
say "System packages: installing$missing"
if [ -n "$(ls /var/lib/dpkg/updates)" ]; then # apt goes on only after this
    say "System packages: an installation was interrupted, finishing it"
    logged dpkg-configure as_root dpkg --configure -a
fi
logged apt-update as_root apt-get update --quiet
# shellcheck disable=SC2086 # the list is meant to be split
logged apt-install as_root apt-get install --option DPkg::Lock::Timeout=300 --yes --quiet \
    --no-install-recommends $missing

#!/bin/sh
# Runs the tests of the workbench in the FreeCAD of Debian's next release, beside the one installed
# here: in a root of its own, so that nothing on the machine changes.
#   freecad_latest.sh prepare   makes the root (2.6 GB), or does nothing where it is there
#   freecad_latest.sh test      runs the tests in it
# Both need root.  GAUSSIANCAD_FREECAD_ROOT names another place for it than /var/tmp.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

RELEASE=forky
root=${GAUSSIANCAD_FREECAD_ROOT:-/var/tmp/gaussiancad-freecad-latest}
made=$root/made-for-gaussiancad # the fingerprint of what the root was made from; written last
export LC_ALL=C.UTF-8

fingerprint() {
    { echo "$RELEASE" && cat scripts/system-packages.txt; } | sha256sum | cut -d ' ' -f 1
}

# inside MOUNTS COMMAND...: runs the command in the root.  Its mounts live in a namespace of their
# own and are gone with it: nothing can be left mounted when the root is removed.  MOUNTS lists
# further files and folders, one a line, that are there at the same path; the first is where the
# command runs.
inside() {
    mounts=$1
    shift
    # shellcheck disable=SC2016 # it is expanded inside
    unshare --mount --propagation private sh -eu -c '
        root=$1 mounts=$2 start=$(printf "%s\n" "$2" | head -n 1)
        shift 2
        mount --bind /proc "$root/proc"
        mount --rbind /dev "$root/dev"
        printf "%s\n" "$mounts" | while IFS= read -r path; do
            [ -n "$path" ] || continue
            if [ -d "$path" ]; then
                mkdir -p "$root$path"
            else
                mkdir -p "$root$(dirname "$path")"
                [ -e "$root$path" ] || : >"$root$path"
            fi
            mount --bind "$path" "$root$path"
        done
        exec chroot "$root" sh -c "cd \"\$1\" && shift && exec \"\$@\"" sh "${start:-/}" "$@"
    ' sh "$root" "$mounts" "$@"
}

prepare() {
    [ ! -f "$made" ] || [ "$(cat "$made")" != "$(fingerprint)" ] || return 0
    if ! command -v debootstrap >/dev/null; then
        logged latest-tool env DEBIAN_FRONTEND=noninteractive \
            apt-get install --yes --quiet --no-install-recommends debootstrap
    fi
    say "FreeCAD of Debian $RELEASE: making $root"
    rm -rf --one-file-system "$root"
    # Debian 12 has no script of that name yet; that of sid fits every newer release.
    logged latest-base debootstrap --variant=minbase --include=ca-certificates "$RELEASE" \
        "$root" "${DEBIAN_MIRROR:-}" /usr/share/debootstrap/scripts/sid
    # The network as it is configured here: names, certificates, apt's own options.
    for file in /etc/resolv.conf /etc/hosts /etc/ssl/certs/ca-certificates.crt; do
        [ ! -e "$file" ] || cp -L "$file" "$root$file"
    done
    cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
    logged latest-update inside '' apt-get update --quiet
    # shellcheck disable=SC2046 # the list is meant to be split
    logged latest-install inside '' env DEBIAN_FRONTEND=noninteractive apt-get install --yes \
        --quiet --no-install-recommends $(sed '/^#/d; s/ .*//' scripts/system-packages.txt)
    fingerprint >"$made"
}

# The checkout, its environment, and the Python that this was built on: the engine runs inside with
# the interpreter that it was installed for.
mounts() {
    pwd
    realpath .venv
    .venv/bin/python -c '
import os, sys, sysconfig
if sys.base_prefix == "/usr":
    print(os.path.realpath(sys.executable), sysconfig.get_path("stdlib"), sep="\n")
else:
    print(sys.base_prefix)'
}

[ "$(id -u)" -eq 0 ] || fail "only root can do this: it makes a root folder of its own and mounts into it"
case ${1:-} in
prepare) prepare ;;
test)
    [ -f "$made" ] || fail "there is no root yet: run 'freecad_latest.sh prepare' first"
    inside "$(mounts)" env GAUSSIANCAD_ARTIFACTS="$PWD/build/artifacts-latest" \
        sh scripts/test.sh workbench gui
    ;;
*) fail "usage: freecad_latest.sh prepare|test" ;;
esac

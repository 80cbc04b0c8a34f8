#!/bin/sh
# Puts the FreeCAD of Debian's next release into a root folder of its own, so that nothing on the
# machine changes; tests/freecad_latest.sh runs the tests in it.
#   freecad_latest.sh prepare   makes the root (2.9 GB), or does nothing where it is there; as root
# GAUSSIANCAD_FREECAD_ROOT names another place for it than /var/tmp, DEBIAN_MIRROR another mirror
# than debootstrap's own.
set -eu
cd "$(dirname "$0")/.."
. scripts/steps.sh

RELEASE=forky
root=${GAUSSIANCAD_FREECAD_ROOT:-/var/tmp/gaussiancad-freecad-latest}
made=$root/made-for-gaussiancad # the fingerprint of what the root was made from; written last
export LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive

fingerprint() {
    { echo "$RELEASE" && cat scripts/system-packages.txt; } | sha256sum | cut -d ' ' -f 1
}

# inside COMMAND...: runs the command in the root.  Its mounts live in a namespace of their own and
# are gone with it: nothing can be left mounted when the root is removed.
inside() {
    # shellcheck disable=SC2016 # it is expanded inside
    unshare --mount --propagation private sh -eu -c '
        root=$1
        shift
        mount --bind /proc "$root/proc"
        mount --rbind /dev "$root/dev"
        exec chroot "$root" "$@"
    ' sh "$root" "$@"
}

prepare() {
    if ! command -v debootstrap >/dev/null; then
        logged latest-tool apt-get install --yes --quiet --no-install-recommends debootstrap
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
    cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true # there may be none
    logged latest-update inside apt-get update --quiet
    # shellcheck disable=SC2046 # the list is meant to be split
    logged latest-install inside apt-get install --yes --quiet --no-install-recommends \
        $(sed '/^#/d; s/ .*//' scripts/system-packages.txt)
    fingerprint >"$made"
}

[ "${1:-}" = prepare ] || fail "usage: freecad_latest.sh prepare"
[ "$(id -u)" -eq 0 ] || fail "only root can make a root folder and mount into it"
[ "$(cat "$made" 2>/dev/null)" = "$(fingerprint)" ] || prepare

#!/bin/sh
# Runs the FreeCAD tests in the FreeCAD of Debian's next release, beside the one installed here.
#   freecad_latest.sh [workbench] [gui]
# FreeCAD lives in a root of its own, made by scripts/freecad_latest.sh on the first run.  The engine
# keeps running in the system it was installed for: inside the root, this system lies at /host, and
# a small program enters it.  All mounts live in a namespace that ends with the tests.
# Where this cannot work the last line says 'skipped: why', and the exit status is 0.
set -eu
cd "$(dirname "$0")/.."

skip() {
    printf 'skipped: %s\n' "$*"
    exit 0
}

[ "$(uname -s)" = Linux ] || skip "a root of its own needs Linux"
[ "$(id -u)" -eq 0 ] || skip "only root can make a root folder and mount into it"
command -v unshare >/dev/null || skip "unshare (util-linux) is not installed"
command -v apt-get >/dev/null || skip "this is no Debian: there is no apt-get"
unshare --mount --propagation private true 2>/dev/null || skip "mounting is not allowed here"

checkout=$(pwd)
root=${GAUSSIANCAD_FREECAD_ROOT:-/var/tmp/gaussiancad-freecad-latest}
export GAUSSIANCAD_FREECAD_ROOT="$root"
sh scripts/freecad_latest.sh prepare || skip "the root at $root could not be made; see above"

mkdir -p build
door=$checkout/build/engine-outside
cat >"$door" <<DOOR
#!/bin/sh
exec chroot /host /bin/sh -c 'cd "\$1" && shift && exec "\$@"' sh \\
    "\$PWD" '$checkout/.venv/bin/python' "\$@"
DOOR
chmod +x "$door"

# The file system of this machine is seen twice: as /host, and its /tmp and the checkout at their
# own paths, so that FreeCAD and the engine speak of the same files.
exec unshare --mount --propagation private sh -eu -c '
    root=$1 checkout=$2 door=$3
    shift 3
    mount --rbind /proc "$root/proc"
    mount --rbind /dev "$root/dev"
    mkdir -p "$root/host" "$root$checkout"
    mount --bind /tmp "$root/tmp"
    mount --bind "$checkout" "$root$checkout"
    mount --rbind / "$root/host"
    export LC_ALL=C.UTF-8 GAUSSIANCAD_PYTHON="$door"
    exec chroot "$root" sh -c "cd \"\$1\" && shift && exec \"\$@\"" sh "$checkout" \
        python3 tests/run_freecad_suites.py "$@"
' sh "$root" "$checkout" "$door" "$@"

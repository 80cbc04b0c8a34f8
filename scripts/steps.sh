# shellcheck shell=sh
# Sourced by the other scripts, from the root of the checkout: how they tell what they do.

# say TEXT: one line for the person who watches.
say() {
    printf '%s\n' "$*"
}

# fail TEXT: the last line before a script gives up.
fail() {
    printf 'error: %s\n' "$*" >&2
    exit 1
}

# logged NAME COMMAND...: runs the command with its output in build/NAME.log, and shows the end of
# that where the command fails.
logged() {
    log=build/$1.log
    shift
    mkdir -p build
    if "$@" >"$log" 2>&1 </dev/null; then
        return 0
    fi
    tail -n 25 "$log" >&2
    fail "'$*' failed; all of its output is in $log"
}

# as_root COMMAND...: runs the command as root, through sudo where that is another user.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        sudo --preserve-env=DEBIAN_FRONTEND "$@"
    fi
}

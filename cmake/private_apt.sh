# Read by scripts that fetch packages of Debian 13 ("trixie") into a folder without installing them: apt with a private list of
# sources and private state needs no privileges, checks Debian's signatures, and changes nothing outside that folder.

# begin NAME FOLDER FILE...: an empty folder to work in becomes the current one, and Debian 13's packages are known. Where FOLDER
# has each FILE nothing is left to be done, and the script ends. What apt says is in FOLDER/fetch_NAME.log.
begin() {
    mkdir -p "$2"
    folder=$(cd "$2" && pwd)
    log=$folder/fetch_$1.log
    work=$folder/.work_$1
    exec 9>"$folder/.lock_$1" && flock 9  # several build folders may share one FOLDER
    shift 2
    has_all "$@" && exit 0

    : >"$log"
    rm -rf "$work"
    mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
    cd "$work"
    command -v apt-get >/dev/null || die "Debian's sources are fetched by apt-get, which this system lacks"
    update_from_own_archive && return
    [ "${ID-}" = debian ] || die "${PRETTY_NAME-this system}'s archives have no Debian 13, from which this comes: ./dev is for Debian 12 and 13"
    die "none of this machine's apt archives serves Debian 13: check the network"
}

# finish ENTRY...: these are what was wanted; they come into FOLDER.
finish() {
    (cd "$folder" && rm -rf "$@")
    mv "$@" "$folder/"
    cd "$folder" && rm -rf "$work"
}

has_all() {
    for file; do
        [ -e "$folder/$file" ] || return 1
    done
}

die() {
    echo "$1 (see $log)${otherwise:+; or $otherwise}" >&2
    exit 1
}

private() {
    "$@" -qq -o Dir::Etc::sourcelist="$work/trixie.list" -o Dir::Etc::sourceparts=/dev/null \
        -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" -o APT::Sandbox::User="$(id -un)" \
        -o Acquire::Languages=none -o APT::Update::Error-Mode=any >>"$log" 2>&1
}

# The archives that this machine already uses are the ones it can reach. A third party's archive may be among them
# (its path can end in "debian" too), so the first that serves a trixie signed by Debian is taken.
update_from_own_archive() {
    . /etc/os-release
    for archive in $(apt-get update --print-uris -o Debug::NoLocking=1 2>>"$log" |
            sed -nE "s,^'(.*)/dists/(${VERSION_CODENAME:-trixie}|stable|testing|unstable|sid)/InRelease'.*,\1,p"); do
        for type in deb deb-src; do
            echo "$type [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $archive trixie main"
        done >"$work/trixie.list"
        private apt-get update && return
    done
    return 1
}

# source_of PACKAGE FOLDER: its source, as Debian patches it. Of a package that is just being renewed an archive may have but
# the original.
source_of() {
    private apt-get source --download-only "$1" || true
    if ls "$1"_*.dsc >/dev/null 2>&1 && dpkg-source -x "$1"_*.dsc "$2" >>"$log" 2>&1; then
        return
    fi
    rm -rf "$2"
    mkdir -p "$2"
    tar -x --strip-components=1 -C "$2" -f "$1"_*.orig.tar.*
}

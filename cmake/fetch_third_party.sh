#!/bin/sh
# Fetches Dear ImGui's source and the glad2 generator from Debian 13 ("trixie") into FOLDER, and generates glad.
#
#   cmake/fetch_third_party.sh FOLDER     leaves FOLDER/imgui and FOLDER/glad
#
# Why not install packages: the packaged ImGui loads GL from libGL, which is not the library that OSMesa draws with,
# and Debian 12 has neither this ImGui nor glad2.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
exec 9>"$folder/.lock" && flock 9        # several build folders may share one FOLDER
[ ! -e "$folder/imgui/imgui.h" ] || [ ! -e "$folder/glad/src/gl.c" ] || exit 0

work=$folder/.work
log=$folder/fetch.log
rm -rf "$work" "$folder/imgui" "$folder/glad"
mkdir -p "$work"
: >"$log"
. "$here/private_apt.sh"
cd "$work"

die() {
    echo "$1 (see $log); or set NORMALSCOPE_IMGUI_DIR and NORMALSCOPE_GLAD_DIR, see cmake/third_party.cmake" >&2
    exit 1
}

command -v apt-get >/dev/null || die "Dear ImGui and glad are fetched by apt-get, which this system lacks"
update_from_own_archive || die "none of this machine's apt archives serves Debian 13: check the network"

source_of imgui imgui || die "Dear ImGui's source could not be fetched"

private apt-get download python3-glad && dpkg-deb -x python3-glad_*.deb generator &&
    PYTHONPATH=generator/usr/lib/python3/dist-packages python3 -m glad --quiet --reproducible --out-path glad \
        --api gl:core=3.3 --extensions GL_KHR_debug c >>"$log" 2>&1 ||
    die "glad could not be fetched or run (it needs python3-jinja2)"

mv imgui glad "$folder/"
cd "$folder" && rm -rf "$work"

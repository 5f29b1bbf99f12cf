#!/bin/sh
# Fetches into FOLDER the sources of what a program for other systems brings along, from Debian 13 ("trixie").
#
#   cmake/fetch_portable.sh FOLDER     leaves FOLDER/portable, which cmake/portable.cmake takes
#
# GLFW 3.4 opens X11 and Wayland, whichever is there, at run time, which Debian 12's 3.3 does not; zlib and libpng are for
# Windows, for which Debian has no libpng.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
exec 7>"$folder/.portable_lock" && flock 7   # several build folders may share one FOLDER
[ ! -e "$folder/portable/complete" ] || exit 0

work=$folder/.portable_work
log=$folder/fetch_portable.log
rm -rf "$work" "$folder/portable"
mkdir -p "$work/portable"
: >"$log"
. "$here/private_apt.sh"
cd "$work"

die() {
    echo "$1 (see $log)" >&2
    exit 1
}

command -v apt-get >/dev/null || die "GLFW's source is fetched by apt-get, which this system lacks"
update_from_own_archive || die "none of this machine's apt archives serves Debian 13: check the network"
for package in glfw3 zlib libpng1.6; do
    source_of $package "portable/$package" || die "$package's source could not be fetched"
done

touch portable/complete
mv portable "$folder/"
cd "$folder" && rm -rf "$work"

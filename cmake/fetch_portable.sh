#!/bin/sh
# Fetches into FOLDER the sources of what a program for other systems brings along, from Debian 13 ("trixie").
#
#   cmake/fetch_portable.sh FOLDER     leaves FOLDER/portable, which cmake/portable.cmake takes
#
# GLFW 3.4 opens X11 and Wayland, whichever is there, at run time, which Debian 12's 3.3 does not; zlib and libpng are for
# systems for which Debian has no libpng.
set -eu

. "$(dirname "$0")/private_apt.sh"
begin portable "$1" portable/complete
mkdir portable
for package in glfw3 zlib libpng1.6; do
    source_of $package "portable/$package" || die "$package's source could not be fetched"
done
touch portable/complete
finish portable

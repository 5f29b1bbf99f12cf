#!/bin/sh
# Fetches Dear ImGui's source and the glad2 generator from Debian 13 ("trixie") into FOLDER, and generates glad.
#
#   cmake/fetch_third_party.sh FOLDER     leaves FOLDER/imgui and FOLDER/glad
#
# Why not install packages: the packaged ImGui loads GL from libGL, which is not the library that OSMesa draws with,
# and Debian 12 has neither this ImGui nor glad2.
set -eu

. "$(dirname "$0")/private_apt.sh"
otherwise="set NORMALSCOPE_IMGUI_DIR and NORMALSCOPE_GLAD_DIR, see cmake/third_party.cmake"
begin third_party "$1" imgui/imgui.h glad/src/gl.c

source_of imgui imgui || die "Dear ImGui's source could not be fetched"

private apt-get download python3-glad && dpkg-deb -x python3-glad_*.deb generator &&
    PYTHONPATH=generator/usr/lib/python3/dist-packages python3 -m glad --quiet --reproducible --out-path glad \
        --api gl:core=3.3 --extensions GL_KHR_debug c >>"$log" 2>&1 ||
    die "glad could not be fetched or run (it needs python3-jinja2)"

finish imgui glad

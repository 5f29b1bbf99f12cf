#!/bin/sh
# One image test, as cmake/testing.cmake calls it:
#
#   image_test.sh NORMALSCOPE FOLDER BASELINE "COMPARE OPTIONS" CAPTURE ARGUMENTS...
#
# FOLDER is left with actual.png, expected.png and difference.png. With NORMALSCOPE_UPDATE_BASELINES set, the baseline
# is rewritten instead.
set -eu
normalscope=$1 folder=$2 baseline=$3 compare_options=$4
shift 4

rm -rf "$folder"
mkdir -p "$folder"
"$normalscope" capture "$@" -o "$folder/actual.png"

if [ -n "${NORMALSCOPE_UPDATE_BASELINES-}" ]; then
    mkdir -p "$(dirname "$baseline")"
    cp "$folder/actual.png" "$baseline"
    exit
fi
if [ ! -e "$baseline" ]; then
    echo "there is no baseline $baseline: ./dev baselines writes it" >&2
    exit 1
fi
cp "$baseline" "$folder/expected.png"
# shellcheck disable=SC2086  # several options
"$normalscope" compare "$folder/actual.png" "$folder/expected.png" $compare_options --diff "$folder/difference.png"

#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build and moves it elsewhere, builds the projects beside this script against it and
# runs a pipeline of their plugins, as somebody would who has nothing but the installed SDK.
#   sdk.sh BUILD_FOLDER CMAKE COMPILER
set -euo pipefail
build=$1 cmake=$2 compiler=$3
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset XGM_PLUGIN_PATH CMAKE_BUILD_TYPE CXXFLAGS

claim() { echo "-- $*"; }
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

claim "what is installed works wherever it lies, and knows nothing of where it was built"
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/sdk"
sdk=$work/sdk
if grep -rlF -e "$source" -e "$build" --include='*.cmake' "$sdk"; then
  fail "the files above name the source or the build folder"
fi
headers_of() { (cd "$1" && find xgm -name '*.hpp' | sort); }
for room in "$source"/framework/*/include; do
  case $room in */geo/include) [ -e "$build/lib/libxgm_geo.so" ] || continue ;; esac  # no GDAL
  headers_of "$room"
done | sort |
  diff - <(headers_of "$sdk/include") || fail "headers differ"
(cd "$source/pipelines" && ls) | diff - <(ls "$sdk/share/xgm/pipelines") || fail "pipelines differ"
cd "$work"
"$sdk/bin/pipeline" check sgm8.yaml >/dev/null || fail "a shipped pipeline is not found"

claim "the cost function's own code is at most 40 lines"
lines=$(grep -cvE '^ *(//.*)?$' "$here/project/squared_difference.cpp")
[ "$lines" -le 40 ] || fail "it is $lines lines"

# Configures the project beside this script, $1, in the folder $2 against the prefix $3.
configure() {
  local project=$1 folder=$2 prefix=$3
  shift 3
  "$cmake" -S "$here/$project" -B "$folder" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" >configure.log 2>&1
}
build() {
  "$cmake" --build "$1" >build.log || { cat build.log; fail "$1 does not build"; }
}
# Whether CMake ended with a message that has these words, wherever it broke the lines.
told() { tr -s ' \n' ' ' <configure.log | grep -qF "$1"; }
does_not_configure() { cat configure.log; fail "it does not configure"; }

claim "the component core can be installed alone: nothing of the other rooms is there"
"$cmake" --install "$build" --component core --prefix "$work/core" >/dev/null
headers_of "$source/framework/core/include" | diff - <(headers_of core/include) ||
  fail "headers differ"
[ -z "$(find core -name 'libxgm_*' -o -path '*/bin/*')" ] || fail "there is more than core"

claim "plugins build against the core alone, optimised although no build type is named"
configure project plugins "$work/core" -DBUILD_TESTING=OFF || does_not_configure
plugins=$(grep -c '^xgm_add_plugin' "$here/project/CMakeLists.txt")
[ "$(grep -cE ' -O[23] .*-DNDEBUG' plugins/compile_commands.json)" = "$plugins" ] ||
  { cat plugins/compile_commands.json; fail "some plugins are not optimised"; }
build plugins

claim "a component that is not installed is named, and so is one that does not exist"
! configure rooms missing "$work/core" -DROOMS=testing || fail "it configures"
told "xgm's component 'testing' cannot be used" && told "not installed: synthesis, testing." ||
  does_not_configure
! configure rooms missing "$work/core" -DROOMS=tasting || fail "it configures"
told "xgm has no component 'tasting'; its components are core, " || does_not_configure

claim "find_package(xgm) gives the core, its components give further rooms and what they need"
configure rooms rooms "$sdk" || does_not_configure
told "rooms found: xgm;core " || does_not_configure
for prefix in "$build" "$sdk"; do
  rm -r rooms
  configure rooms rooms "$prefix" -DROOMS="evaluation;testing" || does_not_configure
  told "rooms found: xgm;core;evaluation;synthesis;testing " || does_not_configure
done
build rooms
rooms/error_of_truth >/dev/null || fail "a program of evaluation and testing fails"

claim "the plugins keep the contracts of their kinds; a build type that is named is kept"
configure project contracts "$sdk" -DCMAKE_BUILD_TYPE=Debug || does_not_configure
! grep -q ' -O[123]' contracts/compile_commands.json || fail "Debug is optimised"
build contracts
(cd contracts && "$(dirname "$cmake")/ctest" --output-on-failure) >contract.log ||
  { cat contract.log; fail "its tests fail"; }
symbols=$(nm -DC --defined-only plugins/xgm_trim_border.so | grep -c ' T ') || true
[ "$symbols" = 1 ] || fail "a plugin shows $symbols functions instead of one"

run() {
  "$sdk/bin/pipeline" run "$here/project/my_pipeline.yaml" "$@" >run.log 2>&1 || return $?
}
valid_share() { sed -nE 's/.*"valid_share": *([0-9.]+).*/\1/p' "$1/run.json" | head -n 1; }

claim "--plugin FILE loads them, and the pipeline finds the sample pair's disparities"
run --output by_option --plugin plugins/xgm_squared_difference.so \
  --plugin plugins/xgm_trim_border.so --plugin plugins/xgm_upside_down.so ||
  { cat run.log; fail "it does not run"; }
share=$(valid_share by_option)
awk -v share="$share" 'BEGIN { exit !(share > 0.5) }' || fail "valid share is '$share'"

claim "XGM_PLUGIN_PATH loads them, beside a broken file that nothing uses, with the same result"
echo junk >plugins/junk.so
XGM_PLUGIN_PATH=$work/plugins run --output by_path || { cat run.log; fail "it does not run"; }
cmp by_option/disparity.pfm by_path/disparity.pfm
grep -qF "$work/plugins/junk.so" run.log || fail "nobody is told of the broken file"

claim "a broken file that is used is named with the reason, and no image is opened (exit 2)"
mv plugins/xgm_trim_border.so hidden.so
head -c 1000 "$here/sdk.sh" >plugins/xgm_trim_border.so
echo "not an image: opening it would be the error" >no_image.png
status=0
XGM_PLUGIN_PATH=$work/plugins run --output broken --left no_image.png --right no_image.png ||
  status=$?
[ $status = 2 ] || { cat run.log; fail "exit $status"; }
grep -q "my_pipeline.yaml:18:12: error: .*trim_border.*could not be loaded" run.log &&
  grep -q "$work/plugins/xgm_trim_border.so: .*ELF" run.log ||
  { cat run.log; fail "path or reason is missing"; }

claim "without the plugins the names are unknown (exit 2)"
status=0
run --output none || status=$?
[ $status = 2 ] || { cat run.log; fail "exit $status"; }
grep -q "there is no matcher called 'upside_down'" run.log || { cat run.log; fail "message"; }

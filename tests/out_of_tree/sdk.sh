#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build, moves it elsewhere, builds the project beside this script against it and runs
# a pipeline of its plugins, as somebody would who has nothing but the installed SDK.
#   sdk.sh BUILD_FOLDER CMAKE COMPILER
set -euo pipefail
build=$1 cmake=$2 compiler=$3
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset XGM_PLUGIN_PATH

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
(cd "$source/framework/include" && find xgm -name '*.hpp' | sort) >"$work/headers"
(cd "$sdk/include" && find xgm -type f | sort) | diff "$work/headers" - || fail "headers differ"
(cd "$source/pipelines" && ls) | diff - <(ls "$sdk/share/xgm/pipelines") || fail "pipelines differ"
cd "$work"
"$sdk/bin/pipeline" check sgm8.yaml >/dev/null || fail "a shipped pipeline is not found"

claim "the cost function's own code is at most 40 lines"
lines=$(grep -cvE '^ *(//.*)?$' "$here/project/squared_difference.cpp")
[ "$lines" -le 40 ] || fail "it is $lines lines"

claim "find_package(xgm) and xgm_add_plugin build a project against it"
cp -r "$here/project" "$work/project"
"$cmake" -S project -B plugins -DCMAKE_PREFIX_PATH="$sdk" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" >configure.log ||
  { cat configure.log; fail "it does not configure"; }
"$cmake" --build plugins >build.log || { cat build.log; fail "it does not build"; }
(cd plugins && "$(dirname "$cmake")/ctest" --output-on-failure) >contract.log ||
  { cat contract.log; fail "its tests fail"; }
symbols=$(nm -DC --defined-only plugins/xgm_trim_border.so | grep -c ' T ') || true
[ "$symbols" = 1 ] || fail "a plugin shows $symbols functions instead of one"

run() {
  "$sdk/bin/pipeline" run project/my_pipeline.yaml "$@" >run.log 2>&1 || return $?
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

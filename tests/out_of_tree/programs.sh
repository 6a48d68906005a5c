#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build, builds the programs of docs/use_from_cpp.md against it and runs them.
#   programs.sh BUILD_FOLDER CMAKE COMPILER
set -euo pipefail
build=$1 cmake=$2 compiler=$3
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

claim() { echo "-- $*"; }
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

claim "find_package(xgm) builds them"
"$cmake" --install "$build" --prefix sdk >/dev/null
"$cmake" -S "$here/programs" -B programs -DCMAKE_PREFIX_PATH="$work/sdk" \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" \
  >configure.log 2>&1 || { cat configure.log; fail "they do not configure"; }
"$cmake" --build programs >build.log || { cat build.log; fail "they do not build"; }

claim "the smallest one matches the sample pair, and writes the files that the program writes"
programs/match_sample >sample.txt || fail "it does not run"
grep -qE "^disparity at \(320, 240\): [0-9.]+ px$" sample.txt || { cat sample.txt; fail "output"; }
sdk/bin/pipeline run sgm8 --output by_program >/dev/null 2>&1
for file in disparity.pfm disparity.png status.png; do
  cmp "sample/$file" "by_program/$file" || fail "$file differs"
done

claim "files and folders are matched; mistakes are told with exit code 2, failures with 1"
sdk/bin/pipeline synth scenes --size 160x120 --disparities 0:15 >/dev/null
scene=scenes/scene_0001
programs/match_files sgm8 $scene/im0.png $scene/im1.png 15 >by_files.txt || fail "two files"
mv found by_files
programs/match_files sgm8 $scene >/dev/null || fail "a scene"
cmp by_files/disparity.pfm found/disparity.pfm || fail "file and folder differ"
rm -r found
exit_of() {
  local status=0
  "$@" >said.txt 2>&1 || status=$?
  echo $status
}
[ "$(exit_of programs/match_files sgm9 $scene)" = 2 ] || fail "unknown pipeline"
grep -q "did you mean 'sgm8.yaml'" said.txt || { cat said.txt; fail "no suggestion"; }
[ "$(exit_of programs/match_files sgm8 nowhere)" = 2 ] || fail "no scene"
[ "$(exit_of programs/match_files sgm8 $scene/im0.png nowhere.png 15)" = 2 ] || fail "no image"
echo junk >junk.png
[ "$(exit_of programs/match_files sgm8 $scene/im0.png junk.png 15)" = 1 ] || fail "junk"
[ ! -e found ] || fail "a run that failed has written something"

claim "images in memory are matched"
programs/match_in_memory >memory.txt || { cat memory.txt; fail "it does not run"; }
grep -q "^found: 7 px$" memory.txt || { cat memory.txt; fail "the wrong disparity"; }

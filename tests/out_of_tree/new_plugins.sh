#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Begins a plugin of each kind with the installed program, and builds and tests all of them against
# the installed SDK, untouched.
#   new_plugins.sh BUILD_FOLDER CMAKE COMPILER
set -euo pipefail
build=$1 cmake=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset XGM_PLUGIN_PATH CMAKE_BUILD_TYPE CXXFLAGS
cd "$work"

claim() { echo "-- $*"; }
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

claim "there is a folder for each kind that has a template, with a name of its own"
"$cmake" --install "$build" --prefix sdk >/dev/null
kinds=$(cd sdk/share/xgm/new_plugin && ls */my_plugin.cpp | cut -d/ -f1)
for kind in $kinds; do
  sdk/bin/pipeline new-plugin "$kind" "own_$kind" >/dev/null || fail "$kind"
done
! grep -riE "my_plugin|MyPlugin|my_kind|SPDX" own_* || fail "these are words of the template"

claim "all build against the installed SDK without a warning"
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(all LANGUAGES CXX)
enable_testing()
file(GLOB plugins LIST_DIRECTORIES true own_*)
foreach(plugin \${plugins})
  add_subdirectory(\${plugin})
endforeach()
END
"$cmake" -B build -DCMAKE_PREFIX_PATH="$work/sdk" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" >configure.log 2>&1 ||
  { cat configure.log; fail "they do not configure"; }
"$cmake" --build build -j2 >build.log 2>&1 || { cat build.log; fail "they do not build"; }

claim "all pass their tests"
(cd build && "$(dirname "$cmake")/ctest" --output-on-failure) >test.log 2>&1 ||
  { cat test.log; fail "their tests fail"; }
[ "$(grep -c ' Passed ' test.log)" = "$(wc -w <<<"$kinds")" ] || { cat test.log; fail "not all ran"; }

claim "all are described, and their pipelines are sound"
for kind in $kinds; do
  plugin=build/own_$kind/xgm_own_$kind.so
  sdk/bin/pipeline describe "$kind/own_$kind" --plugin "$plugin" >/dev/null || fail "$kind"
  [ ! -e "own_$kind/pipeline.yaml" ] ||
    sdk/bin/pipeline check "own_$kind/pipeline.yaml" --plugin "$plugin" >/dev/null || fail "$kind"
done

claim "a pipeline matches the sample pair with its plugin"
sdk/bin/pipeline run own_cost/pipeline.yaml --plugin build/own_cost/xgm_own_cost.so >run.log 2>&1 ||
  { cat run.log; fail "it does not run"; }

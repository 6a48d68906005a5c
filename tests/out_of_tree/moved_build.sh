#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A build tree may be moved: bin, lib and share work from elsewhere, with what lies beside them.
#   moved_build.sh BUILD_FOLDER
set -euo pipefail
build=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset XGM_PLUGIN_PATH LD_LIBRARY_PATH

claim() { echo "-- $*"; }
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

mkdir -p "$work/moved/bin"
cp -P "$build"/bin/pipeline "$work/moved/bin"
cp -RP "$build/lib" "$build/share" "$work/moved"
mv "$work/moved" "$work/again"
cd "$work"
pipeline=again/bin/pipeline

claim "the program uses the libraries and pipelines beside it"
LD_DEBUG=libs $pipeline list >list.txt 2>libs.txt || fail "list"
grep -q "census" list.txt || fail "no census"
! grep -F "$build" libs.txt || fail "it looks where it was built"
$pipeline check sgm8 >check.txt || fail "sgm8 is not found"
[ "$(cat check.txt)" = "$work/again/share/xgm/pipelines/sgm8.yaml: ok" ] || fail "$(cat check.txt)"
$pipeline run sgm8 --output out >/dev/null 2>&1 || fail "sgm8 does not run"
[ -e out/run.json ] || fail "no record"

claim "no path of the source tree's pipelines is compiled in"
! grep -lF "$(cd "$here/../.." && pwd)/pipelines" again/bin/pipeline again/lib/*.so ||
  fail "the files above name it"

claim "plugin files in lib/xgm/plugins are loaded without being asked for"
mkdir -p again/lib/xgm/plugins
cp "$build/tests/example_plugins/xgm_trim_border.so" again/lib/xgm/plugins
$pipeline describe trim_border >/dev/null || fail "trim_border is not there"
$pipeline list filter | grep -q "trim_border .*again/lib/xgm/plugins/xgm_trim_border.so" ||
  fail "nobody says where it comes from"

claim "without shipped pipelines the message says so"
rm -r again/share
status=0
$pipeline check sgm8 2>said.txt || status=$?
[ $status = 2 ] && grep -q "none are shipped beside $work/again/lib/libxgm.so" said.txt ||
  { cat said.txt; fail "exit $status"; }

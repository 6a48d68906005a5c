# SPDX-License-Identifier: Apache-2.0
# On this machine: stopped in the middle and started again, the finished jobs are not done anew.
run_workflow --cores 2 --resources mem_mb=4000 >"$work/first.log" 2>&1 &
workflow_pid=$!
for _ in $(seq 600); do
  [ "$(finished)" -ge 3 ] && break
  sleep 0.1
done
kill -INT "$workflow_pid" 2>/dev/null || true
wait "$workflow_pid" || true
before=$(finished)
[ "$before" -ge 3 ] || { cat "$work/first.log"; fail "no job was done"; }
find "$work/jobs/jobs" -name '*.json' -printf '%p %T@\n' | sort >"$work/before"
run_workflow --cores 2 --resources mem_mb=4000 --rerun-incomplete >"$work/second.log" 2>&1 ||
  { cat "$work/second.log"; fail "the workflow failed"; }
find "$work/jobs/jobs" -name '*.json' -printf '%p %T@\n' | sort >"$work/after"
again=$(comm -23 "$work/before" "$work/after" | wc -l)
[ "$again" = 0 ] || fail "$again finished jobs were done anew"
check_result

# SPDX-License-Identifier: Apache-2.0
# On Slurm: a node is killed in the middle, and a job for its memory; the workflow is stopped and
# started again. Finished jobs are not done anew, and the map is the same.
start_slurm
slurm_workflow() {
  run_workflow "pipeline=$work/pipeline" --profile "$workflow/slurm" --jobs 4 --latency-wait 20 \
    --rerun-incomplete "$@"
}

# Takes more memory than was asked for when the job is first tried.
cat >"$work/pipeline" <<PROGRAM
#!/bin/bash
if [ "\$2 \$4" = "run tile_2_2" ] && mkdir "$work/was_hungry" 2>/dev/null; then
  head -c 900M /dev/zero | tail -c 900M | sleep 15
  exit 1
fi
exec "$pipeline" "\$@"
PROGRAM
chmod +x "$work/pipeline"

kill_node() {  # with what runs on it
  kill -9 "$(cat "$work/d.$1.pid")"
  for environment in /proc/[0-9]*/environ; do
    if grep -qzx "SLURMD_NODENAME=$1" "$environment" 2>/dev/null; then
      kill -9 "$(basename "$(dirname "$environment")")" 2>/dev/null || true
    fi
  done
}
wait_for() {  # so many finished jobs
  for _ in $(seq 900); do
    [ "$(finished)" -ge "$1" ] && return
    sleep 0.1
  done
  cat "$work"/*.log
  fail "$1 jobs were not done"
}

slurm_workflow >"$work/first.log" 2>&1 &
workflow_pid=$!
wait_for 2
kill_node n2
wait_for 4
kill -INT "$workflow_pid"
wait "$workflow_pid" || true
start_node n2
scancel --user "$(id -un)"
find "$work/jobs/jobs" -name '*.json' -printf '%p %T@\n' | sort >"$work/before"
slurm_workflow >"$work/second.log" 2>&1 || { cat "$work/second.log"; fail "the workflow failed"; }
find "$work/jobs/jobs" -name '*.json' -printf '%p %T@\n' | sort >"$work/after"
again=$(comm -23 "$work/before" "$work/after" | wc -l)
[ "$again" = 0 ] || fail "$again finished jobs were done anew"
grep -qhi 'exceeded memory limit' "$work"/d.*.log "$work/ctld.log" "$work"/slurm-*.out ||
  fail "no job was killed for its memory"
check_result

# SPDX-License-Identifier: Apache-2.0
# A Slurm of two nodes on the loopback interface, started and stopped here.
start_node() { slurmd -f "$work/slurm.conf" -N "$1"; }

start_slurm() {
  mkdir -p "$work/state" "$work/spool.n1" "$work/spool.n2" /run/munge
  chmod 755 "$work"
  chown munge /run/munge
  [ -f /etc/munge/munge.key ] || { dd if=/dev/urandom of=/etc/munge/munge.key bs=1 count=1024 2>/dev/null; chown munge /etc/munge/munge.key; chmod 400 /etc/munge/munge.key; }
  pgrep -x munged >/dev/null || { runuser -u munge -- munged; touch "$work/own_munged"; }
  cat >"$work/slurm.conf" <<CONF
ClusterName=xgm
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=17000
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/linux
JobAcctGatherFrequency=1
JobAcctGatherParams=OverMemoryKill
SlurmdTimeout=10
ReturnToService=2
MessageTimeout=10
MinJobAge=60
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool.%n
SlurmctldPidFile=$work/ctld.pid
SlurmdPidFile=$work/d.%n.pid
SlurmctldLogFile=$work/ctld.log
SlurmdLogFile=$work/d.%n.log
NodeName=n[1-2] NodeHostname=$(hostname) NodeAddr=127.0.0.1 Port=[17001-17002] CPUs=1 RealMemory=4000 State=UNKNOWN
PartitionName=p Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$work/slurm.conf
  slurmctld -f "$work/slurm.conf"
  start_node n1
  start_node n2
}

stop_slurm() {
  local pids=()
  for file in "$work"/d.*.pid "$work/ctld.pid"; do
    if [ -f "$file" ]; then pids+=("$(cat "$file")"); fi
  done
  kill "${pids[@]}" 2>/dev/null
  if [ -f "$work/own_munged" ]; then pkill -x munged; fi
  for _ in $(seq 100); do  # they write their state before they end
    local running=0
    for pid in "${pids[@]}"; do
      grep -qs '^State:[[:space:]]*[^ZX[:space:]]' "/proc/$pid/status" && running=1
    done
    [ "$running" = 0 ] && return
    sleep 0.1
  done
}

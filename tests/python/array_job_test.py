"""The array job of docs/how-to/clusters-and-stores.md: its merged parts equal the race on one machine. It runs as a
script and on a real Slurm."""

import contextlib
import os
import shutil
import socket
import subprocess
from pathlib import Path

import labmouse
import pytest

ORDER = dict(mice="flood,random", mazes=["contest-01", "contest-02"], runs=100)
SECONDS = 60
DAEMONS = ["munged", "slurmctld", "slurmd"]
#: One node with two processors, whatever the machine has. It starts jobs without delay.
CONFIGURATION = """
ClusterName=lab
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={control}
SlurmdPort={node}
SlurmUser=root
SlurmdUser=root
MessageTimeout=100
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,batch_sched_delay=0
SlurmdParameters=config_overrides
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A working folder with the script of the page."""
    page = (Path(__file__).resolve().parents[2] / "docs" / "how-to" / "clusters-and-stores.md").read_text(encoding="utf-8")
    script = next(block for block in page.split("```sh\n") if "--shard" in block.split("```")[0])
    (tmp_path / "race.sh").write_text(script.split("```")[0])
    monkeypatch.chdir(tmp_path)
    return tmp_path


def is_the_race_of_one_machine(folder, command):
    command("store", "merge", *sorted(str(file) for file in folder.glob("part-*.db")), "-o", "all.db")
    race = labmouse.race(**ORDER, store="all.db")
    assert race.from_store == len(race.table) == 202
    alone = labmouse.race(**ORDER)
    timing = "microseconds_per_decision"
    assert race.table.drop(columns=timing).equals(alone.table.drop(columns=timing))


def test_the_script_holds_all_parts(folder, command):
    for part in range(1, 65):
        subprocess.run(["sh", "race.sh"], check=True, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(part)})
    is_the_race_of_one_machine(folder, command)


def free_ports(number):
    with contextlib.ExitStack() as open_until_all_are_found:
        sockets = [open_until_all_are_found.enter_context(socket.socket()) for _ in range(number)]
        for free in sockets:
            free.bind(("127.0.0.1", 0))
        return [free.getsockname()[1] for free in sockets]


@pytest.fixture
def slurm(tmp_path_factory):
    """A Slurm of one node; the environment of its commands."""
    if "LABMOUSE_PROOF" not in os.environ:
        pytest.skip("a real Slurm belongs to make proof")
    for daemon in DAEMONS:
        if not shutil.which(daemon):
            pytest.skip(f"no {daemon}: Debian's slurm-wlm and munge have what a real Slurm needs")
    if os.geteuid() != 0:
        pytest.skip("a real Slurm needs root here")
    own = tmp_path_factory.mktemp("slurm")
    control, node = free_ports(2)
    configuration = own / "slurm.conf"
    configuration.write_text(CONFIGURATION.format(host=socket.gethostname().split(".")[0], control=control, node=node, folder=own))
    (own / "state").mkdir()
    (own / "munge.key").write_bytes(os.urandom(128))
    (own / "munge.key").chmod(0o600)
    files = {"key-file": "key", "socket": "socket", "pid-file": "pid", "log-file": "log", "seed-file": "seed"}
    environment = {**os.environ, "SLURM_CONF": str(configuration)}
    started = []
    # munged returns once it listens; the other daemons wait for each other.
    subprocess.run(["munged", "--force", *(f"--{option}={own}/munge.{ending}" for option, ending in files.items())], check=True,
                   timeout=SECONDS)
    try:
        for words in (["slurmctld", "-D"], ["slurmd", "-D"]):
            started.append(subprocess.Popen(words, env=environment, stderr=subprocess.DEVNULL))
        yield environment
    finally:
        for daemon in reversed(started):
            daemon.terminate()
        for daemon in reversed(started):
            daemon.wait(SECONDS)
        subprocess.run(["munged", "--stop", f"--socket={own}/munge.socket"], check=True, timeout=SECONDS)


def test_slurm_holds_all_parts(slurm, folder, command):
    subprocess.run(["sbatch", "--wait", "race.sh"], check=True, env=slurm, timeout=10 * SECONDS)
    is_the_race_of_one_machine(folder, command)

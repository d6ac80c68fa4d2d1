# SPDX-License-Identifier: MIT
"""Sweeps by MPI ranks, and by Slurm jobs under daemons of their own: the same bytes as by luxel sweep alone.

Arguments: luxel, then luxel-sweep-mpi or "none", then the folder of the job scripts.  What is not installed is skipped.
"""
import hashlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import time

from tap import Tap
from tool import run_tests

STUDY = """study: 1
scene: report
set: ['screen.resolution=[40,40]']
count: 900
shard: 30
vary: [{key: 'lights[0].position', random: box, from: [-2000, -2000, 1500], to: [2000, 2000, 4000]}]
outputs: {brightness: float32, mask: uint8}
"""
MPI = sys.argv[2] if sys.argv[2] == "none" else os.path.abspath(sys.argv[2])
SCRIPTS = os.path.abspath(sys.argv[3])
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
           "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
# Open MPI gives back not all that it takes: with sanitizers only other faults of memory count.
if "LUXEL_SANITIZED" in os.environ:
    AS_ROOT["ASAN_OPTIONS"] = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"


def sums(tool, folder):
    found = {}
    for where, _, names in os.walk(tool.file(folder)):
        for name in names:
            with open(os.path.join(where, name), "rb") as file:
                path = os.path.relpath(os.path.join(where, name), tool.file(folder))
                found[path] = hashlib.sha256(file.read()).hexdigest()
    return found


def start_ranks(tool, ranks, folder, *more):
    return subprocess.Popen(["mpirun", "--oversubscribe", "-n", str(ranks), MPI, "s.yaml", "-o", folder, *more],
                            cwd=tool.folder, env={**os.environ, **AS_ROOT, "LC_ALL": "C.UTF-8"},
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def mpi(tap, tool):
    if MPI == "none" or not shutil.which("mpirun"):
        tap.skip("sweeps by MPI", "no MPI")
        return
    tool.write("s.yaml", STUDY)
    tool.run("sweep", "s.yaml", "-o", "alone", "-q")
    expected = sums(tool, "alone")
    tap.equal(len(expected), 1 + 30 * 4, "a sweep alone")
    for ranks in (1, 3):
        process = start_ranks(tool, ranks, "of%d" % ranks)
        text = process.communicate(timeout=120)[0]
        tap.equal((process.returncode, "30 of 30" in text), (0, True), "%d ranks" % ranks)
        tap.ok(sums(tool, "of%d" % ranks) == expected, "the same bytes", text)
    tool.write("s.yaml", STUDY.replace("900", "9000").replace("shard: 30", "shard: 60"))
    process = start_ranks(tool, 2, "dies", "-q")
    end = time.monotonic() + 60
    while not os.path.exists(tool.file("dies/shard-000004")) and time.monotonic() < end:
        time.sleep(0.005)
    children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True, check=False).stdout
    os.kill(int(children.split()[-1]), signal.SIGKILL)
    process.communicate(timeout=120)
    tap.ok(process.returncode != 0, "a rank that dies ends the job")
    before = {name: os.stat(tool.file("dies/" + name)).st_ino for name in os.listdir(tool.file("dies"))
              if name.startswith("shard-")}
    tap.ok(len(before) >= 4, "what was done is there", len(before))
    process = start_ranks(tool, 3, "dies", "-q")
    process.communicate(timeout=120)
    tool.run("sweep", "s.yaml", "-o", "alone9000", "-q")
    tap.ok(sums(tool, "dies") == sums(tool, "alone9000"), "and other ranks go on to the same bytes")
    tap.ok(all(os.stat(tool.file("dies/" + name)).st_ino == node for name, node in before.items()),
           "with what was left")
    tool.write("s.yaml", STUDY.replace("brightness", "brigthness"))
    process = start_ranks(tool, 2, "wrong")
    text = process.communicate(timeout=120)[0]
    tap.ok(process.returncode != 0 and text.count("did you mean") == 1, "a wrong study is told once", text)
    tool.write("s.yaml", STUDY.replace("count: 900", "count: 901"))
    process = start_ranks(tool, 3, "of3")
    text = process.communicate(timeout=120)[0]
    tap.ok(process.returncode == 4 and text.count("another sweep") == 1, "another study's folder is refused once", text)
    tap.ok(sums(tool, "of3") == expected, "and left as it was")
    tool.write("s.yaml", STUDY.replace("uint8}", "uint8, probes: float32}").replace("set: [", "set: ['points=[]', "))
    process = start_ranks(tool, 3, "none")
    text = process.communicate(timeout=120)[0]
    tap.ok(process.returncode == 3 and text.count("wants probes") == 1, "no points to probe: told once", text)


SLURM = """ClusterName=luxel
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=%(port)d
SlurmdPort=%(node_port)d
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=%(folder)s/munge.socket
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
MpiDefault=none
SlurmctldPidFile=%(folder)s/slurmctld.pid
SlurmdPidFile=%(folder)s/slurmd.pid
SlurmdSpoolDir=%(folder)s/spool
StateSaveLocation=%(folder)s/state
SlurmctldLogFile=%(folder)s/slurmctld.log
SlurmdLogFile=%(folder)s/slurmd.log
NodeName=node NodeHostname=%(host)s NodeAddr=127.0.0.1 CPUs=%(cpus)d State=UNKNOWN
PartitionName=all Nodes=node Default=YES MaxTime=10 State=UP
"""


class Slurm:
    """Daemons in a folder of their own, ended by their process ids."""

    def __init__(self, folder):
        self.folder = folder
        self.running = []
        for name in ("spool", "state"):
            os.mkdir(os.path.join(folder, name))
        with open(os.path.join(folder, "munge.key"), "wb") as file:
            file.write(os.urandom(128))
        os.chmod(file.name, 0o400)
        ports = []
        for _ in range(2):
            with socket.socket() as taken:
                taken.bind(("127.0.0.1", 0))
                ports.append(taken.getsockname()[1])
        self.configuration = os.path.join(folder, "slurm.conf")
        with open(self.configuration, "w", encoding="utf-8") as file:
            file.write(SLURM % {"folder": folder, "port": ports[0], "node_port": ports[1], "host": socket.gethostname(),
                                "cpus": os.cpu_count()})
        self.environment = {**os.environ, "SLURM_CONF": self.configuration}
        self.start("munged", "--foreground", "--force", "--socket=%s/munge.socket" % folder, "--key-file=%s/munge.key"
                   % folder, "--pid-file=%s/munged.pid" % folder, "--log-file=%s/munged.log" % folder,
                   "--seed-file=%s/munged.seed" % folder)
        self.start("slurmctld", "-D", "-f", self.configuration)
        self.start("slurmd", "-D", "-N", "node", "-f", self.configuration)

    def start(self, *command):
        with open(os.path.join(self.folder, command[0] + ".out"), "w", encoding="utf-8") as out:
            self.running.append(subprocess.Popen(command, env=self.environment, stdout=out, stderr=out))
        time.sleep(0.5)

    def run(self, *command, **variables):
        return subprocess.run(command, env={**self.environment, **variables}, capture_output=True, text=True,
                              timeout=200, check=False)

    def is_ready(self, seconds=40):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if "idle" in self.run("sinfo", "-h", "-o", "%t").stdout:
                return True
            time.sleep(0.5)
        return False

    def stop(self):
        for process in reversed(self.running):
            process.terminate()
        for process in self.running:
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def slurm(tap, tool):
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch") if not shutil.which(name)]
    if missing or os.getuid() != 0:
        tap.skip("sweeps by Slurm", "no " + ", ".join(missing or ["right to start its daemons"]))
        return
    tool.write("s.yaml", STUDY)
    tool.run("sweep", "s.yaml", "-o", "alone", "-q")
    expected = sums(tool, "alone")
    tap.equal(len(expected), 1 + 30 * 4, "a sweep alone")
    os.mkdir(tool.file("slurm"))
    os.chmod(tool.folder, 0o755)
    daemons = Slurm(tool.file("slurm"))
    try:
        if not daemons.is_ready():
            tap.skip("sweeps by Slurm", "its daemons do not come up here")
            return
        result = daemons.run("sbatch", "--wait", "--array=0-4", "--chdir=" + tool.folder, "--output=array-%a.txt",
                             os.path.join(SCRIPTS, "sweep-array.sh"), STUDY="s.yaml", FOLDER="array", LUXEL=tool.path)
        tap.equal(result.returncode, 0, "an array of five jobs")
        tap.ok(sums(tool, "array") == expected, "the same bytes", result.stderr, *[
            tool.read(name).decode() for name in tool.files() if name.startswith("array-")])
        if MPI != "none" and shutil.which("mpirun"):
            result = daemons.run("sbatch", "--wait", "--ntasks=2", "--chdir=" + tool.folder, "--output=mpi.txt",
                                 os.path.join(SCRIPTS, "sweep-mpi.sh"), STUDY="s.yaml", FOLDER="ranks",
                                 LUXEL_SWEEP_MPI=MPI, MPIRUN_OPTIONS="--oversubscribe", **AS_ROOT)
            tap.equal(result.returncode, 0, "a job of two ranks")
            tap.ok(sums(tool, "ranks") == expected, "the same bytes", tool.read("mpi.txt").decode())
    finally:
        daemons.stop()


tap = Tap()
run_tests(tap, mpi, slurm)
tap.finish()

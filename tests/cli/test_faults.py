# SPDX-License-Identifier: MIT
"""System calls that fail under every command that writes a file: the old file stays as it was or the new one is whole,
a message names the file and the reason, nothing else is left.  Interrupted and slow calls change nothing.

LUXEL_OFFSETS=all lets writing fail at every byte of files up to 20 000 bytes, and at 1000 of longer ones, instead of at
some.
"""
import errno
import os
import shutil
import subprocess
import sys

from tap import Tap
from tool import SCENE, run_tests

REASONS = [errno.ENOSPC, errno.EIO, errno.EDQUOT]
OFFSETS, LONG_FILE = 6, 20000
CALLS = ["open", "openat", "fsync", "linkat", "renameat", "fchmod", "flock", "close", "write", "pread", "read"]
LARGE = ["f.png", "f.svg", "r.html", "r.md", "r.pdf"]  # they take long to draw, or byte by byte
SMALL = ["-s", "screen.resolution=[3, 3]"]
GRID = "grids: [{center: [0, 0, 1200], size: [100, 100], n: [2, 2]}]\n"
PANEL = "{type: volume, mesh: body.off, power: 1}"
BODY = "OFF\n4 4 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"


def writers(tool):
    """Each file that can be written, and the command that writes it."""
    found = {name: ["render", *SMALL, "-o", name] for name in ("a.png", "a.npy", "a.pfm", "a.csv", "a.exr")}
    found["scene.yaml"] = ["set", "scene.yaml", "surfaces[0].radius=100"]
    found["grid.csv"] = ["grid", "scene.yaml", "-o", "grid.csv"]
    found["profile.csv"] = ["profile", "scene.yaml", "-o", "profile.csv"]
    found["lines.csv"] = ["isophotes", "scene.yaml", "-o", "lines.csv"]
    if os.path.exists(os.path.join(os.path.dirname(tool.path), "luxel-draw")):
        found.update({name: ["figure", *SMALL, "-o", name] for name in ("f.png", "f.svg", "f.pdf")})
        found.update({name: ["report", *SMALL, "-o", name] for name in ("r.html", "r.md", "r.tex", "r.pdf")})
    return found


def with_fault(tool, words, arguments):
    return tool.run(*arguments, environment={"LD_PRELOAD": os.path.abspath(sys.argv[2]), "LUXEL_FAULT": words})


def start(tool, name):
    """The folder anew, with an old file of this name."""
    for other in tool.files():
        os.remove(tool.file(other))
    tool.write("scene.yaml", SCENE + GRID)
    if name != "scene.yaml":
        tool.write(name, "old")
    return tool.files(), tool.read(name)


def judge(tool, words, name, arguments, new):
    """What is wrong after a run with this fault; None: it did not matter."""
    files, old = start(tool, name)
    result = with_fault(tool, words, arguments)
    now, reason = tool.read(name), os.strerror(int(words.split()[-1]))
    faults = []
    if result.code == 0 and now != new:
        faults.append("exit code 0 without the new file")
    if result.code not in (0, 4) or (result.code == 4 and now != old):
        faults.append("exit code %d, and the file is %s" % (result.code, "old" if now == old else "torn"))
    if result.code == 4 and ("error: " not in result.err or reason not in result.err):
        faults.append("no reason: " + result.err)
    if result.code == 4 and name not in result.err and "scene.yaml" not in result.err:
        faults.append("no file: " + result.err)
    if tool.files() != files:
        faults.append("left: %r" % tool.files())
    return faults, result


def writing_fails(tap, tool):
    """At every byte, or at some: first, last and between."""
    for name, arguments in writers(tool).items():
        start(tool, name)
        tap.equal(tool.run(*arguments).code, 0, name + " can be written")
        new, faults = tool.read(name), []
        count = OFFSETS
        if os.environ.get("LUXEL_OFFSETS") == "all":
            count = len(new) - 1 if len(new) <= LONG_FILE else 1000
        offsets = sorted({i * (len(new) - 1) // count for i in range(count + 1)} | {1})
        for offset in offsets:
            found, result = judge(tool, "write 0 %d %d" % (offset, REASONS[offset % 3]), name, arguments, new)
            if found or result.code != 4:
                faults.append((offset, found, str(result)))
        tap.equal(faults[:3], [], "%s: writing fails at %d of %d bytes" % (name, len(offsets), len(new)))


def calls_fail(tap, tool):
    """Each call of each kind, one after the other."""
    for name, arguments in writers(tool).items():
        if name in LARGE:
            continue
        start(tool, name)
        tool.run(*arguments)
        new, faults, failed = tool.read(name), [], set()
        for call in CALLS:
            for skip in range(6):
                found, result = judge(tool, "%s %d -1 %d" % (call, skip, errno.EIO), name, arguments, new)
                if found:
                    faults.append((call, skip, found, str(result)))
                if result.code != 0:
                    failed.add(call)
        tap.equal(faults[:3], [], name + ": any call fails")
        tap.ok({"fsync", "fchmod", "renameat"} <= failed, name + ": and it is told", failed)


def slow_calls(tap, tool):
    for name, arguments in writers(tool).items():
        if name in LARGE or name == "f.pdf":
            continue
        start(tool, name)
        tool.run(*arguments)
        new = tool.read(name)
        start(tool, name)
        result = with_fault(tool, "trickle", arguments)
        tap.ok(result.code == 0 and tool.read(name) == new, name + ": interrupted, and byte by byte", result)


def slow_reading(tap, tool):
    """Of scenes, bodies, clouds, and every kind of picture."""
    light = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
    tool.write("body.off", BODY)
    tool.write("cloud.csv", "2000,0,2000,10\n100,200,2500,3\n")
    tool.write("scene.yaml", SCENE.replace(light, PANEL + "\n  - {type: points, file: cloud.csv}"))
    names = ["a.npy", "a.pfm", "a.csv", "a.exr", "a.png"]
    tool.run("render", "scene.yaml", *SMALL, *[part for name in names for part in ("-o", name)])
    for arguments in [["probe", "scene.yaml", "--json"], ["probe", "a.png", "--json"], ["probe", "a.exr", "--json"],
                      *[["stats", name, "--json"] for name in names[:4]]]:
        plain, slow = tool.run(*arguments), with_fault(tool, "trickle", arguments)
        tap.ok(slow.code == plain.code == 0 and slow.json() == plain.json(), "read slowly: " + " ".join(arguments),
               slow)


SCRIPT = """mount -t tmpfs -o size=%dk none "$1" 2>/dev/null || exit 99; cd "$1"; printf old >a.npy; shift
"$@"; code=$?; cat a.npy; ls -A >&2; exit $code"""


def a_full_disk(tap, tool):
    if not shutil.which("unshare"):
        tap.skip("a full disk", "no unshare")
        return
    for kilobytes, code in (64, 4), (4096, 0):
        done = subprocess.run(["unshare", "-m", "sh", "-c", SCRIPT % kilobytes, "sh", tool.folder, tool.path, "render",
                               "-q", "-o", "a.npy"], capture_output=True)
        if done.returncode in (1, 99):
            tap.skip("a full disk", "no right to mount one")
            return
        tap.ok(done.returncode == code and done.stderr.endswith(b"a.npy\n"), "a disk of %d kB" % kilobytes, done)
        if code:
            tap.ok(done.stdout.endswith(b"old") and b"a.npy" in done.stderr.split(b"No space left")[0],
                   "the old file stands there, and the message names it", done)


def write_protected(tap, tool):
    """A folder that cannot be written, and one that is not there."""
    os.mkdir(tool.file("folder"))
    os.chmod(tool.file("folder"), 0o555)
    if os.access(tool.file("folder"), os.W_OK):
        tap.skip("a folder that cannot be written", "this user may write everywhere")
    else:
        result = tool.run("render", "-o", "folder/a.png")
        tap.ok(result.code == 4 and "folder/a.png" in result.err and "Permission denied" in result.err, "read-only",
               result)
    os.chmod(tool.file("folder"), 0o755)
    gone = tool.file("gone")
    os.mkdir(gone)
    script = 'cd "$1" && rmdir "$1" && shift && "$@"'
    for arguments, code in (["render", "-q", "-o", "a.png"], 4), (["check", "report"], 0), (["check", "-"], 3):
        os.makedirs(gone, exist_ok=True)
        done = subprocess.run(["sh", "-c", script, "sh", gone, tool.path, *arguments], capture_output=True,
                              stdin=subprocess.DEVNULL)
        tap.ok(done.returncode == code and (code == 0 or b"error: " in done.stderr),
               "the current folder is gone: luxel " + " ".join(arguments), done)


if os.environ.get("LUXEL_SANITIZED"):
    TAP = Tap()
    TAP.skip("faults", "sanitizers want to be first before the C library")
    TAP.finish()
run_tests(Tap(), writing_fails, calls_fail, slow_calls, slow_reading, a_full_disk, write_protected)

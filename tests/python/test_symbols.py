# SPDX-License-Identifier: MIT
"""The stable binary interface: modules take from Python only what every version from 3.11 on has."""
import glob
import os
import re
import subprocess
import sys
import sysconfig

from package import Tap, luxel, run_tests

# What the headers declare outside of `#ifndef Py_LIMITED_API` and what is in them for later versions alone.
GUARD = re.compile(r"^\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b(.*)$")
NAME = re.compile(r"\b(_?Py[A-Za-z_0-9]+)\s*(?:\(|;|\[|$)")


def visible(line, limited):
    """What a condition of a header means under Py_LIMITED_API=0x030B0000: whether what follows counts."""
    condition = line.strip()
    later = re.search(r"Py_LIMITED_API\s*\+0\s*>=\s*(0x[0-9A-Fa-f]+)", condition)
    if re.match(r"#\s*ifndef\s+Py_LIMITED_API", condition):
        return False
    if later:
        return int(later.group(1), 16) <= 0x030B0000
    if re.match(r"#\s*if\s+!\s*defined\s*\(?\s*Py_LIMITED_API", condition):
        return False
    return limited


def limited_names():
    """Every name that the limited interface has: what the headers show of themselves under it."""
    folder = sysconfig.get_path("include")
    names = set()
    for path in glob.glob(os.path.join(folder, "*.h")):
        with open(path, encoding="utf-8") as file:
            text = re.sub(r"/\*.*?\*/", " ", file.read(), flags=re.DOTALL)
        stack = []
        for line in text.splitlines():
            match = GUARD.match(line)
            if match and match.group(1).startswith("if"):
                stack.append(visible(line, True))
            elif match and match.group(1) in ("else", "elif") and stack:
                stack[-1] = not stack[-1] if match.group(1) == "else" else visible(line.replace("elif", "if"), True)
            elif match and match.group(1) == "endif" and stack:
                stack.pop()
            elif all(stack):
                names.update(NAME.findall(line))
    return names


def test_symbols(tap, tool):
    nm = sys.argv[2]
    folder = os.path.dirname(luxel.__file__)
    names = limited_names()
    tap.ok(len(names) > 500 and "PyObject_GetBuffer" in names and "PyGILState_Ensure" in names, "the headers are read")
    for kept in ("_PyObject_GC_TRACK", "PyRun_SimpleStringFlags", "PyUnicode_New", "PyBytes_AS_STRING",
                 "PyModule_AddObjectRef2", "PyType_GetModuleByDef"):
        tap.ok(kept not in names, "%s is none of them" % kept)
    modules = sorted(glob.glob(os.path.join(folder, "*.so")))
    tap.ok(modules and all(path.endswith(".abi3.so") for path in modules), "modules say abi3", modules)
    for path in modules:
        listing = subprocess.run([nm, "-D", "--undefined-only", "--format=posix", path], capture_output=True, text=True,
                                 check=True).stdout
        taken = {line.split()[0].split("@")[0] for line in listing.splitlines()}
        taken = {name for name in taken if re.match(r"_?Py", name)}
        tap.ok(len(taken) > 10, "%s takes %d names of Python" % (os.path.basename(path), len(taken)))
        tap.equal(sorted(taken - names), [], "%s: all of the limited interface" % os.path.basename(path))
        defined = subprocess.run([nm, "-D", "--defined-only", "--format=posix", path], capture_output=True, text=True,
                                 check=True).stdout
        shown = [line.split()[0] for line in defined.splitlines()]
        tap.equal(shown, ["PyInit_" + os.path.basename(path).split(".")[0]], "it shows nothing but its beginning")


run_tests(Tap(), test_symbols)

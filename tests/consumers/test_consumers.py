# SPDX-License-Identifier: MIT
"""The library as other projects use it: installed into a temporary folder, then found and linked from outside.

Arguments: the root, the build folder, the prefix it is configured for, Meson, nm, CMake ("" where there is none), the
C++ compiler ("" likewise), and the C compiler's command.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from tap import Tap

tap = Tap()
EXPECTED = r"(\d+\.\d+\.\d+) \1 11\.7475 W/sr\n"


class Place:
    """The installation and the tools."""

    def __init__(self, folder, root, build, prefix, kernels, meson, nm, cmake, cxx, cc):
        self.folder, self.root, self.meson, self.nm, self.cmake, self.cxx, self.cc = (
            folder, root, meson, nm, cmake, cxx, cc)
        self.kernels = kernels.split()
        self.prefix = os.path.join(folder, "installed") + prefix
        self.install(build, os.path.join(folder, "installed"))
        self.config, = self.find("luxel.pc")
        # What was configured for the prefix stands below DESTDIR now.
        with open(self.config, encoding="utf-8") as file:
            text = file.read()
        with open(self.config, "w", encoding="utf-8") as file:
            file.write(re.sub("^prefix=.*$", "prefix=" + self.prefix, text, flags=re.MULTILINE))
        self.library = os.path.dirname(self.find("libluxel.so")[0])
        self.environment = dict(os.environ, LC_ALL="C", CMAKE_PREFIX_PATH=self.prefix,
                                PKG_CONFIG_PATH=os.path.dirname(self.config))
        for name in ("DESTDIR", "CFLAGS", "CXXFLAGS", "LDFLAGS", "CPPFLAGS", "MAKEFLAGS"):
            self.environment.pop(name, None)
        self.environment.update(CC=" ".join(cc), **({"CXX": cxx} if cxx else {}))

    def install(self, build, destination):
        environment = dict(os.environ, DESTDIR=destination)
        subprocess.run([self.meson, "install", "-C", build, "--no-rebuild", "--quiet"], env=environment, check=True,
                       stdout=subprocess.DEVNULL)

    def find(self, name):
        return [os.path.join(where, name) for where, _, files in os.walk(self.prefix) if name in files]

    def run(self, command, **more):
        return subprocess.run(command, capture_output=True, text=True, env=self.environment, timeout=120, **more)

    def flags(self, *arguments):
        return subprocess.run(["pkg-config", *arguments, "luxel"], capture_output=True, text=True, check=True,
                              env=self.environment).stdout.split()


def check_program(place, path, static, name):
    """Runs a program that was linked outside; a static one must do without the shared library."""
    if not os.path.exists(path):
        tap.ok(False, name + " exists")
        return
    needed = subprocess.run(["readelf", "-d", path], capture_output=True, text=True, check=True).stdout
    tap.equal("libluxel.so.1" in needed, not static,
              name + (" holds the library" if static else " needs libluxel.so.1"))
    environment = dict(place.environment)
    if not static:
        environment["LD_LIBRARY_PATH"] = place.library
    run = subprocess.run([path], capture_output=True, text=True, env=environment, timeout=60)
    tap.ok(run.returncode == 0 and re.fullmatch(EXPECTED, run.stdout), name + " runs", run.stdout, run.stderr)


def files_are_there(place):
    for name in ("luxel.h", "libluxel.so", "libluxel.so.1", "libluxel.a", "luxel.pc", "LuxelConfig.cmake",
                 "LuxelConfigVersion.cmake"):
        tap.equal(len(place.find(name)), 1, "%s is installed" % name)
    headers = sorted(os.listdir(os.path.join(place.root, "include", "luxel")))
    tap.equal(sorted(os.listdir(os.path.join(place.prefix, "include", "luxel"))), headers, "every header is installed")
    tool = place.run([os.path.join(place.prefix, "bin", "luxel"), "render", "-o", "sphere.png"], cwd=place.folder)
    tap.ok(tool.returncode == 0 and "11.7475" in tool.stdout, "the installed tool runs by itself", tool.stderr)


def archive_is_closed(place):
    """The static library holds all kernels and shows no name but those of the interface."""
    archive = os.path.join(place.library, "libluxel.a")
    listing = subprocess.run([place.nm, "--defined-only", archive], capture_output=True, text=True, check=True).stdout
    symbols = [line.split()[-2:] for line in listing.splitlines() if len(line.split()) >= 3]
    shown = sorted(name for kind, name in symbols if kind.isupper() and not name.startswith("luxel_"))
    tap.ok(not shown, "libluxel.a shows only luxel_ names", *shown)
    names = {name for _, name in symbols}
    for kernels in place.kernels:
        tap.ok("lx_kernels_" + kernels in names, "libluxel.a holds the kernels of %s" % kernels)


def compiler_alone(place, static):
    """What the README says: cc program.c $(pkg-config --cflags --libs luxel)."""
    how = "static" if static else "shared"
    flags = place.flags("--cflags", "--libs", *(["--static"] if static else []))
    if static:
        flags = [os.path.join(place.library, "libluxel.a") if flag == "-lluxel" else flag for flag in flags]
    for compiler, source in ((place.cc, "use.c"), ([place.cxx], "use.cpp")):
        name = "%s, %s, by pkg-config alone" % (source, how)
        if not compiler[0]:
            tap.skip(name, "no C++ compiler")
            continue
        program = os.path.join(place.folder, "alone-%s-%s" % (source.replace(".", "-"), how))
        run = place.run(compiler + [os.path.join(place.root, "tests", "consumers", source), "-o", program, *flags])
        if tap.ok(run.returncode == 0, name + " is linked", run.stderr):
            check_program(place, program, static, name)


def meson_project(place, static):
    name = "Meson, " + ("static" if static else "shared")
    project = os.path.join(place.folder, "meson-project")
    if not os.path.exists(project):
        shutil.copytree(os.path.join(place.root, "tests", "consumers", "meson"), project)
        for source in ("use.c", "use.cpp"):
            shutil.copy(os.path.join(place.root, "tests", "consumers", source), project)
    build = os.path.join(place.folder, "meson-static" if static else "meson-shared")
    setup = place.run([place.meson, "setup", build, project, "-Dstatic=" + str(static).lower()])
    done = setup.returncode == 0 and place.run([place.meson, "compile", "-C", build])
    if tap.ok(done and done.returncode == 0, name + ": the project builds", setup.stdout, setup.stderr,
              *([done.stdout] if done else [])):
        check_program(place, os.path.join(build, "use_c"), static, name + ": the C program")
        if place.cxx:
            check_program(place, os.path.join(build, "use_cpp"), static, name + ": the C++ program")


def cmake_project(place, how, static):
    name = "CMake by %s, %s" % (how, "static" if static else "shared")
    if not place.cmake or not place.cxx:
        tap.skip(name, "no CMake or no C++ compiler")
        return
    build = os.path.join(place.folder, "cmake-%s-%s" % (how, static))
    setup = place.run([place.cmake, "-G", "Ninja", "-S", os.path.join(place.root, "tests", "consumers", "cmake"),
                       "-B", build, "-DHOW=" + how, "-DSTATIC=" + ("ON" if static else "OFF")])
    done = setup.returncode == 0 and place.run([place.cmake, "--build", build])
    if tap.ok(done and done.returncode == 0, name + ": the project builds", setup.stdout, setup.stderr,
              *([done.stdout] if done else [])):
        check_program(place, os.path.join(build, "use_c"), static, name + ": the C program")
        check_program(place, os.path.join(build, "use_cpp"), static, name + ": the C++ program")


def main():
    root, build, prefix, kernels, meson, nm, cmake, cxx, *cc = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="luxel-consumers-") as folder:
        place = Place(folder, root, build, prefix, kernels, meson, nm, cmake, cxx, cc)
        tap.run(files_are_there, place)
        tap.run(archive_is_closed, place)
        for static in (False, True):
            tap.run(compiler_alone, place, static)
            tap.run(meson_project, place, static)
            tap.run(cmake_project, place, "package", static)
            tap.run(cmake_project, place, "pkg-config", static)
    tap.finish()


main()

# SPDX-License-Identifier: MIT
"""A desk for tests of luxel-app: a screen that nobody looks at, a session bus, folders of its own, and a hand.

    with Desk("en") as desk:
        app = desk.start()                    # luxel-app; its windows are found by what it tells to screen readers
        window = app.window()
        desk.key("ctrl+z")                    # what a hand does comes through the X server, as from a real one

The arguments of every test are the programs: LUXEL LUXEL_APP FOLDER_OF_SCHEMAS.
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback

from accessible import PACE, Reader
from tap import Tap
from waiting import DEADLINE, wait
from window import Window

LUXEL, APP, SCHEMAS = (os.path.abspath(path) for path in sys.argv[1:4])
SCREEN = (1400, 900)
CLIPBOARD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "clipboard.py")
SANITIZED = bool(os.environ.get("LUXEL_SANITIZED"))


class Missing(Exception):
    """A program that this test needs is not installed."""


def tool(name):
    """The path of a program that tools/setup installs."""
    found = shutil.which(name)
    if not found:
        raise Missing("%s is not installed; tools/setup installs it" % name)
    return found


def run(*command, **options):
    """Runs a program to its good end; what it printed, as bytes."""
    done = subprocess.run([str(word) for word in command], capture_output=True, timeout=DEADLINE, **options)
    assert done.returncode == 0, "%s: %s" % (" ".join(map(str, command)), done.stderr.decode("utf-8", "replace"))
    return done.stdout


def luxel(*arguments, **options):
    """The command-line tool."""
    return run(LUXEL, *arguments, **options)


class Desk:
    """The screen with everything on it.  `language` is that of the apps started here."""

    def __init__(self, language="en", size=SCREEN):
        self.size = size
        self.children, self.apps = [], []
        self.folder = tempfile.mkdtemp(prefix="luxel-")
        self.environment = {name: os.environ[name] for name in ("PATH", "LD_LIBRARY_PATH", "ASAN_OPTIONS")
                            if name in os.environ}
        self.environment.update(
            LANG="C.UTF-8", LANGUAGE=language, TZ="UTC", HOME=self.path("home"), GSK_RENDERER="cairo",
            GDK_BACKEND="x11", GSETTINGS_BACKEND="memory", GSETTINGS_SCHEMA_DIR=SCHEMAS, GTK_A11Y="atspi",
            GTK_THEME="Adwaita",
            XDG_DATA_DIRS=os.environ.get("XDG_DATA_DIRS", "/usr/local/share:/usr/share"))
        for name in ("CONFIG_HOME", "CACHE_HOME", "DATA_HOME", "STATE_HOME", "RUNTIME_DIR"):
            self.environment["XDG_" + name] = self.path(name.lower())
            os.makedirs(self.path(name.lower()), mode=0o700)
        os.makedirs(self.path("home"))

    def path(self, *names):
        """A path in the folder of this desk, which goes with it."""
        return os.path.join(self.folder, *names)

    def __enter__(self):
        try:
            self._begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _begin(self):
        for name in ("xdotool", "dbus-daemon", "Xvfb"):
            tool(name)
        # -r: a key that a busy machine holds down for long does not repeat itself.
        display = self._speaking([tool("Xvfb"), "-displayfd", "1", "-noreset", "-r", "-nolisten", "tcp", "-screen", "0",
                                  "%dx%dx24" % self.size])
        self.environment["DISPLAY"] = ":" + display
        self.environment["DBUS_SESSION_BUS_ADDRESS"] = self._speaking(
            [tool("dbus-daemon"), "--session", "--nofork", "--nopidfile", "--print-address=1"])
        # What GLib reads of the environment, it reads when it is first used.
        os.environ.update(self.environment)
        self.reader = Reader(self.environment["DBUS_SESSION_BUS_ADDRESS"])

    def _speaking(self, command, **environment):
        """Starts what says in its first line how to reach it."""
        log = open(self.path("log-" + os.path.basename(command[0])), "wb")
        child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log,
                                 env={**self.environment, **environment})
        log.close()
        self.children.append(child)
        line = child.stdout.readline().decode().strip()
        assert line, "%s did not start: %s" % (command[0], open(log.name, errors="replace").read())
        return line

    def __exit__(self, *reason):
        for child in [app.process for app in self.apps] + self.children[::-1]:
            if child.poll() is None:
                child.terminate()
                try:
                    child.wait(20)
                except subprocess.TimeoutExpired:
                    child.kill()
                    child.wait()
            for stream in (child.stdout, child.stderr):
                if stream:
                    stream.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def start(self, *arguments, **environment):
        """luxel-app with the lab report's scene, or with what is named; environment variables can be given by name."""
        return self.start_bare(*(arguments or ("report",)), **environment)

    def start_bare(self, *arguments, **environment):
        """luxel-app with these arguments and no others."""
        app = App(self, arguments, environment)
        self.apps.append(app)
        return app

    # ---- the hand ----

    def hand(self, *words):
        return run(tool("xdotool"), *words, env=self.environment).decode()

    def key(self, *names):
        self.hand("key", "--clearmodifiers", *names)
        time.sleep(PACE)

    def type(self, text):
        self.hand("type", "--delay", "5", "--", text)
        time.sleep(PACE)

    def move(self, x, y):
        self.hand("mousemove", round(x), round(y))

    def click(self, x, y, button=1, count=1):
        self.move(x, y)
        self.hand("click", "--repeat", count, "--delay", 60, button)
        time.sleep(PACE)

    def drag(self, start, end, steps=8, held=(), button=1):
        """Presses, moves in steps, and lets go; `held` are keys like alt."""
        self.move(*start)
        words = []
        for name in held:
            words += ["keydown", name]
        words += ["mousedown", button]
        for i in range(1, steps + 1):
            words += ["mousemove", round(start[0] + (end[0] - start[0]) * i / steps),
                      round(start[1] + (end[1] - start[1]) * i / steps), "sleep", "0.03"]
        words += ["mouseup", button]
        for name in held[::-1]:
            words += ["keyup", name]
        self.hand(*words)
        time.sleep(PACE)

    def copy(self, text):
        """Another program takes the clipboard with this text."""
        self._speaking([sys.executable, CLIPBOARD, text], GTK_A11Y="none")

    def copied(self):
        """What is on the clipboard, as another program reads it."""
        return run(sys.executable, CLIPBOARD, env={**self.environment, "GTK_A11Y": "none"}).decode().rstrip("\n")

    def layout(self, *words):
        """The keyboard's layout, such as us or ru."""
        run(tool("setxkbmap"), *words, env=self.environment)

    def picture(self, path):
        """The screen as a picture in a file."""
        run(tool("import"), "-window", "root", path, env=self.environment)

    def screen(self, x, y, width, height):
        """Red, green and blue of the dots of a part of the screen, row by row, 0 to 255."""
        return run(tool("import"), "-window", "root", "-crop", "%dx%d+%d+%d" % (width, height, x, y), "+repage",
                   "-depth", "8", "rgb:-", env=self.environment)

    def color(self, x, y):
        """Those of a single dot."""
        return tuple(self.screen(round(x), round(y), 1, 1))


class App:
    """A running luxel-app."""

    def __init__(self, desk, arguments, environment):
        self.desk, self.known = desk, []
        self.log = desk.path("stderr-%d" % len(desk.apps))
        with open(self.log, "wb") as log:
            self.process = subprocess.Popen(
                [APP, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=log,
                env={**desk.environment, "G_DEBUG": "fatal-warnings", **environment})

    def said(self):
        """What it wrote to stderr."""
        with open(self.log, "rb") as log:
            return log.read().decode("utf-8", "replace")

    def running(self):
        code = self.process.poll()
        assert code is None, "luxel-app ended with %r: %s" % (code, self.said())
        return True

    def windows(self):
        """The windows that it tells of, the oldest first."""
        self.running()
        root = self.desk.reader.program(self.process.pid)
        return [widget for widget in root.children() if widget.name.endswith("Luxel")] if root else []

    def on_screen(self):
        """The numbers of its windows on the screen.  The search fails where one of them goes meanwhile."""
        search = [tool("xdotool"), "search", "--onlyvisible", "--pid", str(self.process.pid)]

        def found():
            done = subprocess.run(search, capture_output=True, timeout=DEADLINE, env=self.desk.environment, check=False)
            return set(done.stdout.decode().split()) if done.returncode == 0 else None

        return wait("its windows on the screen", found)

    def window(self, count=1):
        """The latest window when there are `count`, ready to be used; each is asked for once, as it appears."""
        widget = wait("%d windows" % count, lambda: self.windows()[count - 1:count] or None)[0]
        window = Window(self, widget, len(self.known) + 1).appear()
        self.known.append(window)
        return window

    def act(self, name, *parameters):
        """An action of the program itself, such as new-window."""
        self.desk.reader.activate("/org/luxel/Luxel", name, *parameters)

    def kill(self):
        """As when the power fails."""
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def quit(self):
        """Ends it in order; what it returned."""
        self.process.terminate()
        return self.process.wait(DEADLINE)


def trial(*functions, language="en", size=SCREEN):
    """A test: each function gets a Tap and the desk; at its end no app may have complained."""
    tap = Tap()

    def alone(function, desk):
        function(tap, desk)
        for app in desk.apps:
            if app.process.poll() is None:
                tap.equal(app.quit(), 0, "luxel-app ends in order")
            tap.equal(app.said(), "", "it had nothing to complain about")

    for function in functions:
        alone.__name__ = function.__name__
        try:
            with Desk(language, size) as desk:
                tap.run(alone, function, desk)
        except Exception:  # the desk itself
            tap.ok(False, "the desk is set up", traceback.format_exc())
    tap.finish()

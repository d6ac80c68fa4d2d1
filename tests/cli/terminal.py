# SPDX-License-Identifier: MIT
"""A program on a terminal of its own, for tests of what only a terminal shows."""
import os
import pty
import re
import select
import signal
import time


class Terminal:
    """Starts a program whose standard streams are a new terminal, and talks with it."""

    def __init__(self, arguments, folder, environment):
        self.seen = b""
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execvpe(arguments[0], arguments, environment)

    def send(self, text):
        os.write(self.master, text.encode("utf-8"))

    def _read(self, seconds):
        """Takes what comes within so many seconds; False at the end of the program."""
        if not select.select([self.master], [], [], max(seconds, 0))[0]:
            return True
        try:
            piece = os.read(self.master, 65536)
        except OSError:
            piece = b""
        self.seen += piece
        return bool(piece)

    def wait_for(self, pattern, seconds=20):
        """The match of a pattern in what was printed since the last one; an error if it does not come."""
        end = time.monotonic() + seconds
        while True:
            match = re.search(pattern.encode("utf-8"), self.seen, re.S)
            if match:
                self.seen = self.seen[match.end():]
                return match.group(match.lastindex or 0).decode("utf-8", "replace")
            if time.monotonic() > end or not self._read(min(1, end - time.monotonic())):
                raise AssertionError("the terminal does not show %r but %r" % (pattern, self.seen[-2000:]))

    def finish(self, seconds=60):
        """All that was printed until the program ended, and its exit code."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and self._read(min(1, end - time.monotonic())):
            pass
        return self.seen.decode("utf-8", "replace"), os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])

    def close(self):
        try:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
        except (ProcessLookupError, ChildProcessError):
            pass
        os.close(self.master)

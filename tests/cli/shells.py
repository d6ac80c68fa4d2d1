# SPDX-License-Identifier: MIT
"""Asks real shells what they offer to complete a command line with, through the scripts that are installed.

Each shell has offers(line): the words that it offers at the end of the line, as a set; and, where a terminal can show
it, inserted(line): what the line becomes by the Tab key.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys

from terminal import Terminal


def environment(folder):
    """The tool that is tried comes first in the path, as completions ask it for the names of a scene."""
    return {"PATH": os.path.dirname(os.path.abspath(sys.argv[1])) + ":" + os.environ["PATH"], "HOME": folder,
            "TERM": "xterm", "LC_ALL": "C.UTF-8", "INPUTRC": "/dev/null", "ZDOTDIR": folder,
            "XDG_CONFIG_HOME": folder, "XDG_DATA_HOME": folder}


def after_tab(shell, folder, line):
    """What a line on a terminal becomes by Tab; the shell shows its line between {{ and }} at Ctrl-X d."""
    terminal = Terminal(shell, folder, environment(folder))
    try:
        terminal.wait_for("=ready=")
        terminal.send(line + "\t\x18d")
        return terminal.wait_for(r"{{([^{}]*)}}\r?\n")
    finally:
        terminal.close()


class Bash:
    """The script's function is called as readline calls it; on a terminal readline itself does."""
    name = "bash"
    SETUP = """\
PS1='> '; source {script}; bind 'set enable-bracketed-paste off'; bind 'set bell-style none'
PROMPT_COMMAND='echo =rea""dy='
show() {{ printf '{{{{%s}}}}\\n' "$READLINE_LINE"; }}; bind -x '"\\C-xd": show'
"""

    def __init__(self, script, folder):
        self.script, self.folder = script, folder
        with open(os.path.join(folder, ".bashrc"), "w") as file:
            file.write(self.SETUP.format(script=shlex.quote(script)))

    def offers(self, line):
        words = [piece for word in re.findall(r"\S+", line) for piece in self._pieces(word)]
        if line.endswith(" "):
            words.append("")
        program = "source %s; COMP_LINE=%s COMP_POINT=%d COMP_CWORD=%d; COMP_WORDS=(%s); _luxel; printf '%%s\\n' " \
                  "\"${COMPREPLY[@]}\"" % (shlex.quote(self.script), shlex.quote(line), len(line), len(words) - 1,
                                           " ".join(shlex.quote(word) for word in words))
        done = subprocess.run(["bash", "--norc", "-c", program], cwd=self.folder, env=environment(self.folder),
                              capture_output=True, encoding="utf-8", timeout=20)
        if done.stderr:
            raise AssertionError(done.stderr)
        return {word for word in done.stdout.split("\n") if word}

    @staticmethod
    def _pieces(word):
        return [word] if word[0] in "'\"" else re.findall(r"[=:]+|[^=:]+", word)

    def inserted(self, line):
        return after_tab(["bash", "--rcfile", ".bashrc", "-i"], self.folder, line)


class Zsh:
    """On a terminal; what is offered goes through compadd, which is listened to."""
    name = "zsh"
    SETUP = """\
PS1='> '; unsetopt prompt_cr prompt_sp auto_list beep; unset zle_bracketed_paste
fpath=({folder}/functions $fpath); autoload -Uz compinit; compinit -u -D
compadd() {{
    local -a hits
    [[ ${{@[1,(i)(-|--)]}} == *-(O|A|D)\\ * ]] && {{ builtin compadd "$@"; return }}
    builtin compadd -A hits "$@"
    print -rl -- $hits >> {folder}/hits
    builtin compadd "$@"
}}
zle-line-init() {{ print -n '=ready=' }}; zle -N zle-line-init
show() {{ print -r -- "{{{{$BUFFER}}}}"; zle -I }}; zle -N show; bindkey '^Xd' show; bindkey '^I' complete-word
"""

    def __init__(self, script, folder):
        self.folder = folder
        os.makedirs(os.path.join(folder, "functions"), exist_ok=True)
        shutil.copy(script, os.path.join(folder, "functions", "_luxel"))
        with open(os.path.join(folder, ".zshrc"), "w") as file:
            file.write(self.SETUP.format(folder=folder))

    def inserted(self, line):
        hits = os.path.join(self.folder, "hits")
        open(hits, "w").close()
        return after_tab(["zsh", "-i"], self.folder, line)

    def offers(self, line):
        self.inserted(line)
        with open(os.path.join(self.folder, "hits"), encoding="utf-8") as file:
            return set(file.read().split("\n")) - {""}


class Fish:
    """Answers without a terminal."""
    name = "fish"

    def __init__(self, script, folder):
        self.script, self.folder = script, folder

    def offers(self, line):
        program = "source %s; complete -C %s" % (shlex.quote(self.script), shlex.quote(line))
        done = subprocess.run(["fish", "--no-config", "-c", program], cwd=self.folder, env=environment(self.folder),
                              capture_output=True, encoding="utf-8", timeout=20)
        if done.stderr:
            raise AssertionError(done.stderr)
        return {offer.split("\t")[0] for offer in done.stdout.split("\n") if offer}

    inserted = None


def installed(folder, scripts):
    """Those shells that this machine has, each with its script."""
    for kind, script in zip((Bash, Zsh, Fish), scripts):
        if shutil.which(kind.name):
            place = os.path.join(folder, kind.name)
            os.makedirs(place)
            yield kind(os.path.abspath(script), place)

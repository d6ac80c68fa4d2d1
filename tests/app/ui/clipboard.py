# SPDX-License-Identifier: MIT
"""Another program that has copied a text: clipboard.py TEXT holds it until it is ended.

Prints a line as soon as the text can be pasted; clipboard.py without a text prints what can be pasted instead.
"""
import sys

import gi

gi.require_version("Gtk", "4.0")
from gi.repository import Gdk, GLib, Gtk  # noqa: E402

Gtk.init()
loop = GLib.MainLoop()
clipboard = Gdk.Display.get_default().get_clipboard()


def came(_clipboard, result):
    try:
        print(clipboard.read_text_finish(result) or "", flush=True)
    except GLib.Error:  # nothing that is a text
        print(flush=True)
    loop.quit()


if len(sys.argv) > 1:
    clipboard.set_content(Gdk.ContentProvider.new_for_value(sys.argv[1]))
    Gdk.Display.get_default().sync()
    print("ready", flush=True)
else:
    clipboard.read_text_async(None, came)
loop.run()

# SPDX-License-Identifier: MIT
"""What a program with GTK tells to screen readers (AT-SPI), read over D-Bus; and the actions of its windows.

The bus is asked directly, as libatspi keeps what it was once told and would have to be watched for what it missed.
"""
import time

try:
    from gi.repository import Gio, GLib
except ImportError as missing:
    raise SystemExit("python3-gi is not installed for this Python; tools/setup installs it") from missing

PREFIX = "org.a11y.atspi."
ROOT = "/org/a11y/atspi/accessible/root"
STATES = {"invalid": 0, "busy": 3, "checked": 4, "focused": 12, "pressed": 20, "selected": 23, "sensitive": 24,
          "visible": 30}
TIMEOUT_MS = 20000
PACE = 0.1  # seconds that a hand takes: what it did is under way before something is read or done


class Rejected(Exception):
    """A question that was not answered: the widget is gone, or cannot do this."""


def call(connection, name, path, interface, method, parameters=None):
    try:
        return connection.call_sync(name, path, interface, method, parameters, None, Gio.DBusCallFlags.NONE, TIMEOUT_MS,
                                    None).unpack()
    except GLib.Error as fault:
        raise Rejected("%s.%s of %s: %s" % (interface, method, path, fault.message)) from None


def connect(address):
    flags = Gio.DBusConnectionFlags
    return Gio.DBusConnection.new_for_address_sync(
        address, flags.AUTHENTICATION_CLIENT | flags.MESSAGE_BUS_CONNECTION, None, None)


class Reader:
    """Both buses: that of the session, and that of the screen readers."""

    def __init__(self, address):
        self.session = connect(address)
        self.bus = connect(call(self.session, "org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress")[0])

    def program(self, process):
        """The root of the program with this number; None as long as it has not registered."""
        root = Widget(self.bus, PREFIX + "Registry", ROOT)
        for child in root.children():
            try:
                if call(self.bus, "org.freedesktop.DBus", "/org/freedesktop/DBus", "org.freedesktop.DBus",
                        "GetConnectionUnixProcessID", GLib.Variant("(s)", (child.owner,)))[0] == process:
                    return child
            except Rejected:  # one that ends just now
                continue
        return None

    def activate(self, path, name, *parameters):
        """An action of a window or of the program; the parameters are GLib.Variants or texts."""
        values = [value if isinstance(value, GLib.Variant) else GLib.Variant("s", value) for value in parameters]
        call(self.session, "org.luxel.Luxel", path, "org.gtk.Actions", "Activate",
             GLib.Variant("(sava{sv})", (name, values, {})))
        time.sleep(PACE)

    def state(self, path, name):
        """Whether an action is enabled, and its state (None: it has none)."""
        enabled, _kind, states = call(self.session, "org.luxel.Luxel", path, "org.gtk.Actions", "Describe",
                                      GLib.Variant("(s)", (name,)))[0]
        return enabled, states[0] if states else None


class Widget:
    """A widget, or a program that has widgets."""

    def __init__(self, bus, owner, path):
        self.bus, self.owner, self.path = bus, owner, path

    def __eq__(self, other):
        return isinstance(other, Widget) and (self.owner, self.path) == (other.owner, other.path)

    def __repr__(self):
        return "%s %r" % (self.role, self.name)

    def ask(self, interface, method, signature=None, *values):
        return call(self.bus, self.owner, self.path, PREFIX + interface, method,
                    GLib.Variant(signature, values) if signature else None)

    def get(self, interface, name):
        return call(self.bus, self.owner, self.path, "org.freedesktop.DBus.Properties", "Get",
                    GLib.Variant("(ss)", (PREFIX + interface, name)))[0]

    def set(self, interface, name, value):
        call(self.bus, self.owner, self.path, "org.freedesktop.DBus.Properties", "Set",
             GLib.Variant("(ssv)", (PREFIX + interface, name, value)))

    # ---- what it is ----

    @property
    def name(self):
        return self.get("Accessible", "Name")

    @property
    def description(self):
        return self.get("Accessible", "Description")

    @property
    def role(self):
        return self.ask("Accessible", "GetRoleName")[0]

    @property
    def interfaces(self):
        return [name[len(PREFIX):] for name in self.ask("Accessible", "GetInterfaces")[0]]

    def children(self):
        return [Widget(self.bus, owner, path) for owner, path in self.ask("Accessible", "GetChildren")[0]]

    def has(self, state):
        low, high = self.ask("Accessible", "GetState")[0]
        return bool((low | high << 32) >> STATES[state] & 1)

    def all(self, role=None, name=None, state=None):
        """Every widget in this one, in their order, of a role, of a name and in a state where they are given."""
        for child in self.children():
            try:
                kind = child.role if role else None
                if kind == role and (name is None or child.name == name) and (state is None or child.has(state)):
                    yield child
                if kind != "label":  # which holds no other widget
                    yield from child.all(role, name, state)
            except Rejected:  # gone while it was looked at
                continue

    def names(self, role=None, name=None, state=None):
        """Their names."""
        return [widget.name for widget in self.all(role, name, state)]

    def find(self, role=None, name=None, state=None):
        """The first of them, or None."""
        return next(self.all(role, name, state), None)

    # ---- what it holds ----

    @property
    def text(self):
        return self.ask("Text", "GetText", "(ii)", 0, self.get("Text", "CharacterCount"))[0]

    @text.setter
    def text(self, text):
        assert self.ask("EditableText", "SetTextContents", "(s)", text)[0]

    @property
    def value(self):
        return self.get("Value", "CurrentValue")

    @value.setter
    def value(self, value):
        self.set("Value", "CurrentValue", GLib.Variant("d", value))

    def area(self):
        """x, y, width, height in the window."""
        return self.ask("Component", "GetExtents", "(u)", 1)[0]

    def act(self, index=0):
        assert self.ask("Action", "DoAction", "(i)", index)[0]
        time.sleep(PACE)

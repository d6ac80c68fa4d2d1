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
STATES = {"checked": 4, "focused": 12, "pressed": 20, "selected": 23, "sensitive": 24, "visible": 30, "invalid": 0}
TIMEOUT_MS = 20000
PACE = 0.1  # seconds that a hand takes: what it did is under way before something is read or done


class Rejected(Exception):
    """A question that was not answered: the widget is gone, or cannot do this."""


def reply(connection, name, path, interface, method, parameters=None):
    """What a question is answered with, packed."""
    try:
        return connection.call_sync(name, path, interface, method, parameters, None, Gio.DBusCallFlags.NONE, TIMEOUT_MS,
                                    None)
    except GLib.Error as fault:
        raise Rejected("%s.%s of %s: %s" % (interface, method, path, fault.message)) from None


def call(*question):
    return reply(*question).unpack()


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

    def seen(self, role=None, name=None, state=None):
        """Every widget in this one, in their order, of a role, of a name and in a state where they are given, and the
        name of each."""
        snapshot = Snapshot(self)
        for path in snapshot.below(self.path):
            if name in (None, snapshot.names[path]) and (state is None or snapshot.states[path] >> STATES[state] & 1):
                widget = Widget(self.bus, self.owner, path)
                if role is None or snapshot.role(widget) == role:
                    yield widget, snapshot.names[path]

    def all(self, *which, **named):
        """Every such widget."""
        return (widget for widget, _name in self.seen(*which, **named))

    def names(self, *which, **named):
        """Their names."""
        return [name for _widget, name in self.seen(*which, **named)]

    def find(self, *which, **named):
        """The first of them, or None."""
        return next(self.all(*which, **named), None)

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


class Snapshot:
    """The widgets below one as they stand at one time.  Of all widgets that a program has told of once it tells the
    names, states and numbers of children at once; asking each costs it, the bus and the reader far more.  Which
    children they are is asked for one by one, as those that were hidden from the first on are told of as seen."""

    roles = {}  # of all that were ever asked for: no widget changes its role, and no path is used again

    def __init__(self, top):
        self.top, self.asked = top, {}
        self.take()
        list(self.below(top.path))
        if any(child not in self.names for children in self.asked.values() for child in children):
            self.take()

    def take(self):
        self.names, self.states, self.counts = {}, {}, {}
        told = reply(self.top.bus, self.top.owner, "/org/a11y/atspi/cache", PREFIX + "Cache", "GetItems")
        told = told.get_child_value(0)
        # Field by field, as all of it would take Python long to unpack.
        for field in (told.get_child_value(i).get_child_value for i in range(told.n_children())):
            path = field(0).get_child_value(1).get_string()
            low, high = (field(9).get_child_value(i).get_uint32() for i in range(2))
            self.names[path], self.states[path] = field(6).get_string(), low | high << 32
            self.counts[path] = field(4).get_int32()

    def children(self, path):
        if path != ROOT and self.counts.get(path) == 0:  # a program's root does not count its windows
            return []
        if path not in self.asked:
            try:
                self.asked[path] = [child.path for child in Widget(self.top.bus, self.top.owner, path).children()]
            except Rejected:  # gone while it was looked at
                self.asked[path] = []
        return self.asked[path]

    def below(self, path):
        """The path of every widget in one, in their order."""
        for child in self.children(path):
            if child in self.names:
                yield child
            yield from self.below(child)

    def role(self, widget):
        if widget.path not in self.roles:
            try:
                self.roles[widget.path] = widget.role
            except Rejected:  # gone while it was looked at
                return None
        return self.roles[widget.path]

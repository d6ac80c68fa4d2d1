#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The stub of a module of C, for type checkers: from the FUNCTION() lines and types in its sources, which are the only
description of what its functions take and give.

    make_stubs.py TITLE STUB SOURCE...
"""
import re
import sys

ALIASES = {
    "_Field": '_Field = TypeVar("_Field", bound="FieldHandle")',
    "_Settings": "_Settings = Tuple[int, int, int, Optional[str], float, float, float, int, bool, bool,\n"
                 "                  Optional[bytes], float, Optional[Callable[[float], Any]]]",
}
TYPING = ("Any", "Callable", "List", "Optional", "Tuple", "Type", "TypeVar", "Union")
TEXT = r'"(?:[^"\\]|\\.)*"'
FUNCTION = re.compile(r"^ +FUNCTION\((%s), \w+, (METH_\w+),\s+(%s(?:\s+%s)*),\s+(%s)\)" % ((TEXT,) * 4), re.M)
TYPE = re.compile(r'PyType_Spec \w+ = \{\.name = "luxel\.\w+\.(\w+)",(.*?)\};', re.S)
CONSTANT = re.compile(r'PyModule_AddStringConstant\(module, "(\w+)"')


def joined(texts):
    """The text of literals of C that follow one another."""
    return "".join(text[1:-1] for text in re.findall(TEXT, texts))


def definition(name, parameters, result):
    """A function of a stub, in lines of at most 120."""
    line = "def %s(%s) -> %s: ..." % (name, parameters, result)
    return line if len(line) <= 120 else "def %s(\n    %s\n) -> %s: ..." % (name, parameters, result)


def class_of(name, rest, source):
    """A type of a stub; one whose numbers are a buffer says so by the method of PEP 688."""
    slots = re.search(r"PyType_Slot %s\[\] = \{(.*?)\};" % re.search(r"\.slots = (\w+)", rest).group(1), source, re.S)
    method = "\n    def __buffer__(self, flags: int, /) -> memoryview: ..."
    body = method if "Py_bf_getbuffer" in slots.group(1) else " ..."
    return ("" if "Py_TPFLAGS_BASETYPE" in rest else "@final\n") + "class %s:%s" % (name, body)


def stub_of(title, sources):
    constants, types, functions = [], [], []
    for text in sources:
        constants += ["%s: str" % name for name in CONSTANT.findall(text)]
        types += [class_of(name, rest, text) for name, rest in TYPE.findall(text)]
        found = FUNCTION.findall(text)
        if len(found) != text.count(" FUNCTION(\""):
            raise SystemExit("a FUNCTION() has another form than FUNCTION(\"name\", name, METH_..., \"...\", \"...\")")
        functions += [definition(joined(name), joined(parameters), joined(result))
                      for name, _, parameters, result in found]
    body = "\n\n".join(constants + types + ["\n".join(functions)])
    aliases = [line for name, line in ALIASES.items() if re.search(r"\b%s\b" % name, body)]
    body = "\n\n".join(aliases + [body])
    imports = [name for name in TYPING if re.search(r"\b%s\b" % name, body)] + (["final"] if "@final" in body else [])
    return "# SPDX-License-Identifier: MIT\n# %s\nfrom typing import %s\n\n%s\n" % (title, ", ".join(imports), body)


def main(title, stub, *paths):
    sources = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            sources.append(file.read())
    with open(stub, "w", encoding="utf-8") as file:
        file.write(stub_of(title, sources))


if __name__ == "__main__":
    main(*sys.argv[1:])

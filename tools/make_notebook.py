#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tutorial as a notebook: docs/PYTHON.md cut into cells, so that page and notebook cannot say different things.

    make_notebook.py PAGE NOTEBOOK           whether the notebook is that of the page
    make_notebook.py PAGE NOTEBOOK --write   writes it
"""
import json
import re
import sys


def cells_of(text):
    """Text and blocks of Python of a page, in turn."""
    for number, part in enumerate(re.split(r"```python\n(.*?)```\n", text, flags=re.DOTALL)):
        part = part.strip("\n")
        if not part:
            continue
        cell = {"cell_type": "code" if number % 2 else "markdown", "id": "cell-%d" % number, "metadata": {},
                "source": part.splitlines(keepends=True)}
        if number % 2:
            cell.update(execution_count=None, outputs=[])
        yield cell


def notebook_of(text):
    """The notebook of a page, as text."""
    # Links of the page are relative to docs/, and the notebook is one folder below.
    text = re.sub(r"\]\(((?!http)[A-Z]+\.md)", r"](../\1", text).replace("](python/", "](")
    book = {"cells": list(cells_of(text)),
            "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                         "language_info": {"name": "python"}},
            "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(book, ensure_ascii=False, indent=1) + "\n"


def main():
    page, notebook = sys.argv[1:3]
    with open(page, encoding="utf-8") as file:
        made = notebook_of(file.read())
    if sys.argv[3:] == ["--write"]:
        with open(notebook, "w", encoding="utf-8") as file:
            file.write(made)
        return 0
    with open(notebook, encoding="utf-8") as file:
        same = file.read() == made
    if not same:
        print("%s is not that of %s: make notebook" % (notebook, page), file=sys.stderr)
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())

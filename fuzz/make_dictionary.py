# SPDX-License-Identifier: MIT
"""Words that libFuzzer may put into scenes and changes of them: keys and choices from the tables, and signs of YAML.

    python3 fuzz/make_dictionary.py BUILD >scene.dict      # asks BUILD/cli/luxel for its schema
"""
import json
import subprocess
import sys

SIGNS = ["- ", ": ", "[", "]", "{", "}", ", ", "#", "'", '"', "\n  - ", "\n", "[0]", ".", "=", "|\n",
         "null", "true", "-1e308", "1e-300"]


def words(node):
    """Names of properties and texts that a value may be."""
    if isinstance(node, list):
        for each in node:
            yield from words(each)
    elif isinstance(node, dict):
        yield from node.get("properties", {})
        yield from (each for each in [node.get("const"), *node.get("enum", [])] if isinstance(each, str))
        for key, value in node.items():
            if key not in ("const", "enum"):
                yield from words(value)


def main():
    schema = json.loads(subprocess.run([sys.argv[1] + "/cli/luxel", "schema"], check=True, capture_output=True).stdout)
    for word in SIGNS + sorted(set(words(schema))):
        print('"%s"' % word.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\x0A"))


main()

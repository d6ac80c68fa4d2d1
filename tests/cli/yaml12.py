# SPDX-License-Identifier: MIT
"""Reads YAML as version 1.2 means it: yes and 0x10 are texts, 1e9 is a number, and a doubled key is an error."""
import re

import yaml


class Loader(yaml.SafeLoader):
    yaml_implicit_resolvers = {}

    def construct_mapping(self, node, deep=False):
        keys = [self.construct_object(key, deep=deep) for key, _ in node.value]
        if len(set(keys)) != len(keys):
            raise yaml.constructor.ConstructorError(None, None, "a doubled key", node.start_mark)
        return super().construct_mapping(node, deep=deep)

    def flatten_mapping(self, node):
        """<< is a key like any other."""


NUMBER = r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"
for tag, pattern in (("null", r"^(~|null|Null|NULL|)$"), ("bool", r"^(true|True|TRUE|false|False|FALSE)$"),
                     ("int", r"^[-+]?[0-9]+$"), ("float", NUMBER + r"|^[-+]?\.(inf|Inf|INF)$|^\.(nan|NaN|NAN)$")):
    Loader.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), None)
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(loader.construct_scalar(node)))


def read(text):
    """The value of a text of one document; yaml.YAMLError where it is none."""
    return yaml.load(text, Loader)

# SPDX-License-Identifier: MIT
"""Studies: the many scenes of a study file, and what is computed of each of them, kept so that it goes on later."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Mapping, Optional, Union

from . import _flow, _luxel
from ._scene import Path, Scene

if TYPE_CHECKING:
    import numpy.typing as npt


class Study:
    """A study as `luxel sweep` takes it (docs/SWEEP.md): a path, its text, or a dictionary.

    Scene i is study[i], and depends on the study and on i alone: what is random is drawn by counter.
    """

    __slots__ = ("_handle", "_count", "shard", "keys", "identity")

    shard: int  #: how many scenes are computed and kept at once
    keys: List[str]  #: what varies, a key for each number: "lights[0].position[2]"
    identity: str  #: all that the scenes depend on, as a text

    def __init__(self, source: "Union[str, os.PathLike[str], Mapping[str, Any]]") -> None:
        if isinstance(source, Mapping):
            found = _luxel.read_study(b"<dict>", _flow.dump(dict(source)).encode("utf-8"))
        elif isinstance(source, str) and ("\n" in source or source.lstrip().startswith("{")):
            found = _luxel.read_study(b"<text>", source.encode("utf-8"))
        else:
            found = _luxel.read_study(os.fsencode(source), None)
        self._handle, self._count, self.shard, self.keys, self.identity = found

    def __len__(self) -> int:
        return int(self._count)

    def _index(self, i: int) -> int:
        if not -len(self) <= i < len(self):
            raise IndexError("scene %d: the study has %d, counted from 0" % (i, len(self)))
        return i % len(self)

    def __getitem__(self, i: int) -> Scene:
        """Scene i."""
        return Scene._of_handle(_luxel.study_scene(self._handle, self._index(i)))

    def __iter__(self) -> Iterator[Scene]:
        return (self[i] for i in range(len(self)))

    def parameters(self, i: int) -> Dict[str, Any]:
        """What varies, in scene i: numbers, and words or other values as YAML."""
        return dict(zip(self.keys, _luxel.study_values(self._handle, self._index(i))))

    def map(self, function: Callable[[Scene], Any], folder: Optional[Path] = None, *,
            progress: Optional[Callable[[float], Any]] = None) -> "npt.NDArray[Any]":
        """What a function gives of each scene, a number or an array of one shape, as an array, a row a scene.

        With a `folder` each shard is kept there as it is done, whole or not at all, and the same call goes on where an
        earlier one was interrupted.  The function is not known by the folder: another one takes another folder.
        ValueError: the folder is that of another study.
        """
        import numpy

        place = None if folder is None else os.fspath(folder)
        if place is not None:
            self._claim(place)
        shards: "List[npt.NDArray[Any]]" = []
        for first in range(0, len(self), self.shard):
            path = None if place is None else os.path.join(place, "shard-%06d.npy" % (first // self.shard))
            if path is not None and os.path.exists(path):
                shards.append(numpy.load(path))
                continue
            rows = []
            for i in range(first, min(first + self.shard, len(self))):
                rows.append(numpy.asarray(function(self[i])))
                if progress is not None and progress((i + 1) / len(self)) is False:
                    raise KeyboardInterrupt("the study was interrupted at scene %d" % i)
            shards.append(numpy.stack(rows))
            if path is not None:
                with open(path + ".part", "wb") as file:
                    numpy.save(file, shards[-1])
                os.replace(path + ".part", path)
        return numpy.concatenate(shards)

    def _claim(self, folder: str) -> None:
        """Makes the folder that of this study."""
        path = os.path.join(folder, "study.txt")
        os.makedirs(folder, exist_ok=True)
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                if file.read() != self.identity:
                    raise ValueError("%s: results of another study are kept here" % folder)
        else:
            with open(path + ".part", "w", encoding="utf-8") as file:
                file.write(self.identity)
            os.replace(path + ".part", path)

# SPDX-License-Identifier: MIT
"""The user's language, from the catalogues of the tool, without touching the locale of the program."""
from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any, Iterator, List, Optional

from . import _luxel

if TYPE_CHECKING:
    from gettext import NullTranslations

_HERE = os.path.dirname(os.path.abspath(__file__))
_speakers: List[Any] = [_luxel]  # the modules of C that tell messages
_catalogue: "Optional[NullTranslations]" = None


def _folders() -> Iterator[str]:
    """Where catalogues may lie: in the build folder, in the environment, where they were to be installed."""
    yield os.path.join(_HERE, "..", "..", "po")
    yield os.path.join(sys.prefix, "share", "locale")
    yield _luxel.LOCALEDIR


def _wanted() -> List[str]:
    """The languages that the environment asks for, the best first; none where it asks for that of C."""
    locale = next((os.environ[name] for name in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(name)), "C")
    if locale in ("C", "POSIX"):
        return []
    return (os.environ.get("LANGUAGE") or locale).split(":")


def _load(languages: List[str]) -> "Optional[NullTranslations]":
    import gettext

    for language in languages:
        # A wheel has them in the package, each in a file of its language.
        path = os.path.join(_HERE, "locale", language.partition(".")[0].partition("_")[0] + ".mo")
        if os.path.exists(path):
            with open(path, "rb") as file:
                return gettext.GNUTranslations(file)
    for folder in _folders():
        if gettext.find("luxel", folder, languages):
            return gettext.translation("luxel", folder, languages)
    return None


def translate(english: str) -> str:
    """A text of the library or the tool in the user's language."""
    return _catalogue.gettext(english) if _catalogue and english else english


def translate_plural(one: str, many: str, count: int) -> str:
    """The same for a text that goes by a number."""
    return _catalogue.ngettext(one, many, count) if _catalogue else (one if count == 1 else many)


def _tell(speaker: Any) -> None:
    speaker.set_language(translate("en"), translate if _catalogue else None)


def add_speaker(speaker: Any) -> None:
    """Lets a module of C speak the language, now and after changes."""
    if speaker not in _speakers:
        _speakers.append(speaker)
        _tell(speaker)


def set_language(code: Optional[str] = None) -> None:
    """Chooses the language of messages and documents: "en", "ru"; None: that of the environment.

    Raises ValueError where there is no catalogue of this language.
    """
    global _catalogue
    found: "Optional[NullTranslations]" = None
    if code is None:
        found = _load(_wanted())
    elif code != "en":
        found = _load([code])
        if found is None:
            raise ValueError("Luxel does not speak %r" % code)
    _catalogue = found
    for speaker in _speakers:
        _tell(speaker)


set_language()

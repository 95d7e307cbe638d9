"""The exceptions of steplab: one family, whose classes have the exit codes of the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .runs import Run


class Error(Exception):
    """The base class of what steplab raises: ``str(error)`` says what is wrong, and what would be right."""

    #: as the program `steplab` would end
    exit_code = 1


class UsageError(Error, ValueError):
    """An unknown name, or a value that is out of range."""

    exit_code = 2


class FileError(Error, OSError):
    """A file cannot be read, written or understood."""

    exit_code = 3


class Diverged(Error):
    """A run diverged, or its method cannot meet its tolerance. ``error.run`` has its rows up to there."""

    exit_code = 4
    run: Run | None = None


class GraphicsError(Error):
    """Nothing can be drawn here."""

    exit_code = 5

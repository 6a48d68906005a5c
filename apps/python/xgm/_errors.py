# SPDX-License-Identifier: Apache-2.0
"""What the package raises."""

from __future__ import annotations

from typing import NamedTuple, Sequence


class Error(RuntimeError):
    """A run that failed.

    ``message`` says what is wrong and what to do about it, ``stage`` is the path of the stage that
    failed ("matcher.cost"), "" outside of stages. If a stage written in Python raised an exception,
    that is the ``__cause__``.
    """

    def __init__(self, message: str, stage: str = "") -> None:
        super().__init__(f"{stage}: {message}" if stage else message)
        self.message = message
        self.stage = stage


class Cancelled(Error):
    """A run that was ended by its ``cancel`` argument."""

    def __init__(self, message: str = "the run was cancelled", stage: str = "") -> None:
        super().__init__(message, stage)


class UsageError(Error, ValueError):
    """A mistake of the caller, found before any work is done."""


class Diagnostic(NamedTuple):
    """A mistake in a pipeline file. Line and column are counted from 1; 0 if unknown."""

    file: str
    line: int
    column: int
    message: str
    remedy: str

    def __str__(self) -> str:
        place = self.file
        if self.line > 0:
            place += f":{self.line}:{self.column}"
        return f"{place}: error: {self.message}; {self.remedy}"


class ConfigError(UsageError):
    """A pipeline with mistakes; ``diagnostics`` lists all of them, sorted by place."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__("\n".join(map(str, diagnostics)))
        self.diagnostics = list(diagnostics)

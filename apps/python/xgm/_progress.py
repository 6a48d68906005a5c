# SPDX-License-Identifier: Apache-2.0
"""How far a run is: told to a function of the user's, or shown as a bar; and the run's log."""

from __future__ import annotations

import logging
import sys
import time
from typing import Any, Callable, Optional, Union

from . import _native
from ._errors import UsageError

ProgressFunction = Callable[[float, str], Any]
Progress = Union[None, bool, ProgressFunction]

logger = logging.getLogger("xgm")
_LEVELS = {"debug": logging.DEBUG, "info": logging.INFO, "warning": logging.WARNING}
_SECONDS_BEFORE_A_BAR = 0.5  # short runs would only flicker


def _log(level: str, path: str, text: str) -> None:
    logger.log(_LEVELS[level], "%s", f"{path}: {text}" if path else text)


def _in_notebook() -> bool:
    shell = sys.modules.get("IPython")
    if shell is None:
        return False
    running = shell.get_ipython()
    return running is not None and "IPKernelApp" in getattr(running, "config", {})


class _Bar:
    """A bar of tqdm, which appears if the run is not over soon."""

    def __init__(self, make: Callable[..., Any]) -> None:
        self._make = make
        self._start = time.monotonic()
        self._bar: Optional[Any] = None

    def __call__(self, share: float, stage: str) -> None:
        if self._bar is None:
            if time.monotonic() - self._start < _SECONDS_BEFORE_A_BAR:
                return
            self._bar = self._make(total=1.0, bar_format="{l_bar}{bar}| {elapsed}{postfix}",
                                   leave=False)
        self._bar.set_postfix_str(stage, refresh=False)
        self._bar.update(share - self._bar.n)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


def _bar_if_seen() -> Optional[_Bar]:
    """A bar, if somebody sees it and tqdm is there."""
    if not _in_notebook() and not (sys.stderr is not None and sys.stderr.isatty()):
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return _Bar(tqdm)


class Watch:
    """Hooks of a run, for ``with``. ``cancel`` is anything with ``is_set()``, such as
    threading.Event."""

    def __init__(self, progress: Progress, cancel: Optional[Any]) -> None:
        if not (progress is None or isinstance(progress, bool) or callable(progress)):
            raise UsageError(f"progress={progress!r}: give a function of the share that is done and "
                             "the path of the stage, or False")
        if cancel is not None and not hasattr(cancel, "is_set"):
            raise UsageError(f"cancel={cancel!r}: give a threading.Event, or what has is_set()")
        self._bar = _bar_if_seen() if progress is None or progress is True else None
        told = progress if callable(progress) else self._bar
        self.hooks = _native.Hooks(told, _log, None if cancel is None else cancel.is_set)

    def __enter__(self) -> Any:
        return self.hooks

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()

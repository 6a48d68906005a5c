# SPDX-License-Identifier: Apache-2.0
"""What stages in Python are given, and whether what they return is what is wanted of their kind."""

from __future__ import annotations

from typing import Any, Callable, Dict, Iterator, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._result import Map, STATUS

Floats = NDArray[np.float32]
Bytes = NDArray[np.uint8]
_NO_MATCH = 255
_MAX_COST = 254


class View(NamedTuple):
    """An image as stages see it: read-only planes of float32, shape (height, width), grey levels 0
    to 255; one (grey) or three (blue, green, red). `valid` is 0 where a pixel has no data, or None
    if all have."""

    planes: Tuple[Floats, ...]
    valid: Optional[Bytes]

    @property
    def grey(self) -> Floats:
        """One plane: the luma of a colour image."""
        if len(self.planes) == 1:
            return self.planes[0]
        blue, green, red = self.planes
        luma: Floats = (blue * np.float32(0.114) + green * np.float32(0.587)
                        + red * np.float32(0.299))
        return luma

    @property
    def shape(self) -> Tuple[int, ...]:
        """(height, width)"""
        return self.planes[0].shape


class Pair(NamedTuple):
    """The view that is matched, and the other one. Pixel (x, y) of `base` with disparity d lies at
    (x - d, y) of `match`. `is_reverse`: whether the base is the right view."""

    base: View
    match: View
    is_reverse: bool


def _pair(shown: Any) -> Pair:
    base, match, is_reverse = shown
    return Pair(View(*base), View(*match), is_reverse)


def _floats(what: str, values: Any, shape: Tuple[int, ...]) -> Floats:
    array = np.asarray(values)
    if array.shape != shape:
        raise ValueError(f"{what} has shape {array.shape}; {shape} is wanted, as (height, width)")
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what} is of type {array.dtype}; float32 is wanted")
    return np.ascontiguousarray(array, dtype=np.float32)


def _statuses(values: Any, shape: Tuple[int, ...]) -> Bytes:
    array = np.asarray(values)
    if array.shape != shape or array.dtype != np.uint8:
        raise ValueError(f"the status has shape {array.shape} and type {array.dtype}; {shape} and "
                         "uint8 are wanted")
    return np.ascontiguousarray(array)


def _two(result: Any, shape: Tuple[int, ...]) -> Tuple[Floats, Optional[Bytes]]:
    """Of a Map, (disparity, status), or disparities alone."""
    if isinstance(result, Map):
        result = result.disparity, result.status
    if isinstance(result, tuple):
        if len(result) != 2:
            raise ValueError(f"run() returned {len(result)} values; (disparity, status) is wanted")
        return _floats("the disparity", result[0], shape), _statuses(result[1], shape)
    if result is None:
        raise TypeError("run() returned None; an array of disparities is wanted")
    return _floats("the disparity", result, shape), None


def _with_status(disparity: Floats, before: Bytes, lost: str, found: str) -> Tuple[Floats, Bytes]:
    """Statuses where only disparities were returned: they change where a disparity comes or goes."""
    has = np.isfinite(disparity)
    had = before <= STATUS.index("filled")
    status = before.copy()
    status[had & ~has] = STATUS.index(lost)
    status[~had & has] = STATUS.index(found)
    return np.where(has, disparity, np.float32(np.nan)), status


def _call_filter(instance: Any) -> Callable[..., Any]:
    def call(shown: Any, pair: Any, context: Any) -> Tuple[Floats, Bytes]:
        given = Map(*shown)
        disparity, status = _two(instance.run(given, _pair(pair), context), given.disparity.shape)
        if status is not None:
            return disparity, status
        return _with_status(disparity, given.status, "ambiguous", "filled")

    return call


def _call_refinement(instance: Any) -> Callable[..., Any]:
    def call(shown: Any, around: Floats, context: Any) -> Tuple[Floats, Bytes]:
        given = Map(*shown)
        disparity, _ = _two(instance.run(given, around, context), given.disparity.shape)
        # What has no disparity keeps none, whatever is computed there.
        return np.where(np.isfinite(given.disparity), disparity, np.float32(np.nan)), given.status

    return call


def _call_matcher(instance: Any) -> Callable[..., Any]:
    def call(shown: Any, begin: int, end: int, context: Any) -> Tuple[Floats, Bytes]:
        pair = _pair(shown)
        shape = pair.base.shape
        disparity, status = _two(instance.run(pair, range(begin, end), context), shape)
        if status is None:
            nothing = np.full(shape, STATUS.index("out_of_range"), np.uint8)
            disparity, status = _with_status(disparity, nothing, "out_of_range", "valid")
        if pair.base.valid is not None:
            unusable = pair.base.valid == 0
            disparity = np.where(unusable, np.float32(np.nan), disparity)
            status = np.where(unusable, np.uint8(STATUS.index("masked")), status)
        return disparity, status

    return call


def _costs(d: int, values: Any, shape: Tuple[int, ...], bound: int) -> Bytes:
    """Rounded; what is not finite cannot be matched."""
    array = np.asarray(values)
    if array.dtype == np.bool_:
        array = array.astype(np.uint8)
    costs = _floats(f"the costs of disparity {d}", array, shape)
    finite = np.isfinite(costs)
    rounded = np.rint(np.where(finite, costs, np.float32(0)))
    if rounded.size and (rounded.min() < 0 or rounded.max() > bound):
        raise ValueError(f"the costs of disparity {d} lie in {costs[finite].min():g} to "
                         f"{costs[finite].max():g}; 0 to max_cost = {bound} are wanted")
    return np.where(finite, rounded, np.float32(_NO_MATCH)).astype(np.uint8)


def _call_cost(instance: Any) -> Callable[..., Any]:
    bound = getattr(instance, "max_cost", _MAX_COST)
    if type(bound) is not int or not 0 < bound <= _MAX_COST:
        raise ValueError(f"max_cost is {bound!r}; a whole number of 1 to {_MAX_COST} is wanted")

    def slices(pair: Pair, searched: range, context: Any) -> Iterator[Bytes]:
        given = iter(instance.run(pair, searched, context))
        for i, d in enumerate(searched):
            try:
                values = next(given)
            except StopIteration:
                raise ValueError(f"run() gave costs of {i} disparities; {len(searched)} are "
                                 "wanted") from None
            yield _costs(d, values, pair.base.shape, bound)
            context.progress((i + 1) / len(searched))
        if next(given, None) is not None:
            raise ValueError(f"run() gave costs of more than {len(searched)} disparities")

    def call(shown: Any, begin: int, end: int, context: Any) -> Tuple[int, Iterator[Bytes]]:
        return bound, slices(_pair(shown), range(begin, end), context)

    return call


#: For each kind, the function that the library calls, made of an instance of the user's class.
CALLS: Dict[str, Callable[[Any], Callable[..., Any]]] = {
    "cost": _call_cost,
    "filter": _call_filter,
    "matcher": _call_matcher,
    "refinement": _call_refinement,
}
Context = _native.Context

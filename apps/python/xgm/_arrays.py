# SPDX-License-Identifier: Apache-2.0
"""Arrays of users as the library takes them: checked, and copied only where their layout is another."""

from __future__ import annotations

import os
from typing import Any, Optional, Sequence, Tuple, TypeGuard, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import UsageError

PathLike = Union[str, "os.PathLike[str]"]
_IMAGE_TYPES = ("uint8", "uint16", "float32", "float64")


def is_path(value: object) -> TypeGuard[PathLike]:
    return isinstance(value, (str, os.PathLike))


def with_plain_rows(array: NDArray[Any]) -> NDArray[Any]:
    """The same values, each row one after the other in memory; no copy if they are so already."""
    item = array.itemsize
    channels = array.shape[2] if array.ndim == 3 else 1
    row = array.shape[1] * channels * item
    plain = (
        array.dtype.isnative
        and array.strides[0] >= row
        and array.strides[1] == channels * item
        and (array.ndim == 2 or array.strides[2] == item)
    )
    if plain:
        return array
    rows: NDArray[Any] = np.empty(array.shape, array.dtype.newbyteorder("="))
    if array.ndim == 2:
        rows[:] = array
    else:  # numpy is slow at pixels whose channels it has to turn, as in image[:, :, ::-1]
        for channel in range(channels):
            rows[:, :, channel] = array[:, :, channel]
    return rows


def _words(shape: Sequence[int]) -> str:
    return "(" + ", ".join(map(str, shape)) + ")"


def _usable(name: str, masked: Optional[NDArray[Any]], mask: Optional[Any],
            shape: Tuple[int, ...]) -> Optional[NDArray[np.uint8]]:
    """Where a pixel may be used: it is so neither if numpy masks it, nor if ``mask`` is 0 there."""
    usable: Optional[NDArray[np.bool_]] = None
    if masked is not None:
        usable = ~(masked.any(axis=2) if masked.ndim == 3 else masked)
    if mask is not None:
        given = np.asarray(mask)
        if given.shape != shape:
            raise UsageError(f"the mask of the {name} image has shape {_words(given.shape)}; "
                             f"give one of the image's shape, {_words(shape)}")
        if given.dtype.kind not in "bui":
            raise UsageError(f"the mask of the {name} image is of {given.dtype}; give bool or whole "
                             "numbers that are not 0 where a pixel may be used")
        usable = given != 0 if usable is None else usable & (given != 0)
    return None if usable is None else np.ascontiguousarray(usable).view(np.uint8)


def to_image(name: str, image: Any, mask: Optional[Any] = None) -> Any:
    """A _native.ArrayImage of a grey or colour array, or a masked one."""
    masked = None
    if isinstance(image, np.ma.MaskedArray):
        masked = np.ma.getmaskarray(image)
        image = image.data
    if not isinstance(image, np.ndarray):
        raise UsageError(f"the {name} image is of type {type(image).__name__}; give a numpy array of "
                         "shape (height, width) or (height, width, channels), or the name of a file")
    if image.ndim == 3 and image.shape[2] == 1:
        image = image[:, :, 0]
        masked = None if masked is None else masked[:, :, 0]
    if image.ndim not in (2, 3) or (image.ndim == 3 and image.shape[2] not in (2, 3, 4)):
        raise UsageError(f"the {name} image has shape {_words(image.shape)}; give (height, width), "
                         "(height, width, 3), or one channel more, which is alpha")
    if 0 in image.shape:
        raise UsageError(f"the {name} image has shape {_words(image.shape)}: it has no pixels")
    if image.dtype.newbyteorder("=").name not in _IMAGE_TYPES:
        raise UsageError(f"the {name} image is of {image.dtype}; convert it to one of "
                         + ", ".join(_IMAGE_TYPES))
    usable = _usable(name, masked, mask, image.shape[:2])
    return _native.ArrayImage(with_plain_rows(image), usable)


def to_map(name: str, values: Any) -> NDArray[np.float32]:
    """Disparities in px as float32; masked ones and those that are not finite are NaN."""
    if isinstance(values, np.ma.MaskedArray):
        values = np.ma.filled(values.astype(np.float32), np.nan)
    array = np.asarray(values)
    if array.ndim != 2 or 0 in array.shape or array.dtype.kind not in "fiu":
        raise UsageError(f"{name}: has shape {_words(array.shape)} and type {array.dtype}; give "
                         "disparities in px as an array of shape (height, width)")
    return with_plain_rows(array.astype(np.float32, copy=False))


def to_mask(name: str, values: Optional[Any], shape: Tuple[int, ...]) -> Optional[NDArray[np.uint8]]:
    """A mask of uint8; True becomes 255."""
    if values is None:
        return None
    array = np.asarray(values)
    if array.shape != shape or array.dtype.kind not in "bui":
        raise UsageError(f"{name}: has shape {_words(array.shape)} and type {array.dtype}; give a "
                         f"mask of shape {_words(shape)}, bool or uint8")
    if array.dtype == np.bool_:
        return np.ascontiguousarray(array).view(np.uint8) * np.uint8(255)
    return with_plain_rows(array.astype(np.uint8, copy=False))


def status_of(disparity: NDArray[np.float32]) -> NDArray[np.uint8]:
    """The statuses of a map of which only the disparities are known: valid, or out of range."""
    out_of_range = _native.statuses.index("out_of_range")
    return np.where(np.isfinite(disparity), 0, out_of_range).astype(np.uint8)


def to_threads(threads: Any) -> int:
    """How many there may be; 0 for all processors."""
    if not isinstance(threads, (int, np.integer)) or isinstance(threads, bool) or threads < 0:
        raise UsageError(f"threads={threads!r}: give how many, or 0 for all processors")
    return int(threads)


def to_tiles(tiles: Any) -> Union[bool, Tuple[int, int]]:
    """Whether images are matched in parts, or the size of these."""
    smallest = 64
    if isinstance(tiles, bool):
        return tiles
    try:
        width, height = tiles
        if min(width, height) >= smallest:
            return int(width), int(height)
    except (TypeError, ValueError):
        pass
    raise UsageError(f"tiles={tiles!r}: give True, or (width, height) in px, each at least {smallest}")


def to_range(disparities: Any) -> Tuple[int, int]:
    """``(begin, end)`` or ``range(begin, end)``; the end is excluded."""
    if isinstance(disparities, range) and disparities.step == 1:
        disparities = (disparities.start, disparities.stop)
    try:
        begin, end = (int(value) if float(value).is_integer() else None for value in disparities)
    except (TypeError, ValueError):
        begin = end = None
    if begin is None or end is None or begin >= end:
        raise UsageError(f"disparities={disparities!r}: give (first, last + 1) in whole px, for "
                         "example (0, 128) for 0 to 127")
    return begin, end

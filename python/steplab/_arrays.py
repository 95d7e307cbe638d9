"""What is given to steplab, checked: a message of its own for each mistake."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from ._errors import UsageError


def array_from(value: Any, name: str, shape: tuple[int | None, ...]) -> np.ndarray:
    """Real numbers of this shape (None: any length) as contiguous float64; copied only where they are not that already."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise UsageError(f"{name} must be real numbers, such as dtype float64 (got dtype {array.dtype})")
    fits = len(array.shape) == len(shape) and all(n is None or n == m for n, m in zip(shape, array.shape))
    if not fits:
        wanted = "(" + ", ".join("n" if n is None else str(n) for n in shape) + ("," if len(shape) == 1 else "") + ")"
        raise UsageError(f"{name} must have the shape {wanted} (got {array.shape})")
    return np.ascontiguousarray(array, dtype=np.float64)


def array_to_fill(out: Any, shape: tuple[int, ...]) -> np.ndarray:
    """An array that results can be written into, or a new one. Nothing is converted: the caller looks into `out`."""
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray):
        raise UsageError(f"out must be a NumPy array (got {type(out).__name__})")
    if out.dtype != np.float64:
        raise UsageError(f"out must have the dtype float64 (got {out.dtype})")
    if out.shape != shape:
        raise UsageError(f"out must have the shape {shape} (got {out.shape})")
    if not out.flags.c_contiguous:
        raise UsageError(f"out must be contiguous, row after row (got strides {out.strides})")
    if not out.flags.writeable:
        raise UsageError("out is read-only")
    return out


def number_from(value: Any, name: str) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise UsageError(f"{name} must be a number (got {value!r})") from None


def count_from(value: Any, name: str, least: int = 0) -> int:
    """An integer from `least` to the largest that a double has exactly."""
    most = 2**53
    try:
        count = int(value)
        if count != value:
            raise ValueError
    except (TypeError, ValueError, OverflowError):
        raise UsageError(f"{name} must be an integer >= {least} (got {value!r})") from None
    if not least <= count <= most:
        raise UsageError(f"{name} must be an integer from {least} to {most} (got {value!r})")
    return count


def word_from(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise UsageError(f"{name} must be a text (got {value!r})")
    return value


def texts_from(parameters: Mapping[str, Any]) -> dict[str, str]:
    """Values of parameters as the library takes them; numbers exactly."""
    texts = {}
    for name, value in parameters.items():
        if isinstance(value, (bool, np.bool_)):
            texts[name] = str(int(value))
        elif isinstance(value, str):
            texts[name] = value
        elif isinstance(value, (int, np.integer)):
            texts[name] = str(int(value))
        else:
            texts[name] = repr(number_from(value, name))
    return texts


def values_from(texts: Mapping[str, str]) -> dict[str, Any]:
    """The other way: whole numbers as int, choices as words."""

    def value(text: str) -> Any:
        for kind in (int, float):
            try:
                return kind(text)
            except ValueError:
                pass
        return text

    return {name: value(text) for name, text in texts.items()}


def words_from(value: Any, name: str) -> list[str]:
    if value is None:
        return []
    if isinstance(value, str):
        return [value]
    return [word_from(each, name) for each in value]

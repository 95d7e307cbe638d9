"""What is given to steplab, checked: a message of its own for each mistake, as UsageError."""

from __future__ import annotations

import os
from typing import Any, Mapping, NoReturn

import numpy as np
import numpy.typing as npt

from ._errors import UsageError


def refuse(value: Any, name: str, wanted: str) -> NoReturn:
    """Raises UsageError: what is wrong with this argument, and what would be right."""
    raise UsageError(f"{name} must be {wanted} (got {_shown(value)})") from None


def _shown(value: Any, most: int = 60) -> str:
    """A value in a message: short, in one line."""
    try:
        text = " ".join(repr(value).split())
    except Exception:  # of any class, as integers of too many digits raise
        text = f"a value of type {type(value).__name__}"
    return text if len(text) <= most else text[: most - 3] + "..."


def of_type(value: Any, name: str, kind: type | tuple[type, ...], wanted: str) -> Any:
    """The value, if it is of this type."""
    if not isinstance(value, kind):
        refuse(value, name, wanted)
    return value


def array_from(value: Any, name: str, shape: tuple[int | None, ...]) -> npt.NDArray[np.float64]:
    """Real numbers of this shape (None: any length) as contiguous float64; copied only where they are not that already."""
    wanted = "(" + ", ".join("n" if n is None else str(n) for n in shape) + ("," if len(shape) == 1 else "") + ")"
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):  # rows of different lengths
        refuse(value, name, f"an array of real numbers of the shape {wanted}")
    if array.dtype.kind not in "fiu":
        raise UsageError(f"{name} must be real numbers, such as dtype float64 (got dtype {array.dtype})")
    fits = len(array.shape) == len(shape) and all(n is None or n == m for n, m in zip(shape, array.shape))
    if not fits:
        raise UsageError(f"{name} must have the shape {wanted} (got {array.shape})")
    return np.ascontiguousarray(array, dtype=np.float64)


def array_to_fill(out: Any, shape: tuple[int, ...]) -> npt.NDArray[np.float64]:
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
    if isinstance(value, (str, bytes, bytearray)):
        refuse(value, name, "a number")
    try:
        return float(value)
    except (TypeError, ValueError):
        refuse(value, name, "a number")
    except OverflowError:
        refuse(value, name, "a number of at most 1.797e308")


def count_from(value: Any, name: str, least: int = 0, most: int = 2**53) -> int:
    """An integer in this range, by default up to the largest that a double has exactly."""
    wanted = f"an integer from {least} to {most}"
    try:
        count = int(value)
        if count != value:
            raise ValueError
    except (TypeError, ValueError, OverflowError):
        refuse(value, name, wanted)
    if not least <= count <= most:
        refuse(value, name, wanted)
    return count


def flag_from(value: Any, name: str) -> bool:
    return bool(of_type(value, name, (bool, np.bool_), "True or False"))


def word_from(value: Any, name: str) -> str:
    """A text that can be encoded."""
    text: str = of_type(value, name, str, "a text")
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise UsageError(
            f"{name} must be Unicode text (character {error.start} is a lone surrogate: {text[error.start]!a})"
        ) from None
    return text


def path_from(value: Any, name: str) -> bytes:
    """The name of a file, as the system has it."""
    try:
        path = os.fsencode(value)
    except (TypeError, UnicodeEncodeError):
        path = b"\0"
    if b"\0" in path:
        refuse(value, name, "the path of a file, as str or os.PathLike")
    return path


def mapping_from(value: Any, name: str, wanted: str = "a dict of values by name") -> dict[str, Any]:
    given = of_type(value, name, Mapping, wanted)
    return {word_from(key, f"each name in {name}"): given[key] for key in given}


def items_from(value: Any, name: str, wanted: str) -> list[Any]:
    """The entries of a list, or of whatever else has some; of a text or a mapping they are not meant."""
    if isinstance(value, (str, bytes, bytearray, Mapping)):
        refuse(value, name, wanted)
    try:
        return list(value)
    except TypeError:
        refuse(value, name, wanted)


def words_from(value: Any, name: str) -> list[str]:
    """None, a word or several."""
    if value is None:
        return []
    if isinstance(value, str):
        return [word_from(value, name)]
    return [word_from(each, f"{name}[{i}]") for i, each in enumerate(items_from(value, name, "a text or a list of texts"))]


def texts_from(parameters: Mapping[str, Any], where: str = "") -> dict[str, str]:
    """Values of parameters as the library takes them; numbers exactly."""

    def text(value: Any, name: str) -> str:
        if isinstance(value, str):
            return word_from(value, name)
        number = number_from(value, name)
        return str(int(value)) if isinstance(value, (bool, np.bool_, int, np.integer)) else repr(number)

    given = mapping_from(parameters, f"{where}parameters")
    return {name: text(value, f"{where}{name}") for name, value in given.items()}


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

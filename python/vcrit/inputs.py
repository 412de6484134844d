"""What callers give as numbers: arrays of any library, with units, masks and labels."""

import contextlib
import operator
import os
import re
import sys
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _vcrit


# numpy.ma has no types.
ma: Any = np.ma


_MOST = 2**31 - 1  # an int of C++

Parse: TypeAlias = Callable[[str], float]
"""The SI value of a text with a unit; raises InputError."""


class Numbers(NamedTuple):
    """Plain numbers of a kind that converts to float64 without loss of meaning."""

    values: npt.NDArray[Any]
    mask: npt.NDArray[np.bool_] | None
    """None where the caller's array has no mask; masked values are NaN in `values`."""


def refused(place: str, found: str, expected: str) -> _vcrit.InputError:
    error = _vcrit.InputError(f"{place}: found {found}; expected {expected}")
    error.place, error.found, error.expected = (place, None, None), found, expected
    return error


def characters(text: Any, place: str) -> str:
    """A text, unless it holds half a character, which no file and no message can."""
    if not isinstance(text, str):
        raise refused(place, _described(text), "a text")
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise refused(place, f"{text[error.start]!a}, a lone surrogate",
                      "text of whole characters") from None
    return text


def name_of_file(name: str | bytes) -> bytes:
    """As the system has it; what Python shows of bytes that are no UTF-8 is those bytes again."""
    try:
        return os.fsencode(name)
    except UnicodeEncodeError:
        assert isinstance(name, str)
        return characters(name, "file").encode()


def numbers(given: Any, place: str, parse: Parse) -> Numbers:
    """`given` without unit, in SI."""
    unit = _unit(given)
    if unit is not None:
        plain = numbers(_magnitude(given), place, parse)
        return Numbers(plain.values * parse(f"1 {unit}"), plain.mask)
    if not isinstance(given, ma.MaskedArray):
        return Numbers(_array(given, place, parse), None)
    mask = ma.getmaskarray(given)
    values = _array(ma.getdata(given), place, parse)
    return Numbers(np.where(mask, np.nan, values) if mask.any() else values, mask)


def number_with_unit(given: Any, place: str) -> str:
    """One number, with a unit or in SI, as the text that a setting takes."""
    unit = _unit(given)
    try:
        plain = float(given if unit is None else _magnitude(given))
    except (TypeError, ValueError, OverflowError):
        raise refused(place, _described(given), "one number (SI), or a text with a unit") from None
    return repr(plain) if unit is None else f"{plain!r} {unit}"


def text_with_unit(given: Any, place: str) -> str:
    """The same; a text stays as it is, and None becomes the empty text."""
    if given is None:
        return ""
    return characters(given, place) if is_text(given) else number_with_unit(given, place)


def plain_number(given: Any, place: str) -> float:
    try:
        return float(given)
    except (TypeError, ValueError, OverflowError):
        raise refused(place, _described(given), "a number") from None


def whole_number(given: Any, place: str) -> int:
    """One that the module takes; what range it must be in, the module says."""
    try:
        number = operator.index(given)
    except TypeError:
        raise refused(place, _described(given), "a whole number") from None
    if not -_MOST <= number <= _MOST:
        raise refused(place, _described(given), f"a whole number of at most {_MOST}")
    return number


def flag(given: Any, place: str) -> bool:
    """True or False, also of NumPy, as 1 or 0, or as None; no text, which would be true whatever it says."""
    with contextlib.suppress(TypeError, ValueError):  # of pandas.NA, of an array of several
        if hasattr(type(given), "__bool__"):
            return bool(given)
    raise refused(place, _described(given), "True or False")


def is_text(given: Any) -> bool:
    return isinstance(given, str)


def joined(masks: list[npt.NDArray[np.bool_] | None],
           shape: tuple[int, ...]) -> npt.NDArray[np.bool_] | None:
    """What is masked in any of them; None where none has a mask."""
    present = [mask for mask in masks if mask is not None]
    if not present:
        return None
    whole = np.zeros(shape, dtype=np.bool_)
    for mask in present:
        whole |= mask
    return whole


def is_labelled(given: Any) -> bool:
    return _of_xarray(given) or _of_pandas(given)


def labelled(function: Callable[[Mapping[str, Any]], Any], given: Mapping[str, Any],
             results: int, parsers: Callable[[str], Parse]) -> Any:
    """`function` of plain arrays, its result (or its several results) with the labels of `given`.

    DataArrays of xarray are broadcast by the names of their dimensions; Series of pandas must
    have one index.
    """
    if any(_of_xarray(value) for value in given.values()):
        return _by_dimensions(function, given, results, parsers)
    series = {name: value for name, value in given.items() if _of_pandas(value)}
    first = _one_index(series)
    found = function({name: _of_series(name, value) if name in series else value
                      for name, value in given.items()})

    def relabelled(values: Any) -> Any:
        if np.shape(values) != np.shape(first):
            raise refused(next(iter(series)), f"a Series of {np.shape(first)[0]} values beside "
                          "arrays of another shape", "as many values as in the Series")
        return type(first)(values, index=first.index)

    return relabelled(found) if results == 1 else tuple(map(relabelled, found))


def _one_index(series: Mapping[str, Any]) -> Any:
    for name, each in series.items():
        if hasattr(each, "columns"):
            raise refused(name, "a DataFrame", f"a Series or an array: {name}.to_numpy()")
    (first_name, first), *others = series.items()
    for name, each in others:
        if not first.index.equals(each.index):
            raise refused(name, f"a Series with another index than that of {first_name}",
                          "one index: see Series.align(), or to_numpy() for arrays without it")
    return first


def _of_series(name: str, series: Any) -> npt.NDArray[Any]:
    if hasattr(series.dtype, "units") or getattr(series.dtype, "kind", "O") in "cmM":
        raise refused(name, f"a Series of {series.dtype}", "numbers in SI")
    try:
        return np.asarray(series.to_numpy(dtype=np.float64, na_value=np.nan))
    except (TypeError, ValueError):
        raise refused(name, f"a Series of {series.dtype}", "numbers") from None


def _by_dimensions(function: Callable[[Mapping[str, Any]], Any], given: Mapping[str, Any],
                   results: int, parsers: Callable[[str], Parse]) -> Any:
    arrays = {}
    for name, value in given.items():
        if not _of_xarray(value):
            if np.ndim(value) > 0:
                raise refused(name, "an array without dimensions' names beside one of xarray",
                              "a DataArray or a number")
            continue
        if hasattr(value, "data_vars"):
            raise refused(name, "a Dataset", "one of its DataArrays")
        unit = _unit(value)
        arrays[name] = value if unit is None else value * parsers(name)(f"1 {unit}")
    xarray: Any = sys.modules[type(next(iter(arrays.values()))).__module__.partition(".")[0]]
    return xarray.apply_ufunc(
        lambda *plain: function({**given, **dict(zip(arrays, plain))}), *arrays.values(),
        output_core_dims=[()] * results)


def _of_xarray(given: Any) -> bool:
    return hasattr(given, "dims") and hasattr(given, "values")


def _of_pandas(given: Any) -> bool:
    return hasattr(given, "to_numpy") and hasattr(given, "index")


def _array(given: Any, place: str, parse: Parse) -> npt.NDArray[Any]:
    try:
        array = np.asarray(given)
    except (TypeError, ValueError):
        raise refused(place, _described(given), "a number or an array of numbers") from None
    if array.dtype.kind in "biuf":
        return array
    if array.dtype.kind == "U":
        parsed = [parse(characters(str(text), place)) for text in array.flat]
        return np.array(parsed, dtype=np.float64).reshape(array.shape)
    if array.ndim == 0 and array.dtype.kind == "O":  # Decimal, Fraction
        return np.array(float(number_with_unit(given, place)))
    what = "objects" if array.dtype.kind == "O" else str(array.dtype)
    raise refused(place, f"an array of {what}",
                  "numbers in SI (of objects that are numbers, array.astype(float))")


def _described(given: Any) -> str:
    text = repr(given)
    return ascii(text if len(text) <= 60 else text[:57] + "...")[1:-1]


def _unit(given: Any) -> str | None:
    """The unit of a quantity of pint, astropy or unyt, or that a DataArray names; else None."""
    if _of_xarray(given):
        unit = getattr(given, "attrs", {}).get("units")
        return None if unit is None else _udunits(str(unit))
    unit = getattr(given, "units", getattr(given, "unit", None))
    if unit is None or not (hasattr(given, "magnitude") or hasattr(given, "value")):
        return None
    return _udunits(f"{unit:D}" if hasattr(given, "magnitude") else str(unit))


def _magnitude(given: Any) -> Any:
    if _of_xarray(given):
        return given.values
    return given.magnitude if hasattr(given, "magnitude") else given.value


def _udunits(unit: str) -> str:
    """Products and powers as udunits writes them; a plain number is "1"."""
    if unit.strip() in ("", "dimensionless"):
        return "1"
    return re.sub(r"\s*\*\s*", ".", re.sub(r"\s*\*\*\s*", "^", unit.strip()))

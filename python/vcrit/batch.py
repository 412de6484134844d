"""v* over arrays of any shape, in blocks that the C++ evaluator takes where they lie."""

from collections.abc import Iterator, Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _vcrit
from .inputs import Numbers, Parse, is_labelled, joined, labelled, ma, numbers, refused

Array: TypeAlias = npt.NDArray[np.float64]

# Values a block: few enough that Ctrl-C is heard at once and what must be copied (other types,
# strides) stays in the cache, many enough that a block's own cost does not count.
BLOCK = 1 << 16


def parser(scene: _vcrit.Scene, name: str) -> Parse:
    """Of texts that are values of the parameter `name`."""
    return lambda text: _vcrit.parse_value(scene, name, text)


def evaluated(scene: _vcrit.Scene, given: Mapping[str, Any], out: Array | None) -> Any:
    """v* of `scene` with the values in `given`, broadcast; a number where all are numbers."""
    _refuse_room(out)
    formula = _vcrit.CriticalVelocities(scene, list(given))
    with_labels = [name for name, values in given.items() if is_labelled(values)]
    if not with_labels:
        return _of_plain(scene, formula, given, out)
    if out is not None:
        raise refused("out", f"an array beside {with_labels[0]}, which has labels",
                      f"no out, or {with_labels[0]} without labels: numpy.asarray()")
    return labelled(lambda plain: _of_plain(scene, formula, plain, None), given, 1,
                    lambda name: parser(scene, name))


def _of_plain(scene: _vcrit.Scene, formula: _vcrit.CriticalVelocities, given: Mapping[str, Any],
              out: Array | None) -> Any:
    columns = [numbers(values, name, parser(scene, name)) for name, values in given.items()]
    masked = any(column.mask is not None for column in columns)
    if out is not None and masked and not isinstance(out, ma.MaskedArray):
        raise refused("out", "an array without a mask", "a masked array, as values are masked")
    room = None if out is None else ma.getdata(out)
    result = _evaluated(formula, columns, room)
    mask = joined([column.mask for column in columns], np.shape(result))
    if out is not None:
        if isinstance(out, ma.MaskedArray):
            out.mask = False if mask is None else mask
        return out
    return result if mask is None else ma.MaskedArray(result, mask)[()]


def _evaluated(formula: _vcrit.CriticalVelocities, given: list[Numbers], out: Array | None) -> Any:
    columns: list[Array] = [column.values for column in given]
    arrays = [i for i, column in enumerate(columns) if column.ndim > 0]
    for i, column in enumerate(columns):
        if column.ndim == 0:
            columns[i] = np.array([column], dtype=np.float64)
    _refuse_wrong(formula, columns, arrays)
    result = np.empty(()) if out is None and not arrays else out
    with _blocks([columns[i] for i in arrays], result) as blocks:
        for *block, velocities in _tuples(blocks):
            for i, column in zip(arrays, block):
                columns[i] = column
            formula(columns, velocities)
        result = blocks.operands[-1]
    return result[()] if out is None else result


def _refuse_room(out: Any) -> None:
    if out is not None and not isinstance(out, np.ndarray):
        raise refused("out", f"a {type(out).__name__}", "an array of float64")


def _refuse_wrong(formula: _vcrit.CriticalVelocities, columns: list[Array],
                  arrays: list[int]) -> None:
    """Refuses the first value that is out of range, names its place, and leaves `out` untouched."""
    if not arrays:
        wrong = formula.first_refused(columns, 1)
        if wrong is not None:
            raise _vcrit.InputError(wrong[1].removeprefix("set "))
        return
    columns = list(columns)
    whole = [columns[i] for i in arrays]
    done = 0
    each: Any = [["readonly", "contig", "aligned"]] * len(whole)
    with np.nditer(whole, ["external_loop", "buffered", "zerosize_ok"], each,
                   [np.float64] * len(whole), order="C", casting="same_kind",
                   buffersize=BLOCK) as blocks:
        for block in _tuples(blocks):
            for i, column in zip(arrays, block):
                columns[i] = column
            wrong = formula.first_refused(columns, block[0].size)
            if wrong is not None:
                place = np.unravel_index(done + wrong[0], np.broadcast(*whole).shape)
                index = ", ".join(str(int(each)) for each in place)
                raise _vcrit.InputError(f"at index {index}: {wrong[1].removeprefix('set ')}")
            done += block[0].size


def _blocks(columns: list[Array], out: Array | None) -> np.nditer:
    """Contiguous blocks of the columns and, last, of `out`, which is made if it is None."""
    read, written = ["readonly"], ["writeonly", "allocate", "no_broadcast"]
    each: Any = [flags + ["contig", "aligned"] for flags in [read] * len(columns) + [written]]
    operands: Any = [*columns, out]
    return np.nditer(operands, ["external_loop", "buffered", "zerosize_ok", "copy_if_overlap"], each,
                     [np.float64] * len(operands), casting="same_kind", buffersize=BLOCK)


def _tuples(blocks: np.nditer) -> Iterator[tuple[Array, ...]]:
    """NumPy gives a lone operand's block bare."""
    for block in blocks:
        yield block if isinstance(block, tuple) else (block,)

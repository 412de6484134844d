"""v* over arrays of any shape, in blocks that the C++ evaluator takes where they lie."""

from collections.abc import Iterator, Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _vcrit

Array: TypeAlias = npt.NDArray[np.float64]

# Values a block: few enough that Ctrl-C is heard at once and what must be copied (other types,
# strides) stays in the cache, many enough that a block's own cost does not count.
BLOCK = 1 << 16


def evaluated(scene: _vcrit.Scene, given: Mapping[str, Any], out: Array | None) -> Any:
    """v* of `scene` with the values in `given`, broadcast; a number where all are numbers."""
    evaluate = _vcrit.CriticalVelocities(scene, list(given))
    columns: list[Array] = [np.asarray(values) for values in given.values()]
    arrays = [i for i, column in enumerate(columns) if column.ndim > 0]
    for i, column in enumerate(columns):
        if column.ndim == 0:
            columns[i] = np.array([column], dtype=np.float64)
    result = np.empty(()) if out is None and not arrays else out
    with _blocks([columns[i] for i in arrays], result) as blocks:
        for *block, velocities in _tuples(blocks):
            for i, column in zip(arrays, block):
                columns[i] = column
            evaluate(columns, velocities)
        result = blocks.operands[-1]
    return result[()] if out is None else result


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

"""Arrays of other libraries: nothing that they carry is dropped in silence.

pint, xarray and pandas need not be installed: small classes stand for what vcrit uses of them.
"""

import sys
import types
import unittest

import numpy as np
import vcrit
from support import PROJECT

ZENER = vcrit.Scene(PROJECT / "scenes/zener.toml")
FREQUENCY = np.array([10e3, 20e3, 30e3])


class Quantity:
    """As pint has it."""

    class Unit(str):
        def __format__(self, spec):
            assert spec == "D"
            return str(self)

    def __init__(self, magnitude, units):
        self.magnitude, self.units = magnitude, self.Unit(units)

    def __array__(self, dtype=None):
        return np.asarray(self.magnitude, dtype)


class AstropyQuantity(np.ndarray):
    """An array that knows its unit."""

    @staticmethod
    def of(values, unit):
        found = np.asarray(values, float).view(AstropyQuantity)
        found.unit = unit
        return found

    @property
    def value(self):
        return self.view(np.ndarray)


class Index(list):
    def equals(self, other):
        return list(self) == list(other)


class Series:
    def __init__(self, values, index):
        self._values, self.index, self.dtype = np.asarray(values), Index(index), np.dtype(float)

    def to_numpy(self, dtype=None, na_value=None):
        return np.array([na_value if each is None else each for each in self._values], dtype)

    def __array__(self, dtype=None):
        return self.to_numpy(dtype)


class DataArray:
    """Dimensions by name, as far as one array of each goes."""

    def __init__(self, values, dims, attrs=None):
        self.values, self.dims, self.attrs = np.asarray(values), tuple(dims), attrs or {}

    def __mul__(self, factor):
        return DataArray(self.values * factor, self.dims)

    def __array__(self, dtype=None):
        return self.values


def apply_ufunc(function, *arrays, output_core_dims):
    dims = tuple(dict.fromkeys(name for array in arrays for name in array.dims))
    plain = [array.values.reshape([array.values.shape[array.dims.index(name)] if name in array.dims else 1
                                   for name in dims]) for array in arrays]
    found = function(*plain)
    if len(output_core_dims) == 1:
        return DataArray(found, dims)
    assert len(found) == len(output_core_dims)
    return tuple(DataArray(values, dims) for values in found)


DataArray.__module__ = "standin_xarray.core"
sys.modules["standin_xarray"] = types.SimpleNamespace(apply_ufunc=apply_ufunc)


class Masks(unittest.TestCase):
    def test_are_kept(self):
        given = np.ma.array([1e4, 1e20, 3e4, -1.0], mask=[False, True, False, True])
        found = ZENER.critical_velocity(frequency=given)
        self.assertIsInstance(found, np.ma.MaskedArray)
        np.testing.assert_array_equal(found.mask, given.mask)
        expected = ZENER.critical_velocity(frequency=[1e4, 3e4])
        np.testing.assert_array_equal(found.compressed(), expected)
        np.testing.assert_array_equal(given.data, [1e4, 1e20, 3e4, -1])

    def test_are_broadcast(self):
        rows = np.ma.array([[1e6], [2e6]], mask=[[False], [True]])
        columns = np.ma.array(FREQUENCY, mask=[True, False, False])
        found = ZENER.critical_velocity(kd=rows, frequency=columns)
        np.testing.assert_array_equal(found.mask, [[True, False, False], [True, True, True]])
        self.assertFalse(ZENER.critical_velocity(frequency=np.ma.array(FREQUENCY)).mask.any())
        self.assertIs(ZENER.critical_velocity(frequency=np.ma.masked), np.ma.masked)

    def test_need_room_with_a_mask(self):
        given = np.ma.array(FREQUENCY, mask=[False, True, False])
        with self.assertRaisesRegex(vcrit.InputError, "^out: found an array without a mask"):
            ZENER.critical_velocity(frequency=given, out=np.empty(3))
        out = np.ma.array(np.zeros(3), mask=[True, False, False])
        self.assertIs(ZENER.critical_velocity(frequency=given, out=out), out)
        np.testing.assert_array_equal(out.mask, given.mask)
        ZENER.critical_velocity(frequency=FREQUENCY, out=out)
        self.assertFalse(out.mask.any())

    def test_of_speeds_are_kept(self):
        given = np.ma.array([0.5, -1.0, 1.5], mask=[False, True, False])
        curve = ZENER.friction_curve(velocity_ratios=given)
        for values in curve:
            np.testing.assert_array_equal(values.mask, given.mask)
        self.assertEqual(list(curve.regime.compressed()), ["stick-slip", "sliding"])


class Units(unittest.TestCase):
    def test_are_converted(self):
        for given in [Quantity(FREQUENCY / 1000, "kilohertz"), AstropyQuantity.of(FREQUENCY / 1000, "kHz"),
                      DataArray(FREQUENCY / 1000, ["f"], {"units": "kHz"})]:
            found = ZENER.critical_velocity(frequency=given)
            np.testing.assert_array_equal(getattr(found, "values", found),
                                          ZENER.critical_velocity(frequency=FREQUENCY))
        for name, given, plain in [("k0", Quantity(9, "newton / micrometer"), 9e6),
                                   ("c1", Quantity(np.array(30.0), "newton * second / meter"), 30.0),
                                   ("c1", Quantity(30.0, "kilogram * second ** -1"), 30.0),
                                   ("mu0", Quantity(0.5, "dimensionless"), 0.5),
                                   ("omega", Quantity(60_000.0, "revolution / minute"), 2000 * np.pi)]:
            with self.subTest(name):
                # One rounding of the unit's factor and one of the product.
                np.testing.assert_allclose(ZENER.critical_velocity({name: given}),
                                           ZENER.critical_velocity({name: plain}), rtol=1e-12)
                np.testing.assert_allclose(ZENER.with_values({name: given}).critical_velocity(),
                                           ZENER.with_values({name: plain}).critical_velocity(), rtol=1e-12)

        for given in [AstropyQuantity.of(25, "kHz"), DataArray(25, [], {"units": "kHz"})]:
            self.assertEqual(ZENER.with_values(frequency=given).parameters["omega"],
                             ZENER.with_values(frequency="25 kHz").parameters["omega"])

    def test_of_other_dimensions_are_refused(self):
        for name, unit in [("frequency", "newton"), ("frequency", "radian / second"), ("omega", "kilohertz"),
                           ("k0", "dimensionless"), ("mu0", "meter"), ("k0", "no such unit")]:
            for use in [ZENER.critical_velocity, ZENER.with_values]:
                with self.subTest(name=name, unit=unit), self.assertRaisesRegex(vcrit.InputError, f"{name}: found"):
                    use({name: Quantity(1.0, unit)})

    def test_of_masked_quantities_are_converted(self):
        found = ZENER.critical_velocity(frequency=Quantity(np.ma.array([10, 20], mask=[True, False]), "kilohertz"))
        np.testing.assert_array_equal(found.mask, [True, False])
        self.assertEqual(found[1], ZENER.critical_velocity(frequency=[20e3])[0])

    def test_of_speeds_are_converted(self):
        expected = ZENER.friction_curve([1e-3, 2e-3])
        for given in [Quantity(np.array([1, 2]), "millimeter / second"), ["1 mm/s", "2 mm/s"], ["1 mm/s", 2e-3]]:
            np.testing.assert_array_equal(ZENER.friction_curve(given).friction_ratio, expected.friction_ratio)
        half = ZENER.simulate(velocity_ratio=0.5)
        for given in ["50 %", Quantity(0.5, "dimensionless")]:
            self.assertEqual(ZENER.simulate(velocity_ratio=given).friction_ratio, half.friction_ratio)
        self.assertEqual(ZENER.simulate(Quantity(2, "mm/s")).velocity, ZENER.simulate("2 mm/s").velocity)
        for given in ["fast", ["fast"], Quantity(1, "meter")]:
            self.assertRaises(vcrit.InputError, ZENER.friction_curve, given)


class Dimensions(unittest.TestCase):
    def test_are_broadcast_by_name(self):
        drive = np.array([1e6, 2e6, 3e6])
        found = ZENER.critical_velocity(frequency=DataArray(FREQUENCY, ["f"]), kd=DataArray(drive, ["k"]), mu0=0.5)
        self.assertEqual(found.dims, ("f", "k"))
        np.testing.assert_array_equal(
            found.values, ZENER.critical_velocity(frequency=FREQUENCY[:, np.newaxis], kd=drive, mu0=0.5))

    def test_of_speeds_are_kept(self):
        curve = ZENER.friction_curve(velocity_ratios=DataArray([0.5, 1.5], ["speed"]))
        for values in curve:
            self.assertEqual(values.dims, ("speed",))
        self.assertEqual(list(curve.regime.values), ["stick-slip", "sliding"])

    def test_beside_arrays_without_names_are_refused(self):
        with self.assertRaisesRegex(vcrit.InputError, "^kd: found an array without dimensions' names"):
            ZENER.critical_velocity(frequency=DataArray(FREQUENCY, ["f"]), kd=np.ones(3))
        with self.assertRaisesRegex(vcrit.InputError, "^out: found an array beside frequency, which has labels"):
            ZENER.critical_velocity(frequency=DataArray(FREQUENCY, ["f"]), out=np.empty(3))


class Indices(unittest.TestCase):
    def test_are_kept(self):
        given = Series([10e3, None, 30e3], ["a", "b", "c"])
        found = ZENER.critical_velocity(frequency=given, k0=8e6, mu0=np.full(3, 0.3))
        self.assertIsInstance(found, Series)
        self.assertEqual(list(found.index), ["a", "b", "c"])
        np.testing.assert_array_equal(np.asarray(found),
                                      ZENER.critical_velocity(frequency=[10e3, np.nan, 30e3], k0=8e6, mu0=[0.3]))
        curve = ZENER.friction_curve(velocity_ratios=Series([0.5, 1.5], [3, 4]))
        for values in curve:
            self.assertEqual(list(values.index), [3, 4])

    def test_that_differ_are_refused(self):
        one, other = Series([1e4, 2e4], [0, 1]), Series([1e6, 2e6], [1, 0])
        with self.assertRaisesRegex(vcrit.InputError, "^kd: found a Series with another index than that of frequency"):
            ZENER.critical_velocity(frequency=one, kd=other)
        with self.assertRaisesRegex(vcrit.InputError, "^frequency: found a Series of 2 values beside"):
            ZENER.critical_velocity(frequency=one, kd=np.ones((2, 1)))


if __name__ == "__main__":
    unittest.main()

"""v* over arrays: NumPy's rules, the right values, and no copies."""

import math
import unittest
from decimal import Decimal
from fractions import Fraction

import numpy as np
import vcrit
from support import PROJECT, U, in_python, relative_difference, scene, scene_rows

ZENER = vcrit.Scene("scenes/zener.toml")
ELASTIC = vcrit.Scene("scenes/elastic.toml")

# What the C++ batch call promises: 1280 u an element (src/critical/batch.hpp); Zener and drive have
# four. Both sides round the units' factors alike.
BATCH = 4 * 1280 * U


def one_by_one(scene, **arrays):
    """The same by a correctly rounded call for each point."""
    broadcast = np.broadcast_arrays(*arrays.values())
    result = [scene.with_values(dict(zip(arrays, map(float, point)))).critical_velocity()
              for point in zip(*(values.flat for values in broadcast))]
    return np.reshape(result, broadcast[0].shape)


class Values(unittest.TestCase):
    def test_are_those_of_the_reference(self):
        for row in scene_rows():
            scene = vcrit.Scene(f"scenes/{row['scene']}")
            # The scene's own number, three times; a unit's factor rounds before, as in test_scene.py.
            found = scene.critical_velocity(mu0=np.full(3, scene.parameters["mu0"].value))
            self.assertEqual(found.shape, (3,))
            elements = len(scene.parameters) - 4
            for value in found:
                self.assertLess(relative_difference(float(value), row["critical_velocity"]),
                                (1280 * elements + 16) * U, row["scene"])

    def test_of_every_parameter_are_those_one_by_one(self):
        random = np.random.default_rng(1)
        for name, parameter in ZENER.parameters.items():
            with self.subTest(name=name):
                values = parameter.value * random.uniform(0.7, 1.3, 5)
                np.testing.assert_allclose(ZENER.critical_velocity({name: values}),
                                           one_by_one(ZENER, **{name: values}), rtol=BATCH)

    def test_an_element_named_like_the_array_of_results(self):
        text = (PROJECT / "scenes/elastic.toml").read_text()
        scene = vcrit.Scene.from_text(text.replace('"kn"', '"spring(out)"').replace("kn =", "out ="))
        values = scene.parameters["out"].value * np.array([1.0, 2.0])
        np.testing.assert_allclose(scene.critical_velocity({"out": values}),
                                   one_by_one(scene, out=values), rtol=BATCH)
        # It would be overwritten.
        before = values.copy()
        with self.assertRaisesRegex(vcrit.InputError, "element of this scene"):
            scene.critical_velocity(out=values)
        np.testing.assert_array_equal(values, before)

    def test_of_synonyms_are_the_same(self):
        frequency = np.array([10e3, 20e3, 35e3])
        by_frequency = ZENER.critical_velocity(frequency=frequency)
        np.testing.assert_allclose(ZENER.critical_velocity(omega=2 * np.pi * frequency), by_frequency, rtol=BATCH)
        np.testing.assert_allclose(one_by_one(ZENER, frequency=frequency), by_frequency, rtol=BATCH)

    def test_of_arrays_in_a_scene(self):
        prony = vcrit.Scene("scenes/prony.toml")
        values = np.array([1e5, 2e5])
        found = prony.critical_velocity({"k[3]": values, "frequency": 25e3})
        expected = [prony.with_values({"k[3]": value, "frequency": 25e3}).critical_velocity() for value in values]
        np.testing.assert_allclose(found, expected, rtol=22 * 1280 * U)

    def test_fill_in_symbols(self):
        text = (PROJECT / "scenes/zener.toml").read_text().replace('"5 g"', '"m"')
        masses = np.array([1e-3, 5e-3])
        np.testing.assert_allclose(vcrit.Scene.from_text(text).critical_velocity(m=masses),
                                   one_by_one(ZENER, m=masses), rtol=BATCH)

    def test_may_be_texts_with_a_unit(self):
        for texts in [["10 kHz", "25000"], ["0.01 MHz", 25e3], np.array([["10 kHz"], ["25e3 Hz"]])]:
            found = ZENER.critical_velocity(frequency=texts)
            self.assertEqual(found.shape, np.shape(texts))
            np.testing.assert_allclose(found.ravel(), ZENER.critical_velocity(frequency=[10e3, 25e3]), rtol=BATCH)

    def test_of_other_values_of_the_scene(self):
        frequency = np.array([10e3, 30e3])
        np.testing.assert_array_equal(ZENER.with_values(k0=9e6).critical_velocity(frequency=frequency),
                                      ZENER.critical_velocity(frequency=frequency, k0=9e6))
        np.testing.assert_array_equal(ZENER.critical_velocity(frequency=frequency, k0="9 N/um"),
                                      ZENER.critical_velocity(frequency=frequency, k0=9e6))


class Shapes(unittest.TestCase):
    # By hand: Eq. (31), v* = mu0 omega du_z kn/kt, so that all factors multiply.
    def test_are_broadcast(self):
        kn, kt, mu0 = np.array([[1e6], [2e6], [3e6]]), np.array([1e6, 5e6]), np.full((2, 1, 1), 0.5)
        found = ELASTIC.critical_velocity(kn=kn, kt=kt, mu0=mu0, omega=10.0, du_z=1e-7)
        self.assertEqual(found.shape, (2, 3, 2))
        np.testing.assert_allclose(found, mu0 * 10.0 * 1e-7 * kn / kt, rtol=2 * 1280 * U + 5 * U)

    def test_of_plain_numbers_is_a_number(self):
        value = ZENER.critical_velocity(frequency=25e3, k0=9e6)
        self.assertIsInstance(value, float)
        self.assertLess(relative_difference(value, ZENER.with_values(frequency=25e3, k0=9e6).critical_velocity()),
                        BATCH)

    def test_may_be_empty_or_have_one_value(self):
        self.assertEqual(ZENER.critical_velocity(k0=np.ones((0, 3))).shape, (0, 3))
        self.assertEqual(ZENER.critical_velocity(k0=[8e6], frequency=[[2e4]]).shape, (1, 1))

    def test_that_do_not_fit_are_refused(self):
        with self.assertRaisesRegex(ValueError, "could not be broadcast"):
            ZENER.critical_velocity(k0=np.ones(2), k1=np.ones(3))
        for out in [np.empty(3), np.empty((1, 2)), np.empty(1)]:
            with self.assertRaises(ValueError):
                ZENER.critical_velocity(k0=np.ones((2, 2)), out=out)

    def test_larger_than_a_block(self):
        n = 300_001  # several blocks, and a rest
        kn = np.linspace(1e6, 2e6, n)
        found = ELASTIC.critical_velocity(kn=kn)
        np.testing.assert_allclose(found, found[0] * kn / kn[0], rtol=2 * (2 * 1280 * U + 5 * U))
        # Columns are read across blocks, and beside them a value for all and a strided one.
        grid = ELASTIC.critical_velocity(kn=kn[:, np.newaxis], kt=np.array([1e6, 2e6]))
        np.testing.assert_allclose(grid[:, 0], 2 * grid[:, 1], rtol=2 * (2 * 1280 * U + 5 * U))
        np.testing.assert_allclose(grid[:, 0] / grid[0, 0], kn / kn[0], rtol=2 * (2 * 1280 * U + 5 * U))


class WrongValues(unittest.TestCase):
    def test_are_named_by_their_index_and_nothing_is_written(self):
        values = np.full(200_000, 20e3)
        values[150_000] = values[170_000] = -1
        out = np.full(200_000, 7.0)
        with self.assertRaisesRegex(vcrit.InputError, "^at index 150000: frequency: found frequency = -1; expected"):
            ZENER.critical_velocity(frequency=values, out=out)
        np.testing.assert_array_equal(out, 7)
        # u_z0 is no part of v*; the index is that of the result.
        for name in ["k0", "u_z0"]:
            with self.assertRaisesRegex(vcrit.InputError, f"^at index 1, 2: {name}: found .*inf.*; expected"):
                ZENER.critical_velocity({name: [[1, 1, 1], [1, 1, np.inf]]})
        with self.assertRaisesRegex(vcrit.InputError, "^at index 0, 2: k0: found k0 = -5"):
            ZENER.critical_velocity(k0=np.asfortranarray([[1.0, 2.0, -5.0], [-3.0, 2.0, 1.0]]))

    def test_that_cut_a_network_are_found_before_anything_is_written(self):
        out = np.full(3, 7.0)
        with self.assertRaisesRegex(vcrit.InputError, "^at index 2: .*cut in two"):
            ZENER.critical_velocity(k0=[0, 8e6, 0], k1=[4e6, 0, 0], out=out)
        np.testing.assert_array_equal(out, 7)
        self.assertTrue(np.isfinite(ZENER.critical_velocity(k0=[0, 8e6], k1=[4e6, 0])).all())

    def test_of_other_kinds_are_refused(self):
        for values, found in {"complex": np.array([1e3 + 1j]), "objects": np.array([1e3, None]),
                              "lists": [[1e3], [1e3, 2e3]], "texts": ["1 kHz", "2 kg"],
                              "dates": np.array(["2026-01-01"], "datetime64[D]"), "none": None}.items():
            with self.subTest(values), self.assertRaisesRegex(vcrit.InputError, "^frequency: found "):
                ZENER.critical_velocity(frequency=found)
        with self.assertRaisesRegex(vcrit.InputError, "^out: found a list"):
            ZENER.critical_velocity(frequency=[1e3], out=[0.0])

    def test_are_no_numbers_that_only_look_unlike_ones(self):
        expected = ZENER.critical_velocity(frequency=20e3)
        for value in [Decimal(20_000), Fraction(20_000), np.float32(20e3), np.longdouble(20e3)]:
            self.assertEqual(ZENER.critical_velocity(frequency=value), expected)


class UnknownValues(unittest.TestCase):
    def test_have_no_critical_velocity(self):
        values = np.full(200_000, 20e3)
        values[150_000] = np.nan
        found = ZENER.critical_velocity(frequency=values)
        np.testing.assert_array_equal(np.flatnonzero(np.isnan(found)), [150_000])
        self.assertEqual(found[0], found[-1])
        for name in ["k0", "u_z0", "poisson"]:
            found = ZENER.critical_velocity({name: [0.3, np.nan]})
            np.testing.assert_array_equal(np.isnan(found), [False, True])
        self.assertTrue(math.isnan(ZENER.critical_velocity(k0=math.nan)))


# v* as four methods of simulation agree on it, to 6 digits; Eq. (24) has 0.0375 for both.
SEPARATING = scene({"k0": 200000, "k1": 2000000, "c1": 40}, normal="zener(k0, k1, c1)", tangential_ratio=0.8,
                   separation=True, angular_frequency=100000, amplitude=1e-6, indentation=4e-7)


class WhereSurfacesSeparate(unittest.TestCase):
    def test_one_value_is_that_of_the_motion(self):
        for indentation, expected in {4e-7: 0.033557, 3e-7: 0.032949}.items():
            scene = vcrit.Scene.from_text(SEPARATING).with_values(indentation=indentation)
            self.assertAlmostEqual(scene.critical_velocity(), expected, delta=1e-6)
            certified = scene.certified_critical_velocity
            self.assertEqual(certified.value, scene.critical_onset.contact_velocity)
            self.assertTrue(math.isnan(certified.relative_error_bound))
            self.assertAlmostEqual(scene.critical_velocity(mu0=0.3), expected, delta=1e-6)

    def test_each_point_is_that_of_its_scene(self):
        scene = vcrit.Scene.from_text(SEPARATING)
        indentation, c1 = np.array([3e-7, np.nan, 4e-7, 2e-5]), np.array([[40.0], [4.0]])
        found = scene.critical_velocity(indentation=indentation, c1=c1)
        self.assertEqual(found.shape, (2, 4))
        for row, damping in zip(found, c1[:, 0]):
            for value, depth in zip(row, indentation):
                if np.isnan(depth):
                    self.assertTrue(np.isnan(value))
                    continue
                expected = scene.with_values(indentation=depth, c1=damping).critical_onset.contact_velocity
                self.assertLess(abs(value / expected - 1), 3 * 1280 * U)
        self.assertAlmostEqual(found[0, 0], 0.032949, delta=1e-6)


class Memory(unittest.TestCase):
    def setUp(self):
        self.frequency = np.linspace(10e3, 30e3, 1000)
        self.expected = ZENER.critical_velocity(frequency=self.frequency)

    def test_of_the_result_may_be_given(self):
        out = np.full(1000, np.nan)
        self.assertIs(ZENER.critical_velocity(frequency=self.frequency, out=out), out)
        np.testing.assert_array_equal(out, self.expected)
        room = np.full((1000, 2), -1.0)
        ZENER.critical_velocity(frequency=self.frequency, out=room[:, 0])
        np.testing.assert_array_equal(room[:, 0], self.expected)
        np.testing.assert_array_equal(room[:, 1], -1)

    def test_may_be_an_argument_as_well(self):
        values = self.frequency.copy()
        ZENER.critical_velocity(frequency=values, out=values)
        np.testing.assert_array_equal(values, self.expected)
        # Backwards, over several blocks: what is written must not be read later.
        values = np.linspace(10e3, 30e3, 300_000)
        expected = ZENER.critical_velocity(frequency=values[::-1])
        ZENER.critical_velocity(frequency=values[::-1], out=values)
        np.testing.assert_array_equal(values, expected)

    def test_may_lie_anyhow(self):
        strided = np.zeros((1000, 3))
        strided[:, 1] = self.frequency
        unaligned = np.zeros(8001, np.uint8)[1:].view(np.float64)
        unaligned[:] = self.frequency
        self.assertFalse(unaligned.flags.aligned)
        for name, values in {
                "strided": strided[:, 1], "reversed": self.frequency[::-1][::-1], "unaligned": unaligned,
                "other bytes": self.frequency.astype(">f8"), "list": self.frequency.tolist()}.items():
            with self.subTest(name):
                np.testing.assert_array_equal(ZENER.critical_velocity(frequency=values), self.expected)
        columns = np.asfortranarray(self.frequency.reshape(20, 50))
        np.testing.assert_array_equal(ZENER.critical_velocity(frequency=columns), self.expected.reshape(20, 50))

    def test_of_whole_numbers_and_short_ones(self):
        np.testing.assert_array_equal(ZENER.critical_velocity(frequency=np.array([10_000, 20_000])),
                                      ZENER.critical_velocity(frequency=np.array([10e3, 20e3])))
        np.testing.assert_array_equal(ZENER.critical_velocity(frequency=np.array([10e3, 20e3], np.float32)),
                                      ZENER.critical_velocity(frequency=np.array([10e3, 20e3])))

    def test_that_may_only_be_read_is_read_and_not_written(self):
        fixed = self.frequency.copy()
        fixed.flags.writeable = False
        np.testing.assert_array_equal(ZENER.critical_velocity(frequency=fixed), self.expected)
        with self.assertRaisesRegex(ValueError, "read-only|writeable"):
            ZENER.critical_velocity(frequency=self.frequency, out=fixed)
        np.testing.assert_array_equal(fixed, self.frequency)

    def test_of_arguments_is_not_copied(self):
        """128 MiB an array, in a process that may take half of that beside them."""
        result = in_python(CROWDED)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.split(), ["contiguous", "strided", "broadcast", "copy", "refused"])


CROWDED = """
import resource
import numpy as np
import vcrit

MIB = 2**20
n = 16 * MIB
scene = vcrit.Scene("scenes/elastic.toml")
kn, pairs, out = np.full(n, 2e6), np.full((n, 2), 3e6), np.zeros(n)
scene.critical_velocity(kn=kn[:1000], kt=pairs[:1000, 0])  # what the first call needs for itself
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 64 * MIB,) * 2)
scene.critical_velocity(kn=kn, out=out)
assert out[-1] == out[0] > 0
print("contiguous")
scene.critical_velocity(kt=pairs[:, 1], kn=kn, out=out)
assert out[-1] == out[0] > 0
print("strided")
scene.critical_velocity(kn=np.broadcast_to(2e6, n), kt=pairs[:, 0], mu0=0.1, out=out)
assert out[-1] == out[0] > 0
print("broadcast")
try:
    kn.copy()
except MemoryError:
    print("copy refused")
"""

if __name__ == "__main__":
    unittest.main()

"""Numbers that carry a bound on what rounding to doubles does to them."""

import mpmath as mp


class Rounded:
    """What doubles make of a number: its value, and a bound on the error to first order. Real operations round once,
    pow twice; complex ones, of up to seven real ones, and cabs by 8 units at most."""

    UNIT = mp.mpf(2) ** -53

    def __init__(self, value, error=None):
        self.value = mp.mpmathify(value)
        self.error = self.UNIT * abs(self.value) if error is None else error

    def rounded(self, value, error, roundings=1):
        units = 8 if isinstance(value, mp.mpc) else roundings
        return Rounded(value, error + units * self.UNIT * abs(value))

    @staticmethod
    def of(other):
        return other if isinstance(other, Rounded) else Rounded(other)

    def __add__(self, other):
        other = self.of(other)
        return self.rounded(self.value + other.value, self.error + other.error)

    def __sub__(self, other):
        return self + -self.of(other)

    def __mul__(self, other):
        other = self.of(other)
        return self.rounded(self.value * other.value, abs(self.value) * other.error + abs(other.value) * self.error)

    def __truediv__(self, other):
        other = self.of(other)
        value = self.value / other.value
        return self.rounded(value, (self.error + abs(value) * other.error) / abs(other.value))

    def __pow__(self, n):
        value = self.value ** n
        return self.rounded(value, n * abs(value / self.value) * self.error if self.value else self.error, 2)

    def __neg__(self):
        return Rounded(-self.value, self.error)

    def __abs__(self):
        value = abs(self.value)
        return Rounded(value, self.error + (8 * self.UNIT * value if isinstance(self.value, mp.mpc) else 0))

    def root(self):
        value = mp.sqrt(self.value)
        return self.rounded(value, self.error / (2 * value) if value else mp.sqrt(self.error))

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, other):
        return self.of(other) - self

    def __rtruediv__(self, other):
        return self.of(other) / self


def root(value):
    return value.root() if isinstance(value, Rounded) else mp.sqrt(value)


def is_real(value):
    return mp.im(value.value if isinstance(value, Rounded) else value) == 0

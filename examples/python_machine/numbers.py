"""Chapter 2: numbers. A Python float is the manual's double, a Python int its integer of any size.

Vertices are worked out one by one on floats; pixels as NumPy arrays, where `one` value stands for
many. Functions named `..._array` are the same operations on arrays.
"""
import math

import numpy as np


def one(bits):
    """[R2.8] The largest value of that many bits."""
    return (1 << bits) - 1


def divide(a, b):
    """[R2.1] IEEE division: Python raises an exception for a zero divisor."""
    if b != 0:
        return a / b
    if a == 0 or math.isnan(a):
        return math.nan
    return math.copysign(math.inf, a) * math.copysign(1.0, b)


def larger(a, b):
    """[R2.6] max(a, b), whose result for NaN depends on the order of its arguments."""
    return b if a < b else a


def smaller(a, b):
    """[R2.6] min(a, b)."""
    return b if b < a else a


def rne(v):
    """[R2.6] The nearest integer, ties to even."""
    return round(v) if math.isfinite(v) else v


def floor(v):
    return math.floor(v) if math.isfinite(v) else v


def clamp01(v):
    """[R2.6] NaN becomes 0."""
    return (v if v < 1 else 1.0) if v > 0 else 0.0


def bounded(v, limit):
    """[R2.6] NaN becomes -limit."""
    return (v if v < limit else limit) if v > -limit else -limit


def to_integer(v, low, high):
    """[R2.6] Towards zero; NaN becomes low."""
    return math.trunc((v if v < high else high) if v > low else low)


def clamp(i, low, high):
    return low if i < low else high if i > high else i


def rne_quotient(numerator, denominator):
    """The nearest integer to a quotient of integers, ties to even; the denominator is positive."""
    quotient, rest = divmod(numerator, denominator)
    if 2 * rest > denominator or (2 * rest == denominator and quotient % 2 == 1):
        quotient += 1
    return quotient


# ---- [R2.7] vectors -------------------------------------------------------------------------


def dot3(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


def dot4(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(v):
    return math.sqrt(dot3(v, v))


def unit(v):
    size = length(v)
    return (v[0] / size, v[1] / size, v[2] / size) if size > 0 else (0.0, 0.0, 0.0)


def transform(m, v):
    """m is a list of four columns."""
    return tuple((m[0][i] * v[0] + m[1][i] * v[1]) + (m[2][i] * v[2] + m[3][i] * v[3])
                 for i in range(4))


# ---- [R2.10] fractions ----------------------------------------------------------------------


def quantize(v, bits):
    return rne(clamp01(v) * one(bits))


def mul(a, b, bits):
    """Integers or arrays of them: the nearest integer to a b / one(bits)."""
    t = a * b + (1 << (bits - 1))
    return (t + (t >> bits)) >> bits


def rescale(v, from_bits, to_bits):
    """Integers or arrays of them."""
    return (2 * v * one(to_bits) + one(from_bits)) // (2 * one(from_bits))


def to_integer_array(v, low, high):
    """to_integer of an array of doubles. low and high fit int64."""
    limited = np.where(v > low, np.where(v < high, v, float(high)), float(low))
    return np.trunc(limited).astype(np.int64)

"""Chapter 3: exp and pow. The two tables are read from the page of the manual, where they stand."""
import math
import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "manual" / "elementary.md"


def read_table(rule):
    """The rows `| i | hi | lo |` after a rule, as {i: (hi, lo)}."""
    text = PAGE.read_text(encoding="utf-8").split(f"**[{rule}]**", 1)[1].split("**[R", 1)[0]
    rows = re.findall(r"^\| (\d+) \| (\S+) \| (\S+) \|$", text, re.MULTILINE)
    return {int(i): (float.fromhex(hi), float.fromhex(lo)) for i, hi, lo in rows}


LOG_NODE = read_table("R3.8")
EXP2_NODE = read_table("R3.9")
LN2 = (float.fromhex("0x1.62e42fefa38p-1"), float.fromhex("0x1.ef35793c7673p-45"))
LN2_64TH = (float.fromhex("0x1.62e42fefap-7"), float.fromhex("0x1.cf79abc9e3b3ap-46"))


# ---- [R3.2] sums of two doubles -------------------------------------------------------------


def two_sum(a, b):
    hi = a + b
    part = hi - a
    return hi, (a - (hi - part)) + (b - part)


def two_product(a, b):
    a_up, b_up = a * 134217729.0, b * 134217729.0
    a_hi, b_hi = a_up - (a_up - a), b_up - (b_up - b)
    a_lo, b_lo = a - a_hi, b - b_hi
    hi = a * b
    return hi, ((a_hi * b_hi - hi) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo


def divide(a, b):
    quotient = a[0] / b[0]
    back = two_product(quotient, b[0])
    return quotient, ((a[0] - back[0]) - back[1] + a[1] - quotient * b[1]) / b[0]


def polynomial(z, c):
    total = c[-1]
    for coefficient in reversed(c[:-1]):
        total = coefficient + z * total
    return total


# ---- [R3.3] to [R3.7] -----------------------------------------------------------------------


def log_as_sum(x):
    m, k = math.frexp(x)
    if m < 45.25 / 64:
        m, k = 2 * m, k - 1
    i = round(64 * m)
    c = i / 64
    s = divide((m - c, 0.0), two_sum(m, c))
    z = s[0] * s[0]
    tail = s[0] * z * polynomial(z, [2 / 3, 2 / 5, 2 / 7, 2 / 9, 2 / 11])
    total = two_sum(k * LN2[0] + LOG_NODE[i][0], 2 * s[0])
    rest = total[1] + (tail + (2 * s[1] + (k * LN2[1] + LOG_NODE[i][1])))
    return two_sum(total[0], rest)


def scale(v, e):
    try:
        return math.ldexp(v, e)
    except OverflowError:
        return math.inf


def exp_of_sum(x):
    if x[0] > 710:
        return math.inf
    if x[0] < -746:
        return 0.0
    k = round(x[0] * float.fromhex("0x1.71547652b82fep6"))
    r = (x[0] - k * LN2_64TH[0]) + (x[1] - k * LN2_64TH[1])
    p = r + r * r * polynomial(r, [1 / 2, 1 / 6, 1 / 24, 1 / 120, 1 / 720])
    i = k & 63
    e = (k - i) // 64
    return scale(EXP2_NODE[i][0] + (EXP2_NODE[i][1] + EXP2_NODE[i][0] * p), e)


def exp(x):
    return x if math.isnan(x) else exp_of_sum((x, 0.0))


def power(x, y):
    """[R3.7] pow(x, y)."""
    if y == 0 or x == 1:
        return 1.0
    if x == 0:
        return 0.0
    log = log_as_sum(x)
    estimate = y * log[0]
    if estimate > 710:
        return math.inf
    if estimate < -746:
        return 0.0
    product = two_product(y, log[0])
    return exp_of_sum((product[0], product[1] + y * log[1]))

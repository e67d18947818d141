"""Compares the numbers of steps with what an oracle expects. Each number is also changed, to see
that the oracle would notice."""
import re
from collections import Counter, defaultdict

from oracle.logs import Said

MANY, SAMPLE = 1000, 12  # of some kinds, so many steps; after those each so manyth
WINDOW = ("left", "row", "right", "width", "height")


class Near:
    """A number with rounding: by default a billionth of it."""

    def __init__(self, value, tolerance=0, size=1):
        self.value = value
        self.tolerance = max(tolerance, 1e-9 * max(abs(value), size))


class Bag:
    """A list whose order says nothing."""

    def __init__(self, items):
        self.items = items


class Spread:
    """Values in any order and any number, each at least once: the distances of the corners of a
    piece of which two may have become one."""

    def __init__(self, items):
        self.items = items


class Between:
    """A whole number that rounding alone decides: a pixel's centre lies on a cut."""

    def __init__(self, least, most):
        self.least, self.most = least, most


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def middle(expected):
    return expected.value if isinstance(expected, Near) else expected


def same(said, expected):
    if isinstance(expected, Bag):
        return (isinstance(said, list) and
                same(sorted(said), sorted(expected.items, key=middle)))
    if isinstance(expected, Spread):
        return (isinstance(said, list) and
                all(any(same(v, right) for right in expected.items) for v in said) and
                all(any(same(v, right) for v in said) for right in expected.items))
    if isinstance(expected, Between):
        return isinstance(said, int) and expected.least <= said <= expected.most
    if isinstance(expected, (list, tuple)):
        return (isinstance(said, list) and len(said) == len(expected) and
                all(map(same, said, expected)))
    if isinstance(expected, Near):
        return is_number(said) and abs(said - expected.value) <= expected.tolerance
    return is_number(said) and said == expected


def numbers_in(value):
    items = value if isinstance(value, list) else [value]
    return len(items) if items and all(map(is_number, items)) else 0


def changed(value):
    """The value with each of its numbers changed in turn."""
    if not isinstance(value, list):
        yield value + 1
        return
    for i in range(len(value)):
        yield value[:i] + [value[i] + 1] + value[i + 1:]


def blind(said, expected):
    """Whether one of the numbers could be changed without being noticed."""
    if isinstance(expected, (list, tuple)):  # number by number, as `same` compares them
        return any(map(blind, said, expected))
    return any(same(other, expected) for other in changed(said))


def values_of(step):
    """All that a sentence can show: values, and the pixels in question."""
    values = dict(step.get("values", {}))
    if "window" in step:
        x, y, width, height = step["window"]
        values.update(zip(WINDOW, (x, y, x + width - 1, width, height)))
    return values


def window(x, y, width, height=1):
    return dict(zip(WINDOW, (x, y, x + width - 1, width, height)))


class Report:
    def __init__(self):
        self.wrong, self.unsure = [], 0
        self.checked = Counter()        # numbers, by (algorithm, test, result)
        self.met = defaultdict(set)     # kinds of steps, by algorithm
        self.known = defaultdict(set)

    def complain(self, run, step, what):
        self.wrong.append(f"{run.name}, step {step['step']}: {step['test']} {step['result']} "
                          f"{step.get('pieces', [])[:6]}: {what}")

    def check(self, run, oracle):
        self.known[run.algorithm] |= set(oracle.kinds)
        shown = shown_names(run.words)
        times = Counter()
        for step in run.steps:
            kind = step["test"], step["result"]
            self.met[run.algorithm].add(kind)
            times[kind] += 1
            if kind in oracle.sampled and times[kind] > MANY and times[kind] % SAMPLE:
                continue
            said = values_of(step)
            numeric = {name for name in shown[kind] if numbers_in(said.get(name))}
            check = oracle.kinds.get(kind)
            if check is None:
                if numeric:
                    self.complain(run, step, f"no check knows its {sorted(numeric)}")
                continue
            try:
                expected = check(oracle, Said(step))
            except (ArithmeticError, LookupError, StopIteration) as error:
                expected = f"it is out of place: {error!r}"
            if isinstance(expected, str):
                self.complain(run, step, expected)
                continue
            for name in numeric - set(expected):
                self.complain(run, step, f"no check knows its {name}")
            for name, right in expected.items():
                self.compare(run, step, kind, name, said.get(name), right)
        for what in oracle.finish():
            self.wrong.append(f"{run.name}: {what}")

    def compare(self, run, step, kind, name, said, right):
        if not same(said, right):
            self.complain(run, step, f"{name} is {said}, but should be {plain(right)}")
            return
        self.checked[(run.algorithm, *kind)] += numbers_in(said)
        if isinstance(right, Between):
            self.unsure += 1
        elif numbers_in(said) and blind(said, right):
            self.complain(run, step, f"a changed {name} would not be noticed: {said}")

    def prove(self, run, oracle):
        """Changes the log: one number of each name of each kind of step at a time. Returns how
        many were noticed, and complains about the others."""
        shown, first = shown_names(run.words), {}
        for i, step in enumerate(run.steps):
            for name, value in step.get("values", {}).items():
                kind = step["test"], step["result"], name
                if name in shown[kind[:2]] and numbers_in(value):
                    first.setdefault(kind, i)
        noticed = 0
        for (_, _, name), i in first.items():
            step = run.steps[i]
            for value in changed(step["values"][name]):
                run.steps[i] = {**step, "values": {**step["values"], name: value}}
                trial = Report()
                trial.check(run, oracle(run))
                run.steps[i] = step
                if trial.wrong:
                    noticed += 1
                else:
                    self.complain(run, step, f"{name} was changed to {value}: not noticed")
        return noticed


def shown_names(words):
    """The names in each sentence."""
    return {(test, result): set(re.findall(r"\{(\w+)\}", sentence["en"]))
            for test, results in words.items() for result, sentence in results.items()}


def plain(expected):
    if isinstance(expected, Between):
        return f"{expected.least} to {expected.most}"
    if isinstance(expected, (Bag, Spread)):
        return sorted(map(middle, expected.items))
    if isinstance(expected, (list, tuple)):
        return list(map(plain, expected))
    return middle(expected)


def of(*kinds):
    """Names the kinds of steps whose numbers a method expects: "test result"."""
    def mark(method):
        method.of = [tuple(kind.rsplit(" ", 1)) for kind in kinds]
        return method
    return mark


class Oracle:
    """Expects numbers, step by step. A method marked with `of` returns the numbers by name, or
    what else is wrong with the step."""
    kinds = {}
    sampled = ()  # kinds that change nothing, of which long logs have very many

    def __init_subclass__(cls):
        cls.kinds = dict(cls.kinds)
        for method in vars(cls).values():
            for kind in getattr(method, "of", []):
                cls.kinds[kind] = method

    def __init__(self, run):
        self.run, self.header, self.camera = run, run.header, run.camera
        self.size, self.unit = run.header["size"], run.header["unit"]

    def finish(self):
        """What is wrong after the last step: for instance, steps that are missing."""
        return []


class Foretold(Oracle):
    """Knows all steps beforehand: `steps` yields (test, result), pieces, numbers of each."""

    def next_step(self, said):
        kind, pieces, numbers = next(self.steps, (None, None, None))
        if kind != (said.test, said.result) or pieces != said.pieces:
            return f"expected is {kind} of {pieces} with {numbers}"
        return numbers

    def finish(self):
        return ["steps are missing"] if next(self.steps, None) else []

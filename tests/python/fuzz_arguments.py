"""Calls every public callable of the package with arguments that fit, and with others that do not.

    python3 fuzz_arguments.py FIRST_SEED COUNT

Any exception with a text is right; a crash, another kind of exception or one without a text is not.
"""
import faulthandler
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import sys
import tempfile
import warnings

import gw
import gw.conformance
import gw.testing
import numpy as np
import pytest

SCENES = pathlib.Path(__file__).parents[2] / "scenes"
# Beside those of the package itself.
MODULES = {"hidden": (gw.hidden, gw.hidden.__all__), "conformance": (gw.conformance, ["run"]),
           "testing": (gw.testing, ["expect_planes_equal", "expect_passes_equal"])}
RIGHT = (gw.Error, pytest.fail.Exception, TypeError, ValueError, IndexError, KeyError,
         AttributeError, OverflowError, MemoryError, OSError, StopIteration, ZeroDivisionError,
         UnicodeError, KeyboardInterrupt, RecursionError)
SECONDS = 2  # after which a call is interrupted, as by Ctrl-C


class Odd:
    """No number, no sequence, and refuses to be printed."""

    def __len__(self):
        return -1

    def __float__(self):
        raise ValueError("an odd object is no float")


def numbers(draw):
    return draw.choice([0, 1, 2, 3, 7, 8, 16, 0.5, 1.0, -1, -0.0, True, 255, 256, 1e-30, 4095,
                        4097])


def wild(draw):
    return draw.choice([
        None, float("nan"), float("inf"), -float("inf"), 2**31, -2**31, 2**32, 2**63, -2**63,
        10**30, 1e300, 1e-320, "", "x" * 70000,
        "vgx", "no such", b"\0\xff", [], [None], [[]], {}, {"a": 1}, (), (1,), (float("nan"),) * 3,
        [1e300] * 3, object(), Odd(), type, len,
        np.zeros((0, 3)), np.zeros((2, 2, 4), np.uint8), np.full((3, 3), np.nan),
        np.array([[1, "a"]], object), np.array(["x"]),
        np.zeros((2, 2), complex), np.zeros(3, [("a", int)]),
        np.broadcast_to(np.uint16(1), (2, 2**31, 4)), np.array(5), np.full((2, 3), 1e300),
        np.zeros((4, 4)), np.full((4, 4), 1e200), np.array([[2**63]], np.uint64),
        np.arange(24).reshape(2, 3, 4)[::-1, :, ::2], 3j, range(3),
        np.datetime64("2020-01-01"), memoryview(b"abcd"), "\ud800"])


def small_scene():
    scene = gw.Scene(name="small")
    scene.add("box", gw.make_box(), gw.SceneMaterial(Ke=(1, 1, 1), d=0.9))
    scene.add("floor", gw.make_rectangle(3, 3), gw.SceneMaterial(Ks=(1, 1, 1), Ns=8, illum=3))
    scene.lights = [gw.SceneLight(name="sun", direction=(1, -1, 0), shadow="Volume")]
    return scene


def small_list():
    commands = gw.CommandList()
    commands.begin_pass("one", digests=True)
    commands.clear(color=(0, 0, 0, 1), depth=1, stencil=0)
    commands.set_state(gw.State())
    commands.draw(gw.Mesh("Triangles", [[0, 0, 0], [1, 0, 0], [0, 1, 0]]))
    return commands


class Pool:
    """Objects of every class, made and changed by the calls so far."""

    def __init__(self):
        scene = small_scene()
        self.by_type = {
            "Machine": [gw.Machine("vgx", 16, 12),
                        gw.Machine("opengl", 9, 9, reference=True, record=True)],
            "CommandList": [small_list(), gw.CommandList()], "Scene": [scene, gw.Scene()],
            "Mesh": [gw.make_box(), gw.Mesh("Points", [[0, 0, 0]])],
            "Texture": [gw.Texture(np.zeros((2, 2, 4), np.uint8))],
            "Recording": [gw.Recording([small_list()], "vgx", 8, 8)],
            "Renderer": [gw.Renderer(scene, 12, 9)],
            "Radiosity": [gw.Radiosity(scene, hemicube=16, texels_per_unit=2)],
            "HiddenRun": [gw.hidden.run(scene, "newell", width=16, height=12)],
            "Picture": [gw.picture(np.zeros((2, 3)))],
            "Object": scene.objects,
        }

    def add(self, value):
        name = type(value).__name__
        if getattr(gw, name, None) is type(value):
            kept = self.by_type.setdefault(name, [])
            kept.append(value)
            del kept[:-6]

    def one(self, draw, name):
        cls = getattr(gw, name)
        if name in self.by_type and draw.random() < 0.9:
            return draw.choice(self.by_type[name])
        members = getattr(cls, "__members__", None)
        return draw.choice(list(members.values())) if members else cls()


def fitting(draw, kind, pool, folder):
    """A value of the kind that a signature names."""
    kind = kind.replace("gw._gw.", "").strip()
    if kind.startswith("Optional["):
        return None if draw.random() < 0.5 else fitting(draw, kind[9:-1], pool, folder)
    if kind.startswith("Union["):
        return fitting(draw, draw.choice(kind[6:-1].split(", ")), pool, folder)
    if kind.startswith("List["):
        return [fitting(draw, kind[5:-1], pool, folder) for _ in range(draw.choice([0, 1, 2, 6]))]
    if kind.startswith("Tuple["):
        return tuple(fitting(draw, k, pool, folder) for k in kind[6:-1].split(", "))
    if kind == "Profile":
        return draw.choice(["vgx", "ideal", "opengl", gw.Profile()])
    if kind in ("int", "float"):
        return numbers(draw)
    if kind == "bool":
        return draw.random() < 0.5
    if kind == "str":
        return draw.choice(["newell", "bsp", "hierarchy", "raster", "radiosity", "sphere", "a",
                            "radius", ""])
    if kind in ("os.PathLike", "Path"):
        return draw.choice([folder + "/a", folder + "/b.json", folder, folder + "/scene.obj",
                            "/nowhere/at/all"])
    if kind == "bytes":
        return draw.choice([b"", b"abc", pool.by_type["Recording"][0].encode(),
                            pool.by_type["Recording"][0].encode()[:200]])
    if "ndarray" in kind:
        return draw.choice([np.eye(4), np.zeros((3, 3)), np.zeros((2, 2, 4), np.uint16),
                            np.zeros((2, 3)), [[0, 0, 0]] * 3])
    if kind == "function":
        return draw.choice([lambda *a: [], lambda *a: None,
                            lambda *a: [{"kind": "draw", "pieces": ["1"]}], len])
    if hasattr(gw, kind) and isinstance(getattr(gw, kind), type):
        return pool.one(draw, kind)
    return numbers(draw) if draw.random() < 0.5 else [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


def signature(name, function):
    """[(argument, kind, is keyword only)] of the first signature."""
    text = (getattr(function, "__doc__", None) or "").replace("gw._gw.", "")
    found = re.search(rf"{re.escape(name)}\((.*)\) -> ", text)
    if not found:
        import inspect
        try:
            return [(n, str(p.annotation).split("|")[0], p.kind == p.KEYWORD_ONLY) for n,
                    p in inspect.signature(function).parameters.items()
                    if n != "self"]
        except (TypeError, ValueError):
            return []
    arguments, keyword = [], False
    for part in re.split(r", (?=\w+:|\*)", found[1]):
        if part == "*":
            keyword = True
        elif ":" in part and not part.startswith(("self:", "**")):
            argument, _, kind = part.partition(": ")
            arguments.append((argument, kind.split(" = ")[0], keyword))
    return arguments


def targets():
    """(class or None, name): everything that can be called, read or set."""
    skipped = {"Error"}
    for name, value in vars(gw).items():
        if name.startswith("_") or name in skipped or not getattr(value, "__module__",
            "").startswith("gw"):
            continue
        yield None, name
        if isinstance(value, type):
            for member in vars(value):
                if not member.startswith("_") or member in ("__len__", "__iter__", "__next__",
                                                            "__eq__", "__repr__", "__str__",
                                                            "__copy__"):
                    yield name, member
    for module, (_, names) in MODULES.items():
        for name in names:
            yield module, name


def call(draw, pool, folder, target):
    owner, name = target
    value = lambda kind: wild(draw) if draw.random() < 0.15 else fitting(draw, kind, pool, folder)
    if owner in MODULES or owner is None:
        function, this = getattr(MODULES[owner][0] if owner else gw, name), []
        if getattr(function, "__members__", None):
            return function(wild(draw))
        fields = getattr(function, "_fields", None)
        if fields:
            return function(**{f: value(field_kind(function, f)) for f in fields
                               if draw.random() < 0.2})
        arguments = signature("__init__", function.__init__) if isinstance(function,
            type) else signature(name, function)
    else:
        cls = getattr(gw, owner)
        member, function = vars(cls)[name], None
        one = wild(draw) if draw.random() < 0.03 else pool.one(draw, owner)
        if isinstance(member, property):
            if member.fset and draw.random() < 0.5:
                return setattr(one, name, value(field_kind(cls, name)))
            return getattr(one, name)
        if isinstance(member, staticmethod):
            function, this = member.__func__, []
        elif not callable(member):
            return None
        else:
            function, this = member, [one]
        arguments = signature(name, function)
    positional = this + [value(kind) for _, kind, keyword in arguments if not keyword
                         and draw.random() < 0.97]
    keywords = {argument: value(kind) for argument, kind, keyword in arguments if keyword
                and draw.random() < 0.3}
    if draw.random() < 0.02:
        positional.append(wild(draw))
    return function(*positional, **keywords)


def field_kind(cls, field):
    text = (vars(cls)[field].fget.__doc__ or "").split("\n")[0]
    return text.partition(" -> ")[2] or "float"


def interrupted(*_):
    raise KeyboardInterrupt("too long")


def run(seed, everything):
    draw = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        shutil.copy(SCENES / "hidden/cycle.obj", folder + "/scene.obj")
        pool = Pool()
        for step in range(60):
            target = draw.choice(everything)
            if os.environ.get("GW_FUZZ_VERBOSE"):
                print(seed, step, target, flush=True)
            signal.setitimer(signal.ITIMER_REAL, SECONDS)
            try:
                result = call(draw, pool, folder, target)
                pool.add(result)
                repr(result)
            except RIGHT as error:
                if not str(error) and not isinstance(error, (StopIteration, MemoryError)):
                    raise SystemExit(
                        f"seed {seed}, step {step}, {target}: {type(error).__name__} without a text")
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        os.chdir("/")


if __name__ == "__main__":
    faulthandler.enable()
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    gigabyte = 1 << 30
    if not os.environ.get("GW_NO_MEMORY_LIMIT"):
        resource.setrlimit(resource.RLIMIT_AS, (3 * gigabyte, 3 * gigabyte))
    signal.signal(signal.SIGALRM, interrupted)
    everything = list(targets())
    first, count = int(sys.argv[1]), int(sys.argv[2])
    for seed in range(first, first + count):
        print("seed", seed, flush=True)
        run(seed, everything)
    print("done:", len(everything), "callables")

"""Objects are whole, files are whole, and the interpreter ends: no expression of Python crashes it."""
import copy
import os
import pathlib
import pickle
import resource
import stat
import subprocess
import sys

import gw
import numpy as np
import pytest

SCENES = pathlib.Path(__file__).parents[2] / "scenes"
CLASSES = [value for value in vars(gw).values() if isinstance(value, type)
           and value.__module__.startswith("gw._gw") and not issubclass(value, Exception)]
BASE = gw.State.__mro__[1]
BOX = gw.make_box()


def test_the_classes_are_found():
    assert len(CLASSES) > 40


@pytest.mark.parametrize("kind", CLASSES, ids=lambda kind: kind.__name__)
def test_no_object_without_its_constructor(kind):
    for attempt in (
        lambda: kind.__new__(kind),
        lambda: BASE.__new__(kind),
        lambda: object.__new__(kind),
        lambda: type("Derived", (kind,), {}),
        lambda: setattr(BOX, "__class__", kind),
        lambda: object.__dict__["__class__"].__set__(BOX, kind),
    ):
        with pytest.raises(TypeError):
            attempt()


def test_no_object_of_the_base_of_all_classes():
    new = BASE.__new__
    for attempt in (BASE, lambda: new(BASE), lambda: new(), lambda: new(1)):
        with pytest.raises(TypeError):
            attempt()


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_pickle_takes_names_and_refuses_the_rest(protocol):
    less = gw.CompareFunc.Less
    assert pickle.loads(pickle.dumps(less, protocol)) == less
    assert copy.deepcopy(less) == less
    for value in (gw.State(), gw.Camera(), gw.Machine("vgx", 8, 8), gw.CommandList(), BOX):
        with pytest.raises(TypeError):
            pickle.loads(pickle.dumps(value, protocol))


def huge(shape, number):
    return np.broadcast_to(number(0), shape)


@pytest.mark.parametrize("use", [
    lambda: gw.Texture(huge((400_000, 400_000, 4), np.uint8)),
    lambda: gw.Texture(huge((400_000, 400_000, 4), np.uint16)),
    lambda: gw.CommandList().write_pixels(0, 0, huge((400_000, 400_000, 4), np.uint8)),
    lambda: gw.CommandList().write_pixels(0, 0, huge((400_000, 400_000), np.uint32), "Depth"),
    lambda: gw.CommandList().draw_pixels(0, 0, huge((400_000, 400_000, 4), np.uint8)),
    lambda: gw.Mesh("Points", huge((10**11, 3), np.float32)),
    lambda: gw.Mesh("Points", [[0, 0, 0]], indices=huge((10**12,), np.uint32)),
], ids=["texture 8", "texture 16", "write", "write depth", "draw", "positions", "indices"])
def test_arrays_beyond_memory_are_memory_errors(use):
    with pytest.raises(MemoryError):
        use()


def test_lengths_beyond_the_machines_are_errors():
    with pytest.raises(gw.Error, match="expected at most 2147483647 along an axis"):
        gw.CommandList().write_pixels(0, 0, huge((2**32 + 1, 0, 4), np.uint8))


@pytest.mark.parametrize("reference", [False, True])
def test_a_view_shows_what_the_next_list_leaves(reference):
    machine = gw.Machine("vgx", 64, 64, reference=reference)
    views = {plane: machine.plane(plane) for plane in ("Color", "Depth", "Stencil", "Accum")}
    commands = gw.CommandList()
    commands.clear(color=(0, 0, 0.3, 1), depth=0.5, stencil=7, accum=(0.5, 0, 0, 0))
    machine.execute(commands)
    shown = {plane: view.copy() for plane, view in views.items()}
    for plane, view in shown.items():
        assert view.max() > 0 and (view == machine.plane(plane)).all(), plane


def saves(tmp_path):
    run = gw.hidden.run(gw.Scene.open(SCENES / "hidden/cycle.toml"), "newell", width=64, height=48)
    picture = gw.picture(gw.Machine("vgx", 512, 512).depth)
    recording = gw.Recording([gw.CommandList()], gw.Profile("vgx"), 8, 8)
    return {
        "player.html": lambda file: gw.hidden.save_player(run, file),
        "picture.png": picture.save,
        "recording.gwt": recording.save,
    }


@pytest.mark.parametrize("name", ["player.html", "picture.png", "recording.gwt"])
def test_a_file_is_replaced_whole_or_stays(tmp_path, name):
    save = saves(tmp_path)[name]
    file = tmp_path / name
    save(file)
    whole = file.read_bytes()
    file.chmod(0o600)
    link = tmp_path / f"link{file.suffix}"
    link.symlink_to(file)
    save(link)
    assert link.is_symlink() and file.read_bytes() == whole
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    save(tmp_path / ("n" * 250 + ".png"))
    with pytest.raises(gw.Error, match="cannot be written"):
        save(tmp_path / "missing" / name)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(whole) // 2, before[1]))
    try:
        with pytest.raises(gw.Error, match="cannot be written"):
            save(file)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert file.read_bytes() == whole
    assert sorted(os.listdir(tmp_path)) == sorted([name, link.name, "n" * 250 + ".png"])


@pytest.mark.parametrize("work", [
    "gw.render(scene, 800, 600, 'raytrace')",
    "[machine.execute(commands) for _ in iter(int, 1)]",
    "[machine.digests() for _ in iter(int, 1)]",
], ids=["rays", "lists", "digests"])
def test_the_interpreter_ends_while_a_daemon_draws(work):
    program = f"""
import threading, time, gw
scene = gw.Scene.open({str(SCENES / 'fig9.toml')!r})
machine = gw.Machine("vgx", 512, 512)
commands = gw.CommandList()
commands.clear(color=(0, 0, 1, 1), depth=1)
def draw():
    try: {work}
    except gw.Error as error: assert str(error) == "the interpreter ends"
threading.Thread(target=draw, daemon=True).start()
time.sleep(0.5)
"""
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")


def test_every_module_of_the_documents_is_there_after_import_gw():
    program = "import gw; gw.conformance.run; gw.testing.expect_planes_equal; gw.hidden.run"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    with pytest.raises(AttributeError, match="module 'gw' has no attribute 'nothing'"):
        gw.nothing

"""The machine from Python: the bits of both machines, views, errors."""
import threading

import gw
import numpy as np
import pytest
from gw.testing import expect_planes_equal


def triangle_list():
    mesh = gw.Mesh("Triangles", [[-0.8, -0.8, 0], [0.8, -0.7, 0.5], [0, 0.9, -0.5]],
                   colors=[[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]])
    commands = gw.CommandList()
    commands.begin_pass("triangle", digests=True)
    commands.clear(color=(0, 0, 0.5, 1), depth=1, stencil=3)
    commands.set_state(gw.State(depth=gw.DepthState(test=True, func="LEqual")))
    commands.draw(mesh)
    return commands


@pytest.mark.parametrize("profile", [p.name for p in gw.profiles()])
def test_both_machines_have_the_same_bits(profile):
    fast = gw.Machine(profile, 67, 45)
    reference = gw.Machine(profile, 67, 45, reference=True)
    for machine in (fast, reference):
        machine.execute(triangle_list())
    for plane in ("Color", "Depth", "Stencil", "Accum"):
        expect_planes_equal(fast.plane(plane), reference.plane(plane), plane)
    assert fast.passes() == reference.passes()
    assert fast.digests() == reference.digests()
    assert 0 < fast.passes()[0]["written"] < 67 * 45


def test_planes_are_read_only_views_that_keep_the_machine_alive():
    machine = gw.Machine("vgx", 16, 8)
    commands = gw.CommandList()
    commands.clear(color=(1, 0.5, 0, 1))
    machine.execute(commands)
    color = machine.color
    assert color.shape == (8, 16, 4) and color.dtype == np.uint16
    assert not color.flags.owndata and not color.flags.writeable
    assert np.shares_memory(color, machine.color)
    del machine
    assert color[0, 0].tolist() == [255, 128, 0, 255]


def test_rows_count_from_the_bottom():
    machine = gw.Machine("vgx", 4, 4)
    commands = gw.CommandList()
    values = np.zeros((1, 4, 4), np.uint16)
    values[0, 1] = [9, 8, 7, 6]
    commands.write_pixels(0, 2, values)
    machine.execute(commands)
    assert machine.color[2, 1].tolist() == [9, 8, 7, 6]
    assert machine.color[1].max() == 0
    assert gw.picture(machine.color).pixels[1, 1].tolist() == [9, 8, 7]


@pytest.mark.parametrize("name, begins", [
    ("a.png", b"\x89PNG"), ("a.PNG", b"\x89PNG"), ("a.jpg", b"\xff\xd8\xff"), ("a.ppm", b"P6"),
])
def test_a_picture_is_saved_in_the_format_of_its_extension(name, begins, tmp_path):
    plane = np.zeros((2, 3, 4), np.uint8)
    plane[0, 0, :3] = 1, 2, 3
    gw.picture(plane).save(tmp_path / name)
    written = (tmp_path / name).read_bytes()
    assert written.startswith(begins)
    if name == "a.ppm":
        assert written.endswith(bytes(3 * 3) + bytes([1, 2, 3]) + bytes(3 * 2))
    with pytest.raises(gw.Error, match="no picture format has the extension .xyz; expected .png"):
        gw.picture(plane).save(str(tmp_path / "a.xyz"))


def test_every_command_runs():
    machine = gw.Machine("opengl", 16, 16, record=True)
    commands = gw.CommandList()
    commands.begin_pass("all")
    commands.clear(color=(0.25, 0.25, 0.25, 1), depth=1, stencil=0, accum=(0, 0, 0, 0))
    commands.accumulate("Load", 0.5)
    commands.accumulate("Return", 2.0)
    commands.write_spans([[0, 0, 16, 0]], [[255, 0, 0, 255]])
    commands.copy_pixels("Color", (0, 0, 16, 1), 0, 5)
    commands.copy_texture(3, "Color", (0, 0, 4, 4))
    commands.draw(gw.Mesh("Quads", [[-1, -1, 0], [0, -1, 0], [0, 0, 0], [-1, 0, 0]],
                          texcoords=[[0, 0], [1, 0], [1, 1], [0, 1]]), slot=3)
    commands.draw_pixels(2, 2, np.full((2, 2, 4), 7))
    commands.read(5, "Color", (0, 0, 16, 2))
    commands.read(6, "Depth", (0, 0, 2, 3))
    commands.make_surface(1, 8, 4, ["Color", "Depth"], depth_bits=32)
    commands.use_surface(1)
    commands.clear(color=(1, 1, 1, 1), depth=1)
    commands.use_surface(0)
    commands.blit(1, ["Color"], (0, 0, 8, 4), (8, 12, 8, 4))
    commands.make_surface(2, 1, 1, ["Color"])
    commands.draw(gw.Mesh("Points", [[0.9, -0.9, 0]]), surface=2, surface_plane="Color")
    commands.swap_buffers()
    machine.execute(commands)
    assert commands.names()[0] == "BeginPass" and len(commands) == len(commands.names())
    read = machine.readbacks()
    assert read[5].shape == (2, 16, 4) and read[6].shape == (3, 2)
    assert machine.back is not None and machine.back[5, 15].tolist() == [255, 0, 0, 255]
    recording = machine.recording()
    assert recording.compare_machines() is None


def test_values_are_compared_printed_and_copied():
    state = gw.State()
    state.depth.test = True
    state.clip_planes = [gw.ClipPlane(enable=True, plane=(0, 0, 1, 0))] + [gw.ClipPlane()] * 5
    copy = state.copy()
    assert copy == state
    copy.depth.test = False
    assert state.depth.test and copy != state
    assert repr(gw.DepthState(test=True, func="Equal")).startswith("DepthState(test=True, func=")
    assert str(gw.Profile("opengl,depth_bits=32")).startswith("opengl") or "depth_bits=32" in str(
        gw.Profile("opengl,depth_bits=32"))


@pytest.mark.parametrize("wrong, message", [
    (lambda: gw.Machine("vgx", 0, 4), "window"),
    (lambda: gw.Machine("irix", 4, 4), None),
    (lambda: gw.Mesh("Triangles", [[0, 0], [1, 0], [0, 1]]), "expected \\(n, 3\\)"),
    (lambda: gw.Mesh("Triangles", [[0, 0, float("nan")]] * 3), "finite"),
    (lambda: gw.Mesh("Triangles", [[0, 0, 0]] * 3, indices=[0, 1, -1]), "expected 0 .. "),
    (lambda: gw.Mesh("Triangles", [[0, 0, 0]] * 3, indices=[0, 1, 0.5]), "whole numbers"),
    (lambda: gw.Mesh("Triangles", [[0, 0, 0]] * 3, indices=[0, 1, 7]), None),
    (lambda: gw.Texture(np.zeros((2, 2, 3), np.uint8)), "expected \\(height, width, 4\\)"),
    (lambda: gw.Texture(np.zeros((2, 2, 4), np.float32)), "uint8 or uint16"),
    (lambda: gw.DepthState(tets=True), "no 'tets'; expected test, func, mask"),
    (lambda: gw.DepthState(func="Lequal"), "DepthState.func"),
    (lambda: gw.CompareFunc("Lequal"), "expected Never, Less"),
    (lambda: gw.Machine(threads=-1), "threads"),
    (lambda: gw.Machine("vgx", 4, 4).recording(), "record=True"),
    (lambda: gw.Recording.open("missing.gwt"), "missing.gwt"),
])
def test_wrong_input_is_an_error_that_says_what_was_expected(wrong, message):
    with pytest.raises((gw.Error, TypeError, ValueError), match=message):
        wrong()


def test_an_invalid_list_draws_nothing_and_names_its_command():
    machine = gw.Machine("vgx", 8, 8)
    commands = gw.CommandList()
    commands.begin_pass("offset")
    commands.clear(color=(1, 1, 1, 1))
    commands.set_state(gw.State(polygon_offset=gw.PolygonOffsetState(enable=True)))
    commands.draw(gw.Mesh("Triangles", [[0, 0, 0], [1, 0, 0], [0, 1, 0]]))
    for reference in (False, True):
        machine = gw.Machine("vgx", 8, 8, reference=reference)
        with pytest.raises(gw.Error, match="of pass 'offset'.*polygon_offset"):
            machine.execute(commands)
        assert machine.color.max() == 0


def test_a_list_may_grow_while_another_thread_executes_it():
    machine = gw.Machine("vgx", 64, 64, reference=True)
    commands = triangle_list()
    worker = threading.Thread(target=lambda: machine.execute(commands))
    worker.start()
    for _ in range(100):
        commands.clear(color=(0, 0, 0, 1))
    worker.join()
    assert machine.color[32, 32].max() > 0 and len(commands) == 104


def test_control_c_ends_a_long_list_on_the_reference_machine():
    import _thread
    machine = gw.Machine("vgx", 256, 256, reference=True)
    commands = gw.CommandList()
    mesh = gw.Mesh("Triangles", [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]])
    for _ in range(3000):
        commands.draw(mesh)
    timer = threading.Timer(0.2, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        machine.execute(commands)

"""Ctrl-C ends long work soon and leaves its objects as they were, or usable; threads take turns."""
import _thread
import pathlib
import threading
import time

import gw
import pytest

SCENES = pathlib.Path(__file__).parents[2] / "scenes"
LONG = 120  # seconds that none of these would take less than, uninterrupted, by far


def interrupted(work):
    """Whether Ctrl-C, a third of a second after the beginning, ends the work."""
    timer = threading.Timer(0.3, _thread.interrupt_main)
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        work()
        timer.join()
    return time.monotonic() - begin < LONG


def whole_window():
    return gw.Mesh("Triangles", [[-1, -1, 0], [3, -1, 0], [-1, 3, 0]],
                   texcoords=[[0, 0], [9, 0], [0, 9]])


@pytest.mark.parametrize("reference", [False, True])
def test_a_long_list_ends_and_the_machine_goes_on(reference):
    machine = gw.Machine("vgx", 512 if reference else 2048, 512 if reference else 2048,
                         reference=reference)
    commands = gw.CommandList()
    commands.set_state(gw.State(blend=gw.BlendState(enable=True, src="One", dst="One")))
    for _ in range(20000):
        commands.draw(whole_window(), color=(0.1, 0, 0, 1))
    assert interrupted(lambda: machine.execute(commands))
    after = gw.CommandList()
    after.clear(color=(0, 1, 0, 1))
    machine.execute(after)
    assert machine.color[5, 5].tolist() == [0, 255, 0, 255]


def test_a_recording_of_an_interrupted_machine_is_what_it_did():
    machine = gw.Machine("vgx", 256, 256, reference=True, record=True)
    commands = gw.CommandList()
    commands.set_state(gw.State(blend=gw.BlendState(enable=True, src="One", dst="One")))
    for _ in range(20000):
        commands.draw(whole_window(), color=(0.004, 0, 0, 1))
    assert interrupted(lambda: machine.execute(commands))
    assert machine.recording().replay().digests() == machine.digests()


@pytest.mark.parametrize("renderer", ["raytrace", "adaptive", "multipass", "scanline"])
def test_a_long_picture_ends_and_the_next_is_right(renderer):
    scene = gw.Scene.open(SCENES / "rings.toml")
    drawer = gw.Renderer(scene, 32, 24, renderer, depth=4)
    drawer.draw()
    first = drawer.machine.digests()["color"]
    large = gw.Renderer(scene, 1600, 1200, renderer, samples=500, depth=4)
    assert interrupted(lambda: large.draw())
    drawer.draw()
    assert drawer.machine.digests()["color"] == first


def test_a_long_hidden_surface_run_ends():
    scene = gw.Scene()
    for i in range(4):
        scene.add(f"ball {i}", gw.make_icosphere(1 + i, 4))
    assert interrupted(lambda: gw.hidden.run(scene, "newell", limit=0))


def test_a_shot_ends_and_the_solution_is_as_before():
    scene = gw.Scene()
    scene.add("room", gw.make_room((4, 3, 4)), gw.SceneMaterial(Kd=(0.6, 0.6, 0.6), Ke=(1, 1, 1)))
    solver = gw.Radiosity(scene, hemicube=2048, texels_per_unit=12, patch=32)
    before = solver.books()
    assert interrupted(lambda: solver.shoot())
    assert solver.books() == before and solver.shots == 0


def test_threads_that_share_objects_take_turns():
    scene = gw.Scene.open(SCENES / "rings.toml")
    machine, drawer = gw.Machine("vgx", 64, 64, record=True), gw.Renderer(scene, 40, 30, samples=2)
    room = gw.Scene()
    room.add("room", gw.make_room(), gw.SceneMaterial(Kd=(0.5, 0.5, 0.5), Ke=(1, 1, 1)))
    solver = gw.Radiosity(room, hemicube=16, texels_per_unit=8)
    commands = gw.CommandList()
    commands.begin_pass("p", digests=True)
    commands.clear(color=(1, 0, 0, 1))
    commands.draw(whole_window())
    commands.read(1, "Color", (0, 0, 8, 8))
    failures = []

    def use(number):
        try:
            for _ in range(15):
                machine.execute(commands)
                machine.passes(), machine.digests(), machine.readbacks(), machine.color.sum(
                    ), machine.recording()
                drawer.draw()
                drawer.rays(), drawer.passes()
                solver.shoot()
                solver.pixmaps(), solver.books(), solver.form_factors(number)
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=use, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
    assert len(machine.passes()) == 60 and solver.shots == 60
    assert drawer.machine.digests()["color"] == gw.render(scene, 40, 30,
                                                          samples=2).digests()["color"]


def test_another_thread_runs_while_the_machine_draws():
    machine = gw.Machine("vgx", 1024, 1024, threads=1)
    commands = gw.CommandList()
    for _ in range(300):
        commands.draw(whole_window())
    counted, ends = 0, threading.Event()
    worker = threading.Thread(target=lambda: (machine.execute(commands), ends.set()))
    worker.start()
    while not ends.is_set():
        counted += 1
    worker.join()
    assert counted > 1000  # with the interpreter's lock held it would be a handful

"""The papers' renderers from Python, beside the command's answers."""
import json
import math
import os
import pathlib
import subprocess
import zlib

import gw
import numpy as np
import pytest

COMMAND = os.environ.get("GW")
SCENES = pathlib.Path(__file__).parents[2] / "scenes"


def room():
    scene = gw.Scene(name="room")
    scene.add("room", gw.make_room((4, 3, 4)), gw.SceneMaterial(Kd=(0.6, 0.6, 0.6)))
    lamp = np.eye(4)
    lamp[1, 3] = 1.2
    scene.add("lamp", gw.make_box((1, 0.1, 1)), gw.SceneMaterial(Ke=(9, 9, 9), Kd=(0, 0, 0)),
              world_from_object=lamp)
    scene.camera = gw.Camera(eye=(0, 0, 1.9), at=(0, -0.3, -1), fov=60)
    return scene


def png_rows(file):
    """The pixels of an 8-bit RGB PNG without filters or with them, top row first."""
    data = pathlib.Path(file).read_bytes()
    width, height = int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")
    at, packed = 8, b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    rows, raw = np.zeros((height, width * 3), np.uint8), zlib.decompress(packed)
    stride = width * 3 + 1
    for y in range(height):
        kind, line = raw[y * stride], bytearray(raw[y * stride + 1:(y + 1) * stride])
        above = rows[y - 1] if y else np.zeros(width * 3, np.uint8)
        for i in range(len(line)):
            a, b, c = (line[i - 3] if i >= 3 else 0), int(above[i]), (int(above[i - 3]) if i >= 3
                else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows[y] = np.frombuffer(bytes(line), np.uint8)
    return rows.reshape(height, width, 3)


@pytest.mark.parametrize("renderer", ["hardware", "multipass", "scanline", "raytrace", "adaptive"])
def test_a_picture_has_the_bits_of_the_command(renderer, tmp_path):
    if not COMMAND or not os.path.exists(COMMAND):
        pytest.skip("no command gw")
    scene_file = SCENES / "rings.toml"
    subprocess.run([COMMAND, "render", scene_file, "-o", tmp_path / "a.png", "--size", "80x60",
                    "--renderer", renderer,
                    "--quiet"], check=True, capture_output=True)
    machine = gw.render(gw.Scene.open(scene_file), 80, 60, renderer)
    assert np.array_equal(gw.picture(machine.color).pixels, png_rows(tmp_path / "a.png"))


def test_a_file_with_passes_of_its_own_is_drawn_with_them(tmp_path):
    text = """
[[object]]
shape = "teapot"

[[pass]]
name = "red"
clear = ["color", "depth", "stencil"]
Ke = [1, 0, 0]
depth = {func = "Less", mask = true}
"""
    scene_file = tmp_path / "own.toml"
    scene_file.write_text(text)
    passes = gw.read_passes(scene_file)
    assert passes is not None and [p.name for p in passes] == ["red"]
    assert gw.read_passes(SCENES / "rings.toml") is None
    machine = gw.render(scene_file, 80, 60)
    assert machine.color[..., 0].max() == 255 and machine.color[..., 1].max() == 0
    if COMMAND and os.path.exists(COMMAND):
        subprocess.run([COMMAND, "render", scene_file, "-o", tmp_path / "a.png", "--size", "80x60",
                        "--quiet"], check=True)
        assert np.array_equal(gw.picture(machine.color).pixels, png_rows(tmp_path / "a.png"))


def test_passes_as_a_table_have_sets_and_estimates():
    renderer = gw.Renderer(gw.Scene.open(SCENES / "rings.toml"), 64, 48)
    renderer.draw()
    rows = {row["pass"]: row for row in renderer.passes()}
    assert rows["depth"]["set"] == "(Ka=0, Kd=0, Ks=0, Ke=0, Map=none)"
    assert all(row["vgx_seconds"] > 0 for row in rows.values() if row["fragments"])
    assert rows["count pixels"]["set"] == ""


def test_both_machines_draw_a_scene_with_the_same_bits():
    scene = gw.Scene.open(SCENES / "rings.toml")
    fast = gw.render(scene, 64, 48, record=True)
    reference = gw.render(scene, 64, 48, reference=True)
    assert fast.digests() == reference.digests()
    assert [p["pass"] for p in fast.passes()] == [p["pass"] for p in reference.passes()]
    assert fast.recording().replay().digests() == fast.digests()


def test_custom_passes_and_components():
    scene = room()
    scene.lights = [gw.SceneLight(name="lamp", kind="Point", position=(0, 1, 0))]
    passes = gw.passes_for(scene, traced=False)
    assert any("diffuse" in str(p) for p in passes)
    whole = gw.render(scene, 64, 48, traced=False)
    assert gw.render(scene, 64, 48, passes=passes, traced=False).digests() == whole.digests()
    black = [p.copy() for p in passes]
    for p in black:
        p.material = gw.PassMaterial()
    assert gw.render(scene, 64, 48, passes=black, traced=False).color[..., :3].max() == 0
    images = gw.components(scene, 64, 48)
    summed = np.minimum(sum(i.astype(int) for i in images.values()), 255)
    assert np.array_equal(summed[..., :3], whole.color[..., :3])
    with pytest.raises(gw.Error, match="pass 0"):
        gw.Renderer(scene, 8, 8,
                    passes=[gw.Pass(name="late", depth=gw.DepthState(test=True, func="Equal"))])


def test_item_buffer_and_rays():
    scene = gw.Scene.open(SCENES / "rings.toml")
    ids = gw.item_buffer(scene, 64, 48)
    assert ids.shape == (48, 64) and ids.max() > 1
    renderer = gw.Renderer(scene, 64, 48, "raytrace")
    renderer.draw()
    assert renderer.rays()["primary"] == 64 * 48
    slow, fast = (gw.cast_rays(scene, m, 32, 24) for m in ("brute_force", "hierarchy"))
    assert np.array_equal(slow["color"],
                          fast["color"]) and slow["tests"].sum() > fast["tests"].sum()
    expected = "method 'magic': expected one of brute-force, volumes, hierarchy, grid"
    with pytest.raises(gw.Error, match=expected):
        gw.cast_rays(scene, "magic")
    found = gw.renderer_differences(scene, 32, 24)
    assert sum(row["pixels"] for row in found["reasons"]) == 32 * 24


def test_passes_and_rays_are_those_of_the_last_picture():
    renderer = gw.Renderer(gw.Scene.open(SCENES / "fig9.toml"), 32, 24)
    counted = []
    for _ in range(2):
        renderer.draw()
        counted.append((len(renderer.passes()), sum(p["fragments"] for p in renderer.passes()),
                        renderer.rays(), renderer.ray_work()))
    assert counted[0] == counted[1]
    assert set(renderer.rays()) == {"primary", "reflected", "transmitted", "shadow"}
    assert renderer.ray_work()["boxes"] > renderer.ray_work()["triangles"] > 0


def test_pass_study_is_that_of_the_command(tmp_path):
    scene = gw.Scene.open(SCENES / "fig9.toml")
    rows = gw.pass_study(scene, "lights", [1, 3], 32, 24)
    assert [(r["value"], r["method"]) for r in rows][3:5] == [(1, "ray-tracing"), (3, "maps")]
    assert gw.pass_study(scene, "lights", [1, 3], 32, 24, threads=2) == rows
    with pytest.raises(gw.Error, match="sweep 'lite': expected one of scene, lights"):
        gw.pass_study(scene, "lite")
    with pytest.raises(gw.Error, match="sweep lights '0': expected"):
        gw.pass_study(scene, "lights", [0])
    if COMMAND and os.path.exists(COMMAND):
        subprocess.run([COMMAND, "study", "passes", SCENES / "fig9.toml", "-o", tmp_path / "out",
                        "--size", "32x24", "--sweep", "lights=1,3", "--runs", "0", "--quiet"],
                       check=True, capture_output=True)
        found = json.loads((tmp_path / "out/results.json").read_text())["rows"][4:]
        for ours, theirs in zip(rows, found, strict=True):
            assert ours["picture"] == theirs["picture"]
            assert {k: ours["counts"][k] for k in theirs["counts"] if k in ours["counts"]}.items() \
                <= theirs["counts"].items()


def test_radiosity_is_an_iterator_of_shots():
    solver = gw.Radiosity(room(), hemicube=32, texels_per_unit=3)
    unshot = [shot["unshot"] for _, shot in zip(range(40), solver)]
    assert unshot[-1] < unshot[0] < 1 and solver.shots == 40
    books = solver.books()
    assert books["imbalance"] < 1e-9
    walls = solver.pixmaps()
    assert all(p.ndim == 3 and p.shape[2] == 3 for p in walls.values()) and max(p.max()
        for p in walls.values()) > 1
    row = solver.form_factors(0)
    assert row["factors"].sum() + row["backs"] + row["escaped"] == pytest.approx(1, abs=1e-9)
    assert solver.draw(width=64, height=48, brightness=0.2).color.max() > 20
    dimmed = room()
    materials = dimmed.materials
    materials[1].Ke = (4, 4, 4)
    dimmed.materials = materials
    before = walls["room"].mean() if "room" in walls else max(p.mean() for p in walls.values())
    solver.update(dimmed)
    after = solver.pixmaps()
    assert (after["room"].mean() if "room" in after
            else max(p.mean() for p in after.values())) < before
    with pytest.raises(gw.Error, match="expected"):
        solver.form_factors(10**9)


def test_radiosity_of_a_lamp_in_candela(tmp_path):
    (tmp_path / "s.toml").write_text("""white = {lux = 100}
texels = 5
[[light]]
position = [0, 2, 0]
candela = 300
[[object]]
name = "floor"
shape = "rectangle"
width = 1
depth = 1
material = {Kd = 0.5}
""")
    scene = gw.Scene.open(tmp_path / "s.toml")
    lamp = scene.lights[0]
    assert scene.white == 100
    assert lamp.candela == pytest.approx((300, 300, 300))
    assert lamp.lumen == pytest.approx((4 * math.pi * 300,) * 3)
    solver = gw.Radiosity(scene, hemicube=128)
    # at the foot I / d^2; 0.5 of it is reflected, and shown by the white
    assert solver.pixmaps("irradiance")["floor"].max() == pytest.approx(300 / 4, rel=0.02)
    camera = gw.Camera()
    camera.eye, camera.at, camera.up = (0, 1, 0), (0, 0, 0), (0, 0, 1)
    picture = solver.draw(camera, width=33, height=33, ambient=False)
    assert picture.color[16, 16, 0] == pytest.approx(0.5 * 0.75 * 255, abs=3)
    assert gw.SceneLight().candela is None and gw.SceneLight().lumen is None


def painter(header):
    """Far to near by the farthest corner."""
    def farthest(polygon):
        return max(z for loop in polygon["outline"] for _, _, z in loop)
    in_window = [polygon for polygon in header["polygons"] if polygon["outline"]]
    for polygon in sorted(in_window, key=farthest, reverse=True):
        yield {"kind": "draw", "pieces": [str(polygon["id"])]}


@pytest.mark.parametrize("name", ["newell", "bsp", "warnock", "z-buffer", "scan-line"])
def test_hidden_surfaces_log_steps_and_agree_with_the_z_buffer(name):
    scene = gw.Scene.open(SCENES / "hidden/cycle.toml")
    assert name in gw.hidden.algorithms()
    run = gw.hidden.run(scene, name, width=96, height=72)
    steps = list(gw.hidden.steps(run))
    assert len(steps) == len(run) and all(step["sentence"] for step in steps)
    assert run.ids.shape == (72, 96)
    assert run.counts()["wrong"] == 0
    assert run.log().count("\n") == len(run) + 2


def test_an_algorithm_in_python_is_played_and_graded(tmp_path):
    scene = gw.Scene.open(SCENES / "hidden/cycle.toml")
    mine = gw.hidden.play(scene, painter, width=80, height=60)
    assert mine.name == "painter" and len(mine) > 0
    assert sum(row["expected"] for row in mine.grades()) == 80 * 60
    assert mine.counts()["wrong"] == np.count_nonzero(mine.difference == 4)
    blame = gw.hidden.blame(mine)
    assert sum(row["pixels"] for row in blame) == mine.counts()["wrong"] > 0
    assert all(mine.ids[row["first"][1], row["first"][0]] == row["polygon"] for row in blame)
    assert gw.hidden.blame(gw.hidden.run(scene, "z-buffer", width=80, height=60)) == []
    gw.hidden.save_player(mine, tmp_path / "player.html")
    assert (tmp_path / "player.html").stat().st_size > 10000
    with pytest.raises(gw.Error, match="nobody:1: "):
        def nobody(header):
            yield {"kind": "draw", "pieces": ["999999"]}
        gw.hidden.play(scene, nobody)
    with pytest.raises(gw.Error, match="step 1 is no JSON"):
        gw.hidden.play(scene, lambda header: [{"kind": {1}}])


def test_a_run_that_would_take_too_long_is_refused():
    scene = gw.Scene()
    scene.add("ball", gw.make_icosphere(1, 5))
    with pytest.raises(gw.Error, match="would take about .*limit=0 to try"):
        gw.hidden.run(scene, "newell", limit=0.001)

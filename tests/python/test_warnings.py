"""Input that is valid and not done as asked: one warning that names it, and never an endless loop."""
import itertools
import os
import pathlib
import warnings

import gw
import numpy as np
import pytest

SCENES = pathlib.Path(__file__).parents[2] / "scenes"

def room(Kd):
    scene = gw.Scene()
    scene.add("white room", gw.make_room(),
              gw.SceneMaterial(name="white", Kd=(Kd, Kd, Kd), Ke=(1, 1, 1)))
    return gw.Radiosity(scene, hemicube=16, texels_per_unit=1)


def test_light_that_is_not_absorbed_ends_with_a_warning():
    light = room(1)
    most = 4 * max(light.patches, 16)
    with pytest.warns(UserWarning, match="'white room' reflects 1 of its light; expected Kd below 1"):
        shots = len(list(itertools.islice(light, most)))
    assert shots < most
    with pytest.warns(UserWarning, match="neither escapes nor is absorbed"):
        assert list(light) == []
    assert light.shoot()["shot"] == shots + 1  # as asked


def test_a_room_that_absorbs_shoots_on_without_a_word():
    light = room(0.9)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert any(shot["unshot"] < 0.01 for shot in itertools.islice(light, 10000))


def test_an_update_begins_to_watch_again():
    light = room(1)
    with pytest.warns(UserWarning):
        list(itertools.islice(light, 4 * max(light.patches, 16)))
    scene = gw.Scene()
    scene.add("white room", gw.make_room(),
              gw.SceneMaterial(name="white", Kd=(0.5, 0.5, 0.5), Ke=(1, 1, 1)))
    light.update(scene)
    assert len(list(itertools.islice(light, 3))) == 3


def test_planes_that_count_as_one_are_named():
    corners = [(-2, -2), (2, -2), (2, 2), (-2, 2)]
    sheets = [[x, y, z if y < 0 else -z] for z in (0, 1e-6) for x, y in corners]
    scene = gw.Scene()
    scene.add("sheets", gw.Mesh("Quads", sheets))
    scene.camera = gw.Camera(eye=(0, 0, 10), at=(0, 0, 0))
    with pytest.warns(UserWarning, match="bsp: polygons 1 of 'sheets' and 2 of 'sheets' .* are wrong"):
        gw.hidden.run(scene, "bsp", width=64, height=48)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        gw.hidden.run(scene, "z-buffer", width=64, height=48)


def flush_lamp():
    """A lamp in the plane of its ceiling, and a line."""
    scene = gw.Scene()
    scene.add("ceiling", gw.make_rectangle(4, 4))
    scene.add("lamp", gw.make_rectangle(1, 1), gw.SceneMaterial(name="light", Ke=(1, 1, 1)))
    scene.add("wire", gw.Mesh("Lines", [[0, 1, 0], [1, 1, 0]]))
    scene.camera = gw.Camera(eye=(0, 5, 3), at=(0, 0, 0))
    return scene


@pytest.mark.parametrize("use", [
    lambda scene: gw.hidden.run(scene, "bsp", width=32, height=24),
    lambda scene: gw.hidden.polygons(scene, width=32, height=24),
    lambda scene: gw.Radiosity(scene, hemicube=16, texels_per_unit=1),
], ids=["run", "polygons", "radiosity"])
def test_every_door_warns_of_coincident_objects_and_lines(use):
    with pytest.warns(UserWarning) as found:
        use(flush_lamp())
    texts = [str(warning.message) for warning in found]
    assert any("'ceiling' and 'lamp' share a part of a plane" in text for text in texts)
    assert any("lines and points are left out, as of object 'wire'" in text for text in texts)


@pytest.mark.parametrize("use", [
    lambda scene, size: gw.render(scene, **size),
    lambda scene, size: gw.Renderer(scene, **size).draw(),
    lambda scene, size: gw.components(scene, **size),
    lambda scene, size: gw.item_buffer(scene, **size),
    lambda scene, size: gw.cast_rays(scene, **size),
    lambda scene, size: gw.renderer_differences(scene, **size),
    lambda scene, size: gw.pass_study(scene, values=[1], runs=0, **size),
    lambda scene, size: gw.hidden.run(scene, "newell", **size),
    lambda scene, size: gw.hidden.polygons(scene, **size),
], ids=["render", "renderer", "components", "item_buffer", "cast_rays", "differences", "study",
        "hidden", "polygons"])
def test_every_door_warns_of_a_scene_without_objects(use):
    empty = "^the scene has nothing to draw; expected an object$"
    with pytest.warns(UserWarning, match=empty) as found:
        use(gw.Scene(), {"width": 16, "height": 12})
    assert len(found) == 1


def test_a_model_is_drawn_without_a_picture_that_is_missing(tmp_path):
    """A scene's own map is an error."""
    (tmp_path / "m.mtl").write_text("newmtl wood\nKa 0\nKd 1 0 0\nmap_Kd gone.png\nmap_d hole.png\n")
    (tmp_path / "m.obj").write_text(
        "mtllib m.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
    with pytest.warns(UserWarning, match=r"m.mtl:4: map_Kd .*gone.png: no such file; expected a "
                      "picture file, so it is left out, beside 1 more$") as found:
        scene = gw.Scene.open(tmp_path / "m.obj")
    assert len(found) == 1
    red = gw.render(scene, 32, 24).color.max(axis=(0, 1))
    assert red[0] > 100 and red[1] == red[2] == 0
    (tmp_path / "s.toml").write_text('[[object]]\nshape = "sphere"\nmaterial = "skin"\n'
                                     '[material.skin]\nmap_Kd = "gone.png"\n')
    with pytest.raises(gw.Error, match="s.toml:5: map_Kd .*gone.png: no such file"):
        gw.Scene.open(tmp_path / "s.toml")


@pytest.mark.parametrize("draw", [gw.render, gw.cast_rays, gw.renderer_differences])
def test_an_empty_picture_of_a_scene_is_named(draw):
    scene = gw.Scene()
    scene.add("box", gw.make_box())
    scene.camera = gw.Camera(eye=(0, 0, 5), at=(0, 0, 10))
    with pytest.warns(UserWarning, match="the picture is empty: no pixel differs"):
        draw(scene, width=16, height=12)


def test_a_picture_of_light_names_what_its_near_plane_cuts_off():
    scene = gw.Scene()
    scene.add("near", gw.make_rectangle(1, 1), gw.SceneMaterial(name="light", Ke=(1, 1, 1)))
    far = np.eye(4)
    far[:3, 3] = 0, -500, 0
    scene.add("far", gw.make_box(), world_from_object=far)
    scene.camera = gw.Camera(eye=(0, 0.001, 0.0001), at=(0, 0, 0))
    light = gw.Radiosity(scene, hemicube=16, texels_per_unit=1)
    with pytest.warns(UserWarning, match="'near' is cut off"):
        light.draw(width=32, height=24)


def test_warnings_show_names_of_any_bytes(tmp_path):
    """A name of a file may have bytes that are no UTF-8."""
    file = os.fsencode(tmp_path) + b"/far\xff.obj"
    with open(file, "w") as out:
        out.write("v 4310000 54110000 0\nv 4310001 54110000 0\nv 4310000 54110001 0\nf 1 2 3\n")
    with pytest.warns(UserWarning, match="far.*lies far from 0"):
        gw.Scene.open(os.fsdecode(file))


def test_positions_that_lose_digits_are_named():
    square = np.array([[0, 0, 0], [0.3, 0, 0], [0.3, 0.3, 0], [0, 0.3, 0]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        gw.Mesh("Quads", square)
        gw.Mesh("Points", [[0.9, -0.9, 0]])
        gw.Mesh("Quads", (square + [431000.1, 5411000.2, 0]).astype(np.float32))
    with pytest.warns(UserWarning, match="positions: float32 moves them by up to 0.2.* in a mesh 0.3"):
        gw.Mesh("Quads", square + [431000.1, 5411000.2, 0])


def test_colors_of_a_mesh_are_named_where_a_material_colours_it():
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    with pytest.warns(UserWarning, match="object 'scan': colors of its mesh are not drawn; expected"):
        gw.Scene().add("scan", gw.Mesh("Triangles", corners, colors=np.ones((3, 4))))


def test_opacity_is_named_where_hidden_surfaces_are_opaque():
    scene = gw.Scene()
    scene.add("pane", gw.make_box(), gw.SceneMaterial(d=0.5))
    with pytest.warns(UserWarning, match="^gw.hidden leaves out of this scene: translucency$"):
        gw.hidden.run(scene, "newell", width=16, height=12)


def test_a_light_that_radiosity_leaves_out_is_named():
    scene = gw.Scene()
    scene.add("lamp", gw.make_room(), gw.SceneMaterial(Kd=(0.5, 0.5, 0.5), Ke=(1, 1, 1)))
    scene.lights = [gw.SceneLight(name="key")]
    with pytest.warns(UserWarning, match="light 'key' is not in candela or lumen, so radiosity"):
        gw.Radiosity(scene, hemicube=16, texels_per_unit=1)


def test_bytes_are_colours_from_0_to_255():
    corners = np.zeros((3, 3))
    colors = gw.Mesh("Triangles", corners, colors=np.full((3, 4), 128, np.uint8)).colors
    with pytest.warns(UserWarning, match="^colors: 255; expected 0 to 1, or bytes"):
        gw.Mesh("Triangles", corners, colors=np.full((3, 4), 255))
    assert np.allclose(colors, 128 / 255)
    assert gw.Mesh("Triangles", corners, colors=np.ones((3, 4))).colors.max() == 1


def test_pictures_of_planes_of_more_bits_are_refused_or_right():
    machine = gw.render(SCENES / "rings.toml", 16, 12, profile="ideal")
    with pytest.raises(gw.Error, match="expected 0 .. 255, or bits = the plane's bits"):
        gw.picture(machine.color)
    assert np.array_equal(gw.picture(machine.color, bits=16).pixels, machine.color[::-1, :, :3])
    for wrong in (np.full((2, 2, 3), -1), np.full((2, 2, 3), 300), np.ones((2, 2, 3))):
        with pytest.raises(gw.Error):
            gw.picture(wrong)


def test_an_endless_algorithm_ends(monkeypatch):
    def endless(header):
        while True:
            yield {"kind": "compare"}

    monkeypatch.setattr(gw.hidden, "_MOST_STEPS", 1000)
    with pytest.raises(gw.Error, match="endless: step 1001 is one too many; expected at most 1,000"):
        gw.hidden.play(gw.Scene.open(SCENES / "hidden/cycle.toml"), endless)

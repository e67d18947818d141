"""Arguments of every kind, at random: exceptions with a text, never a crash."""
import pathlib
import subprocess
import sys

import gw
import numpy as np
import pytest

FUZZ = pathlib.Path(__file__).parent / "fuzz_arguments.py"
BOX = gw.make_box()


@pytest.mark.parametrize("first", [1000, 1040])
def test_no_argument_crashes_the_interpreter(first):
    done = subprocess.run([sys.executable, FUZZ, str(first), "12"], capture_output=True, text=True,
                          timeout=240)  # a call that nothing interrupts
    assert done.returncode == 0, done.stdout[-300:] + done.stderr[-3000:]


def scene_with(**members):
    scene = gw.Scene(name="wrong")
    scene.add("box", BOX, gw.SceneMaterial(name="paint"))
    for name, value in members.items():
        setattr(scene, name, value)
    return scene


@pytest.mark.parametrize("members, message", [
    ({"materials": []}, "object 'box', material: 0; expected a scene with materials"),
    ({"objects": [gw.Object(name="empty")]}, "object 'empty', mesh: None"),
    ({"materials": [gw.SceneMaterial(name="m", Kd=(float("nan"), 0, 0))]},
     "material 'm', Kd: nan; expected a number from 0"),
    ({"materials": [gw.SceneMaterial(name="m", d=-1)]},
     "material 'm', d: -1; expected a number from 0 to 1"),
    ({"lights": [gw.SceneLight(name="l", direction=(0, 0, 0))]},
     "light 'l', direction: 0; expected a direction"),
    ({"camera": gw.Camera(eye=(1, 1, 1), at=(1, 1, 1))}, "camera, at: the eye"),
    ({"camera": gw.Camera(fov=float("nan"))}, "camera, fov: nan; expected a number from 0.1 to 179"),
    ({"fog": gw.Fog(start=2, end=1)}, "fog, end: not beyond start"),
    ({"background": (float("inf"), 0, 0)}, "scene 'wrong', background: inf"),
])
def test_a_scene_with_values_that_no_file_can_have_is_refused_by_every_user(members, message):
    scene = scene_with(**members)
    for use in (lambda: gw.render(scene, 8, 8), lambda: gw.item_buffer(scene, 8, 8),
                lambda: gw.Radiosity(scene),
                lambda: gw.hidden.run(scene, "newell"), lambda: gw.cast_rays(scene),
                lambda: gw.components(scene)):
        with pytest.raises(gw.Error, match=message):
            use()


def test_a_matrix_without_inverse_is_refused():
    scene = gw.Scene()
    scene.add("flat", BOX, world_from_object=np.zeros((4, 4)))
    with pytest.raises(gw.Error, match="object 'flat', world_from_object: not affine"):
        gw.render(scene, 8, 8)


def test_lists_of_a_value_are_copies_that_outlive_it():
    scene = scene_with()
    materials = scene.materials
    materials[0].name = "changed"
    assert scene.materials[0].name == "paint"
    scene.materials = [gw.SceneMaterial() for _ in range(1000)]
    del scene
    assert materials[0].name == "changed"


@pytest.mark.parametrize("wrong, message", [
    (lambda: gw.make_sphere(slices=-1),
     "sphere, slices: -1; expected a whole number from 3 to 4096"),
    (lambda: gw.make_icosphere(divisions=30),
     "icosphere, divisions: 30; expected a whole number from 0 to 9"),
    (lambda: gw.make_box((1, float("nan"), 1)), "box, height: nan"),
    (lambda: gw.make_shape("kettle"), "no shape 'kettle'; expected one of bottle"),
    (lambda: gw.make_shape("vase", slice=3), "vase has no 'slice'; expected slices, segments"),
    (lambda: gw.Machine("vgx", 10**5, 10**5), "expected"),
    (lambda: gw.Machine("indigo", 8, 8), "unknown profile 'indigo'; expected vgx, reality"),
    (lambda: gw.render(scene_with(), 8, 8, profile="vgx,bits=3"), "^[^\\n]*bits[^\\n]*$"),
    (lambda: gw.Mesh("Squares", [[0, 0, 0]]), "Primitive has no 'Squares'; expected Points, Lines"),
    (lambda: gw.Mesh("Points", np.ma.array(np.zeros((1, 3)), mask=[[0, 1, 0]])),
     r"positions: has masked elements; expected none, as filled\(\) gives"),
    (lambda: gw.picture(np.zeros((0, 5, 3), np.uint8)), r"plane: an array of shape \(0, 5, 3\)"),
    (lambda: gw.picture(np.full((4, 5), np.nan)), "plane: values that are not finite"),
    (lambda: gw.Machine(threads=10**6), "threads: 1000000; expected a whole number from 0 to 1024"),
    (lambda: gw.Renderer(scene_with(), samples=0), "samples '0': expected a whole number, 1..32768"),
    (lambda: gw.Renderer(scene_with(), depth=-1), "depth '-1': expected a whole number, 1..64"),
    (lambda: gw.Radiosity(scene_with(), texels_per_unit=float("nan")), "texels_per_unit: nan"),
    (lambda: gw.CommandList().write_spans([[0, 0, 1.5, 0]], [[0, 0, 0, 0]]), "whole numbers"),
    (lambda: gw.CommandList().draw(None), "incompatible function arguments"),
    (lambda: setattr(gw.SceneMaterial(), "map_Kd", [None]), "expected a Texture"),
    (lambda: gw.SceneMaterial(Kd=0.5), r"SceneMaterial.Kd: got 0.5; expected 3 numbers"),
    (lambda: gw.hidden.run(scene_with(), "newell").sentence(0, "fr"),
     "language: 'fr'; expected en or ja"),
])
def test_wrong_values_are_named_with_their_limits(wrong, message):
    with pytest.raises((ValueError, TypeError), match=message):
        wrong()


@pytest.mark.parametrize("actual, expected, worst", [
    ([[0.25, 0.5]], [[0.25, 0.75]], "1 pixels differ; the worst, 1 0: expected 0.75, got 0.5"),
    ([[np.nan, 1.0]], [[1.0, np.nan]], "2 pixels differ; the worst, 0 0: expected 1.0, got nan"),
    (np.zeros((2, 2, 4), np.uint8), np.full((2, 2, 4), 3, np.uint8),
     r"4 pixels differ; the worst, 0 0: expected \[3, 3, 3, 3\], got \[0, 0, 0, 0\]"),
])
def test_planes_of_any_numbers_are_compared_to_the_bit(actual, expected, worst):
    from gw.testing import expect_planes_equal
    expect_planes_equal(actual, actual)
    expect_planes_equal(expected, np.array(expected))
    with pytest.raises(pytest.fail.Exception, match=worst):
        expect_planes_equal(actual, expected)


def test_what_is_no_plane_is_refused():
    from gw.testing import expect_planes_equal
    for wrong in (3, [1, 2], [["a"]], [[1j]], [[None]]):
        with pytest.raises(TypeError, match="expected numbers of shape"):
            expect_planes_equal(wrong, wrong)

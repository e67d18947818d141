"""The wheel serves alone, without the build tree and the system's copies of its libraries."""
import os
import pathlib
import re
import subprocess
import sys
import zipfile

import pytest

import gw

PACKAGE = pathlib.Path(gw.__file__).parent
SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
OSMESA = PACKAGE.parent.parent / "lib/opengl/libOSMesa.so.8"


def run(unpacked, *words):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("LD_")}
    environment["PYTHONPATH"] = str(unpacked)
    return subprocess.run([sys.executable, *words], cwd=unpacked, env=environment, check=True,
                          capture_output=True, text=True)


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run([sys.executable, SOURCE / "python/make_wheel.py", PACKAGE, OSMESA, "0.1", folder],
                   check=True)
    (wheel,) = folder.glob("gw-0.1-*.whl")
    with zipfile.ZipFile(wheel) as file:
        assert file.testzip() is None
        file.extractall(folder / "unpacked")
    return folder / "unpacked"


def test_the_module_takes_its_libraries_from_the_wheel(unpacked):
    shown = run(unpacked, "-c", "import gw; gw.Machine('vgx', 8, 8)\n"
                "print(open('/proc/self/maps').read())")
    loaded = set(re.findall(r"/\S+/lib(?:fmt|tbb|png\d*)\.so\S*", shown.stdout))
    assert len(loaded) == 3 and all(file.startswith(f"{unpacked}/gw/lib/") for file in loaded)


def test_it_has_the_licences_of_its_libraries(unpacked):
    (licence,) = unpacked.glob("gw-*.dist-info/LICENSE")
    text = licence.read_text(encoding="utf-8")
    assert text.startswith("MIT License\n")
    for package in ("libfmt9", "libhwy-dev", "libpng16-16", "libtbb12", "pybind11-dev"):
        assert f"\n{package}\n\n" in text


def test_pyopengl_draws_on_the_wheels_osmesa(unpacked):
    drawn = run(unpacked, SOURCE / "tests/python/osmesa_triangle.py")
    library = unpacked / "gw/opengl/libOSMesa.so.8"
    assert drawn.stdout == f"{library}\nGW [0, 255, 0, 255] [255, 0, 0, 255]\n"
    assert drawn.stderr == f"gw.osmesa: OpenGL is drawn by {library}\n"


def test_osmesa_that_comes_too_late_or_is_missing_says_so(unpacked):
    (unpacked / "gw/opengl/libOSMesa.so.8").rename(unpacked / "aside")
    for words, expected in (("import OpenGL.GL, gw.osmesa", "before it"),
                            ("import gw.osmesa", "no libOSMesa.so.8 in")):
        with pytest.raises(subprocess.CalledProcessError) as failed:
            run(unpacked, "-c", words)
        assert re.search(rf"ImportError: gw\.osmesa: .*{expected}.*\n$", failed.value.stderr)
    (unpacked / "aside").rename(unpacked / "gw/opengl/libOSMesa.so.8")

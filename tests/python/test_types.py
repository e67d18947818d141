"""The types of the package, as mypy sees them."""
import atexit
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import gw
import pytest

PACKAGE = pathlib.Path(gw.__file__).parent
NOTEBOOKS = pathlib.Path(__file__).parents[2] / "examples/notebooks"
CACHE = pathlib.Path(tempfile.mkdtemp(prefix="gw-mypy-"))  # NumPy's types take most of the time
atexit.register(shutil.rmtree, CACHE, ignore_errors=True)

PROGRAM = '''
import gw
from gw.testing import expect_passes_equal

machine = gw.Machine("vgx", 64, 64, threads=1)
commands = gw.CommandList()
commands.clear(color=(0, 0, 0, 1), depth=1.0)
commands.set_state(gw.State(depth=gw.DepthState(test=True, func="LEqual")))
commands.draw(gw.Mesh("Triangles", [[0, 0, 0], [1, 0, 0], [0, 1, 0]]),
              material=gw.Material(Kd=(1, 0, 0)))
machine.execute(commands)
height: int = machine.color.shape[0]
gw.picture(machine.color).save("a.png")
for row in gw.render(gw.Scene.open("a.toml"), 64, 48, samples=2).passes():
    print(row["pass"])
print(gw.hidden.algorithms(), gw.make_shape("vase", slices=8).vertex_count)
reveal_type(machine.depth)
WRONG
'''


def mypy(tmp_path, text, *more):
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(text)
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(CACHE),
                           *more, "program.py"],
                          cwd=tmp_path, env={"MYPYPATH": str(PACKAGE.parent), "PATH":
                                             "/usr/bin:/bin"},
                          capture_output=True, text=True)


def test_a_program_and_the_package_pass_strict_mypy(tmp_path):
    done = mypy(tmp_path, PROGRAM.replace("WRONG", ""))
    assert done.returncode == 0, done.stdout + done.stderr
    assert "numpy.ndarray" in done.stdout


def test_mypy_finds_a_wrong_type(tmp_path):
    done = mypy(tmp_path, PROGRAM.replace("WRONG", "gw.DepthState(tets=True)\nmachine.execute(3)"))
    assert done.returncode == 1 and done.stdout.count("error:") == 2, done.stdout


def test_the_notebooks_pass_mypy(tmp_path):
    """Strictly, but for functions that the class reads without annotations."""
    cells = []
    for notebook in sorted(NOTEBOOKS.glob("*.ipynb")):
        sources = [c["source"] for c in json.loads(notebook.read_text(encoding="utf-8"))["cells"]
                   if c["cell_type"] == "code"]
        (tmp_path / f"{notebook.stem}.py").write_text("\n".join("".join(source)
            for source in sources) + "\n")
        cells.append(f"{notebook.stem}.py")
    # By module: options of the whole run would have the cache of the packages made anew.
    (tmp_path / "mypy.ini").write_text("[mypy]\n" + "".join(
        f"[mypy-{cell.removesuffix('.py')}]\nallow_untyped_defs = True\n"
        "allow_untyped_calls = True\nallow_incomplete_defs = True\nwarn_return_any = False\n"
        for cell in cells))
    done = mypy(tmp_path, "", *cells)
    assert done.returncode == 0, done.stdout + done.stderr


def test_everything_has_a_docstring_and_a_signature():
    for name, value in vars(gw._gw).items():
        if name.startswith("_"):
            continue
        assert value.__doc__, name
        if isinstance(value, type):
            for member, m in vars(value).items():
                if not member.startswith("_") and not hasattr(value, "__members__"):
                    assert m.__doc__, f"{name}.{member}"

"""The types of the package, as mypy sees them."""
import pathlib
import subprocess
import sys

import gw
import pytest

PACKAGE = pathlib.Path(gw.__file__).parent

PROGRAM = '''
import gw
from gw.testing import expect_passes_equal

machine = gw.Machine("vgx", 64, 64, threads=1)
commands = gw.CommandList()
commands.clear(color=(0, 0, 0, 1), depth=1.0)
commands.set_state(gw.State(depth=gw.DepthState(test=True, func="LEqual")))
commands.draw(gw.Mesh("Triangles", [[0, 0, 0], [1, 0, 0], [0, 1, 0]]), material=gw.Material(Kd=(1, 0, 0)))
machine.execute(commands)
height: int = machine.color.shape[0]
reveal_type(machine.depth)
WRONG
'''


def mypy(tmp_path, text):
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(text)
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "program.py"],
                          cwd=tmp_path, env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"},
                          capture_output=True, text=True)


def test_a_program_and_the_package_pass_strict_mypy(tmp_path):
    done = mypy(tmp_path, PROGRAM.replace("WRONG", ""))
    assert done.returncode == 0, done.stdout + done.stderr
    assert "numpy.ndarray" in done.stdout


def test_mypy_finds_a_wrong_type(tmp_path):
    done = mypy(tmp_path, PROGRAM.replace("WRONG", "gw.DepthState(tets=True)\nmachine.execute(3)"))
    assert done.returncode == 1 and done.stdout.count("error:") == 2, done.stdout


def test_everything_has_a_docstring_and_a_signature():
    for name, value in vars(gw._gw).items():
        if name.startswith("_"):
            continue
        assert value.__doc__, name
        if isinstance(value, type):
            for member, m in vars(value).items():
                if not member.startswith("_") and not hasattr(value, "__members__"):
                    assert m.__doc__, f"{name}.{member}"

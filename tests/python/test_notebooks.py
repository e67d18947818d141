"""The notebooks of examples/ run to the end, and show pictures."""
import ast
import json
import pathlib

import pytest

FOLDER = pathlib.Path(__file__).parents[2] / "examples/notebooks"


def shown(source, names):
    """Runs a cell; the value of its last expression, as a notebook shows it."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None


@pytest.mark.parametrize("notebook", sorted(FOLDER.glob("*.ipynb")), ids=lambda n: n.stem)
def test_a_notebook_runs_to_the_end_and_shows_pictures(notebook, monkeypatch):
    monkeypatch.chdir(FOLDER)
    cells = [c for c in json.loads(notebook.read_text(encoding="utf-8"))["cells"]
             if c["cell_type"] == "code"]
    names = {"__name__": "__main__"}
    pictures = [value for cell in cells
                if hasattr(value := shown("".join(cell["source"]), names), "_repr_png_")]
    assert len(pictures) >= 2
    assert all(picture._repr_png_().startswith(b"\x89PNG") for picture in pictures)
    assert not any(output["output_type"] == "error" for cell in cells for output in cell["outputs"])


def test_all_notebooks_are_there():
    assert len(list(FOLDER.glob("*.ipynb"))) == 5

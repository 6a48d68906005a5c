# SPDX-License-Identifier: Apache-2.0
"""The package's types are sound, its stubs are those of the module, and users' mistakes are found."""
import ast
import pathlib

import pytest

import xgm

PACKAGE = pathlib.Path(xgm.__file__).resolve().parent
SOURCES = pathlib.Path(__file__).resolve().parents[2]
mypy = pytest.importorskip("mypy.api")


def checked(*words):
    out, errors, code = mypy.run(["--config-file", str(SOURCES / "pyproject.toml"),
                                  "--cache-dir=/dev/null", *map(str, words)])
    return code, out + errors


def test_the_package_is_sound():
    code, text = checked(PACKAGE)
    assert code == 0, text


def test_the_stubs_name_what_the_module_has():
    from xgm import _native

    tree = ast.parse((PACKAGE / "_native.pyi").read_text())
    stubs = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            stubs[node.name] = {item.name if isinstance(item, ast.FunctionDef) else item.target.id
                                for item in node.body
                                if isinstance(item, (ast.FunctionDef, ast.AnnAssign))}
        elif isinstance(node, ast.FunctionDef):
            stubs[node.name] = None
        elif isinstance(node, ast.AnnAssign):
            stubs[node.target.id] = None
    there = {name for name in vars(_native) if not name.startswith("__")}
    if "run_surface" not in there:  # built without GDAL and PROJ
        for name in ("SurfaceFiles", "SurfaceWishes", "RecordedSurface", "read_surface_scene",
                     "run_surface", "reasons"):
            del stubs[name]
    assert set(stubs) == there
    for name, members in stubs.items():
        if members is None:
            continue
        real = {key for key in vars(getattr(_native, name)) if not key.startswith("_")}
        assert members - {"__init__"} == real, name


def test_what_a_user_writes_wrong_is_found(tmp_path, monkeypatch):
    file = tmp_path / "user.py"
    file.write_text("import xgm\n"
                    "result = xgm.load('sgm8').run(scene='scene', threads=2)\n"
                    "shape: str = result.disparity.shape\n"
                    "xgm.load('sgm8').run(thread=2)\n")
    monkeypatch.setenv("MYPYPATH", str(PACKAGE.parent))
    code, text = checked(file)
    assert code == 1 and "user.py:3" in text and "user.py:4" in text and "user.py:2" not in text, text

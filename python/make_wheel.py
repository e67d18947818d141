#!/usr/bin/env python3
"""Packs the built package as a wheel for pip, with the libraries that it needs beside it. It runs
on any Linux with Debian 12's glibc or a later one, and the same Python.
Usage: make_wheel.py PACKAGE_DIR OSMESA VERSION OUTPUT_DIR: needs patchelf and python3-wheel.
    OSMESA: libOSMesa.so.8 for gw.osmesa, or "" for none
"""
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

package, osmesa, version = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
output = pathlib.Path(sys.argv[4])
root = pathlib.Path(__file__).resolve().parent.parent
# The system's: every Linux has them, or they are bound to its loader.
system = re.compile(r"lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)\.so|ld-linux")


def libraries_of(module):
    found = subprocess.run(["ldd", module], check=True, capture_output=True, text=True).stdout
    paths = re.findall(r"=> (/\S+)", found)
    return [pathlib.Path(path) for path in paths if not system.match(pathlib.Path(path).name)]


with tempfile.TemporaryDirectory() as folder:
    top = pathlib.Path(folder) / f"gw-{version}"
    shutil.copytree(package, top / "gw", ignore=shutil.ignore_patterns("__pycache__"))
    (module,) = (top / "gw").glob("_gw.*.so")
    # What is looked for beside a module: where from it.
    modules = {module: "$ORIGIN/lib"}
    if osmesa:
        (top / "gw/opengl").mkdir()
        modules[pathlib.Path(shutil.copy(osmesa, top / "gw/opengl"))] = "$ORIGIN/../lib"
    needed = {library for file in modules for library in libraries_of(file)}
    (top / "gw/lib").mkdir()
    for library in needed:
        copied = top / "gw/lib" / library.name
        shutil.copy(library.resolve(), copied)
        subprocess.run(["patchelf", "--set-rpath", "$ORIGIN", copied], check=True)
    for file, path in modules.items():
        subprocess.run(["strip", "--strip-unneeded", file], check=True)
        subprocess.run(["patchelf", "--set-rpath", path, file], check=True)

    # GW's own glibc is the oldest that serves.
    glibc = platform.libc_ver()[1].replace(".", "_")
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    info = top / f"gw-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: gw\nVersion: {version}\nSummary: A graphics workstation of "
        "1991 in software, exact to the bit\nLicense: MIT\nRequires-Python: "
        f"=={sys.version_info.major}.{sys.version_info.minor}.*\nRequires-Dist: numpy\n")
    (info / "WHEEL").write_text(
        "Wheel-Version: 1.0\nGenerator: make_wheel.py\nRoot-Is-Purelib: false\n"
        f"Tag: {python}-{python}-manylinux_{glibc}_{platform.machine()}\n")
    licences = subprocess.run([root / "scripts/licences", "pybind11-dev", *needed], check=True,
                              capture_output=True)
    (info / "LICENSE").write_bytes(licences.stdout)
    output.mkdir(exist_ok=True)
    subprocess.run([sys.executable, "-m", "wheel", "pack", "--dest-dir", output, top], check=True,
                   stdout=subprocess.DEVNULL)

# SPDX-License-Identifier: Apache-2.0
"""Builds a wheel of the Python package that includes the library: see docs/python.md."""
import pathlib
import re

from skbuild import setup

HERE = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r'XGM_VERSION "(.*)"', (
    HERE / "framework/core/include/xgm/plugin/version.hpp").read_text())[1]


def without_sdk(files):
    """Leaves out what only C++ programs need, and all names of a library but the one it is loaded by:
    a wheel holds no links."""
    unneeded = re.compile(r"/(include|cmake|doc)/|/libxgm\w*\.so(\.\d+\.\d+\.\d+)?$")
    return [file for file in files if not unneeded.search(file)]


setup(
    name="xgm",
    version=VERSION,
    description="Dense disparity maps of rectified image pairs",
    license="Apache-2.0",
    packages=["xgm"],
    package_dir={"": "apps/python"},
    package_data={"xgm": ["py.typed", "*.pyi"]},
    python_requires=">=3.10",
    install_requires=["numpy<2"],
    extras_require={"bar": ["tqdm"]},
    cmake_source_dir=".",
    cmake_install_dir="apps/python/xgm",
    cmake_install_target="install_python_package",
    cmake_process_manifest_hook=without_sdk,
    cmake_args=[
        "-DCMAKE_BUILD_TYPE=Release",
        "-DXGM_BUILD_PYTHON=ON",
        "-DXGM_BUILD_TESTS=OFF",
        f"-DCMAKE_PREFIX_PATH={HERE / 'build/opencv'}",
    ],
)

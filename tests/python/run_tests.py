# SPDX-License-Identifier: Apache-2.0
"""Runs a test file of the Python package, or says why it is skipped (exit code 77).
Usage: run_tests.py FOLDER_OF_PACKAGE FILE"""
import pathlib
import sys

folder, file = sys.argv[1:]
if not folder:
    print("SKIPPED: the Python package is not built (XGM_BUILD_PYTHON)")
    sys.exit(77)
try:
    import pytest
except ImportError as missing:
    print(f"SKIPPED: the tests of the Python package need python3-pytest ({missing})")
    sys.exit(77)
sys.path.insert(0, folder)
sys.dont_write_bytecode = True
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "--rootdir", str(pathlib.Path(file).parent),
                      file]))

# SPDX-License-Identifier: Apache-2.0
"""The Python of docs/python.md and the README, and the notebook, run from top to bottom."""
import json
import pathlib
import re

import pytest

SOURCES = pathlib.Path(__file__).resolve().parents[2]


def blocks(page):
    text = (SOURCES / page).read_text()
    if page.endswith(".ipynb"):
        sources = ["".join(cell["source"]) for cell in json.loads(text)["cells"]
                   if cell["cell_type"] == "code"]
        return [compile(source, f"{page}, cell {i}", "exec") for i, source in enumerate(sources)]
    found = re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S)
    return [compile("\n" * (text[:block.start()].count("\n") + 1) + block[1], page, "exec")
            for block in found]


@pytest.mark.parametrize("page", ["docs/python.md", "README.md", "docs/python.ipynb"])
def test_every_block_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    assert blocks(page)
    for block in blocks(page):
        exec(block, names)

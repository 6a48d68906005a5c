# SPDX-License-Identifier: Apache-2.0
"""Opens the page of `pipeline run --report` in headless Chromium, without network.

check_report.py PIPELINE_PROGRAM PIPELINES_FOLDER; exit code 77 without Chromium.
"""
import array
import base64
import html
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BROWSERS = ["chromium", "chromium-browser", "google-chrome"]
# Whatever the page asked for would go to a port where nobody listens, and be complained of.
NO_NETWORK = ["--proxy-server=127.0.0.1:9", "--host-resolver-rules=MAP * ~NOTFOUND"]
# A name that would break a page that is not careful.
NAME = "a<b>&'\"<script>alert(1)"


def read_pfm(file):
    """(width, height, rows from the top); not finite where there is no disparity."""
    with open(file, "rb") as stream:
        assert stream.readline() == b"Pf\n"
        width, height = map(int, stream.readline().split())
        assert float(stream.readline()) < 0  # little-endian
        values = array.array("f", stream.read())
    if sys.byteorder == "big":
        values.byteswap()
    rows = [values[y * width:(y + 1) * width] for y in range(height)]
    return width, height, rows[::-1]


class Browser:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def open(self, page, silent=True):
        """What the page is as HTML once its program has run. `silent`: fails on any message."""
        command = [self.program, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom",
                   "--enable-logging=stderr", "--virtual-time-budget=30000", *NO_NETWORK,
                   f"--user-data-dir={self.folder}/profile", page]
        done = subprocess.run(command, capture_output=True, text=True, timeout=180, check=True)
        messages = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
        assert not (messages and silent), "the browser's console says: " + "\n".join(messages)
        return done.stdout


def write_report(program, pipelines, folder):
    pipeline = folder / (NAME + ".yaml")
    shutil.copy(pathlib.Path(pipelines) / "tmgm8.yaml", pipeline)
    subprocess.run([program, "run", str(pipeline), "--report", "--output", str(folder / "out"),
                    "--log-level", "error"], check=True, stdout=subprocess.DEVNULL)
    return folder / "out"


def check_values(browser, page, output):
    """The value shown at a pixel is that of disparity.pfm."""
    width, height, rows = read_pfm(output / "disparity.pfm")
    pixels = [(x, y) for y in range(height) for x in range(width)]
    missing = next(p for p in pixels if not math.isfinite(rows[p[1]][p[0]]))
    for x, y in [(width // 2, height // 3), (width - 1, height - 1), missing]:
        dom = browser.open(f"{page}#x={x}&y={y}")
        assert 'class="ready"' in dom, "the viewer did not start"
        assert f"Pixel x = {x}, y = {y}" in dom
        shown = re.search(r'id="value-0">([^<]*)<', dom).group(1)
        wanted = rows[y][x]
        assert (shown == "–") == (not math.isfinite(wanted)), (x, y, shown, wanted)
        if shown != "–":
            assert abs(float(shown) - wanted) <= 0.001, (x, y, shown, wanted)
    return dom


def check_viewer(dom):
    """Layers of all kinds can be chosen; the name is text wherever it stands."""
    for layer in ["left", "truth", "0.disparity", "0.status", "0.error", "0.bad", "0.s8.disparity",
                  "0.s4.first", "0.s2.last", "0.s1.count"]:
        assert f'<option value="{layer}">' in dom, layer
    assert "<script>alert(1)" not in dom
    assert html.escape(NAME, quote=False) in dom or "a&lt;b&gt;&amp;" in dom


def check_layers(browser, page):
    """Every layer of the page can be drawn."""
    for left, right in [("truth", "0.status"), ("0.error", "0.bad"), ("0.s8.count", "0.s4.first"),
                        ("0.s2.last", "0.s1.status")]:
        dom = browser.open(f"{page}#a={left}&b={right}&split=30")
        assert 'class="ready"' in dom, (left, right)
        legends = re.findall(r'<div id="legend-[ab]">(<b>.*?</div>)', dom)
        assert len(legends) == 2 and all("legend" in text for text in legends), (left, right)


def check_without_script(browser, output):
    """Pictures, legends and tables are there; what needs a program is not."""
    allowed = "script-src 'unsafe-inline'"
    text = (output / "report.html").read_text(encoding="utf-8")
    assert allowed in text
    forbidden = output / "without_script.html"
    forbidden.write_text(text.replace(allowed, "script-src 'none'", 1), encoding="utf-8")
    dom = browser.open(forbidden.as_uri(), silent=False)  # the browser tells what it blocked
    assert 'class="ready"' not in dom
    assert re.search(r'<section id="viewer"[^>]* hidden', dom)
    images = re.findall(r'<img[^>]* alt="([^"]+)" src="data:image/(png|jpeg);base64,([^"]+)"', dom)
    titles = [title for title, _, _ in images]
    for title in ["Left image", "True disparity", "Disparity", "Status", "Error",
                  "Off by more than 1 px, non-occluded", "Disparity, 1/8",
                  "Disparities searched, full size"]:
        assert title in titles, (title, titles)
    heads = {"png": b"\x89PNG\r\n\x1a\n", "jpeg": b"\xff\xd8\xff"}
    for title, kind, data in images:
        assert base64.b64decode(data, validate=True).startswith(heads[kind]), title
    for text in ["Time and memory", "Pipeline with every parameter", "Compared with the truth"]:
        assert text in dom, text


def main():
    program, pipelines = sys.argv[1:3]
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print("SKIPPED: none of", ", ".join(BROWSERS), "is installed; the page was not opened")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        output = write_report(program, pipelines, folder)
        page = (output / "report.html").as_uri()
        assert not list(output.glob(".*")), "a temporary file is left"
        chromium = Browser(browser, folder)
        check_viewer(check_values(chromium, page, output))
        check_layers(chromium, page)
        check_without_script(chromium, output)
        print("opened", os.path.getsize(output / "report.html"), "bytes in", browser)
    return 0


if __name__ == "__main__":
    sys.exit(main())

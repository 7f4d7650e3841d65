#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The HTML reports of `stad tune`, `eval` and `simulate`: one file, no network, and in a browser they render and their sliders move.

The browser half needs Chromium and Playwright (Debian: chromium; Python: playwright) and says so when it is left out."""
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from base64 import b64decode
from pathlib import Path

STAD = Path(os.environ["STAD_BUILD"]) / "stad"
RANGE = ["--min-disparity", "0", "--num-disparities", "32"]


def stad(*args):
    subprocess.run([STAD, *map(str, args)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def make_reports(work):
    stad("scene", "-o", work / "a", "--width", 200, "--height", 120, "--num-disparities", 32, "--seed", 7)
    left, right, truth = (work / "a" / name for name in ("left.png", "right.png", "disp.pfm"))
    odd = work / "it's <odd> & so.html"
    stad("tune", left, right, "--truth", truth, *RANGE, "--start", "default", "--max-evals", 20, "--free", "p1,p2",
         "--focal", 500, "--baseline", 0.1, "--report", odd)
    stad("match", left, right, "-o", work / "d.npy", *RANGE)
    stad("eval", work / "d.npy", truth, *RANGE, "--report", work / "eval.html")
    for i in range(3):
        shutil.copy(left, work / f"{i}_left.png")
        shutil.copy(right, work / f"{i}_right.png")
    (work / "1_left.png").write_bytes(b"no picture")
    stad("simulate", work, *RANGE, "--keep-going", "--report", work / "simulate.html")
    return odd, work / "eval.html", work / "simulate.html"


def png_size(data):
    """Width and height of a PNG whose pixels inflate to what they should."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "an embedded picture is no PNG"
    width, height, depth, colour = struct.unpack(">IIBB", data[16:26])
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        packed += data[at + 8 : at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    samples = 3 if colour == 2 else 1
    assert len(zlib.decompress(packed)) == height * (1 + width * samples * depth // 8), "a picture is cut short"
    return width, height


def check_text(path, pictures):
    text = path.read_text()
    assert "://" not in text, "the report refers to the network"
    assert not re.search(r'(?:src|href)="(?!data:)', text), "the report needs another file"
    found = re.findall(r'src="data:image/png;base64,([^"]+)"', text)
    assert len(found) == pictures, f"{len(found)} pictures, expected {pictures}"
    for picture in found:
        assert png_size(b64decode(picture)) == (200, 120)
    return text


def check_tune(path):
    text = check_text(path, 6)
    assert "it'\\''s &lt;odd&gt; &amp; so.html'" in text, "the command is not quoted and escaped"
    assert "--free p1,p2" in text, "the command lost a part"
    assert re.search(r"<td>p1</td><td>2</td><td>\d+</td><td>free</td>", text), "no table of parameters"
    assert "<td>block_size</td><td>3</td><td>3</td><td>kept</td>" in text
    assert text.count("<circle") == 20, "the plot has not 20 evaluations"
    assert "3.12 m" in text, "500 px * 0.1 m at 16 px is 3.12 m"


def check_in_browser(path, browser, sliders):
    page = browser.new_page()
    trouble = []
    page.on("console", lambda m: trouble.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda e: trouble.append(str(e)))
    page.on("request", lambda r: None if r.url.startswith(("file:", "data:")) else trouble.append(r.url))
    page.goto(path.as_uri())
    assert page.evaluate("[...document.images].every(i => i.complete && i.naturalWidth == 200)"), "a picture does not render"
    pairs = page.locator(".pair")
    assert pairs.count() == sliders, f"{pairs.count()} sliders"
    for i in range(sliders):
        box = pairs.nth(i).bounding_box()
        clips = []
        for part in (0.25, 0.75):
            pairs.nth(i).scroll_into_view_if_needed()
            pairs.nth(i).locator("input").click(position={"x": box["width"] * part, "y": box["height"] / 2})
            clips.append(pairs.nth(i).locator("img").nth(1).evaluate("i => getComputedStyle(i).clipPath"))
        left = [float(re.search(r"([\d.]+)%\)", c).group(1)) for c in clips]
        assert 15 < left[0] < 35 and 65 < left[1] < 85, f"slider {i} does not move: {clips}"
    assert not trouble, trouble
    page.close()


def main():
    if not STAD.exists():
        print(f"SKIPPED: {STAD} is not built")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        tune, evaluation, simulation = make_reports(Path(folder))
        check_tune(tune)
        check_text(evaluation, 3)
        assert check_text(simulation, 2).count('class="skipped"') == 1, "the skipped frame is not in the plot"
        chromium = shutil.which("chromium") or shutil.which("chromium-browser")
        try:
            from playwright.sync_api import sync_playwright
        except ImportError:
            chromium = None
        if not chromium:
            print("the text is as it should be; SKIPPED the browser: chromium or playwright is missing")
            return 0
        with sync_playwright() as p:
            browser = p.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
            check_in_browser(tune, browser, 3)
            check_in_browser(evaluation, browser, 1)
            check_in_browser(simulation, browser, 1)
            browser.close()
    print("text and browser as they should be")
    return 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: MIT
"""Figures 1 and 2 and the tables of table1.py as one HTML page without any outside file."""
import base64
import html as escape
import math

import cv2
import numpy as np

from scenes import DEFAULT, NONE, Scene, sample, split

COLOURS = {"ncg": "#c00", "ncg-bare": "#e80", "hybrid": "#a60", "ncg-paper": "#808", "sd": "#b8b", "grid": "#06c", "bobyqa": "#0a8", "nelder-mead": "#083",
           "cma-es": "#000", "tpe": "#777", "pso": "#5bd", "ga": "#9c3", "random": "#bbb"}
W, H, LEFT, TOP = 640, 360, 50, 10


def gap_curves(results, kind, places, budget):
    """method -> matrix scenes x evaluations of the best gap so far, percent."""
    best = {p: min(min(r["costs"]) for k, r in results.items() if k.startswith(f"{kind}|{p}|")) for p in places}
    curves = {}
    for m in COLOURS:
        if not all(f"{kind}|{p}|{m}" in results for p in places):
            continue
        rows = []
        for p in places:
            low = np.minimum.accumulate(results[f"{kind}|{p}|{m}"]["costs"]).astype(float)
            low = np.concatenate([low, np.full(max(0, budget - len(low)), low[-1])])[:budget]
            rows.append(100 * (low / best[p] - 1))
        curves[m] = np.array(rows)
    return curves


def figure1(results, kind, places, budget, title):
    """Median gap over the scenes against evaluations, the quartiles as a band; the vertical scale is logarithmic."""
    x = lambda n: LEFT + (W - LEFT - 130) * n / budget
    y = lambda g: TOP + (H - TOP - 40) * (math.log10(200) - math.log10(min(max(g, 0.1), 200))) / (math.log10(200) + 1)
    out = [f'<svg width="{W}" height="{H}" font-size="11" font-family="sans-serif"><text x="{LEFT}" y="{H - 5}">evaluations ({escape.escape(title)})</text>']
    for g in (0.1, 0.3, 1, 2, 5, 10, 30, 100):
        out.append(f'<line x1="{LEFT}" x2="{x(budget)}" y1="{y(g)}" y2="{y(g)}" stroke="#ddd"/><text x="5" y="{y(g) + 4}">{g:g} %</text>')
    for n in range(0, budget + 1, 25):
        out.append(f'<text x="{x(n) - 6}" y="{H - 22}">{n}</text>')
    for i, (m, rows) in enumerate(gap_curves(results, kind, places, budget).items()):
        low, mid, high = np.percentile(rows, (25, 50, 75), axis=0)
        path = lambda v: " ".join(f"{x(n + 1):.1f},{y(g):.1f}" for n, g in enumerate(v))
        back = " ".join(f"{x(n + 1):.1f},{y(g):.1f}" for n, g in reversed(list(enumerate(low))))
        if m in ("ncg", "grid"):
            out.append(f'<polygon points="{path(high)} {back}" fill="{COLOURS[m]}" opacity="0.12"/>')
        out.append(f'<polyline points="{path(mid)}" fill="none" stroke="{COLOURS[m]}" stroke-width="{2 if m == "ncg" else 1}"/>')
        out.append(f'<text x="{W - 120}" y="{TOP + 14 * (i + 1)}" fill="{COLOURS[m]}">{m}</text>')
    return "".join(out) + "</svg>"


def picture(bgr):
    return '<img width="300" src="data:image/png;base64,' + base64.b64encode(cv2.imencode(".png", bgr)[1].tobytes()).decode() + '">'


def coloured(px, known, top):
    grey = np.clip(np.where(known, px, 0) * 255 / top, 0, 255).astype(np.uint8)
    bgr = cv2.applyColorMap(grey, cv2.COLORMAP_TURBO)
    bgr[~known] = 0
    return bgr


def errors(scene, px, known):
    """Green right, red wrong, black missing, grey occluded, white not scored."""
    truth = scene.truth / 65536.0
    wrong = np.abs(px - truth) > scene.threshold_q16 / 65536.0
    bgr = np.full(px.shape + (3,), 255, np.uint8)
    seen = scene.label == 1
    bgr[scene.label == 2] = (160, 160, 160)
    bgr[seen & ~wrong] = (120, 200, 120)
    bgr[seen & wrong] = (40, 40, 220)
    bgr[seen & ~known] = 0
    return bgr


def figure2(results, kind, places):
    """Left image and truth, then disparity over error map: default, sample, tuned."""
    out = []
    for place in places:
        s = Scene(place)
        tuned = tuple(results[f"{kind}|{place}|ncg"]["best"])
        cells = [picture(cv2.cvtColor(s.left, cv2.COLOR_GRAY2BGR)) + "<br>" + picture(coloured(s.truth / 65536.0, s.truth != NONE, s.disparities))]
        for x in (DEFAULT, sample(), tuned):
            d = s.disparity(x)
            px, known = d / 16.0, d >= 0
            cells.append(picture(coloured(px, known, s.disparities)) + "<br>" + picture(errors(s, px, known)) + f"<br>{s.cost(x, kind) * 100 / 2**20:.2f} % at {x}")
        out.append(f"<h3>{escape.escape(place)}</h3><table><tr>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr></table>")
    return "".join(out)


def table_html(markdown):
    out = []
    for line in markdown.split("\n"):
        if line.startswith("|---"):
            continue
        if line.startswith("|"):
            out.append("<tr>" + "".join(f"<td>{escape.escape(c.strip())}</td>" for c in line.strip("|").split("|")) + "</tr>")
        elif line:
            out.append(f"</table><h3>{escape.escape(line.strip('*'))}</h3><table border=1 cellpadding=3 style='border-collapse:collapse'>")
    return "<table>" + "".join(out) + "</table>"


def html(path, results, args, parts):
    body = ["<h1>The tuner and its rivals</h1>", *map(table_html, parts), "<h2>Figure 1: cost against evaluations</h2>",
            "<p>Median over the scenes of the gap to the best of all methods; band: quartiles (ncg and grid).</p>"]
    for kind in args.cost:
        for family in args.family:
            for half in args.half:
                body.append(figure1(results, kind, split(half, family), args.budget, f"{kind}, {family}, {half} half"))
    body.append("<h2>Figure 2: before and after</h2><p>Left image over truth, then disparity over error map with default, sample and tuned parameters. "
                "Green right, red wrong, black missing, grey occluded, white not scored.</p>")
    for family in args.family:
        places = [p for p in split("report", family)[:3] if f"{args.cost[0]}|{p}|ncg" in results]
        body.append(figure2(results, args.cost[0], places))
    with open(path, "w") as f:
        f.write("<!doctype html><meta charset=utf-8><title>tuner study</title>" + "".join(body))

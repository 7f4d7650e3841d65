# SPDX-License-Identifier: MIT
"""Figures 1 and 2 of the tuner's study, as files of their own and, with the tables, as one HTML page without outside files."""
import base64
import html as escape
import math
import os

import cv2
import numpy as np

from scenes import DEFAULT, NONE, Scene, sample, split

COLOURS = {"ncg": "#c00", "ncg-bare": "#e80", "hybrid": "#a60", "ncg-paper": "#808", "sd": "#d7a", "grid": "#06c", "bobyqa": "#0a8", "nelder-mead": "#083",
           "cma-es": "#000", "tpe": "#777", "pso": "#5bd", "ga": "#9c3", "random": "#bbb"}
BANDS = ("ncg", "grid", "cma-es")  # methods whose spread is drawn
W, H, LEFT, RIGHT, TOP, BOTTOM = 820, 440, 64, 120, 34, 48
LOWEST, HIGHEST = 0.1, 300.0  # percent, ends of the vertical axis


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


def axis_x(n, budget):
    return LEFT + (W - LEFT - RIGHT) * n / budget


def axis_y(gap):
    part = math.log(min(max(gap, LOWEST), HIGHEST) / LOWEST) / math.log(HIGHEST / LOWEST)
    return H - BOTTOM - (H - TOP - BOTTOM) * part


def frame(title, budget):
    out = [f'<text x="{LEFT}" y="20" font-size="14" font-weight="bold">{escape.escape(title)}</text>']
    for g in (0.1, 0.3, 1, 2, 5, 10, 30, 100, 300):
        out.append(f'<line x1="{LEFT}" x2="{W - RIGHT}" y1="{axis_y(g):.1f}" y2="{axis_y(g):.1f}" stroke="{"#999" if g == 2 else "#e4e4e4"}"/>'
                   f'<text x="{LEFT - 6}" y="{axis_y(g) + 4:.1f}" text-anchor="end">{"&#8804; " if g == LOWEST else ""}{g:g}</text>')
    for n in range(0, budget + 1, 25):
        out.append(f'<line x1="{axis_x(n, budget):.1f}" x2="{axis_x(n, budget):.1f}" y1="{H - BOTTOM}" y2="{H - BOTTOM + 5}" stroke="#999"/>'
                   f'<text x="{axis_x(n, budget):.1f}" y="{H - BOTTOM + 18}" text-anchor="middle">{n}</text>')
    middle = (TOP + H - BOTTOM) / 2
    out.append(f'<text x="{(LEFT + W - RIGHT) / 2}" y="{H - 10}" text-anchor="middle">distinct evaluations</text>'
               f'<text transform="translate(14 {middle}) rotate(-90)" text-anchor="middle">cost above the best known, %</text>')
    return out


def figure1(results, kind, places, budget, title):
    """SVG: median over the scenes of the cost above the best known, the quartiles as a band; the vertical axis is logarithmic."""
    curves = gap_curves(results, kind, places, budget)
    path = lambda v: " ".join(f"{axis_x(n + 1, budget):.1f},{axis_y(g):.1f}" for n, g in enumerate(v))
    back = lambda v: " ".join(f"{axis_x(n + 1, budget):.1f},{axis_y(g):.1f}" for n, g in reversed(list(enumerate(v))))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{W}" height="{H}" viewBox="0 0 {W} {H}" font-size="11" font-family="sans-serif">'
           f'<rect width="{W}" height="{H}" fill="#fff"/>'] + frame(title, budget)
    for m in BANDS:
        if m in curves:
            low, high = np.percentile(curves[m], (25, 75), axis=0)
            out.append(f'<polygon points="{path(high)} {back(low)}" fill="{COLOURS[m]}" opacity="0.12"/>')
    order = sorted(curves, key=lambda m: -np.median(curves[m], axis=0)[-1])
    for m in order:
        out.append(f'<polyline points="{path(np.median(curves[m], axis=0))}" fill="none" stroke="{COLOURS[m]}" stroke-width="{2.5 if m == "ncg" else 1.3}"/>')
    for i, m in enumerate(order):
        y = TOP + 12 + 18 * i
        out.append(f'<line x1="{W - RIGHT + 10}" x2="{W - RIGHT + 30}" y1="{y - 4}" y2="{y - 4}" stroke="{COLOURS[m]}" stroke-width="3"/>'
                   f'<text x="{W - RIGHT + 36}" y="{y}">{m}</text>')
    return "".join(out) + "</svg>\n"


def coloured(px, known, top):
    level = np.clip(np.where(known, px, 0) * 255 / top, 0, 255).astype(np.uint8)
    bgr = cv2.applyColorMap(level, cv2.COLORMAP_TURBO)
    bgr[~known] = 0
    return bgr


def errors(scene, px, known):
    """Green right, red wrong, black missing, grey occluded, white not scored."""
    wrong = np.abs(px - scene.truth / 65536.0) > scene.threshold
    bgr = np.full(px.shape + (3,), 255, np.uint8)
    seen = scene.label == 1
    bgr[scene.label == 2] = (160, 160, 160)
    bgr[seen & ~wrong] = (150, 210, 150)
    bgr[seen & wrong] = (40, 40, 220)
    bgr[seen & ~known] = 0
    bgr[:, :scene.disparities] = 255
    return bgr


def thickened(picture, known):
    """Sparse points grown over their neighbours that hold nothing, so that they survive being shrunk."""
    out, held = picture.copy(), known.copy()
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            take = np.roll(known, (dy, dx), (0, 1)) & ~held
            out[take] = np.roll(picture, (dy, dx), (0, 1))[take]
            held |= take
    return out


def cell(picture, caption, width):
    """A picture shrunk to `width` with a line under it."""
    height = round(picture.shape[0] * width / picture.shape[1])
    small = cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA)
    strip = np.full((20, width, 3), 255, np.uint8)
    cv2.putText(strip, caption, (3, 14), cv2.FONT_HERSHEY_SIMPLEX, 0.38, (0, 0, 0), 1, cv2.LINE_AA)
    return np.pad(np.vstack([small, strip]), ((0, 4), (3, 3), (0, 0)), constant_values=255)


def figure2(scene, kind, tuned):
    """A picture: left frame over truth; then for default, sample and tuned the disparity over its error map."""
    truth, width = scene.truth / 65536.0, 420 if scene.truth.shape[1] > 1000 else 300
    grown = lambda picture, known: thickened(picture, known) if (scene.truth != NONE).mean() < 0.5 else picture
    top = np.percentile(truth[scene.truth != NONE], 99.5) * 1.05
    columns = [[cell(cv2.cvtColor(scene.left, cv2.COLOR_GRAY2BGR), f"left frame, {scene.path}", width),
                cell(grown(coloured(truth, scene.truth != NONE, top), scene.truth != NONE), "truth", width)]]
    for name, x in (("default", DEFAULT), ("sample", sample()), ("tuned", tuned)):
        d = scene.disparity(x)
        px, known = d / 16.0, d >= 0
        columns.append([cell(coloured(px, known, top), f"{name} " + ",".join(map(str, x)), width),
                        cell(grown(errors(scene, px, known), scene.label > 0), f"{name}: {kind} {scene.cost(x, kind) * 100 / 2**20:.2f} %", width)])
    return np.hstack([np.vstack(c) for c in columns])


def png(picture):
    return cv2.imencode(".png", picture, [cv2.IMWRITE_PNG_COMPRESSION, 9])[1].tobytes()


def table_html(markdown):
    out = []
    for line in markdown.split("\n"):
        if line.startswith("|---"):
            continue
        if line.startswith("|"):
            out.append("<tr>" + "".join(f"<td>{escape.escape(c.strip())}</td>" for c in line.strip("|").split("|")) + "</tr>")
        elif line:
            out.append(f"<h3>{escape.escape(line.replace('*', ''))}</h3><table>")
    return "".join(out) + "</table>"


def figures(results, args):
    """name -> bytes: an SVG for each cost and family over its report scenes, a PNG for each of three report scenes a family."""
    out = {}
    for kind in args.cost:
        for family in args.family:
            places = split("report", family)
            out[f"figure1-{kind}-{family}.svg"] = figure1(results, kind, places, args.budget,
                                                          f"tuned on {kind}: {len(places)} {family} report scenes, median and quartiles").encode()
    kind = args.cost[0]
    for place in [p for family in args.family for p in split("report", family)[1:4]]:
        if f"{kind}|{place}|ncg" in results:
            name = place.replace("/", "-")
            out[f"figure2-{name}.png"] = png(figure2(Scene(place), kind, tuple(results[f"{kind}|{place}|ncg"]["best"])))
    return out


STYLE = ("body{font-family:sans-serif;max-width:1300px;margin:24px auto;padding:0 12px}table{border-collapse:collapse;font-size:13px}"
         "td{border:1px solid #ccc;padding:3px 7px;text-align:right}td:first-child{text-align:left}tr:first-child{font-weight:bold}"
         "img{max-width:100%;display:block;margin:10px 0}")


def page(made, parts):
    body = ["<h1>The tuner and its rivals</h1>", *map(table_html, parts), "<h2>Figure 1: cost against evaluations</h2>",
            f"<p>Median over the scenes of the cost above the best of all methods; bands: quartiles ({', '.join(BANDS)}).</p>"]
    body += [data.decode() for name, data in made.items() if name.startswith("figure1")]
    body.append("<h2>Figure 2: before and after</h2><p>Left frame over truth, then disparity over error map with default, sample and tuned parameters "
                "(P1, P2, block, uniqueness, cap, disp12). Green right, red wrong, black missing, grey occluded, white not scored.</p>")
    for name, data in made.items():
        if name.startswith("figure2"):
            body.append(f'<img alt="{escape.escape(name)}" src="data:image/png;base64,{base64.b64encode(data).decode()}">')
    return f"<!doctype html><html lang=en><meta charset=utf-8><title>The tuner and its rivals</title><style>{STYLE}</style>" + "".join(body) + "</html>\n"


def write(results, args, parts):
    made = figures(results, args)
    if args.html:
        with open(args.html, "w") as f:
            f.write(page(made, parts))
    if args.figures:
        os.makedirs(args.figures, exist_ok=True)
        for name, data in made.items():
            with open(os.path.join(args.figures, name), "wb") as f:
                f.write(data)

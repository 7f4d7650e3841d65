# SPDX-License-Identifier: MIT
"""Costs and measures from exact counts, so that counts alone are kept."""
COUNTS = ("visible", "occluded", "wrong_visible", "wrong_occluded", "missing_visible", "missing_occluded", "d1_visible", "d1_occluded",
          "square_sum_q16", "abs_sum_q16")


def cost_q20(n, kind):
    """The library's cost from exact counts (test_score_numpy.py holds both equal)."""
    if kind == "bad":
        part, whole = n["wrong_visible"] + n["missing_visible"], n["visible"]
    elif kind == "chow":
        part, whole = 2 * (n["wrong_visible"] + n["wrong_occluded"]) + n["missing_visible"], 2 * (n["visible"] + n["occluded"])
    elif kind == "d1":
        part, whole = n["d1_visible"] + n["missing_visible"], n["visible"]
    else:
        raise ValueError(kind)
    return (part * 2**20 + whole // 2) // whole


def measures(n):
    """bad, chow, density as percent; RMSE in px."""
    matched = n["visible"] - n["missing_visible"]
    return {"bad": 100 * (n["wrong_visible"] + n["missing_visible"]) / n["visible"],
            "chow": 50 * (2 * (n["wrong_visible"] + n["wrong_occluded"]) + n["missing_visible"]) / (n["visible"] + n["occluded"]),
            "rmse": (n["square_sum_q16"] / 65536 / max(matched, 1)) ** 0.5, "density": 100 * matched / n["visible"]}

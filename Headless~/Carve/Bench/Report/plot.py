"""Draws the benchmark's plots from its tables.

    plot.py FOLDER

FOLDER holds benchmarks-pareto.csv and benchmarks-scaling.csv, as `carve bench all --report` writes them; the plots go there too, as SVG.
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "AnatomyCarve"  # the same tables give the same file
from matplotlib import pyplot  # noqa: E402


def read(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def save(figure, folder, name):
    figure.tight_layout()
    figure.savefig(os.path.join(folder, name), metadata={"Date": None, "Creator": "carve bench all --report"})
    pyplot.close(figure)


def front(points):
    """The points that no other one beats in both time and error, by time."""
    best = float("inf")
    kept = []
    for point in sorted(points, key=lambda p: (float(p["ms"]), float(p["error codes"]))):
        if float(point["error codes"]) < best:
            best = float(point["error codes"])
            kept.append(point)
    return kept


def draw_pareto(folder):
    points = read(folder, "benchmarks-pareto.csv")
    figure, axes = pyplot.subplots(figsize=(8, 5))
    looks = {("Compact", "Exact"): ("o", "compact, exact filter"), ("Compact", "Hardware"): ("^", "compact, GPU's filter"), ("Portable", "Exact"): ("s", "portable, exact filter")}
    for skipping, color in (("True", "tab:blue"), ("False", "tab:orange")):
        for (layout, kind), (marker, label) in looks.items():
            chosen = [p for p in points if p["skipping"] == skipping and p["layout"] == layout and p["filter"] == kind]
            if chosen:
                axes.scatter([float(p["ms"]) for p in chosen], [float(p["error codes"]) for p in chosen], marker=marker, color=color, alpha=0.7,
                             label=label + (", skipping" if skipping == "True" else ", nothing skipped"))
    best = front([p for p in points if p["cut"] == "Binary"])
    axes.plot([float(p["ms"]) for p in best], [float(p["error codes"]) for p in best], color="black", linewidth=1, label="front (binary cuts)")
    for point in points:
        if point["preset"]:
            axes.annotate(point["preset"], (float(point["ms"]), float(point["error codes"])), textcoords="offset points", xytext=(6, 6), weight="bold")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("ray pass, ms (one CPU driver; only ratios mean something)")
    axes.set_ylabel("RMSE of colour, codes of 255")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7)
    save(figure, folder, "benchmarks-pareto.svg")


def draw_scaling(folder):
    points = read(folder, "benchmarks-scaling.csv")
    curves = list(dict.fromkeys(p["curve"] for p in points))
    figure, all_axes = pyplot.subplots(1, len(curves), figsize=(4 * len(curves), 3.6))
    for axes, curve in zip(all_axes, curves):
        for what in dict.fromkeys(p["what"] for p in points if p["curve"] == curve):
            chosen = [p for p in points if p["curve"] == curve and p["what"] == what]
            sizes = [float(p["size"]) for p in chosen]
            axes.plot(sizes, [float(p["ms"]) for p in chosen], marker="o", label=what)
            axes.fill_between(sizes, [float(p["least ms"]) for p in chosen], [float(p["most ms"]) for p in chosen], alpha=0.2)
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_xlabel(curve)
        axes.set_ylabel("ms")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=7)
    save(figure, folder, "benchmarks-scaling.svg")


draw_pareto(sys.argv[1])
draw_scaling(sys.argv[1])

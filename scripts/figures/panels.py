"""What the pictures of the experiments are made of."""

import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgba
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "samples" / "python"))
from figure_style import SETTINGS, style
from results import distinct, series

ROTATION, TRANSLATION, CENTRE = "rotation_deg", "translation_percent", "centre_m"
LABELS = {
    ROTATION: "mean rotation error [°]",
    TRANSLATION: "mean translation error [%]",
    CENTRE: "mean error of the camera centre [m]",
}
OURS = ["GMLPnP", "GMLPnP marginal", "GMLPnP*"]

plt.rcParams.update(SETTINGS)


def plain_log(axis, ticks=None):
    """Powers of ten are hard to read between 0.3 and 3: plain numbers instead."""
    if ticks is not None:
        axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def ticks_between(low, high):
    return [t for t in (m * 10.0**e for e in range(-5, 5) for m in (1, 2, 5)) if low <= t <= high]


def draw_line(ax, xs, ys, yerr, solver, **kwargs):
    """A line with intervals, those of the others fainter than ours."""
    look = style(solver)
    faint = to_rgba(look["color"], 1 if solver in OURS else 0.45)
    ax.errorbar(xs, ys, yerr=yerr, ecolor=faint, elinewidth=0.9, **look, **kwargs)


def draw_errors(ax, rows, y, solvers=None):
    for solver in solvers or distinct(rows, "solver"):
        xs, ys, yerr = series(rows, solver, "x", y)
        draw_line(ax, xs, ys, yerr, solver, label=solver)
    ax.set_yscale("log")
    ax.set_ylabel(LABELS[y])
    plain_log(ax.yaxis, ticks_between(*ax.get_ylim()))


def draw_ratios(ax, rows, y, limits):
    for solver in distinct(rows, "solver"):
        xs, ys, yerr = series(rows, solver, "x", y + "_ratio")
        draw_line(ax, xs, ys, yerr, solver, label=solver)
    ax.set_ylim(*limits)
    ax.set_ylabel(f"{LABELS[y].split(' [')[0]}\nas a ratio to {rows[0]['ratio_to']}")


def legend_right(fig, ax):
    handles, labels = ax.get_legend_handles_labels()
    fig.legend([h[0] if hasattr(h, "__len__") else h for h in handles], labels, loc="center right", frameon=False)


def errors_and_ratios(results, name, xlabel, limits, log_x=False, ticks=None):
    rows = results.rows(name)
    fig, axes = plt.subplots(2, 2, figsize=(9.6, 6.4), sharex=True)
    for column, metric in enumerate((ROTATION, TRANSLATION)):
        draw_errors(axes[0, column], rows, metric)
        draw_ratios(axes[1, column], rows, metric, limits)
        axes[1, column].set_xlabel(xlabel)
        if log_x:
            axes[1, column].set_xscale("log")
            plain_log(axes[1, column].xaxis, ticks)
    legend_right(fig, axes[0, 0])
    fig.tight_layout(rect=(0, 0, 0.85, 1))
    return fig


def ratio_bars(results, name, metrics, limits):
    """Ratios to the reference as points with intervals, a panel for each cell; outside the limits: an arrow."""
    rows = results.rows(name)
    cells = distinct(rows, "cell")
    solvers = distinct(rows, "solver")
    fig, axes = plt.subplots(1, len(cells), figsize=(2.55 * len(cells), 4.6), sharey=True, sharex=True)
    low, high = limits
    for ax, cell in zip(np.atleast_1d(axes), cells):
        for row in (r for r in rows if r["cell"] == cell):
            for k, (metric, filled) in enumerate(metrics):
                at = solvers.index(row["solver"]) + 0.17 * (2 * k - 1)
                y = row[metric + "_ratio"]
                look = style(row["solver"])
                if not low < y < high:
                    tip, tail = (high, high * 0.9) if y >= high else (low, low / 0.9)
                    ax.annotate("", (tip, at), (tail, at), arrowprops=dict(arrowstyle="->", color=look["color"]))
                    continue
                ax.errorbar(y, at, xerr=[[y - row[metric + "_ratio_low"]], [row[metric + "_ratio_high"] - y]],
                            color=look["color"], marker="o" if filled else "s",
                            markerfacecolor=look["color"] if filled else "white", markersize=4.5, elinewidth=1.2)
        ax.axvline(1, color="#444444", linewidth=0.8)
        ax.set_xscale("log")
        ax.set_xlim(low, high)
        plain_log(ax.xaxis, [0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5])
        ax.set_title(cell)
        ax.set_xlabel(f"ratio to {rows[0]['ratio_to']}")
    first = np.atleast_1d(axes)[0]
    first.set_yticks(range(len(solvers)))
    first.set_yticklabels(solvers)
    first.set_ylim(len(solvers) - 0.5, -0.5)
    fig.text(0.5, 0.005, "filled: rotation; hollow: camera centre; arrow: beyond the picture", ha="center", fontsize=8.5)
    fig.tight_layout(rect=(0, 0.03, 1, 1))
    return fig

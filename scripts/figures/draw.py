"""Draws the results of gmlpnp_experiments: draw.py RESULTS PICTURES"""

import pathlib
import re
import sys

import numpy as np

from panels import (CENTRE, LABELS, OURS, ROTATION, TRANSLATION, draw_errors, draw_ratios, errors_and_ratios,
                    legend_right, plain_log, plt, ratio_bars, ticks_between)
from figure_style import ellipse, style
from results import Results, distinct, series


def points(results):
    return errors_and_ratios(results, "points", "number of points", (0.6, 1.5))


def noise(results):
    return errors_and_ratios(results, "noise", "σ of the object noise [m]; ten times as many pixels", (0.5, 1.7),
                             True, [0.02, 0.05, 0.1, 0.2, 0.5])


def consistency(results):
    rows = results.rows("consistency")
    fig, axes = plt.subplots(1, 2, figsize=(9.6, 4.2))
    for ax, metric in zip(axes, (ROTATION, TRANSLATION)):
        draw_errors(ax, rows, metric)
        xs, ys, _ = series(rows, "GMLPnP*", "x", metric)
        law = [ys[0] * (xs[0] / x) ** 0.5 for x in xs]
        ax.plot(xs, law, color="#0072B2", linewidth=0.8, linestyle=":", label="1/√n")
        ax.set_xscale("log")
        plain_log(ax.xaxis, [20, 50, 100, 200, 500, 1000, 2000, 5000, 10000])
        ax.tick_params(axis="x", labelrotation=45)
        ax.set_xlabel("number of points")
    legend_right(fig, axes[0])
    fig.tight_layout(rect=(0, 0, 0.85, 1))
    return fig


def time(results):
    rows = results.rows("time")
    fig, ax = plt.subplots(figsize=(7.4, 4.4))
    for solver in distinct(rows, "solver"):
        xs, ys, _ = series(rows, solver, "x", "us_median")
        ax.plot(xs, ys, label=solver, **style(solver))
    ax.set_xscale("log")
    ax.set_yscale("log")
    plain_log(ax.xaxis, [20, 50, 100, 200, 500, 1000])
    ax.set_xlabel("number of points")
    ax.set_ylabel("median CPU time of a call [µs]")
    legend_right(fig, ax)
    fig.tight_layout(rect=(0, 0, 0.78, 1))
    return fig


def guess(results):
    rows = results.rows("guess")
    sigmas = distinct(rows, "sigma_m")
    fig, axes = plt.subplots(2, len(sigmas), figsize=(9.6, 5.4), sharex=True, sharey="row")
    for column, sigma in enumerate(sigmas):
        mine = [row for row in rows if row["sigma_m"] == sigma]
        for solver in distinct(mine, "solver"):
            xs, ys, yerr = series(mine, solver, "offset_deg", "success")
            axes[0, column].errorbar(xs, [100 * y for y in ys], yerr=[[100 * e for e in side] for side in yerr],
                                     label=solver, elinewidth=0.7, **style(solver))
            xs, ys, yerr = series(mine, solver, "offset_deg", ROTATION)
            axes[1, column].errorbar(xs, ys, yerr=yerr, elinewidth=0.7, **style(solver))
        axes[0, column].set_title(f"σ = {sigma:g} m, {10 * sigma:g} px")
        axes[0, column].set_ylim(0, 104)
        axes[1, column].set_yscale("log")
        axes[1, column].set_xticks([0, 30, 60, 90, 120, 150, 180])
        axes[1, column].set_xlabel("offset of the guess [°];\n1 m per 30°")
    axes[0, 0].set_ylabel("same pose as from the truth [%]")
    axes[1, 0].set_ylabel(LABELS[ROTATION])
    plain_log(axes[1, 0].yaxis, ticks_between(*axes[1, 0].get_ylim()))
    axes[0, 0].legend(frameon=False, loc="lower left")
    fig.tight_layout()
    return fig


def rounds(results):
    rows = results.rows("rounds")
    fig, axes = plt.subplots(2, 2, figsize=(9.6, 6.4), sharex=True)
    panels = [("determinant_median", "median of |Σ̂| [m⁶]"), ("frobenius", "mean of ‖Σ̂ − Σ‖ [m²] (Frobenius)"),
              ("smallest_deviation_median", "smallest deviation of Σ̂ [m], median"), (ROTATION, LABELS[ROTATION])]
    for ax, (y, label) in zip(axes.flat, panels):
        for estimator in distinct(rows, "estimator"):
            xs, ys, yerr = series(rows, estimator, "round", y, key="estimator")
            ax.errorbar(xs, ys, yerr=yerr, label=estimator, elinewidth=0.8, capsize=1.5, **style(estimator))
        ax.set_ylabel(label)
    axes[0, 0].axhline(rows[0]["true_determinant"], color="#0072B2", linestyle=":", label="true |Σ|, mean")
    axes[0, 0].set_yscale("log")
    axes[1, 0].set_yscale("log")
    for ax in axes[1]:
        ax.set_xlabel("round")
        ax.set_xticks(range(0, 13, 2))
    axes[0, 1].set_ylim(bottom=0)
    axes[0, 1].legend(*axes[0, 0].get_legend_handles_labels(), frameon=False, loc="lower left")
    fig.tight_layout()
    return fig


def covariance(results):
    rows = results.rows("covariance")
    fig, axes = plt.subplots(1, 2, figsize=(9.6, 3.8), sharey=True)
    for ax, sigma in zip(axes, distinct(rows, "sigma_m")):
        mine = [row for row in rows if row["sigma_m"] == sigma]
        for estimator in distinct(mine, "estimator"):
            xs, ys, yerr = series(mine, estimator, "x", "relative_frobenius", key="estimator")
            ax.errorbar(xs, ys, yerr=yerr, label=estimator, elinewidth=0.8, capsize=1.5, **style(estimator))
        ax.set_xscale("log")
        plain_log(ax.xaxis, [20, 50, 100, 200, 500, 1000, 2000])
        ax.set_title(f"σ = {sigma:g} m, {10 * sigma:g} px")
        ax.set_xlabel("number of points")
    axes[0].set_ylim(bottom=0)
    axes[0].set_ylabel("mean of ‖Σ̂ − Σ‖ / ‖Σ‖ (Frobenius)")
    axes[0].legend(frameon=False, loc="lower left")
    fig.tight_layout()
    return fig


def case(results):
    clouds, kinds = results.rows("case"), ["noise", "GMLPnP", "GMLPnP marginal"]
    titles = ["true noise", "residuals of GMLPnP", "residuals of GMLPnP marginal"]
    colours = {"noise": "#0072B2", "GMLPnP": style("GMLPnP")["color"],
               "GMLPnP marginal": style("GMLPnP marginal")["color"]}
    C = {row["kind"]: np.array([row[a + b] for a in "xyz" for b in "xyz"]).reshape(3, 3)
         for row in results.rows("case_covariances")}
    fig, axes = plt.subplots(2, 3, figsize=(9.6, 6.6), sharex=True, sharey=True)
    for row, pair in enumerate(((0, 1), (0, 2))):
        for ax, kind, title in zip(axes[row], kinds, titles):
            cloud = [p for p in clouds if p["kind"] == kind]
            ax.scatter([p["xyz"[pair[0]]] for p in cloud], [p["xyz"[pair[1]]] for p in cloud], s=7, linewidths=0,
                       color=colours[kind], alpha=0.55)
            ax.add_patch(ellipse(C["noise"][np.ix_(pair, pair)], edgecolor=colours["noise"], linewidth=1.6))
            if kind != "noise":
                ax.add_patch(ellipse(C[kind][np.ix_(pair, pair)], edgecolor=colours[kind], linewidth=1.8,
                                     linestyle="--"))
            ax.set_aspect("equal")
            if row == 0:
                ax.set_title(title)
        axes[row, 0].set_ylabel(f"{'xyz'[pair[1]]} [m]")
    for ax in axes[1]:
        ax.set_xlabel("x [m]")
    fig.text(0.5, 0.005, "solid: 95 % ellipse of the true Σ; dashed: of the estimate", ha="center", fontsize=8.5)
    fig.tight_layout(rect=(0, 0.02, 1, 1))
    return fig


def depth(results):
    return ratio_bars(results, "depth", ((ROTATION, True), (CENTRE, False)), (0.3, 3))


def pixels(results):
    return ratio_bars(results, "pixels", ((ROTATION, True), (CENTRE, False)), (0.25, 3))


def omnidir(results):
    rows = results.rows("omnidir")
    fig, axes = plt.subplots(1, 2, figsize=(9.6, 3.8), sharey=True)
    for ax, metric in zip(axes, (ROTATION, CENTRE)):
        draw_ratios(ax, rows, metric, (0.9, 1.35))
        ax.set_xscale("log")
        plain_log(ax.xaxis, [20, 50, 100, 200])
        ax.set_xlabel("number of points")
    legend_right(fig, axes[0])
    fig.tight_layout(rect=(0, 0, 0.83, 1))
    return fig


def outliers(results):
    rows = results.rows("outliers")
    fig, axes = plt.subplots(1, 2, figsize=(9.6, 4.2))
    for ax, cell in zip(axes, distinct(rows, "cell")):
        mine = [dict(row, x=100 * row["x"]) for row in rows if row["cell"] == cell]
        draw_errors(ax, mine, ROTATION)
        ax.set_title(cell)
        ax.set_xlabel("share of such points [%]")
    legend_right(fig, axes[0])
    fig.tight_layout(rect=(0, 0, 0.85, 1))
    return fig


def coverage(results):
    rows = results.rows("coverage")
    noises, fields = distinct(rows, "noise"), distinct(rows, "half_field_deg")
    fig, axes = plt.subplots(len(fields), len(noises), figsize=(9.6, 5.2), sharex=True, sharey=True)
    for line, field in enumerate(fields):
        for column, kind in enumerate(noises):
            ax = axes[line, column]
            mine = [r for r in rows if r["noise"] == kind and r["half_field_deg"] == field]
            for solver in OURS:
                xs, ys, yerr = series(mine, solver, "x", "coverage")
                ax.errorbar(xs, ys, yerr=yerr, label=solver, elinewidth=0.8, **style(solver))
            ax.axhspan(0.93, 0.97, color="#dfeedd", zorder=0)
            ax.set_xscale("log")
            plain_log(ax.xaxis, [8, 15, 20, 50, 100, 200])
            ax.set_title(f"noise of {'points' if kind == 'object' else kind}, ±{field:g}°")
        axes[line, 0].set_ylabel("truth in the 95 % ellipsoid")
    for ax in axes[-1]:
        ax.set_xlabel("number of points")
    axes[0, 0].set_ylim(0, 1.02)
    axes[0, 0].legend(frameon=False, loc="lower right")
    fig.tight_layout()
    return fig


def nees(results):
    """Histograms of the squared Mahalanobis distance of the truth, and chi square of six degrees of freedom."""
    rows = [row for row in results.rows("coverage_nees") if row["solver"] == "GMLPnP marginal" and row["x"] >= 15]
    cells, sizes = distinct([dict(row, cell=(row["noise"], row["half_field_deg"])) for row in rows], "cell"), distinct(
        rows, "x")
    fig, axes = plt.subplots(len(cells), len(sizes), figsize=(9.6, 8.4), sharex=True, sharey=True)
    for line, (kind, field) in enumerate(cells):
        for column, n in enumerate(sizes):
            ax = axes[line, column]
            mine = [r for r in rows if (r["noise"], r["half_field_deg"], r["x"]) == (kind, field, n)]
            ax.bar([r["from"] for r in mine], [r["share"] for r in mine], width=1, align="edge",
                   color=style("GMLPnP marginal")["color"], alpha=0.6)
            ax.step([r["from"] for r in mine] + [mine[-1]["to"]], [r["expected"] for r in mine] +
                    [mine[-1]["expected"]], where="post", color="#0072B2", linewidth=1)
            if line == 0:
                ax.set_title(f"n = {n:g}")
        axes[line, 0].set_ylabel(f"{'points' if kind == 'object' else kind}, ±{field:g}°")
    for ax in axes[-1]:
        ax.set_xlabel("squared distance")
    fig.text(0.5, 0.005, "bars: share of the problems, the last class has no end; line: χ² of six degrees of freedom",
             ha="center", fontsize=8.5)
    fig.tight_layout(rect=(0, 0.02, 1, 1))
    return fig


PICTURES = [points, noise, time, guess, rounds, case, covariance, consistency, depth, pixels, omnidir, outliers, coverage,
            nees]


FILES = {"nees": "coverage_nees"}  # of the pictures that are not named after theirs


def shorten(path):
    """Two decimals are a hundredth of a pixel; matplotlib writes six, and the pictures are part of the repository."""
    text = path.read_text()
    rounded = lambda match: re.sub(r"(\.\d\d)\d+", r"\1", match[0])
    path.write_text(re.sub(r'\b(d|x|y)="[^"]*"', rounded, text))


def main(folder, target):
    results, target = Results(folder), pathlib.Path(target)
    target.mkdir(parents=True, exist_ok=True)
    for picture in PICTURES:
        if not results.has(FILES.get(picture.__name__, picture.__name__)):
            print(f"{picture.__name__}: no results, not drawn")
            continue
        fig = picture(results)
        fig.savefig(target / f"{picture.__name__}.svg", metadata={"Date": None})
        shorten(target / f"{picture.__name__}.svg")
        fig.savefig(target / f"{picture.__name__}.png", dpi=110)
        plt.close(fig)
        print(f"{target}/{picture.__name__}.svg, .png")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])

# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""The pictures of draw.py, one function a kind of file."""

import math
import os

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import LightSource, LinearSegmentedColormap
from matplotlib.lines import Line2D

from figure_style import BLACK, BLUE, GREY, ORANGE, SETTINGS, ellipse, style
from sample_data import Grid, SampleData

plt.rcParams.update(SETTINGS)
plt.rcParams.update({"savefig.dpi": 110, "figure.titlesize": 12})

LIGHT_BLUE, LIGHT_ORANGE = "#94C3E2", "#F0B894"
SQUARED_RADIUS_95 = 5.991  # of a normal distribution in two dimensions
RADIUS_95 = 1.96  # in one
REACH = 1.6  # of a plot, in radii of its ellipse: outliers are seen too
MOST_POINTS = 20000  # in one plot; more only fill the paper


def draw(path):
    """The figure of a file. Raises OSError where it cannot be read and ValueError where it is not what it should be."""
    data = SampleData(path)
    kind = data.head["kind"]
    if kind not in KINDS:
        raise ValueError(f"{path}: of unknown kind '{kind}', not one of {', '.join(KINDS)}")
    plt.close("all")
    figure = KINDS[kind](data)
    figure.suptitle(data.head.get("title", ""), x=0.01, ha="left")
    return figure


def length_unit(unit, extent):
    """The unit in which such a length is legible, and how many of it make one of the file's."""
    if unit != "m" or extent >= 1:
        return unit or "units", 1.0
    return ("cm", 100.0) if extent >= 0.01 else ("mm", 1000.0)


def round_step(value):
    """The largest of 1, 2, 5 times a power of ten that is not above the value."""
    power = 10.0 ** math.floor(math.log10(value))
    return power * max(m for m in (1, 2, 5) if m * power <= value * (1 + 1e-9))


def say(ax, text):
    """In place of what there is nothing of to show."""
    ax.text(0.5, 0.5, text, transform=ax.transAxes, ha="center", va="center", color=GREY)


def line(colour, label, **kwargs):
    """An entry of a legend."""
    return Line2D([], [], **dict(dict(color=colour, label=label, linewidth=1.4), **kwargs))


def dots(colour, label, **kwargs):
    return line(colour, label, **dict(dict(linestyle="none", marker="o", markersize=4), **kwargs))


def square(ax, reach):
    ax.set_xlim(-reach, reach)
    ax.set_ylim(-reach, reach)
    ax.set_aspect("equal")


# --- Residuals of a pose: pose_from_correspondences, omnidir_pose ---


def image_limits(data, pixels):
    """The image, or where its size is not known the part of it that holds the pixels."""
    if "image_size" in data.head:
        width, height = data.head_numbers("image_size", 2)
        return -0.5, width - 0.5, -0.5, height - 0.5
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    margin = 0.05 * max(*(high - low), 1.0)
    return low[0] - margin, high[0] + margin, low[1] - margin, high[1] + margin


def draw_image_plane(ax, data, squared_radius, inside):
    """Residuals and their ellipses in the image, magnified alike until an ellipse of median size can be seen."""
    pixels, residuals = data.numbers("u", "v"), data.numbers("residual_u", "residual_v")
    covariances = data.numbers("cov_uu", "cov_uv", "cov_uv", "cov_vv").reshape(-1, 2, 2)
    left, right, top, bottom = image_limits(data, pixels)
    values, vectors = np.linalg.eigh(covariances)
    radii = np.sqrt(squared_radius * np.maximum(values, 0))
    median = np.median(np.sqrt(radii.prod(axis=1)))
    magnified = max(1.0, round_step(0.028 * max(right - left, bottom - top) / median)) if median > 0 else 1.0

    turn = np.linspace(0, 2 * np.pi, 49)
    circle = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    outlines = pixels[:, None] + magnified * circle @ (vectors * radii[:, None]).transpose(0, 2, 1)
    for group, tint, colour in ((inside, LIGHT_BLUE, BLUE), (~inside, LIGHT_ORANGE, ORANGE)):
        at, along = pixels[group], magnified * residuals[group]
        ax.add_collection(LineCollection(outlines[group], colors=tint, linewidths=0.8, zorder=2))
        ax.quiver(*at.T, *along.T, color=colour, angles="xy", scale_units="xy", scale=1, width=0.0016, headwidth=4,
                  headlength=5, headaxislength=4.5, zorder=3)
    ax.scatter(*pixels.T, s=4, color=BLACK, linewidths=0, zorder=4)
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    ax.set_aspect("equal")
    ax.set_xlabel("u [px]")
    ax.set_ylabel("v [px]")
    ax.set_title(f"Image: residuals and 95 % ellipses, {magnified:g} times as large" if magnified != 1
                 else "Image: residuals and 95 % ellipses")
    share = 100 * inside.mean()
    ax.legend(handles=[dots(BLACK, "observed pixel", markersize=3),
                       line(BLUE, f"residual inside its 95 % ellipse: {share:.1f} %"),
                       line(ORANGE, f"outside: {100 - share:.1f} % (5 % expected)")],
              loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=3, frameon=False)


def draw_object_space(ax, data, covariance, squared_radius, inside, names):
    """Object residuals in one plane of the camera frame, with the ellipse of their mean covariance."""
    pair = ["xyz".index(name) for name in names]
    C = covariance[np.ix_(pair, pair)]
    radius = math.sqrt(squared_radius * max(C[0, 0], C[1, 1]))
    unit, scale = length_unit(data.head.get("unit", ""), radius)
    ax.set_xlabel(f"{names[0]} [{unit}]")
    ax.set_ylabel(f"{names[1]} [{unit}]")
    if not radius > 0:
        say(ax, "no noise")
        return
    residuals = scale * data.numbers(*names)
    for group, colour in ((inside, BLUE), (~inside, ORANGE)):
        ax.scatter(*residuals[group].T, s=9, color=colour, alpha=0.7, linewidths=0)
    ax.add_patch(ellipse(scale**2 * C, squared_radius, edgecolor=BLACK, linewidth=1.2, zorder=3))
    square(ax, REACH * scale * radius)
    if names[1] == "y":
        ax.invert_yaxis()


def residuals_of_a_pose(data):
    """The residuals with the ellipses that should hold 95 % of them: in the image, and in object space."""
    figure = plt.figure(figsize=(13, 7.4))
    grid = figure.add_gridspec(2, 2, width_ratios=(2.4, 1), left=0.055, right=0.985, bottom=0.12, top=0.89, wspace=0.16,
                               hspace=0.34)
    image, xy, xz = figure.add_subplot(grid[:, 0]), figure.add_subplot(grid[0, 1]), figure.add_subplot(grid[1, 1])
    if not data.rows:
        for ax in (image, xy, xz):
            say(ax, "no residuals")
        return figure
    squared_radius, inside = data.head_numbers("squared_radius_95", 1)[0], data.text("inside") == "1"
    draw_image_plane(image, data, squared_radius, inside)
    names = ["cov_xx", "cov_xy", "cov_xz", "cov_xy", "cov_yy", "cov_yz", "cov_xz", "cov_yz", "cov_zz"]
    covariance = data.numbers(*names).mean(axis=0).reshape(3, 3)
    for ax, plane, title in ((xy, "xy", "Object space, across the view"),
                             (xz, "xz", "Object space, in depth")):
        draw_object_space(ax, data, covariance, squared_radius, inside, plane)
        ax.set_title(title)
    xz.legend(handles=[dots(BLUE, "ray to object point"), line(BLACK, "mean 95 % ellipse", linewidth=1.2)],
              loc="upper center", bbox_to_anchor=(0.5, -0.17), ncol=2, frameon=False)
    return figure


# --- Errors of solvers: the studies ---

SHOWN_SHARE = 0.95  # of the errors of the solver that has the smallest there


def errors_of_solvers(data):
    """For each quantity the share of all pairs, failed ones among them, whose error is below the abscissa."""
    quantities = data.columns[data.columns.index("tz") + 1:-1] if "tz" in data.columns else []
    if not quantities:
        raise ValueError(f"{data.path}: no column with errors")
    solvers = list(dict.fromkeys(data.text("method")))
    across = min(3, len(quantities))
    down = -(-len(quantities) // across)
    figure, axes = plt.subplots(down, across, figsize=(max(8.4, 4.4 * across), 3.5 * down + 1.1), squeeze=False)
    for ax in axes.flat[len(quantities):]:
        ax.set_axis_off()
    for ax, quantity in zip(axes.flat, quantities):
        draw_shares(ax, data, solvers, quantity)
    for ax in axes[:, 0]:
        ax.set_ylabel("pairs with a smaller error [%]")
    handles, labels = axes[0, 0].get_legend_handles_labels()
    height = figure.get_size_inches()[1]
    rows = -(-len(solvers) // 4)
    figure.legend(handles, labels, loc="lower center", ncol=4, frameon=False)
    figure.tight_layout(rect=(0, (0.15 + 0.22 * rows) / height, 1, 1 - 0.4 / height))
    return figure


def draw_shares(ax, data, solvers, quantity):
    solved, ends = data.text("solved") == "1", []
    for solver in solvers:
        mine = data.text("method") == solver
        errors = np.sort(np.abs(data.numbers(quantity, where=mine & solved)[:, 0]))
        if len(errors):
            ends.append(errors[int(SHOWN_SHARE * (len(errors) - 1))])
        shares = 100 * np.arange(len(errors) + 1) / mine.sum()
        look = style(solver)
        ax.step([0, *errors, errors[-1] * 1e3 if len(errors) else 0], [*shares, shares[-1]], where="post", label=solver,
                color=look["color"], linewidth=look["linewidth"], zorder=look.get("zorder", 2))
    name, _, unit = quantity.rpartition("_")
    ax.set_xlabel(f"{name.replace('_', ' ')} error [{unit}]")
    ax.set_ylim(0, 101)
    if ends and min(ends) > 0:
        ax.set_xlim(0, 1.03 * min(ends))
    else:
        say(ax, "no errors: nothing solved, or exact data")


# --- Residuals under the true motion: the studies with --residuals ---


def isotropy(data):
    """Residuals in the planes of the object frame with the 95 % ellipses of their second moments and of isotropic
    ones, the second moments as a matrix, and the test."""
    figure = plt.figure(figsize=(12.4, 7.8))
    grid = figure.add_gridspec(2, 3, width_ratios=(1, 1, 0.72), left=0.065, right=0.985, bottom=0.075, top=0.89,
                               wspace=0.28, hspace=0.28)
    names = data.head.get("axes", "").split()
    if len(names) != 3:
        raise ValueError(f"{data.path}: expected three names after '# axes'")
    moments, even = (data.head_numbers(key, 9).reshape(3, 3) for key in ("moments", "isotropic"))
    reach = math.sqrt(SQUARED_RADIUS_95 * max(moments.max(), even.max()))
    unit, scale = length_unit(data.head.get("unit", ""), reach)
    every = scale * data.numbers("ex", "ey", "ez")
    shown = every[:: len(every) // MOST_POINTS + 1]
    for cell, pair in ((grid[0, 0], (0, 1)), (grid[1, 0], (0, 2)), (grid[1, 1], (1, 2))):
        ax = figure.add_subplot(cell)
        ax.set_xlabel(f"{names[pair[0]]} [{unit}]")
        ax.set_ylabel(f"{names[pair[1]]} [{unit}]")
        if not reach > 0:
            say(ax, "exact data")
            continue
        ax.scatter(*shown[:, pair].T, s=1.2 if len(shown) > 2000 else 6, color=BLUE, linewidths=0, alpha=0.6,
                   rasterized=True)
        for C, colour, width in ((even, BLACK, 1.4), (moments, ORANGE, 2)):
            ax.add_patch(ellipse(scale**2 * C[np.ix_(pair, pair)], edgecolor=colour, linewidth=width, zorder=3))
        square(ax, REACH * scale * math.sqrt(SQUARED_RADIUS_95 * max(C[i, i] for C in (moments, even) for i in pair)))
    draw_matrix(figure.add_subplot(grid[0, 1]), scale**2 * moments, names, unit)
    draw_notes(figure.add_subplot(grid[:, 2]), data, (scale**2 * moments, scale**2 * even), unit)
    return figure


def draw_matrix(ax, matrix, names, unit):
    """The larger an entry, the darker its square: blue where positive, orange where negative."""
    largest = np.abs(matrix).max() or 1.0
    colours = LinearSegmentedColormap.from_list("signed", [ORANGE, "#FFFFFF", BLUE])
    ax.imshow(matrix, cmap=colours, vmin=-largest, vmax=largest)
    decimals = max(0, 2 - math.floor(math.log10(largest)))
    for (row, column), value in np.ndenumerate(matrix):
        ax.text(column, row, f"{value:.{decimals}f}", ha="center", va="center",
                color="white" if abs(value) > 0.75 * largest else BLACK)
    ax.set_xticks(range(3), names)
    ax.set_yticks(range(3), names)
    ax.grid(False)
    ax.tick_params(length=0)
    ax.set_title(f"second moments [{unit}²]")


def draw_notes(ax, data, matrices, unit):
    def deviations(C):
        values = np.sqrt(np.maximum(np.linalg.eigvalsh(C)[::-1], 0))
        return ", ".join(f"{value:.3g}" for value in values) + f" {unit}"

    found, even = (deviations(C) for C in matrices)
    distance, residuals, pairs = (data.head_numbers(key, 1)[0] for key in ("distance", "p_residuals", "p_pairs"))
    ax.set_axis_off()
    handles = [dots(BLUE, f"{len(data.rows)} residuals of {len(set(data.text('pair')))} pairs", markersize=3),
               line(ORANGE, f"95 % of their second moments;\ndeviations {found}", linewidth=2),
               line(BLACK, f"95 % of as long ones, isotropic;\ndeviations {even}")]
    ax.text(0, 1, data.head.get("frame", ""), transform=ax.transAxes, va="top")
    ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(0, 0.965), frameon=False, borderaxespad=0, borderpad=0,
              labelspacing=1.1)
    ax.text(0, 0.78, f"Test of isotropy\n\ndistance {distance:.3f} of the trace\np = {residuals:.4f}, residuals "
            f"independent\np = {pairs:.4f}, pairs independent", transform=ax.transAxes, va="top", linespacing=1.5)


# --- Where a picture was taken: uav_localization ---


def map_of_a_picture(data):
    """The ground with the points that were used and the camera; beside it, enlarged, the 95 % region of its position,
    the truth and what each solver finds, on the map and in elevation."""
    what, places = data.text("what"), data.numbers("easting", "northing", "elevation")
    if np.sum(what == "centre") != 1:
        raise ValueError(f"{data.path}: expected one row 'centre'")
    centre, truth = places[what == "centre"][0], places[what == "truth"]
    size = (12.8, 7.2)
    figure = plt.figure(figsize=size)

    def panel(left, bottom, width, height):  # inches
        return figure.add_axes((left / size[0], bottom / size[1], width / size[0], height / size[1]))

    draw_ground(panel(1.1, 0.8, 5.7, 5.7), data, places[what == "point"], centre)
    zoom, height = panel(7.7, 2.5, 4, 4), panel(12.25, 2.5, 0.45, 4)
    solvers = dict(zip(data.text("name")[what == "method"], places[what == "method"] - centre))
    draw_position(zoom, height, data.head_numbers("covariance", 9).reshape(3, 3), truth - centre, solvers)

    def label(name, offset):
        off = [f": {np.linalg.norm(offset - t):.2f} m off" for t in truth - centre]
        return name + "".join(off)

    handles = [dots(style(name)["color"], label(name, offset)) for name, offset in solvers.items()]
    if len(truth):
        handles.append(dots(BLACK, "truth", marker="x", markersize=7, markeredgewidth=2))
    handles.append(line(ORANGE, f"95 % of {data.text('name')[what == 'centre'][0]}", linewidth=2))
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(7.5 / size[0], 1.95 / size[1]), ncol=2,
                  frameon=False)
    return figure


def draw_ground(ax, data, points, centre):
    terrain = Grid(os.path.join(os.path.dirname(data.path), data.head.get("terrain", "")))
    light = LightSource(azdeg=315, altdeg=40)
    shade = light.hillshade(np.ma.masked_invalid(terrain.z), dx=terrain.cell, dy=terrain.cell)
    ax.imshow(shade, cmap="gray", vmin=-0.6, vmax=1, extent=terrain.extent, interpolation="bilinear")
    ax.scatter(*points[:, :2].T, s=7, color=BLUE, linewidths=0, label="points used", zorder=3)
    ax.scatter(*centre[:2], s=70, color=ORANGE, edgecolors="white", label="camera", zorder=4)
    ax.set_xlim(terrain.extent[:2])
    ax.set_ylim(terrain.extent[2:])
    ax.ticklabel_format(useOffset=False, style="plain")
    ax.tick_params(axis="x", labelrotation=20)
    ax.grid(False)
    ax.set_xlabel("easting [m]")
    ax.set_ylabel("northing [m]")
    ax.legend(loc="upper right", framealpha=0.85)


def draw_position(ax, height, covariance, truth, solvers):
    """All relative to the estimate, in one scale for the map and the elevation."""
    deviations = np.sqrt(np.diag(covariance))
    reach = 1.4 * max(math.sqrt(SQUARED_RADIUS_95) * deviations.max(), 1.1 * np.abs(truth).max(initial=0), 1e-6)
    ax.add_patch(ellipse(covariance[:2, :2], edgecolor=ORANGE, linewidth=2, zorder=3))
    height.axhspan(-RADIUS_95 * deviations[2], RADIUS_95 * deviations[2], color=LIGHT_ORANGE, alpha=0.6)
    for name, offset in solvers.items():
        look = style(name)
        ax.scatter(*offset[:2], s=34, color=look["color"], linewidths=0, zorder=look.get("zorder", 4))
        height.axhline(offset[2], color=look["color"], linewidth=1.8, zorder=look.get("zorder", 4))
    for offset in truth:
        ax.scatter(*offset[:2], s=60, color=BLACK, marker="x", linewidths=2.2, zorder=8)
        height.scatter(0.5, offset[2], s=60, color=BLACK, marker="x", linewidths=2.2, zorder=8)
    square(ax, reach)
    ax.set_xlabel("east of the estimate [m]")
    ax.set_ylabel("north of the estimate [m]")
    height.set_xlim(0, 1)
    height.set_ylim(-reach, reach)
    height.set_xticks([])
    height.set_title("up [m]")


KINDS = {"residuals": residuals_of_a_pose, "errors": errors_of_solvers, "isotropy": isotropy, "map": map_of_a_picture}

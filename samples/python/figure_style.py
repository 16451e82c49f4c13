# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""How figures look: those of the samples (pictures.py) and those of the experiments (scripts/figures)."""

import numpy as np
from matplotlib.patches import Ellipse

# Colours that readers with any colour vision tell apart (Okabe and Ito).
BLUE, ORANGE, BLACK, GREY = "#0072B2", "#D55E00", "#1E1E1E", "#828282"

SETTINGS = {
    "font.size": 9, "axes.titlesize": 10, "legend.fontsize": 8.5, "axes.grid": True, "grid.color": "#e4e4e4",
    "grid.linewidth": 0.6, "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True,
    "svg.hashsalt": "gmlpnp", "svg.fonttype": "path", "figure.facecolor": "white", "path.simplify": True,
}

# Ours in strong colours; the solvers that are told the true noise dashed.
STYLES = {
    "EPnP": dict(color="#999999", marker="o"),
    "BA": dict(color="#56B4E9", marker="s"),
    "PPnP": dict(color="#8C6D31", marker="v"),
    "SQPnP": dict(color="#000000", marker="D"),
    "CPnP": dict(color="#F0A0C8", marker="^"),
    "UPnP": dict(color="#C5B000", marker="<"),
    "MLPnP": dict(color="#7B4FB5", marker="P", linestyle="--"),
    "REPPnP": dict(color="#B0B0B0", marker="x"),
    "EPnPU": dict(color="#5FA55A", marker=">", linestyle="--"),
    "DLSU": dict(color="#2F7F7F", marker="X", linestyle="--"),
    "GMLPnP": dict(color="#E69F00", marker="o", linewidth=2.2, zorder=5),
    "GMLPnP marginal": dict(color="#D55E00", marker="o", linewidth=2.2, zorder=6),
    "GMLPnP marginal, object noise only": dict(color="#CC79A7", marker="d", linewidth=2.2, zorder=5),
    "GMLPnP*": dict(color="#0072B2", marker="*", linewidth=2.2, linestyle="--", zorder=4),
}
# The samples call solvers by OpenCV's flags, and have three that the experiments do not.
STYLES.update({
    "EPNP": STYLES["EPnP"],
    "ITERATIVE": STYLES["BA"],
    "SQPNP": STYLES["SQPnP"],
    "SQPNP+LM": dict(color="#7B4FB5", marker="^"),
    "ISOTROPIC": dict(color="#009E73", marker="v"),
    "BEARING": dict(color="#0072B2", marker="s"),
    "GMLPNP": STYLES["GMLPnP"],
    "GMLPNP_MARGINAL": STYLES["GMLPnP marginal"],
})


def style(solver):
    """Line and marker of a solver; grey for one that nobody has given a colour."""
    common = dict(linewidth=1.2, linestyle="-", markersize=4, markeredgewidth=0.8)
    return dict(common, **STYLES.get(solver, dict(color=GREY, marker=".")))


def ellipse(covariance, squared_radius=5.991, **kwargs):
    """The ellipse about zero that holds 95 % of a normal distribution, or up to another squared radius."""
    values, vectors = np.linalg.eigh(covariance)
    width, height = 2 * np.sqrt(squared_radius * np.maximum(values, 0))
    angle = np.degrees(np.arctan2(vectors[1, 0], vectors[0, 0]))
    return Ellipse((0, 0), width, height, angle=angle, fill=False, **kwargs)

"""The CSV files of gmlpnp_experiments, and how a solver looks everywhere."""

import csv
import pathlib

# Ours in strong colours that readers with any colour vision tell apart (Okabe and Ito); the solvers that are told the
# true noise dashed.
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


def style(solver):
    return dict(dict(linewidth=1.2, linestyle="-", markersize=4, markeredgewidth=0.8), **STYLES[solver])


class Results:
    """The files of one folder; a row is a dictionary with numbers where there are numbers."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def has(self, name):
        return (self.folder / f"{name}.csv").exists()

    def rows(self, name):
        with open(self.folder / f"{name}.csv", newline="") as file:
            return [{key: self._value(cell) for key, cell in row.items()} for row in csv.DictReader(file)]

    @staticmethod
    def _value(cell):
        if cell == "":
            return float("nan")
        try:
            return float(cell)
        except ValueError:
            return cell


def distinct(rows, key):
    """The values of a column in the order of the file."""
    return list(dict.fromkeys(row[key] for row in rows))


def series(rows, solver, x, y, key="solver"):
    """x, y and the interval of y as matplotlib's yerr, of one solver."""
    mine = [row for row in rows if row[key] == solver]
    values = [row[y] for row in mine]
    below = [row[y] - row[y + "_low"] if y + "_low" in row else 0 for row in mine]
    above = [row[y + "_high"] - row[y] if y + "_high" in row else 0 for row in mine]
    return [row[x] for row in mine], values, [below, above]

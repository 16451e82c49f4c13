"""The CSV files of gmlpnp_experiments."""

import csv
import pathlib


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

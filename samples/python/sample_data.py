# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""The files of the samples that draw.py draws: a head of lines `# key value`, of which `# kind` is the first, the names
of the columns, then rows of cells between commas."""

import numpy as np


class SampleData:
    """One such file. Raises OSError where it cannot be read and ValueError, naming the file, where it is not one."""

    def __init__(self, path):
        self.path, self.head, self.rows, self.columns = path, {}, [], None
        try:
            with open(path, encoding="utf-8", errors="replace") as file:
                for number, line in enumerate(file, 1):
                    self._read(number, line.rstrip("\r\n"))
        except OSError as error:
            raise OSError(f"{path}: cannot be read ({error.strerror})") from error
        if "kind" not in self.head or self.columns is None:
            raise ValueError(f"{path}: is not a file of a sample that can be drawn: no '# kind' line at its top")

    def _read(self, number, line):
        if line.startswith("#"):
            key, _, value = line[1:].strip().partition(" ")
            self.head.setdefault(key, value)
        elif self.columns is None:
            self.columns = line.split(",")
        elif line:
            cells = line.split(",")
            if len(cells) != len(self.columns):
                raise ValueError(f"{self.path}:{number}: expected {len(self.columns)} cells, found {len(cells)}")
            self.rows.append(cells)

    def text(self, column):
        """A column as it stands in the file."""
        if column not in self.columns:
            raise ValueError(f"{self.path}: no column '{column}'")
        at = self.columns.index(column)
        return np.array([row[at] for row in self.rows], dtype=object)

    def numbers(self, *columns, where=slice(None)):
        """Columns side by side, of all rows or of some."""
        return np.stack([self._finite(self.text(column)[where], column) for column in columns], axis=-1)

    def head_numbers(self, key, count):
        """The numbers of a line of the head."""
        values = self._finite(self.head.get(key, "").split(), key)
        if len(values) != count:
            raise ValueError(f"{self.path}: expected {count} numbers after '# {key}', found {len(values)}")
        return values

    def _finite(self, cells, name):
        try:
            values = np.array(cells, dtype=float)
        except ValueError as error:
            raise ValueError(f"{self.path}: {name}: {error}") from None
        if not np.all(np.isfinite(values)):
            raise ValueError(f"{self.path}: {name}: a number is not finite")
        return values


class Grid:
    """An ESRI ASCII grid, its rows from north to south; `z` is NaN where nothing is known."""

    def __init__(self, path):
        try:
            with open(path, encoding="ascii") as file:
                words = file.read().split()
        except OSError as error:
            raise OSError(f"{path}: cannot be read ({error.strerror})") from error
        try:
            head = {key.lower(): float(value) for key, value in zip(words[:12:2], words[1:12:2])}
            shape, self.cell = (int(head["nrows"]), int(head["ncols"])), head["cellsize"]
            west, south = head["xllcorner"], head["yllcorner"]
            z = np.array(words[12:], dtype=float).reshape(shape)
            if min(shape) < 2 or not self.cell > 0:
                raise ValueError("no area")
        except (KeyError, OverflowError, ValueError):
            raise ValueError(f"{path}: is no ESRI ASCII grid") from None
        self.z = np.where(z == head.get("nodata_value"), np.nan, z)
        self.extent = (west, west + self.cell * shape[1], south, south + self.cell * shape[0])

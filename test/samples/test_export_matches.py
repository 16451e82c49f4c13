"""The exporter of samples/python writes what readMatches() documents; no matcher needs to be installed."""

import importlib.util
import os
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def load():
    spec = importlib.util.spec_from_file_location("export_matches", PROGRAM)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class ExportMatches(unittest.TestCase):
    def test_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a__b.txt")
            load().write_matches(path, [[1, 2.5], [3, 4]], [[5, 6], [7, 8]], [0.5, 1])
            with open(path, encoding="ascii") as file:
                rows = [line.split() for line in file if not line.startswith("#")]
        self.assertEqual([[float(word) for word in row] for row in rows], [[1, 2.5, 5, 6, 0.5], [3, 4, 7, 8, 1]])

    def test_sizes_must_agree(self):
        with self.assertRaisesRegex(ValueError, "1 pixels of the reference but 2"):
            load().write_matches(os.devnull, [[1, 2]], [[1, 2], [3, 4]])
        with self.assertRaisesRegex(ValueError, "2 confidences for 1"):
            load().write_matches(os.devnull, [[1, 2]], [[1, 2]], [1, 1])


if __name__ == "__main__":
    unittest.main()

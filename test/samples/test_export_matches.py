"""The exporter of samples/python writes what readMatches() documents; no matcher needs to be installed."""

import importlib
import os
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


def load():
    sys.path.insert(0, os.path.dirname(PROGRAM))
    return importlib.import_module("export_matches")


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

    def test_an_error_leaves_what_was_there_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a__b.txt")
            with open(path, "w", encoding="ascii") as file:
                file.write("kept")
            with self.assertRaises(ValueError):
                load().write_matches(path, [[1, 2], [3, 4]], [[5, 6], [7, 8]], [1, "high"])
            with open(path, encoding="ascii") as file:
                self.assertEqual(file.read(), "kept")
            self.assertEqual(os.listdir(folder), ["a__b.txt"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_a_full_disk_is_an_error(self):
        with self.assertRaisesRegex(OSError, "/dev/full: cannot be written"):
            load().write_matches("/dev/full", [[1, 2]], [[3, 4]])


if __name__ == "__main__":
    unittest.main()

"""What scripts/check_layers.py finds in small trees made for it."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = sys.argv.pop()


def check(files):
    """Exit status and output for a tree of files, each with the headers that it includes."""
    with tempfile.TemporaryDirectory() as folder:
        for name, includes in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("".join(f'#include "{header}"\n' for header in includes), encoding="utf-8")
        done = subprocess.run([sys.executable, CHECK, "--source", folder], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout


class CheckLayers(unittest.TestCase):
    def test_downward_is_fine(self):
        status, output = check({"precomp.hpp": [], "math/lie.hpp": ["../precomp.hpp"],
                                "rays/ray_pass.hpp": ["../math/lie.hpp", "opencv2/core.hpp"]})
        self.assertEqual((0, "5 floors, 1 arrows between rooms, all downward\n"), (status, output))

    def test_upward_is_found(self):
        status, output = check({"rays/ray_pass.hpp": ["../noise/model.hpp"], "noise/model.hpp": []})
        self.assertEqual(1, status)
        self.assertIn("rays/ray_pass.hpp: 'rays' must not include noise/model.hpp", output)

    def test_across_is_found(self):
        status, output = check({"camera/pinhole.cpp": ["../noise/model.hpp"], "noise/model.hpp": []})
        self.assertEqual(1, status)
        self.assertIn("a lens knows no solver", output)

    def test_kernels_include_nothing(self):
        status, output = check({"kernels/loops.hpp": ["../math/lie.hpp"], "math/lie.hpp": []})
        self.assertEqual(1, status)
        self.assertIn("kernels/loops.hpp", output)

    def test_new_folders_need_a_place(self):
        status, output = check({"attic/old.hpp": [], "stray.hpp": []})
        self.assertEqual(1, status)
        self.assertIn("'attic' is no room", output)
        self.assertIn("stray.hpp: stands in no room", output)

    def test_missing_files_are_named(self):
        status, output = check({"api/solve.cpp": ["../estimator/gone.hpp"]})
        self.assertEqual(1, status)
        self.assertIn("includes estimator/gone.hpp, which is no file", output)


if __name__ == "__main__":
    unittest.main()

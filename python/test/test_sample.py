"""samples/python/pose_from_correspondences.py as a user calls it."""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import gmlpnp

try:
    import cv2
except ImportError:
    cv2 = None

ROOT = os.environ.get("GMLPNP_ROOT", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PROGRAM = os.path.join(ROOT, "samples", "python", "pose_from_correspondences.py")
FILES = sorted(glob.glob(os.path.join(ROOT, "samples", "data", "*.txt")))
METHODS = ["EPNP", "ITERATIVE", "SQPNP", "GMLPNP", "GMLPNP_MARGINAL"]


def run(*arguments):
    done = subprocess.run([sys.executable, PROGRAM, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def rows_of(output):
    """Per method of the first table: rvec [deg], tvec [cm], rotation error, position error, time."""
    lines = (line.split() for line in output.split("\n\nmean over")[0].splitlines())
    rows = (words for words in lines if words and words[0] in METHODS and len(words) == 10)
    return {words[0]: np.array(words[1:], float) for words in rows}


class Sample(unittest.TestCase):
    def test_all_files(self):
        self.assertGreater(len(FILES), 1)
        code, output, complaint = run("--repeat=1", *FILES)
        self.assertEqual((code, complaint), (0, ""))
        self.assertNotIn("not solved", output)
        for word in ("Sigma", "Gamma", "Standard deviations of the pose", "mean over the files"):
            self.assertIn(word, output)
        self.assertTrue(re.search(rf"^GMLPNP_MARGINAL +{len(FILES)} ", output, re.MULTILINE))

    def test_poses_are_near_the_truth_and_the_modules_own(self):
        code, output, _ = run("--repeat=1", "--brief", FILES[0])
        self.assertEqual(code, 0)
        rows = rows_of(output)
        self.assertEqual(list(rows), METHODS)
        points, pixels = (np.ascontiguousarray(part) for part in np.split(np.loadtxt(FILES[0]), [3], axis=1))
        K = np.array([[517.3, 0, 318.6], [0, 516.5, 255.3], [0, 0, 1]])
        D = np.array([0.2624, -0.9531, -0.0054, 0.0026, 1.1633])
        for method, row in rows.items():
            self.assertTrue(row[6] < 1.0 and row[7] < 2.0, f"{method}: {row[6]} deg, {row[7]} cm off")
            solvers = [gmlpnp] if cv2 is None or "GMLPNP" in method else [gmlpnp, cv2]
            for solver in solvers:
                flags = getattr(solver, "SOLVEPNP_" + method)
                _, rvec, tvec = solver.solvePnP(points, pixels, K, D, flags=flags)
                np.testing.assert_allclose(row[:3], np.degrees(rvec.ravel()), atol=0.02, err_msg=method)
                np.testing.assert_allclose(row[3:6], 100.0 * tvec.ravel(), atol=0.05, err_msg=method)

    def test_one_method(self):
        code, output, _ = run("--repeat=1", "--method=GMLPNP", FILES[0])
        self.assertEqual((code, list(rows_of(output))), (0, ["GMLPNP"]))
        self.assertIn("GMLPNP also gives", output)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
    def test_a_full_disk_is_an_error(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            arguments = [sys.executable, PROGRAM, "--repeat=1", "--method=GMLPNP", FILES[0]]
            done = subprocess.run(arguments, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("No space left on device", done.stderr)

    def test_mistakes(self):
        head, row = "# fx fy cx cy 500 500 320 240\n", "0.1 0.2 3 300 200\n"
        line = "".join(f"{i} {i} {i}0 {i}00 {i}00\n" for i in range(1, 9))
        for text, message in (
            (head + row + "0.1 0.2 3 300\n", ":3: expected 5 numbers, found 4"),
            (head + row + "0.1 0.2 three 300 200\n", ":3: .*three"),
            (head + "0.1 0.2 nan 300 200\n", ":2: a number is not finite"),
            (head + 3 * row, ": 3 points; at least 4 are needed"),
            (4 * row, ": no '# fx fy cx cy' line"),
            (head + line, ": no pose by GMLPNP_MARGINAL: Result.status=STATUS_DEGENERATE"),
        ):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "bad.txt")
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                code, _, complaint = run("--repeat=1", path)
                self.assertEqual(code, 1, text)
                self.assertRegex(complaint, "bad.txt" + message)
        self.assertEqual(run(os.path.join(ROOT, "nowhere.txt"))[0], 1)
        self.assertEqual(run()[0], 2)
        self.assertEqual(run("--method=DLT", FILES[0])[0], 2)


if __name__ == "__main__":
    unittest.main()

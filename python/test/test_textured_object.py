"""samples/python/textured_object.py as a user calls it; its data come with OpenCV's sources."""

import csv
import os
import subprocess
import sys
import tempfile
import unittest

import gmlpnp

try:
    import cv2
except ImportError:
    cv2 = None

ROOT = os.environ.get("GMLPNP_ROOT", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PROGRAM = os.path.join(ROOT, "samples", "python", "textured_object.py")
TUTORIAL = "samples/cpp/tutorial_code/calib3d/real_time_pose_estimation/Data"
DATA = os.path.join(os.environ.get("GMLPNP_OPENCV_SOURCE", ""), TUTORIAL)


@unittest.skipUnless(cv2 and hasattr(gmlpnp, "drawPoseUncertainty"), "no cv2, or built without opencv_imgproc")
class TexturedObject(unittest.TestCase):
    def run_program(self, *arguments):
        done = subprocess.run([sys.executable, PROGRAM, *arguments], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def test_missing_data(self):
        code, _, errors = self.run_program("nowhere")
        self.assertEqual(code, 1)
        self.assertIn("cookies_ORB.yml: cannot be opened", errors)

    @unittest.skipUnless(os.path.exists(os.path.join(DATA, "box.mp4")), "GMLPNP_OPENCV_SOURCE has no video of the box")
    def test_every_frame_has_a_pose(self):
        with tempfile.TemporaryDirectory() as folder:
            poses, video = os.path.join(folder, "poses.csv"), os.path.join(folder, "drawn.avi")
            code, output, errors = self.run_program(DATA, "--frames=10", f"--csv={poses}", f"--video={video}")
            self.assertEqual(code, 0, errors)
            self.assertIn("10 poses in 10 frames", output)
            with open(poses, encoding="ascii") as file:
                rows = list(csv.DictReader(file))
            self.assertGreater(os.path.getsize(video), 0)
        self.assertEqual(len(rows), 10)
        for row in rows:
            self.assertEqual(row["found"], "1")
            self.assertTrue(100 < float(row["tz_cm"]) < 300, row)
            self.assertTrue(0 < float(row["camera_sd_cm"]) < 5, row)


if __name__ == "__main__":
    unittest.main()

"""samples/python/textured_object.py as a user calls it; its data come with OpenCV's sources."""

import csv
import os
import subprocess
import sys
import tempfile
import unittest

import gmlpnp
from no_room import no_room_for_files, resource

try:
    import cv2
except ImportError:
    cv2 = None

ROOT = os.environ.get("GMLPNP_ROOT", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PROGRAM = os.path.join(ROOT, "samples", "python", "textured_object.py")
TUTORIAL = "samples/cpp/tutorial_code/calib3d/real_time_pose_estimation/Data"
DATA = os.path.join(os.environ.get("GMLPNP_OPENCV_SOURCE", ""), TUTORIAL)


def make_object(folder):
    """Data of an object that is in neither of the two frames."""
    zeros = ", ".join(32 * "0")
    points = '   rows: 1\n   cols: 1\n   dt: "3f"\n   data: [ 0., 0., 0. ]\n'
    descriptors = f"   rows: 1\n   cols: 32\n   dt: u\n   data: [ {zeros} ]\n"
    matrices = (("points_3d", points), ("descriptors", descriptors))
    for name, text in (
        ("cookies_ORB.yml", "%YAML:1.0\n---\n" + "".join(f"{n}: !!opencv-matrix\n{m}" for n, m in matrices)),
        ("box.ply", "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0 0 0\n"),
        ("box.mp4", "YUV4MPEG2 W64 H48 F30:1 C420jpeg\n" + 2 * ("FRAME\n" + 64 * 48 * 3 // 2 * "Z")),
    ):
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)


@unittest.skipUnless(cv2 and hasattr(gmlpnp, "drawPoseUncertainty"), "no cv2, or built without opencv_imgproc")
class TexturedObject(unittest.TestCase):
    def run_program(self, *arguments):
        done = subprocess.run([sys.executable, PROGRAM, *arguments], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def test_missing_data(self):
        code, _, errors = self.run_program("nowhere")
        self.assertEqual(code, 1)
        self.assertIn("cookies_ORB.yml: cannot be opened", errors)

    def test_files_are_whole_or_not_there(self):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as data:
            make_object(data)
            poses, video = os.path.join(folder, "poses.csv"), os.path.join(folder, "drawn.avi")
            code, output, errors = self.run_program(data, f"--csv={poses}", f"--video={video}")
            self.assertEqual(code, 0, errors)
            self.assertIn("0 poses in 2 frames", output)
            with open(poses, encoding="ascii") as file:
                self.assertEqual(len(file.readlines()), 3)
            self.assertEqual(cv2.VideoCapture(video).get(cv2.CAP_PROP_FRAME_COUNT), 2)
            for name, arguments in (
                ("poses.csv", (f"--csv={poses}", "--video=")),
                ("drawn.avi", (f"--csv={os.devnull}", f"--video={video}")),
            ):
                self.check_no_room(folder, name, data, *arguments)

    def check_no_room(self, folder, name, *arguments):
        path, before = os.path.join(folder, name), sorted(os.listdir(folder))
        if resource is not None:
            with open(path, "w", encoding="ascii") as file:
                file.write("kept")
            with no_room_for_files():
                code, _, errors = self.run_program(*arguments)
            self.assertEqual(code, 1, name)
            self.assertIn(f"{name}: cannot be written", errors)
            with open(path, encoding="ascii") as file:
                self.assertEqual(file.read(), "kept")
        if os.path.exists("/dev/full"):
            os.remove(path)
            os.symlink("/dev/full", path)
            code, _, errors = self.run_program(*arguments)
            self.assertEqual(code, 1, name)
            self.assertIn(f"{name}: cannot be written", errors)
            self.assertTrue(os.path.islink(path))
        self.assertEqual(sorted(os.listdir(folder)), before)

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

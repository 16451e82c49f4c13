"""CameraModel: its factories, rays and pixels."""

import copy
import json
import os
import pickle
import tempfile
import threading
import unittest

import numpy as np

import gmlpnp
from no_room import no_room_for_files, resource
from scenes import D, K, PoseTestCase, in_camera, object_points, pinhole_pixels

try:
    import cv2
except ImportError:
    cv2 = None

CAMERAS = {
    "pinhole": lambda: gmlpnp.CameraModel.pinhole(K, D),
    "undistorted": lambda: gmlpnp.CameraModel.pinhole(K=K),
    "fisheye": lambda: gmlpnp.CameraModel.fisheye(K=K, D=[0.01, -0.002, 0.0005, -0.0001]),
    "omnidir": lambda: gmlpnp.CameraModel.omnidir(K=K, D=[-0.1, 0.01, 0.001, 0.002], xi=1.2),
    "eucm": lambda: gmlpnp.CameraModel.eucm(K=K, alpha=0.6, beta=1.1),
    "doubleSphere": lambda: gmlpnp.CameraModel.doubleSphere(K=K, xi=-0.2, alpha=0.55),
    "equirectangular": lambda: gmlpnp.CameraModel.equirectangular(size=(2000, 1000)),
}
POINTS = object_points()
SEEN = in_camera(POINTS)


class Cameras(PoseTestCase):
    def test_project_and_unproject_are_inverses(self):
        for name, make in CAMERAS.items():
            with self.subTest(camera=name):
                camera = make()
                pixels, seen = camera.project(points=SEEN)
                rays, valid, jacobian = camera.unproject(imagePoints=pixels)
                n = len(SEEN)
                self.assertEqual((pixels.shape, rays.shape, jacobian.shape), ((n, 2), (n, 3), (n, 6)))
                for flags in (seen, valid):
                    self.assertEqual((flags.shape, flags.dtype), ((n, 1), np.uint8))
                    self.assertTrue(np.all(flags == 255))
                directions = SEEN / np.linalg.norm(SEEN, axis=1, keepdims=True)
                np.testing.assert_allclose(rays, directions, atol=1e-10)

    def test_jacobian_is_the_derivative(self):
        camera = CAMERAS["omnidir"]()
        pixels, _ = camera.project(SEEN)
        _, _, jacobian = camera.unproject(pixels)
        step = 1e-3
        for column in range(2):
            shift = np.eye(2)[column] * step
            numeric = (camera.unproject(pixels + shift)[0] - camera.unproject(pixels - shift)[0]) / (2.0 * step)
            np.testing.assert_allclose(jacobian.reshape(-1, 3, 2)[:, :, column], numeric, atol=1e-9)

    def test_solve_with_every_camera(self):
        for name, make in CAMERAS.items():
            with self.subTest(camera=name):
                camera = make()
                retval, result = gmlpnp.solve(POINTS, camera.project(SEEN)[0], camera)
                self.assertTrue(retval)
                self.assertPose(result.rvec, result.tvec)

    def test_what_a_lens_does_not_see(self):
        camera = gmlpnp.CameraModel.pinhole(K)
        pixels, valid = camera.project([[0.0, 0.0, 2.0], [0.0, 0.0, -2.0]])
        np.testing.assert_array_equal(valid, [[255], [0]])
        np.testing.assert_array_equal(pixels, [[320.0, 240.0], [0.0, 0.0]])
        self.assertEqual(camera.project(np.reshape(SEEN, (-1, 1, 3)))[0].shape, (len(SEEN), 2))

    def test_same_pixels_as_the_formula(self):
        np.testing.assert_allclose(CAMERAS["pinhole"]().project(SEEN)[0], pinhole_pixels(POINTS, D), atol=1e-9)

    @unittest.skipIf(cv2 is None, "cv2 is not installed: nothing to compare to")
    def test_same_pixels_as_cv2(self):
        zero = np.zeros((3, 1))
        pixels, _ = cv2.projectPoints(SEEN, zero, zero, K, D)
        np.testing.assert_allclose(CAMERAS["pinhole"]().project(SEEN)[0], pixels.reshape(-1, 2), atol=1e-9)
        k = np.array([0.01, -0.002, 0.0005, -0.0001])
        pixels, _ = cv2.fisheye.projectPoints(SEEN.reshape(-1, 1, 3), zero, zero, K, k)
        np.testing.assert_allclose(CAMERAS["fisheye"]().project(SEEN)[0], pixels.reshape(-1, 2), atol=1e-9)

    def test_save_and_load(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, make in CAMERAS.items():
                for extension in ("yml", "json", "xml"):
                    path = os.path.join(folder, f"{name}.{extension}")
                    camera = make()
                    camera.save(path)
                    twin = gmlpnp.CameraModel.load(filename=path, model="")
                    np.testing.assert_array_equal(twin.project(SEEN)[0], camera.project(SEEN)[0])
            with self.assertRaisesRegex(gmlpnp.error, "nowhere"):
                gmlpnp.CameraModel.load(os.path.join(folder, "nowhere.yml"))

    @unittest.skipIf(resource is None, "no limits of files here")
    def test_save_keeps_what_was_there(self):
        camera = CAMERAS["pinhole"]()
        with tempfile.TemporaryDirectory() as folder:
            path, link = os.path.join(folder, "camera.yml"), os.path.join(folder, "link.yml")
            with open(path, "w", encoding="ascii") as file:
                file.write("kept")
            os.chmod(path, 0o640)
            with no_room_for_files(), self.assertRaisesRegex(gmlpnp.error, "camera.yml: cannot be written"):
                camera.save(path)
            with open(path, encoding="ascii") as file:
                self.assertEqual(file.read(), "kept")
            os.symlink("camera.yml", link)
            camera.save(link)
            gmlpnp.CameraModel.load(path)
            self.assertTrue(os.path.islink(link))
            self.assertEqual(os.stat(path).st_mode & 0o777, 0o640)
            self.assertEqual(sorted(os.listdir(folder)), ["camera.yml", "link.yml"])

    def test_save_where_nothing_can_be_written(self):
        camera = CAMERAS["pinhole"]()
        with tempfile.TemporaryDirectory() as folder:
            for path in (folder, os.path.join(folder, "nowhere", "camera.yml")):
                with self.assertRaisesRegex(gmlpnp.error, path + ": cannot be written"):
                    camera.save(path)
            with self.assertRaisesRegex(gmlpnp.error, "camera.yml.gz: is not compressed"):
                camera.save(os.path.join(folder, "camera.yml.gz"))
            self.assertEqual(os.listdir(folder), [])
            if os.path.exists("/dev/full"):
                link = os.path.join(folder, "full.yml")
                os.symlink("/dev/full", link)
                with self.assertRaisesRegex(gmlpnp.error, "full.yml: cannot be written"):
                    camera.save(link)
                self.assertEqual(os.listdir(folder), ["full.yml"])

    @unittest.skipUnless(hasattr(os, "mkfifo"), "no pipes with names here")
    def test_save_into_a_pipe(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe, texts = os.path.join(folder, "pipe.json"), []

            def read():
                with open(pipe, encoding="ascii") as file:
                    texts.append(file.read())

            os.mkfifo(pipe)
            reader = threading.Thread(target=read)
            reader.start()
            CAMERAS["pinhole"]().save(pipe)
            reader.join()
        self.assertEqual(json.loads(texts[0])["camera"]["model"], "pinhole")

    def test_repr_pickle_copy(self):
        for name, make in CAMERAS.items():
            camera = make()
            self.assertRegex(repr(camera), r"^CameraModel\(\{'model': '" + name.replace("undistorted", "pinhole"))
            for twin in (pickle.loads(pickle.dumps(camera)), copy.copy(camera), copy.deepcopy(camera)):
                np.testing.assert_array_equal(twin.project(SEEN)[0], camera.project(SEEN)[0])


if __name__ == "__main__":
    unittest.main()

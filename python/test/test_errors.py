"""Misuse raises gmlpnp.error and names the argument; a call that does not fit the signature is a TypeError."""

import unittest

import numpy as np

import gmlpnp
from scenes import D, K, object_points, pinhole_pixels

try:
    import cv2
except ImportError:
    cv2 = None

POINTS = object_points()
PIXELS = pinhole_pixels(POINTS)
BAD_ARGUMENT, ASSERTION = -5, -215


class Errors(unittest.TestCase):
    def assertRefused(self, code, name, function, *args, **kwargs):
        with self.assertRaises(gmlpnp.error) as caught:
            function(*args, **kwargs)
        self.assertEqual(caught.exception.code, code, str(caught.exception))
        self.assertIn(name, caught.exception.err)

    def test_class(self):
        self.assertTrue(issubclass(gmlpnp.error, RuntimeError))
        self.assertEqual((gmlpnp.error.__module__, gmlpnp.error.__name__), ("gmlpnp", "error"))

    def test_attributes(self):
        with self.assertRaises(gmlpnp.error) as caught:
            gmlpnp.solvePnP(POINTS, PIXELS, K, D, flags=77)
        error = caught.exception
        self.assertEqual(error.code, BAD_ARGUMENT)
        self.assertIn("77", error.err)
        self.assertTrue(error.func)
        self.assertTrue(error.file.endswith(".cpp") and error.line > 0)
        self.assertEqual((error.msg, error.args), (str(error), (str(error),)))

    @unittest.skipIf(cv2 is None, "cv2 is not installed: nothing to compare to")
    def test_attributes_are_those_of_cv2(self):
        def public(error):
            return {name for name in dir(error) if not name.startswith("_")}

        with self.assertRaises(cv2.error) as theirs:
            cv2.solvePnP(POINTS, PIXELS, K, D, flags=77)
        with self.assertRaises(gmlpnp.error) as ours:
            gmlpnp.solvePnP(POINTS, PIXELS, K, D, flags=77)
        self.assertEqual(public(ours.exception), public(theirs.exception))
        self.assertEqual(ours.exception.code, theirs.exception.code)

    def test_raised_from_python(self):
        self.assertEqual(gmlpnp.error("mine").code, 0)

    def test_shapes(self):
        for points in (POINTS.T, POINTS[:, :2], POINTS.ravel(), np.zeros((0, 3)), 3.0, None, np.zeros((2, 5, 2, 3))):
            self.assertRefused(ASSERTION, "objectPoints", gmlpnp.solvePnP, points, PIXELS, K, D)
            self.assertRefused(ASSERTION, "objectPoints", gmlpnp.solve, points, PIXELS, K, D)
        self.assertRefused(ASSERTION, "imagePoints", gmlpnp.solvePnP, POINTS, PIXELS[:, :1], K, D)
        self.assertRefused(ASSERTION, "imagePoints", gmlpnp.solvePnP, POINTS, PIXELS[:-1], K, D)
        self.assertRefused(ASSERTION, "rays", gmlpnp.solveRays, POINTS, PIXELS)
        self.assertRefused(ASSERTION, "K", gmlpnp.CameraModel.pinhole, K[:2])
        self.assertRefused(ASSERTION, "D", gmlpnp.CameraModel.fisheye, K, np.zeros(5))

    def test_not_numbers(self):
        ragged = [[1, 2, 3], [4, 5]]
        for points in ("points", ragged, [["a", "b", "c"]], POINTS + 1j, POINTS > 0, [None] * 5, object(), {}):
            self.assertRefused(BAD_ARGUMENT, "objectPoints", gmlpnp.solvePnP, points, PIXELS, K, D)
        self.assertRefused(BAD_ARGUMENT, "distCoeffs", gmlpnp.solvePnP, POINTS, PIXELS, K, "none")
        self.assertRefused(BAD_ARGUMENT, "rvec", gmlpnp.solvePnP, POINTS, PIXELS, K, None, "zero")

    def test_values(self):
        self.assertRefused(BAD_ARGUMENT, "method", gmlpnp.solve, POINTS, PIXELS, K, D, gmlpnp.Params(method=1))
        self.assertRefused(BAD_ARGUMENT, "alpha", gmlpnp.CameraModel.eucm, K, 2.0, 1.0)
        self.assertRefused(BAD_ARGUMENT, "camera", gmlpnp.solve, POINTS, PIXELS, None)

    def test_calls_that_do_not_fit(self):
        with self.assertRaises(TypeError):
            gmlpnp.solvePnP(POINTS, PIXELS, K)
        with self.assertRaises(TypeError):
            gmlpnp.solvePnP(POINTS, PIXELS, K, D, flag=0)
        with self.assertRaises(TypeError):
            gmlpnp.solvePnP(POINTS, PIXELS, K, D, flags="EPNP")
        with self.assertRaises(TypeError):
            gmlpnp.solve(POINTS, PIXELS, K)
        with self.assertRaises(TypeError):
            gmlpnp.CameraModel()


if __name__ == "__main__":
    unittest.main()

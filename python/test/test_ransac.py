"""RANSAC: poses and inliers of correspondences of which some are wrong."""

import types
import unittest

import numpy as np

import gmlpnp
import gmlpnp.fisheye
from scenes import D, K, RVEC, TVEC, PoseTestCase, in_camera, object_points, pinhole_pixels

try:
    import cv2
except ImportError:
    cv2 = None

COUNT, WRONG = 60, 20
GOOD = np.arange(WRONG, COUNT).reshape(-1, 1)


def spoiled(pixels, seed=3):
    """The first ones anywhere."""
    pixels = pixels.copy()
    pixels[:WRONG] = np.random.default_rng(seed).uniform(0.0, 480.0, (WRONG, 2))
    return pixels


POINTS = object_points(COUNT)
PIXELS = spoiled(pinhole_pixels(POINTS, D))


class Ransac(PoseTestCase):
    def test_solveRansac(self):
        camera = gmlpnp.CameraModel.pinhole(K, D)
        for arguments in ((camera,), (K, D)):
            retval, result, inliers = gmlpnp.solveRansac(POINTS, PIXELS, *arguments)
            self.assertIs(retval, True)
            self.assertPose(result.rvec, result.tvec, 1e-6)
            np.testing.assert_array_equal(inliers, GOOD)
            self.assertEqual(inliers.dtype, np.int32)
            self.assertEqual(result.usedPoints, COUNT - WRONG)

    def test_solveRaysRansac(self):
        rays = in_camera(POINTS)
        rays[:WRONG] = np.random.default_rng(5).normal(0.0, 1.0, (WRONG, 3))
        ransac = gmlpnp.RansacParams(threshold=1e-3, seed=9)
        retval, result, inliers = gmlpnp.solveRaysRansac(POINTS, rays, ransac)
        self.assertTrue(retval)
        self.assertPose(result.rvec, result.tvec)
        np.testing.assert_array_equal(inliers, GOOD)

    def test_solvePnPRansac_is_that_of_cv2(self):
        retval, rvec, tvec, inliers = gmlpnp.solvePnPRansac(POINTS, PIXELS, K, D)
        self.assertIs(retval, True)
        self.assertEqual((rvec.shape, tvec.shape), ((3, 1), (3, 1)))
        self.assertPose(rvec, tvec, 1e-6)
        np.testing.assert_array_equal(inliers, GOOD)
        again = gmlpnp.solvePnPRansac(
            POINTS, PIXELS, K, D, None, None, False, 10000, 8.0, 0.99, None, gmlpnp.SOLVEPNP_GMLPNP_MARGINAL
        )
        np.testing.assert_array_equal(rvec, again[1])
        if cv2 is None:
            self.skipTest("no cv2")
        for name in ("SOLVEPNP_EPNP", "USAC_DEFAULT", "USAC_MAGSAC"):
            flags = getattr(cv2, name)
            self.assertEqual(flags, getattr(gmlpnp, name))
            arguments = dict(iterationsCount=200, reprojectionError=4.0, confidence=0.9, flags=flags)
            ours = gmlpnp.solvePnPRansac(POINTS, PIXELS, K, D, **arguments)
            theirs = cv2.solvePnPRansac(POINTS, PIXELS, K, D, **arguments)
            for a, b in zip(ours, theirs):
                np.testing.assert_array_equal(a, b, name)

    def test_usac_params(self):
        params = types.SimpleNamespace(
            threshold=3.0, confidence=0.99, maxIterations=1000, randomGeneratorState=4, sampler=0
        )
        retval, matrix, rvec, tvec, inliers = gmlpnp.solvePnPRansac(POINTS, PIXELS, K, D, params=params)
        self.assertTrue(retval)
        np.testing.assert_array_equal(matrix, K)
        self.assertPose(rvec, tvec, 1e-6)
        np.testing.assert_array_equal(inliers, GOOD)
        if cv2 is not None:
            usac = cv2.UsacParams()
            usac.threshold, usac.maxIterations, usac.randomGeneratorState = 3.0, 1000, 4
            again = gmlpnp.solvePnPRansac(POINTS, PIXELS, K, D, None, None, None, usac)
            self.assertEqual(len(again), 5)
            np.testing.assert_array_equal(rvec, again[2])

    def test_fisheye(self):
        lens = np.array([-0.02, 0.004, -0.001, 0.0001])
        camera = gmlpnp.CameraModel.fisheye(K, lens)
        pixels = spoiled(camera.project(in_camera(POINTS))[0])
        retval, rvec, tvec, inliers = gmlpnp.fisheye.solvePnPRansac(POINTS, pixels, K, lens, reprojectionError=2.0)
        self.assertTrue(retval)
        self.assertPose(rvec, tvec, 1e-6)
        np.testing.assert_array_equal(inliers, GOOD)

    def test_guess_and_arrays_that_are_filled(self):
        rvec, tvec = RVEC + 0.05, TVEC + 0.1
        retval, r, t, _ = gmlpnp.solvePnPRansac(POINTS, PIXELS, K, D, rvec, tvec, True, iterationsCount=1)
        self.assertTrue(retval and r is rvec and t is tvec)
        self.assertPose(rvec, tvec, 1e-6)

    def test_failure(self):
        pixels = np.random.default_rng(1).uniform(0.0, 480.0, (COUNT, 2))
        rvec = np.ones((3, 1))
        retval, r, t, inliers = gmlpnp.solvePnPRansac(POINTS, pixels, K, None, rvec, iterationsCount=200)
        self.assertIs(retval, False)
        self.assertIs(r, rvec)
        np.testing.assert_array_equal(rvec, 1.0)
        self.assertIsNone(t)
        self.assertIsNone(inliers)
        retval, result, inliers = gmlpnp.solveRansac(POINTS, pixels, K, None)
        self.assertIs(retval, False)
        self.assertIsNone(inliers)
        self.assertEqual(result.status, gmlpnp.STATUS_NO_CONSENSUS)

    def test_options(self):
        ransac = gmlpnp.RansacParams(threshold=2.0, confidence=0.999, maxIterations=50, seed=7, ordered=True)
        self.assertEqual(
            repr(ransac), "RansacParams(threshold=2.0, confidence=0.999, maxIterations=50, seed=7, ordered=True)"
        )
        ransac.ordered = False
        self.assertTrue(gmlpnp.solveRansac(POINTS, PIXELS, K, D, ransac, gmlpnp.Params(robust=False))[0])
        for name, value in (("threshold", -1.0), ("confidence", 1.0), ("maxIterations", 0)):
            with self.assertRaisesRegex(gmlpnp.error, name):
                gmlpnp.solveRansac(POINTS, PIXELS, K, D, gmlpnp.RansacParams(**{name: value}))
        with self.assertRaises(TypeError):
            gmlpnp.RansacParams(treshold=1.0)


if __name__ == "__main__":
    unittest.main()

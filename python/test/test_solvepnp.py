"""solvePnP against exact poses and against cv2."""

import unittest

import numpy as np

import gmlpnp
from scenes import D, K, RVEC, TVEC, PoseTestCase, noisy_scene, object_points, pinhole_pixels, rotation

try:
    import cv2
except ImportError:
    cv2 = None

OURS = (gmlpnp.SOLVEPNP_GMLPNP, gmlpnp.SOLVEPNP_GMLPNP_MARGINAL)
POINTS = object_points()
PIXELS = pinhole_pixels(POINTS, D)


class SolvePnP(PoseTestCase):
    def test_exact_data(self):
        for flags in OURS:
            retval, rvec, tvec = gmlpnp.solvePnP(POINTS, PIXELS, K, D, flags=flags)
            self.assertIs(retval, True)
            self.assertEqual((rvec.shape, tvec.shape, rvec.dtype, tvec.dtype), ((3, 1), (3, 1), np.float64, np.float64))
            self.assertPose(rvec, tvec)

    def test_keywords_are_those_of_cv2(self):
        retval, rvec, tvec = gmlpnp.solvePnP(
            objectPoints=POINTS,
            imagePoints=PIXELS,
            cameraMatrix=K,
            distCoeffs=D,
            rvec=None,
            tvec=None,
            useExtrinsicGuess=False,
            flags=gmlpnp.SOLVEPNP_GMLPNP,
        )
        self.assertTrue(retval)
        self.assertPose(rvec, tvec)

    def test_default_is_the_marginal_method(self):
        points, pixels = noisy_scene()
        default = gmlpnp.solvePnP(points, pixels, K, None)
        marginal = gmlpnp.solvePnP(points, pixels, K, None, None, None, False, gmlpnp.SOLVEPNP_GMLPNP_MARGINAL)
        published = gmlpnp.solvePnP(points, pixels, K, None, flags=gmlpnp.SOLVEPNP_GMLPNP)
        np.testing.assert_array_equal(default[1], marginal[1])
        self.assertFalse(np.array_equal(default[1], published[1]))

    def test_float_arrays_are_filled(self):
        for dtype, shape in ((np.float64, (3, 1)), (np.float64, (3,)), (np.float32, (3, 1))):
            rvec, tvec = np.zeros(shape, dtype), np.zeros(shape, dtype)
            retval, r, t = gmlpnp.solvePnP(POINTS, PIXELS, K, D, rvec, tvec)
            self.assertTrue(retval and r is rvec and t is tvec)
            self.assertPose(rvec, tvec, 1e-5)

    def test_other_arrays_are_left_alone(self):
        frozen = np.zeros((3, 1))
        frozen.flags.writeable = False
        for given in (np.zeros((1, 3)), np.zeros((3, 1), int), [0, 0, 0], frozen, np.zeros((6, 1))[::2]):
            retval, r, t = gmlpnp.solvePnP(POINTS, PIXELS, K, D, given, given)
            self.assertTrue(retval)
            self.assertIsNot(r, given)
            self.assertEqual((r.shape, t.shape), ((3, 1), (3, 1)))
            self.assertFalse(np.any(given))
            self.assertPose(r, t)

    def test_guess(self):
        three, pixels = POINTS[:3], PIXELS[:3]
        near_r, near_t = RVEC + 0.01, TVEC + 0.02
        retval, rvec, tvec = gmlpnp.solvePnP(three, pixels, K, D, near_r.tolist(), near_t.tolist(), True)
        self.assertTrue(retval)
        self.assertPose(rvec, tvec, 1e-6)
        with self.assertRaises(gmlpnp.error):
            gmlpnp.solvePnP(three, pixels, K, D, None, None, True)

    def test_no_pose_is_false_and_none(self):
        line = np.outer(np.arange(6.0), [1.0, 1.0, 1.0])
        nan = POINTS.copy()
        nan[3, 1] = np.nan
        for points in (line, nan):
            self.assertEqual(gmlpnp.solvePnP(points, PIXELS[: len(points)], K, D), (False, None, None))

    def test_no_pose_leaves_arrays_untouched(self):
        rvec, tvec = np.full((3, 1), 5.0), np.full((3, 1), 6.0)
        retval, r, t = gmlpnp.solvePnP(np.full((6, 3), np.inf), PIXELS[:6], K, D, rvec, tvec)
        self.assertTrue(retval is False and r is rvec and t is tvec)
        np.testing.assert_array_equal(np.hstack([r, t]), np.tile([5.0, 6.0], (3, 1)))

    def test_opencv_flags_work_without_cv2(self):
        retval, rvec, tvec = gmlpnp.solvePnP(POINTS, pinhole_pixels(POINTS), K, None, flags=gmlpnp.SOLVEPNP_SQPNP)
        self.assertTrue(retval)
        self.assertPose(rvec, tvec, 1e-6)


class Generic(PoseTestCase):
    def test_exact_data(self):
        for flags in (*OURS, gmlpnp.SOLVEPNP_SQPNP):
            pixels = pinhole_pixels(POINTS)
            retval, rvecs, tvecs, reprojection = gmlpnp.solvePnPGeneric(POINTS, pixels, K, None, flags=flags)
            self.assertTrue(retval == len(rvecs) == len(tvecs) == len(reprojection) >= 1)
            self.assertTrue(isinstance(rvecs, tuple) and isinstance(tvecs, tuple))
            self.assertPose(rvecs[0], tvecs[0], 1e-6)
            self.assertEqual(reprojection.shape, (retval, 1))
            self.assertTrue(reprojection[0, 0] < 1e-4)

    def test_the_guess_is_not_written(self):
        rvec, tvec = RVEC + 0.01, TVEC + 0.02
        for flags in (gmlpnp.SOLVEPNP_GMLPNP, gmlpnp.SOLVEPNP_ITERATIVE):
            answer = gmlpnp.solvePnPGeneric(
                POINTS, PIXELS, K, D, useExtrinsicGuess=True, flags=flags, rvec=rvec, tvec=tvec
            )
            self.assertEqual(answer[0], 1)
            self.assertPose(answer[1][0], answer[2][0], 1e-5)
            self.assertPose(rvec, tvec, 1e-15, (RVEC + 0.01, TVEC + 0.02))

    def test_no_pose(self):
        line = np.outer(np.arange(6.0), [1.0, 1.0, 1.0])
        self.assertEqual(gmlpnp.solvePnPGeneric(line, PIXELS[:6], K, D), (0, (), (), None))


class Refine(PoseTestCase):
    FUNCTIONS = (gmlpnp.solvePnPRefine, gmlpnp.solvePnPRefineLM, gmlpnp.solvePnPRefineVVS)

    def test_exact_data(self):
        for function in self.FUNCTIONS:
            for shape in ((3, 1), (3,)):
                rvec, tvec = (RVEC + 0.01).reshape(shape), (TVEC + 0.02).reshape(shape)
                r, t = function(POINTS, PIXELS, K, D, rvec, tvec)
                self.assertTrue(r is rvec and t is tvec)
                self.assertPose(r, t, 1e-4)
            r, t = function(POINTS, PIXELS, K, D, (RVEC + 0.01).ravel().tolist(), (TVEC + 0.02).ravel().tolist())
            self.assertEqual((r.shape, t.shape), ((3, 1), (3, 1)))
            self.assertPose(r, t, 1e-4)

    def test_keywords_and_criteria(self):
        for function in self.FUNCTIONS:
            r, t = function(
                objectPoints=POINTS,
                imagePoints=PIXELS,
                cameraMatrix=K,
                distCoeffs=D,
                rvec=RVEC + 0.01,
                tvec=TVEC + 0.02,
                criteria=(3, 50, 1e-12),
            )
            self.assertPose(r, t, 1e-5)
        gmlpnp.solvePnPRefineVVS(POINTS, PIXELS, K, D, RVEC.copy(), TVEC.copy(), None, VVSlambda=0.5)
        with self.assertRaises(TypeError):
            gmlpnp.solvePnPRefine(POINTS, PIXELS, K, D)
        with self.assertRaisesRegex(TypeError, "criteria"):
            gmlpnp.solvePnPRefine(POINTS, PIXELS, K, D, RVEC.copy(), TVEC.copy(), 20)


@unittest.skipIf(cv2 is None, "cv2 is not installed: nothing to compare to")
class AgainstCv2(PoseTestCase):
    def test_flags_are_those_of_cv2(self):
        for name in dir(gmlpnp):
            if name.startswith("SOLVEPNP_") and "GMLPNP" not in name:
                self.assertEqual(getattr(gmlpnp, name), getattr(cv2, name), name)

    def test_forwarded_flags_give_the_same_bits(self):
        points, pixels = noisy_scene()
        for dtype in (np.float64, np.float32):
            p, u = points.astype(dtype), pixels.astype(dtype)
            for flag in (cv2.SOLVEPNP_ITERATIVE, cv2.SOLVEPNP_EPNP, cv2.SOLVEPNP_SQPNP):
                theirs = cv2.solvePnP(p, u, K, D, flags=flag)
                ours = gmlpnp.solvePnP(p, u, K, D, flags=flag)
                self.assertEqual(ours[0], theirs[0])
                for a, b in zip(ours[1:], theirs[1:]):
                    self.assertEqual(a.dtype, b.dtype)
                    np.testing.assert_array_equal(a, b)

    def test_outputs_are_typed_and_shaped_as_by_cv2(self):
        for given in (None, np.zeros((3, 1)), np.zeros(3), np.zeros((3, 1), np.float32), np.zeros((1, 3), np.float32)):
            mine, theirs = (None if given is None else given.copy() for _ in range(2))
            ours = gmlpnp.solvePnP(POINTS, PIXELS, K, D, mine, mine, False, cv2.SOLVEPNP_SQPNP)
            wanted = cv2.solvePnP(POINTS, PIXELS, K, D, theirs, theirs, False, cv2.SOLVEPNP_SQPNP)
            self.assertEqual((ours[1].shape, ours[1].dtype), (wanted[1].shape, wanted[1].dtype))
            self.assertEqual(ours[1] is mine, wanted[1] is theirs)

    def test_failure_is_that_of_cv2(self):
        line = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]])
        pixels = np.array([[1.0, 2], [3, 4], [5, 6], [7, 8]])
        theirs = cv2.solvePnP(line, pixels, K, None, flags=cv2.SOLVEPNP_P3P)
        self.assertEqual(theirs, (False, None, None))
        self.assertEqual(gmlpnp.solvePnP(line, pixels, K, None, flags=gmlpnp.SOLVEPNP_P3P), theirs)

    def test_generic_and_refinement_give_the_same_bits(self):
        points, pixels = noisy_scene()
        for flags in (cv2.SOLVEPNP_SQPNP, cv2.SOLVEPNP_EPNP):
            theirs = cv2.solvePnPGeneric(points, pixels, K, D, flags=flags)
            ours = gmlpnp.solvePnPGeneric(points, pixels, K, D, flags=flags)
            self.assertEqual(ours[0], theirs[0])
            for a, b in zip(ours[1] + ours[2] + (ours[3],), theirs[1] + theirs[2] + (theirs[3],)):
                np.testing.assert_array_equal(a, b)
        for name in ("solvePnPRefineLM", "solvePnPRefineVVS"):
            theirs = getattr(cv2, name)(points, pixels, K, D, RVEC + 0.1, TVEC + 0.1)
            ours = getattr(gmlpnp, name)(points, pixels, K, D, RVEC + 0.1, TVEC + 0.1)
            np.testing.assert_array_equal(ours, theirs)

    def test_same_pose_as_cv2_on_exact_data(self):
        _, rvec, tvec = cv2.solvePnP(POINTS, PIXELS, K, D)
        _, r, t = gmlpnp.solvePnP(POINTS, PIXELS, K, D)
        self.assertPose(r, t, 1e-6, (rvec, tvec))


class Fisheye(PoseTestCase):
    def pixels(self, rays, k):
        """theta_d (X, Y) / |(X, Y)|, theta_d = theta (1 + k1 theta^2 + ...)."""
        radius = np.hypot(rays[:, 0], rays[:, 1])
        theta = np.arctan2(radius, rays[:, 2])
        distorted = theta * (1.0 + sum(c * theta ** (2 * i + 2) for i, c in enumerate(k)))
        x, y = distorted / radius * rays[:, 0], distorted / radius * rays[:, 1]
        return np.column_stack([K[0, 0] * x + K[0, 2], K[1, 1] * y + K[1, 2]])

    def test_beyond_90_degrees(self):
        k = [0.01, -0.002, 0.0005, -0.0001]
        directions = np.array(
            [[1.0, 0.1, -0.1], [-1, 0.2, -0.05], [0.1, 1, 0.2], [0.3, -1, 0], [0.5, 0.4, 1], [-1, 1, 1]]
        )
        depths = np.array([[2.0], [3], [2.5], [4], [5], [3.5]])
        points = (directions * depths - TVEC.T) @ rotation(RVEC)
        retval, rvec, tvec = gmlpnp.fisheye.solvePnP(points, self.pixels(directions, k), K, k)
        self.assertTrue(retval)
        self.assertPose(rvec, tvec)
        criteria = (3, 20, 1e-6)
        again = gmlpnp.fisheye.solvePnP(points, self.pixels(directions, k), K, k, criteria=criteria)
        np.testing.assert_array_equal(again[1], rvec)
        with self.assertRaisesRegex(TypeError, "criteria"):
            gmlpnp.fisheye.solvePnP(points, self.pixels(directions, k), K, k, criteria=3)


if __name__ == "__main__":
    unittest.main()

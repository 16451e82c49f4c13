#!/usr/bin/env python

# Python 2/3 compatibility
from __future__ import print_function

import numpy as np
import cv2 as cv

from tests_common import NewOpenCVTests


class gmlpnp_test(NewOpenCVTests):

    K = np.array([[800., 0, 320], [0, 800, 240], [0, 0, 1]])
    D = np.array([-0.1, 0.01, 0.001, -0.001, 0.0])
    rvec = np.array([0.3, -0.4, 0.5])
    tvec = np.array([0.1, -0.2, 6.0])

    def scene(self, n=40, sigma=0.0):
        rng = np.random.RandomState(n)
        points = rng.uniform(-2, 2, (n, 3))
        pixels = cv.projectPoints(points, self.rvec, self.tvec, self.K, self.D)[0].reshape(n, 2)
        return points + rng.normal(0, 1, (n, 3)) * sigma, pixels

    def assert_pose(self, rvec, tvec, tolerance=1e-6):
        self.assertLess(np.abs(np.ravel(rvec) - self.rvec).max(), tolerance)
        self.assertLess(np.abs(np.ravel(tvec) - self.tvec).max(), tolerance)

    def test_solvePnP_is_a_drop_in(self):
        points, pixels = self.scene()
        for flags in (cv.gmlpnp.SOLVEPNP_GMLPNP, cv.gmlpnp.SOLVEPNP_GMLPNP_MARGINAL, cv.SOLVEPNP_ITERATIVE,
                      cv.SOLVEPNP_SQPNP):
            theirs = cv.solvePnP(points, pixels, self.K, self.D)
            ours = cv.gmlpnp.solvePnP(points, pixels, self.K, self.D, flags=flags)
            self.assertEqual(len(theirs), len(ours))
            ok, rvec, tvec = ours
            self.assertIs(ok, True)
            self.assertEqual((3, 1), rvec.shape)
            self.assertEqual(np.float64, tvec.dtype)
            # OpenCV's flags undistort by five steps only
            self.assert_pose(rvec, tvec, 1e-6 if flags >= 100 else 1e-3)

    def test_solvePnP_keywords(self):
        points, pixels = self.scene()
        ok, rvec, tvec = cv.gmlpnp.solvePnP(objectPoints=points, imagePoints=pixels, cameraMatrix=self.K,
                                            distCoeffs=self.D, rvec=self.rvec + 0.01, tvec=self.tvec + 0.01,
                                            useExtrinsicGuess=True, flags=cv.gmlpnp.SOLVEPNP_GMLPNP)
        self.assertTrue(ok)
        self.assert_pose(rvec, tvec)

    def test_layouts(self):
        points, pixels = self.scene()
        wide = np.zeros((len(points), 5))
        wide[:, 1:4] = points
        for p in (points, points.astype(np.float32), points.reshape(-1, 1, 3), points.reshape(1, -1, 3), wide[:, 1:4],
                  np.asfortranarray(points)):
            ok, rvec, tvec = cv.gmlpnp.solvePnP(p, pixels, self.K, self.D)
            self.assertTrue(ok)
            self.assert_pose(rvec, tvec, 1e-5)

    def test_result(self):
        points, pixels = self.scene(200, np.array([0.02, 0.02, 0.1]))
        ok, result = cv.gmlpnp.solve(points, pixels, self.K, self.D)
        self.assertTrue(ok)
        self.assertIn(result.status, (cv.gmlpnp.STATUS_CONVERGED, cv.gmlpnp.STATUS_MAX_ROUNDS))
        self.assertEqual(200, result.usedPoints)
        self.assert_pose(result.rvec, result.tvec, 0.05)
        for covariance, n in ((result.poseCovariance, 6), (result.poseCovarianceRt, 6),
                              (result.cameraCenterCovariance, 3), (result.objectNoise, 3), (result.bearingNoise, 3)):
            self.assertEqual((n, n), covariance.shape)
        for covariance in (result.poseCovariance, result.poseCovarianceRt):
            self.assertGreater(np.linalg.eigvalsh(covariance).min(), 0)
        R = cv.Rodrigues(np.array(result.rvec))[0]
        np.testing.assert_allclose(-R.T.dot(result.tvec), result.cameraCenter, atol=1e-9)
        # 0.1 along z of the object, 0.02 across
        sigma = np.sqrt(np.diag(result.objectNoise))
        self.assertLess(sigma[0], 0.04)
        self.assertGreater(sigma[2], 0.05)

    def test_params(self):
        points, pixels = self.scene(50, 0.02)
        params = cv.gmlpnp.Params()
        self.assertEqual(cv.gmlpnp.SOLVEPNP_GMLPNP_MARGINAL, params.method)
        params.method = cv.gmlpnp.SOLVEPNP_GMLPNP
        params.objectNoise = np.eye(3) * 4e-4
        params.useExtrinsicGuess = True
        params.rvec = tuple(self.rvec)
        params.tvec = tuple(self.tvec)
        ok, result = cv.gmlpnp.solve(points, pixels, self.K, self.D, params)
        self.assertTrue(ok)
        self.assert_pose(result.rvec, result.tvec, 0.05)
        np.testing.assert_array_equal(params.objectNoise, result.objectNoise)

    def test_cameras(self):
        K, D = self.K, self.D[:4]
        cameras = (cv.gmlpnp.CameraModel.pinhole(K, self.D), cv.gmlpnp.CameraModel.fisheye(K, D),
                   cv.gmlpnp.CameraModel.omnidir(K, D, 1.2), cv.gmlpnp.CameraModel.eucm(K, 0.6, 1.1),
                   cv.gmlpnp.CameraModel.doubleSphere(K, -0.2, 0.6),
                   cv.gmlpnp.CameraModel.equirectangular((1600, 800)))
        points, _ = self.scene()
        seen = points.dot(cv.Rodrigues(self.rvec)[0].T) + self.tvec
        for camera in cameras:
            pixels, valid = camera.project(seen)
            self.assertTrue(valid.all())
            rays, valid, jacobian = camera.unproject(pixels)
            self.assertTrue(valid.all())
            self.assertEqual((len(points), 6), jacobian.shape)
            np.testing.assert_allclose(seen / np.linalg.norm(seen, axis=1, keepdims=True), rays, atol=1e-9)
            for ok, result in (cv.gmlpnp.solve(points, pixels, camera), cv.gmlpnp.solveRays(points, rays)):
                self.assertTrue(ok)
                self.assert_pose(result.rvec, result.tvec)

    def test_batch(self):
        points, pixels = self.scene()
        rays = cv.gmlpnp.CameraModel.pinhole(self.K, self.D).unproject(pixels)[0]
        solved, results = cv.gmlpnp.solveBatch([points, points[:3]], [rays, rays[:3]])
        self.assertEqual(1, solved)
        self.assert_pose(results[0].rvec, results[0].tvec)
        self.assertEqual(cv.gmlpnp.STATUS_TOO_FEW_POINTS, results[1].status)

    def test_ransac(self):
        points, pixels = self.scene(60)
        pixels[:20] = np.random.RandomState(1).uniform(0, 480, (20, 2))
        good = np.arange(20, 60).reshape(-1, 1)
        ok, rvec, tvec, inliers = cv.gmlpnp.solvePnPRansac(points, pixels, self.K, self.D, reprojectionError=3.0)
        self.assertTrue(ok)
        self.assert_pose(rvec, tvec)
        np.testing.assert_array_equal(good, inliers)
        params = cv.UsacParams()
        params.threshold = 3.0
        ok, K, rvec, tvec, inliers = cv.gmlpnp.solvePnPRansac(points, pixels, self.K, self.D, params=params)
        self.assertTrue(ok)
        self.assert_pose(rvec, tvec)
        ransac = cv.gmlpnp.RansacParams()
        ransac.threshold = 0.005
        camera = cv.gmlpnp.CameraModel.pinhole(self.K, self.D)
        rays = camera.unproject(pixels)[0]
        ok, result, inliers = cv.gmlpnp.solveRaysRansac(points, rays, ransac=ransac)
        self.assertTrue(ok)
        self.assert_pose(result.rvec, result.tvec)
        ok, result, inliers = cv.gmlpnp.solveRansac(points, pixels, camera)
        self.assertTrue(ok)
        np.testing.assert_array_equal(good, inliers)

    def test_no_pose_is_no_exception(self):
        line = np.outer(np.arange(10.), [1., 2, 3]) + [0, 0, 5]
        pixels = line[:, :2] / line[:, 2:] * 800 + [320, 240]
        ok, result = cv.gmlpnp.solve(line, pixels, self.K, None)
        self.assertFalse(ok)
        self.assertEqual(cv.gmlpnp.STATUS_DEGENERATE, result.status)

    def test_misuse_is_an_exception(self):
        points, pixels = self.scene()
        with self.assertRaises(cv.error):
            cv.gmlpnp.solvePnP(points, pixels[:-1], self.K, None)
        with self.assertRaises(cv.error):
            cv.gmlpnp.solvePnP(points, pixels, self.K, None, flags=99)


if __name__ == '__main__':
    NewOpenCVTests.bootstrap()

"""solve, solveRays, Params and Result."""

import copy
import math
import pickle
import threading
import unittest

import numpy as np

import gmlpnp
from scenes import D, K, PoseTestCase, in_camera, noisy_scene, object_points, pinhole_pixels

POINTS = object_points()
PIXELS = pinhole_pixels(POINTS, D)
MATRICES = {
    "poseCovariance": 6,
    "poseCovarianceRt": 6,
    "cameraCenterCovariance": 3,
    "objectNoise": 3,
    "bearingNoise": 3,
}


def attributes(struct):
    return [name for name in dir(struct) if not name.startswith("_")]


def same_bits(a, b):
    """Whether all attributes are equal."""

    def equal(x, y):
        return x is None and y is None or np.array_equal(np.asarray(x), np.asarray(y))

    return all(equal(getattr(a, name), getattr(b, name)) for name in attributes(a))


class Solve(PoseTestCase):
    def test_both_overloads_agree(self):
        retval, with_matrix = gmlpnp.solve(POINTS, PIXELS, K, D)
        self.assertIs(retval, True)
        self.assertPose(with_matrix.rvec, with_matrix.tvec)
        retval, with_camera = gmlpnp.solve(POINTS, PIXELS, gmlpnp.CameraModel.pinhole(K, D))
        self.assertIs(retval, True)
        self.assertTrue(same_bits(with_matrix, with_camera))

    def test_keywords(self):
        params = gmlpnp.Params()
        camera = gmlpnp.CameraModel.pinhole(K, D)
        calls = (
            gmlpnp.solve(objectPoints=POINTS, imagePoints=PIXELS, camera=camera, params=params),
            gmlpnp.solve(objectPoints=POINTS, imagePoints=PIXELS, cameraMatrix=K, distCoeffs=D, params=params),
            gmlpnp.solve(POINTS, PIXELS, camera, None),
            gmlpnp.solve(POINTS, PIXELS, K, D, None),
        )
        for retval, result in calls:
            self.assertTrue(retval)
            self.assertTrue(same_bits(result, calls[0][1]))

    def test_rays(self):
        rays = in_camera(POINTS)  # of any length
        retval, result = gmlpnp.solveRays(objectPoints=POINTS, rays=rays, params=gmlpnp.Params())
        self.assertTrue(retval)
        self.assertPose(result.rvec, result.tvec)

    def test_batch(self):
        rays = in_camera(POINTS)
        retval, results = gmlpnp.solveBatch([POINTS, POINTS * [1, 0, 0], POINTS.tolist()], [rays] * 3)
        self.assertEqual(2, retval)
        self.assertEqual(
            [gmlpnp.STATUS_CONVERGED, gmlpnp.STATUS_DEGENERATE, gmlpnp.STATUS_CONVERGED],
            [result.status for result in results],
        )
        for result in (results[0], results[2]):
            self.assertTrue(same_bits(result, gmlpnp.solveRays(POINTS, rays)[1]))
        self.assertEqual(2, gmlpnp.solveBatch(np.stack([POINTS] * 2), np.stack([rays] * 2))[0])
        self.assertEqual((0, ()), gmlpnp.solveBatch([], []))
        with self.assertRaisesRegex(gmlpnp.error, "problem 1.*rays"):
            gmlpnp.solveBatch([POINTS] * 2, [rays, rays[:-1]])

    def test_all(self):
        camera = gmlpnp.CameraModel.pinhole(K, D)
        for arguments in ((POINTS, PIXELS, camera), (POINTS, PIXELS, K, D, gmlpnp.Params())):
            retval, results = gmlpnp.solveAll(*arguments)
            self.assertTrue(isinstance(results, tuple) and retval == len(results) >= 1)
            self.assertPose(results[0].rvec, results[0].tvec)
            self.assertEqual(sorted(result.cost for result in results), [result.cost for result in results])
        self.assertEqual(gmlpnp.solveAll(POINTS * [1, 0, 0], PIXELS, camera), (0, ()))

    def test_covariances_of_points_and_pixels(self):
        points, pixels = noisy_scene()
        per_point = np.tile(np.diag([1e-4, 2e-4, 3e-4]).ravel(), (len(points), 1))
        for options in (
            {"objectCovariances": per_point},
            {"pixelCovariances": np.ones(len(points))},
            {"pixelCovariances": np.tile(np.eye(2).ravel(), (len(points), 1))},
        ):
            retval, result = gmlpnp.solve(points, pixels, K, None, gmlpnp.Params(**options))
            self.assertTrue(retval, options)
            self.assertPose(result.rvec, result.tvec, 0.2)
            with self.assertRaises(gmlpnp.error):
                gmlpnp.solve(points[:-1], pixels[:-1], K, None, gmlpnp.Params(**options))

    def test_wrong_matches_weigh_little(self):
        points, pixels = noisy_scene(100)
        pixels[:5] += 60.0
        retval, result = gmlpnp.solve(points, pixels, K, None)
        self.assertTrue(retval)
        self.assertEqual(result.weights.shape, (100, 1))
        self.assertLess(result.weights[:5].max(), 0.2)
        self.assertGreater(result.tailShare, 0.02)
        self.assertTrue(math.isfinite(result.tailDof))
        _, gaussian = gmlpnp.solve(points, pixels, K, None, gmlpnp.Params(robust=False))
        self.assertEqual(gaussian.tailDof, math.inf)
        self.assertEqual(gaussian.tailShare, 0)

    def test_params_reach_the_solver(self):
        points, pixels = noisy_scene()
        params = gmlpnp.Params(method=gmlpnp.SOLVEPNP_GMLPNP)
        _, published = gmlpnp.solve(points, pixels, K, None, params)
        _, marginal = gmlpnp.solve(points, pixels, K, None)
        self.assertFalse(np.array_equal(published.rvec, marginal.rvec))
        known = np.diag([1e-4, 2e-4, 3e-4])
        _, result = gmlpnp.solve(points, pixels, K, None, gmlpnp.Params(objectNoise=known))
        np.testing.assert_allclose(result.objectNoise, known, rtol=1e-12)
        _, result = gmlpnp.solve(points, pixels, K, None, gmlpnp.Params(maxRounds=1, tolerance=0))
        self.assertEqual((result.status, result.rounds), (gmlpnp.STATUS_MAX_ROUNDS, 1))

    def test_pixels_without_a_ray_are_left_out(self):
        camera = gmlpnp.CameraModel.doubleSphere(K, 0.5, 0.6)
        pixels, valid = camera.project(in_camera(POINTS))
        self.assertTrue(np.all(valid == 255))
        pixels[4] = 1e5, 1e5
        retval, result = gmlpnp.solve(POINTS, pixels, camera)
        self.assertTrue(retval)
        self.assertEqual(result.usedPoints, len(POINTS) - 1)
        self.assertPose(result.rvec, result.tvec)

    def test_failure_has_a_status(self):
        nan = POINTS.copy()
        nan[0, 0] = math.nan
        line = np.outer(np.arange(20.0), [1, 1, 1])
        for points, pixels, status in (
            (nan, PIXELS, gmlpnp.STATUS_NOT_FINITE),
            (line, PIXELS, gmlpnp.STATUS_DEGENERATE),
            (POINTS[:3], PIXELS[:3], gmlpnp.STATUS_TOO_FEW_POINTS),
        ):
            retval, result = gmlpnp.solve(points, pixels, K, D)
            self.assertEqual((retval, result.status), (False, status))

    def test_equal_bits_again_and_from_threads(self):
        points, pixels = noisy_scene(200)
        _, first = gmlpnp.solve(points, pixels, K, D)
        results = []

        def work():
            for _ in range(5):
                results.append(gmlpnp.solve(points, pixels, K, D)[1])

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 20)
        self.assertTrue(all(same_bits(result, first) for result in results))

    def test_other_threads_run_during_a_solve(self):
        """With the GIL held a long solve would stop this thread from counting."""
        points, pixels = noisy_scene(100000)
        counted, done = 0, threading.Event()

        def work():
            gmlpnp.solve(points, pixels, K, None, gmlpnp.Params(tolerance=0))
            done.set()

        thread = threading.Thread(target=work)
        thread.start()
        while not done.wait(0.001):
            counted += 1
        thread.join()
        self.assertGreater(counted, 5)


class ResultOfNoisyData(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        points, pixels = noisy_scene()
        cls.retval, cls.result = gmlpnp.solve(points, pixels, K, None)

    def test_shapes(self):
        self.assertTrue(self.retval)
        for name in ("rvec", "tvec", "cameraCenter"):
            vector = getattr(self.result, name)
            self.assertEqual((vector.shape, vector.dtype), ((3, 1), np.float64), name)
        for name, size in MATRICES.items():
            matrix = getattr(self.result, name)
            self.assertEqual((matrix.shape, matrix.dtype), ((size, size), np.float64), name)
            np.testing.assert_allclose(matrix, matrix.T, rtol=1e-9, atol=1e-15, err_msg=name)

    def test_values_make_sense(self):
        r = self.result
        self.assertIn(r.status, (gmlpnp.STATUS_CONVERGED, gmlpnp.STATUS_MAX_ROUNDS))
        self.assertTrue(math.isfinite(r.cost) and r.rounds > 0)
        self.assertEqual(r.usedPoints, 40)
        self.assertTrue(np.all(np.diag(r.poseCovariance) > 0))

    def test_arrays_are_copies(self):
        before = self.result.rvec
        self.result.rvec[0] = 77.0
        self.result.poseCovariance[:] = 0.0
        np.testing.assert_array_equal(self.result.rvec, before)
        self.assertTrue(np.any(self.result.poseCovariance))

    def test_arrays_outlive_the_result(self):
        points, pixels = noisy_scene()
        rvec, covariance = (lambda r: (r.rvec, r.poseCovariance))(gmlpnp.solve(points, pixels, K, None)[1])
        np.testing.assert_array_equal(rvec, self.result.rvec)
        np.testing.assert_array_equal(covariance, self.result.poseCovariance)

    def test_repr(self):
        text = repr(self.result)
        self.assertRegex(text, r"^Result\(status=STATUS_\w+, .*rvec=\[.*poseCovariance=<6x6>.*usedPoints=40.*\)$")
        self.assertEqual(repr(gmlpnp.solve(POINTS[:2], PIXELS[:2], K, D)[1]), "Result(status=STATUS_TOO_FEW_POINTS)")

    def test_pickle_and_copy(self):
        for twin in (pickle.loads(pickle.dumps(self.result)), copy.copy(self.result), copy.deepcopy(self.result)):
            self.assertTrue(same_bits(twin, self.result))


class ParamsAttributes(unittest.TestCase):
    def test_defaults(self):
        params = gmlpnp.Params()
        self.assertEqual(params.method, gmlpnp.SOLVEPNP_GMLPNP_MARGINAL)
        self.assertEqual((params.maxRounds, params.useExtrinsicGuess), (0, False))
        self.assertIsNone(params.objectNoise)
        np.testing.assert_array_equal(params.rvec, np.zeros((3, 1)))

    def test_keywords_and_attributes(self):
        params = gmlpnp.Params(maxRounds=np.int64(3), tolerance=2, useExtrinsicGuess=np.True_, tvec=(1, 2, 3))
        self.assertEqual((params.maxRounds, params.tolerance, params.useExtrinsicGuess), (3, 2.0, True))
        np.testing.assert_array_equal(params.tvec, [[1.0], [2.0], [3.0]])
        params.objectNoise = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        np.testing.assert_array_equal(params.objectNoise, np.eye(3))
        params.objectNoise = None
        self.assertIsNone(params.objectNoise)

    def test_arrays_are_copied_in(self):
        noise = np.eye(3)
        params = gmlpnp.Params(objectNoise=noise)
        noise[:] = 0.0
        np.testing.assert_array_equal(params.objectNoise, np.eye(3))

    def test_mistakes(self):
        with self.assertRaisesRegex(TypeError, "maxRound"):
            gmlpnp.Params(maxRound=3)
        with self.assertRaises(TypeError):
            gmlpnp.Params(gmlpnp.SOLVEPNP_GMLPNP)
        with self.assertRaises(AttributeError):
            gmlpnp.Params().maxRound = 3
        wrong_types = (("maxRounds", 2.5), ("maxRounds", "3"), ("tolerance", "small"), ("useExtrinsicGuess", None))
        for name, value in wrong_types:
            with self.assertRaisesRegex(TypeError, name):
                gmlpnp.Params(**{name: value})
        for name, value in (("rvec", [1, 2]), ("rvec", None), ("objectNoise", "3x3")):
            with self.assertRaisesRegex(gmlpnp.error, name):
                setattr(gmlpnp.Params(), name, value)

    def test_repr_pickle_copy(self):
        params = gmlpnp.Params(method=gmlpnp.SOLVEPNP_GMLPNP, bearingNoise=np.eye(3))
        self.assertRegex(repr(params), r"^Params\(method=SOLVEPNP_GMLPNP, maxRounds=0, .*bearingNoise=<3x3>.*\)$")
        for twin in (pickle.loads(pickle.dumps(params)), copy.copy(params), copy.deepcopy(params)):
            self.assertTrue(same_bits(twin, params))


if __name__ == "__main__":
    unittest.main()

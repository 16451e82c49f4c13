"""Scenes with a known pose, and comparisons that no NaN passes."""

import unittest

import numpy as np

K = np.array([[500.0, 0.0, 320.0], [0.0, 510.0, 240.0], [0.0, 0.0, 1.0]])
D = np.array([0.1, -0.05, 0.001, -0.002, 0.01])
RVEC = np.array([[0.2], [-0.3], [0.4]])
TVEC = np.array([[0.1], [-0.2], [6.0]])


def rotation(rvec):
    """Rodrigues' formula."""
    x, y, z = np.asarray(rvec, float).ravel()
    angle = np.sqrt(x * x + y * y + z * z)
    hat = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    if angle == 0.0:
        return np.eye(3)
    return np.eye(3) + np.sin(angle) / angle * hat + (1.0 - np.cos(angle)) / angle**2 * hat @ hat


def object_points(count=20, seed=7):
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (count, 3))


def in_camera(points, rvec=RVEC, tvec=TVEC):
    return points @ rotation(rvec).T + np.asarray(tvec).reshape(1, 3)


def pinhole_pixels(points, distortion=()):
    """Pixels of object points seen from (RVEC, TVEC): the formula of OpenCV's documentation."""
    k1, k2, p1, p2, k3 = distortion if len(distortion) else np.zeros(5)
    X = in_camera(points)
    a, b = X[:, 0] / X[:, 2], X[:, 1] / X[:, 2]
    r2 = a * a + b * b
    radial = 1.0 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    x = a * radial + 2.0 * p1 * a * b + p2 * (r2 + 2.0 * a * a)
    y = b * radial + p1 * (r2 + 2.0 * b * b) + 2.0 * p2 * a * b
    return np.column_stack([K[0, 0] * x + K[0, 2], K[1, 1] * y + K[1, 2]])


def noisy_scene(count=40, sigma_px=1.0, seed=11):
    """Object points and their pixels with normal noise."""
    points = object_points(count, seed)
    noise = np.random.default_rng(seed + 1).normal(0.0, sigma_px, (count, 2))
    return points, pinhole_pixels(points) + noise


class PoseTestCase(unittest.TestCase):
    def assertPose(self, rvec, tvec, tolerance=1e-7, expected=(RVEC, TVEC)):
        for name, value, wanted in (("rvec", rvec, expected[0]), ("tvec", tvec, expected[1])):
            error = np.max(np.abs(np.ravel(value) - np.ravel(wanted)))
            self.assertTrue(error < tolerance, f"{name} is {np.ravel(value)}, off by {error}")

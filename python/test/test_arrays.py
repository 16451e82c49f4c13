"""Everything that may be passed as an array gives the same pose."""

import unittest

import numpy as np

import gmlpnp
from scenes import D, K, PoseTestCase, object_points, pinhole_pixels

# Whole numbers, so that integer types and float32 hold them exactly.
POINTS = np.round(object_points() * 20.0)
PIXELS = np.round(pinhole_pixels(POINTS / 20.0))


def layouts(array):
    """The same N x d numbers in every layout."""
    n, d = array.shape
    spread = np.zeros((3 * n, 2 * d), array.dtype)
    spread[::3, ::2] = array
    backwards = np.ascontiguousarray(array[::-1])
    unaligned = np.zeros(array.nbytes + 1, np.uint8)[1:].view(array.dtype).reshape(n, d)
    unaligned[:] = array
    frozen = array.copy()
    frozen.flags.writeable = False
    return {
        "Nxd": array,
        "Nx1xd": array.reshape(n, 1, d),
        "1xNxd": array.reshape(1, n, d),
        "slice": spread[::3, ::2],
        "slice Nx1xd": spread[::3, ::2].reshape(n, 1, d),
        "reversed": backwards[::-1],
        "Fortran": np.asfortranarray(array),
        "transposed": np.ascontiguousarray(array.T).T,
        "unaligned": unaligned,
        "read-only": frozen,
        "big-endian": array.astype(array.dtype.newbyteorder(">")),
        "list": array.tolist(),
        "list of tuples": [tuple(row) for row in array.tolist()],
        "tuple of arrays": tuple(array),
    }


class Layouts(PoseTestCase):
    def setUp(self):
        _, self.rvec, self.tvec = gmlpnp.solvePnP(POINTS, PIXELS, K, D)
        self.assertTrue(np.all(np.isfinite(self.rvec)))

    def assertSame(self, answer):
        retval, rvec, tvec = answer
        self.assertTrue(retval)
        np.testing.assert_array_equal(rvec, self.rvec)
        np.testing.assert_array_equal(tvec, self.tvec)

    def test_every_layout_gives_the_same_bits(self):
        for name, points in layouts(POINTS).items():
            with self.subTest(objectPoints=name):
                self.assertSame(gmlpnp.solvePnP(points, PIXELS, K, D))
        for name, pixels in layouts(PIXELS).items():
            with self.subTest(imagePoints=name):
                self.assertSame(gmlpnp.solvePnP(POINTS, pixels, K, D))

    def test_every_real_type_gives_the_same_bits(self):
        for dtype in "float64 float32 longdouble int64 int32 int16".split():
            with self.subTest(dtype=dtype):
                self.assertSame(gmlpnp.solvePnP(POINTS.astype(dtype), PIXELS.astype(dtype), K.astype(dtype), D))

    def test_forwarded_flags_take_every_layout(self):
        reference = gmlpnp.solvePnP(POINTS, PIXELS, K, D, flags=gmlpnp.SOLVEPNP_ITERATIVE)
        for name, points in layouts(POINTS).items():
            with self.subTest(objectPoints=name):
                answer = gmlpnp.solvePnP(points, PIXELS, K, D, flags=gmlpnp.SOLVEPNP_ITERATIVE)
                np.testing.assert_array_equal(answer[1], reference[1])

    def test_camera_matrix_and_distortion(self):
        for matrix in (K.tolist(), np.asfortranarray(K), K.astype(int)):
            for coefficients in (D, D.tolist(), tuple(D), D.reshape(1, 5), D.reshape(5, 1), np.repeat(D, 2)[::2]):
                self.assertSame(gmlpnp.solvePnP(POINTS, PIXELS, matrix, coefficients))

    def test_no_distortion(self):
        reference = gmlpnp.solvePnP(POINTS, PIXELS, K, np.zeros(5))
        for none in (None, [], (), np.zeros(0), np.zeros((0, 0)), np.zeros(4)):
            np.testing.assert_array_equal(gmlpnp.solvePnP(POINTS, PIXELS, K, none)[1], reference[1])

    def test_arguments_are_not_written(self):
        given = [POINTS.copy(), PIXELS.copy(), K.copy(), D.copy()]
        gmlpnp.solvePnP(*given)
        gmlpnp.solve(*given)
        for after, before in zip(given, (POINTS, PIXELS, K, D)):
            np.testing.assert_array_equal(after, before)

    def test_temporaries_live_long_enough(self):
        for _ in range(50):
            self.assertSame(gmlpnp.solvePnP(POINTS * 1.0, PIXELS * 1.0, K * 1.0, (D * 1.0).tolist()))


if __name__ == "__main__":
    unittest.main()

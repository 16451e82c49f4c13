"""drawPoseUncertainty: where it draws, and what it refuses."""

import unittest

import numpy as np

import gmlpnp
from scenes import K, noisy_scene


@unittest.skipUnless(hasattr(gmlpnp, "drawPoseUncertainty"), "built without opencv_imgproc")
class Draw(unittest.TestCase):
    def setUp(self):
        self.camera = gmlpnp.CameraModel.pinhole(K)
        _, self.result = gmlpnp.solve(*noisy_scene(), self.camera)
        self.origin = self.camera.project(self.result.tvec.reshape(1, 3))[0].ravel().round().astype(int)

    def test_draws_on_the_array_that_is_passed(self):
        for shape in ((480, 640), (480, 640, 3), (480, 640, 4)):
            image = np.zeros(shape, np.uint8)
            self.assertIs(gmlpnp.drawPoseUncertainty(image, self.camera, self.result, 0.5), image)
            u, v = self.origin
            self.assertGreater(image[v - 3 : v + 4, u - 3 : u + 4].max(), 0)

    def test_points(self):
        image, more = np.zeros((480, 640, 3), np.uint8), np.zeros((480, 640, 3), np.uint8)
        gmlpnp.drawPoseUncertainty(image, self.camera, self.result, 0.5)
        gmlpnp.drawPoseUncertainty(more, self.camera, self.result, 0.5, points=[[0.5, 0.5, 0.5]], thickness=3)
        self.assertGreater((more != image).sum(), 0)

    def test_misuse(self):
        image = np.zeros((480, 640, 3), np.uint8)
        for wrong in (image.astype(float), image[:, ::2], image[0, 0], np.zeros((4, 4, 5), np.uint8), [[0]]):
            with self.assertRaisesRegex(gmlpnp.error, "image"):
                gmlpnp.drawPoseUncertainty(wrong, self.camera, self.result, 0.5)
        with self.assertRaisesRegex(gmlpnp.error, "length"):
            gmlpnp.drawPoseUncertainty(image, self.camera, self.result, -1.0)


if __name__ == "__main__":
    unittest.main()

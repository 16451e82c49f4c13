"""As typed_use.py, for the function that only builds with opencv_imgproc have."""

from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import gmlpnp

picture = np.zeros((4, 4, 3), np.uint8)
camera = gmlpnp.CameraModel.equirectangular((4, 4))
assert_type(gmlpnp.drawPoseUncertainty(picture, camera, gmlpnp.Result(), 1.0, thickness=2), NDArray[np.uint8])
gmlpnp.drawPoseUncertainty(np.zeros((4, 4)), camera, gmlpnp.Result(), 1.0)  # type: ignore[arg-type]

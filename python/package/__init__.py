"""Camera pose, noise and uncertainty from object points and pixels, for any lens, without a prior.

    retval, rvec, tvec = gmlpnp.solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs)   # as cv2.solvePnP
    retval, result = gmlpnp.solve(objectPoints, imagePoints, gmlpnp.CameraModel.fisheye(K, D))  # and what it knows

Poses turn object coordinates into camera coordinates, X = R p + t, as everywhere in OpenCV. Lengths are the caller's,
angles are radians, pixel (0, 0) is the centre of the top-left pixel.

Arguments may be numpy arrays of any layout and any real type, lists or tuples; float32 and float64 arrays in C order
are not copied. Data that give no pose return False; misuse raises gmlpnp.error, and a call that does not fit the
signature TypeError. Equal input gives equal output, bit for bit, from any thread; solves run while other Python
threads do.
"""

from . import _gmlpnp, fisheye
from ._gmlpnp import *  # noqa: F401,F403
from ._gmlpnp import __version__  # noqa: F401

__all__ = ["fisheye"] + [name for name in dir(_gmlpnp) if not name.startswith("_")]

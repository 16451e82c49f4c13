"""Read by mypy, never run: the types that users of the package see."""

from typing import Optional, Tuple, Union, assert_type

import numpy as np
from numpy.typing import NDArray

import gmlpnp
import gmlpnp.fisheye

Float64 = NDArray[np.float64]
Float = Union[NDArray[np.float64], NDArray[np.float32]]
Rows = NDArray[np.int32]

camera = gmlpnp.CameraModel.pinhole(np.eye(3), None)
assert_type(camera, gmlpnp.CameraModel)
assert_type(camera.unproject([[0, 0]]), Tuple[Float64, NDArray[np.uint8], Float64])
assert_type(camera.project([[0, 0, 1]]), Tuple[Float64, NDArray[np.uint8]])
assert_type(gmlpnp.CameraModel.equirectangular((1024, 512)), gmlpnp.CameraModel)

params = gmlpnp.Params(method=gmlpnp.SOLVEPNP_GMLPNP, rvec=[0, 0, 1], objectNoise=None)
assert_type(params.maxRounds, int)
assert_type(params.rvec, Float64)
assert_type(params.objectNoise, Optional[Float64])
gmlpnp.Params(rounds=1)  # type: ignore[call-arg]

assert_type(gmlpnp.solve([], [], camera, params), Tuple[bool, gmlpnp.Result])
assert_type(gmlpnp.solve([], [], np.eye(3), None), Tuple[bool, gmlpnp.Result])
gmlpnp.solve([], [])  # type: ignore[call-overload]
count, results = gmlpnp.solveAll([], [], camera)
assert_type(count, int)
assert_type(results, Tuple[gmlpnp.Result, ...])
assert_type(results[0].poseCovariance, Optional[Float64])
assert_type(gmlpnp.solveBatch([np.zeros((4, 3))], [np.zeros((4, 3))]), Tuple[int, Tuple[gmlpnp.Result, ...]])
assert_type(gmlpnp.solveRansac([], [], camera), Tuple[bool, gmlpnp.Result, Optional[Rows]])

assert_type(gmlpnp.solvePnP([], [], np.eye(3), None), Tuple[bool, Optional[Float], Optional[Float]])
assert_type(
    gmlpnp.solvePnPRansac([], [], np.eye(3), None, useExtrinsicGuess=True),
    Tuple[bool, Optional[Float], Optional[Float], Optional[Rows]],
)
assert_type(
    gmlpnp.fisheye.solvePnP([], [], np.eye(3), None, criteria=(3, 10, 1e-8)),
    Tuple[bool, Optional[Float], Optional[Float]],
)
assert_type(gmlpnp.solvePnPRefine([], [], np.eye(3), None, [], []), Tuple[Float, Float])
assert_type(gmlpnp.error().code, int)

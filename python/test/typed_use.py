"""Read by mypy, never run: the types that users of the package see.

A call that must be refused names its error, and mypy reports the names that are not needed.
"""

from typing import Optional, Tuple, Union, assert_type

import numpy as np
from numpy.typing import NDArray

import gmlpnp
import gmlpnp.fisheye

Float64 = NDArray[np.float64]
Vector = Union[NDArray[np.float64], NDArray[np.float32]]
Rows = Optional[NDArray[np.int32]]

points = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 2.0]]
pixels = np.zeros((4, 2))
K = np.eye(3, dtype=np.float32)

camera = gmlpnp.CameraModel.pinhole(K)
assert_type(camera, gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.pinhole(K, D=None), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.fisheye(K, [0.1, 0, 0, 0]), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.omnidir(K, None, 1), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.eucm(K, 0.5, beta=1.0), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.doubleSphere(K, xi=0.5, alpha=1.0), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.equirectangular((640, 320)), gmlpnp.CameraModel)
assert_type(gmlpnp.CameraModel.load("camera.yml", model="fisheye"), gmlpnp.CameraModel)
assert_type(camera.save("camera.yml"), None)
assert_type(camera.unproject(pixels), Tuple[Float64, NDArray[np.uint8], Float64])
assert_type(camera.project(points), Tuple[Float64, NDArray[np.uint8]])

params = gmlpnp.Params(method=gmlpnp.SOLVEPNP_GMLPNP, maxRounds=3, robust=False, rvec=[0, 0, 0], objectNoise=np.eye(3))
ransac = gmlpnp.RansacParams(threshold=4, seed=1, ordered=True)
assert_type(params.method, int)
assert_type(params.tolerance, float)
assert_type(params.robust, bool)
assert_type(params.rvec, Float64)
assert_type(params.objectNoise, Optional[Float64])
assert_type(ransac.threshold, float)
assert_type(gmlpnp.Result().status, int)
assert_type(gmlpnp.Result().tvec, Float64)
assert_type(gmlpnp.Result().poseCovariance, Optional[Float64])
assert_type(gmlpnp.Result().cost, float)
params.maxRounds = 4
params.pixelCovariances = None

assert_type(gmlpnp.solve(points, pixels, camera), Tuple[bool, gmlpnp.Result])
assert_type(gmlpnp.solve(points, pixels, K, None, params=params), Tuple[bool, gmlpnp.Result])
assert_type(gmlpnp.solveAll(points, pixels, camera, None), Tuple[int, Tuple[gmlpnp.Result, ...]])
assert_type(gmlpnp.solveAll(points, pixels, K, None), Tuple[int, Tuple[gmlpnp.Result, ...]])
assert_type(gmlpnp.solveRays(points, points), Tuple[bool, gmlpnp.Result])
assert_type(gmlpnp.solveBatch([points], (points,)), Tuple[int, Tuple[gmlpnp.Result, ...]])
assert_type(gmlpnp.solveRansac(points, pixels, camera, ransac, params), Tuple[bool, gmlpnp.Result, Rows])
assert_type(gmlpnp.solveRansac(points, pixels, K, None, params=params), Tuple[bool, gmlpnp.Result, Rows])
assert_type(gmlpnp.solveRaysRansac(points, points, ransac=None), Tuple[bool, gmlpnp.Result, Rows])

Pose = Tuple[bool, Optional[Vector], Optional[Vector]]
PoseAndRows = Tuple[bool, Optional[Vector], Optional[Vector], Rows]
assert_type(gmlpnp.solvePnP(points, pixels, K, None), Pose)
assert_type(gmlpnp.solvePnP(points, pixels, K, None, [0, 0, 0], None, True, gmlpnp.SOLVEPNP_EPNP), Pose)
assert_type(gmlpnp.solvePnPRansac(points, pixels, K, None, confidence=0.9), PoseAndRows)
poses = gmlpnp.solvePnPGeneric(points, pixels, K, None)
assert_type(poses, Tuple[int, Tuple[Vector, ...], Tuple[Vector, ...], Optional[Float64]])
assert_type(gmlpnp.solvePnPRefine(points, pixels, K, None, [0, 0, 0], [0, 0, 1]), Tuple[Vector, Vector])
assert_type(gmlpnp.solvePnPRefineLM(points, pixels, K, None, K, K, (3, 20, 1e-6)), Tuple[Vector, Vector])
assert_type(gmlpnp.solvePnPRefineVVS(points, pixels, K, None, K, K, VVSlambda=0.5), Tuple[Vector, Vector])
assert_type(gmlpnp.fisheye.solvePnP(points, pixels, K, None, criteria=(3, 10, 1e-8)), Pose)
assert_type(gmlpnp.fisheye.solvePnPRansac(points, pixels, K, None, iterationsCount=9), PoseAndRows)

assert_type(gmlpnp.STATUS_CONVERGED, int)
assert_type(gmlpnp.USAC_MAGSAC, int)
assert_type(gmlpnp.__version__, str)
try:
    gmlpnp.solveRays([], [])
except gmlpnp.error as error:
    assert_type(error.code, int)
    assert_type(error.msg, str)

gmlpnp.solve(points, pixels)  # type: ignore[call-overload]
gmlpnp.solve(points, pixels, camera, ransac)  # type: ignore[call-overload]
gmlpnp.solveRays(points, None)  # type: ignore[arg-type]
gmlpnp.solvePnPRefine(points, pixels, K, None, None, None)  # type: ignore[arg-type]
gmlpnp.Params(method="marginal")  # type: ignore[arg-type]
gmlpnp.Params(rounds=3)  # type: ignore[call-arg]
gmlpnp.Result().covariance  # type: ignore[attr-defined]

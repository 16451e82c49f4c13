"""Types of the module gmlpnp; its docstrings give shapes and units."""

from typing import Iterable, Optional, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import fisheye as fisheye

__version__: str

SOLVEPNP_GMLPNP: int
SOLVEPNP_GMLPNP_MARGINAL: int
SOLVEPNP_ITERATIVE: int
SOLVEPNP_EPNP: int
SOLVEPNP_P3P: int
SOLVEPNP_DLS: int  # OpenCV 4 only
SOLVEPNP_UPNP: int  # OpenCV 4 only
SOLVEPNP_AP3P: int
SOLVEPNP_IPPE: int
SOLVEPNP_IPPE_SQUARE: int
SOLVEPNP_SQPNP: int

USAC_DEFAULT: int
USAC_PARALLEL: int
USAC_FM_8PTS: int
USAC_FAST: int
USAC_ACCURATE: int
USAC_PROSAC: int
USAC_MAGSAC: int

STATUS_CONVERGED: int
STATUS_MAX_ROUNDS: int
STATUS_TOO_FEW_POINTS: int
STATUS_DEGENERATE: int
STATUS_NOT_FINITE: int
STATUS_NO_CONSENSUS: int

NOISE_GIVEN: int
NOISE_ISOTROPIC: int
NOISE_OBJECT: int
NOISE_BEARING: int
NOISE_BOTH: int

_Float64 = NDArray[np.float64]
_Float = Union[NDArray[np.float64], NDArray[np.float32]]
_Rows = NDArray[np.int32]

class error(RuntimeError):
    code: int
    err: str
    func: str
    file: str
    line: int
    msg: str

# Attributes that are arrays take anything numpy makes an array of and give a copy.
class Params:
    def __init__(
        self,
        *,
        method: int = ...,
        maxRounds: int = ...,
        tolerance: float = ...,
        robust: bool = ...,
        useExtrinsicGuess: bool = ...,
        rvec: ArrayLike = ...,
        tvec: ArrayLike = ...,
        objectNoise: Optional[ArrayLike] = ...,
        bearingNoise: Optional[ArrayLike] = ...,
        objectCovariances: Optional[ArrayLike] = ...,
        pixelCovariances: Optional[ArrayLike] = ...,
    ) -> None: ...
    method: int
    maxRounds: int
    tolerance: float
    robust: bool
    useExtrinsicGuess: bool
    rvec: _Float64
    tvec: _Float64
    objectNoise: Optional[_Float64]
    bearingNoise: Optional[_Float64]
    objectCovariances: Optional[_Float64]
    pixelCovariances: Optional[_Float64]

class RansacParams:
    def __init__(
        self,
        *,
        threshold: float = ...,
        confidence: float = ...,
        maxIterations: int = ...,
        seed: int = ...,
        ordered: bool = ...,
    ) -> None: ...
    threshold: float
    confidence: float
    maxIterations: int
    seed: int
    ordered: bool

class Result:
    def __init__(self) -> None: ...
    status: int
    rounds: int
    cost: float
    rvec: _Float64
    tvec: _Float64
    poseCovariance: Optional[_Float64]
    poseCovarianceRt: Optional[_Float64]
    cameraCenter: _Float64
    cameraCenterCovariance: Optional[_Float64]
    objectNoise: Optional[_Float64]
    bearingNoise: Optional[_Float64]
    objectNoiseStdErr: Optional[_Float64]
    bearingNoiseStdErr: Optional[_Float64]
    objectNoiseRank: int
    noiseModel: int
    noiseEvidence: float
    poseEvidence: float
    tailShare: float
    tailDof: float
    weights: Optional[_Float64]
    usedPoints: int

class CameraModel:
    @staticmethod
    def pinhole(K: ArrayLike, D: Optional[ArrayLike] = ...) -> CameraModel: ...
    @staticmethod
    def fisheye(K: ArrayLike, D: Optional[ArrayLike] = ...) -> CameraModel: ...
    @staticmethod
    def omnidir(K: ArrayLike, D: Optional[ArrayLike], xi: float) -> CameraModel: ...
    @staticmethod
    def eucm(K: ArrayLike, alpha: float, beta: float) -> CameraModel: ...
    @staticmethod
    def doubleSphere(K: ArrayLike, xi: float, alpha: float) -> CameraModel: ...
    @staticmethod
    def equirectangular(size: Tuple[int, int]) -> CameraModel: ...
    @staticmethod
    def load(filename: str, model: str = ...) -> CameraModel: ...
    def save(self, filename: str) -> None: ...
    def unproject(self, imagePoints: ArrayLike) -> Tuple[_Float64, NDArray[np.uint8], _Float64]: ...
    def project(self, points: ArrayLike) -> Tuple[_Float64, NDArray[np.uint8]]: ...

@overload
def solve(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    camera: CameraModel,
    params: Optional[Params] = ...,
) -> Tuple[bool, Result]: ...
@overload
def solve(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    params: Optional[Params] = ...,
) -> Tuple[bool, Result]: ...
@overload
def solveAll(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    camera: CameraModel,
    params: Optional[Params] = ...,
) -> Tuple[int, Tuple[Result, ...]]: ...
@overload
def solveAll(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    params: Optional[Params] = ...,
) -> Tuple[int, Tuple[Result, ...]]: ...
def solveRays(
    objectPoints: ArrayLike, rays: ArrayLike, params: Optional[Params] = ...
) -> Tuple[bool, Result]: ...
def solveBatch(
    objectPoints: Iterable[ArrayLike], rays: Iterable[ArrayLike], params: Optional[Params] = ...
) -> Tuple[int, Tuple[Result, ...]]: ...
@overload
def solveRansac(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    camera: CameraModel,
    ransac: Optional[RansacParams] = ...,
    params: Optional[Params] = ...,
) -> Tuple[bool, Result, Optional[_Rows]]: ...
@overload
def solveRansac(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    ransac: Optional[RansacParams] = ...,
    params: Optional[Params] = ...,
) -> Tuple[bool, Result, Optional[_Rows]]: ...
def solveRaysRansac(
    objectPoints: ArrayLike,
    rays: ArrayLike,
    ransac: Optional[RansacParams] = ...,
    params: Optional[Params] = ...,
) -> Tuple[bool, Result, Optional[_Rows]]: ...
def solvePnP(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: Optional[ArrayLike] = ...,
    tvec: Optional[ArrayLike] = ...,
    useExtrinsicGuess: bool = ...,
    flags: int = ...,
) -> Tuple[bool, Optional[_Float], Optional[_Float]]: ...
@overload
def solvePnPRansac(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: Optional[ArrayLike] = ...,
    tvec: Optional[ArrayLike] = ...,
    useExtrinsicGuess: bool = ...,
    iterationsCount: int = ...,
    reprojectionError: float = ...,
    confidence: float = ...,
    inliers: object = ...,
    flags: int = ...,
) -> Tuple[bool, Optional[_Float], Optional[_Float], Optional[_Rows]]: ...
@overload
def solvePnPRansac(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: Optional[ArrayLike] = ...,
    tvec: Optional[ArrayLike] = ...,
    inliers: object = ...,
    params: object = ...,
) -> Tuple[bool, ArrayLike, Optional[_Float], Optional[_Float], Optional[_Rows]]: ...
def solvePnPGeneric(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvecs: object = ...,
    tvecs: object = ...,
    useExtrinsicGuess: bool = ...,
    flags: int = ...,
    rvec: Optional[ArrayLike] = ...,
    tvec: Optional[ArrayLike] = ...,
    reprojectionError: object = ...,
) -> Tuple[int, Tuple[_Float, ...], Tuple[_Float, ...], Optional[_Float64]]: ...
def solvePnPRefine(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: ArrayLike,
    tvec: ArrayLike,
    criteria: Optional[Tuple[int, int, float]] = ...,
) -> Tuple[_Float, _Float]: ...
def solvePnPRefineLM(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: ArrayLike,
    tvec: ArrayLike,
    criteria: Optional[Tuple[int, int, float]] = ...,
) -> Tuple[_Float, _Float]: ...
def solvePnPRefineVVS(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: ArrayLike,
    tvec: ArrayLike,
    criteria: Optional[Tuple[int, int, float]] = ...,
    VVSlambda: float = ...,
) -> Tuple[_Float, _Float]: ...
def drawPoseUncertainty(
    image: NDArray[np.uint8],
    camera: CameraModel,
    result: Result,
    length: float,
    points: Optional[ArrayLike] = ...,
    thickness: int = ...,
) -> NDArray[np.uint8]: ...

"""Types of the module gmlpnp.fisheye; its docstrings give shapes and units."""

from typing import Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Float = Union[NDArray[np.float64], NDArray[np.float32]]

def solvePnP(
    objectPoints: ArrayLike,
    imagePoints: ArrayLike,
    cameraMatrix: ArrayLike,
    distCoeffs: Optional[ArrayLike],
    rvec: Optional[ArrayLike] = ...,
    tvec: Optional[ArrayLike] = ...,
    useExtrinsicGuess: bool = ...,
    flags: int = ...,
    criteria: Optional[Tuple[int, int, float]] = ...,
) -> Tuple[bool, Optional[_Float], Optional[_Float]]: ...
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
    criteria: Optional[Tuple[int, int, float]] = ...,
) -> Tuple[bool, Optional[_Float], Optional[_Float], Optional[NDArray[np.int32]]]: ...

"""The lens of cv2.fisheye: Kannala-Brandt, as in CameraModel.fisheye, on the whole sphere."""

from ._gmlpnp import _fisheye

__all__ = [name for name in dir(_fisheye) if not name.startswith("_")]
globals().update({name: getattr(_fisheye, name) for name in __all__})

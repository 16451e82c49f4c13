from ._gmlpnp import _fisheye

__doc__ = _fisheye.__doc__
__all__ = [name for name in dir(_fisheye) if not name.startswith("_")]
globals().update({name: getattr(_fisheye, name) for name in __all__})

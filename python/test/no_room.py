"""A full disk, for the tests of what is written."""

import contextlib

try:
    import resource
except ImportError:
    resource = None


@contextlib.contextmanager
def no_room_for_files():
    """No file may grow, nor those of programs started meanwhile. Python ignores the signal, so a write is an error."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)

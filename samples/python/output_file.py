# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""Files that come into being as a whole or not at all: common/output_file.hpp for the programs of this folder."""

import contextlib
import os
import shutil


@contextlib.contextmanager
def partial_file(path):
    """Yields the name to write to, which takes its place at the end. After an exception what stood there before still
    does and nothing is left over. Devices and pipes are written to directly; a symbolic link stays one."""
    target = os.path.realpath(path)
    if os.path.exists(target) and not os.path.isfile(target):
        yield target
        return
    stem, extension = os.path.splitext(target)
    partial = f"{stem}.partial{os.getpid()}{extension}"
    try:
        yield partial
        if os.path.exists(target):
            shutil.copymode(target, partial)
        os.replace(partial, target)
    finally:
        with contextlib.suppress(OSError):
            os.remove(partial)


def write_text(path, text):
    """A text file of that kind. Raises OSError naming it where it cannot be written."""
    try:
        with partial_file(path) as name, open(name, "w", newline="", encoding="ascii") as file:
            file.write(text)
    except OSError as error:
        raise OSError(f"{path}: cannot be written ({error.strerror})") from error

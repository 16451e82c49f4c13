#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""Draws what the samples write: the residuals of pose_from_correspondences and omnidir_pose (--residuals=FILE.csv), and
the folders of rgbd_motion, lidar_motion and uav_localization (--output=FOLDER): errors, residuals, maps."""

import argparse
import os
import sys

from output_file import partial_file

FORMATS = (".png", ".svg", ".pdf")


def is_drawable(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.readline().startswith("# kind ")


def data_files(paths):
    """The files named, and those of the folders named that can be drawn."""
    files = []
    for path in paths:
        if not os.path.isdir(path):
            files.append(path)
            continue
        names = sorted(name for name in os.listdir(path) if name.endswith(".csv"))
        drawable = [name for name in names if is_drawable(os.path.join(path, name))]
        if not drawable:
            raise ValueError(f"{path}: holds nothing that can be drawn")
        files += [os.path.join(path, name) for name in drawable]
    return files


def targets(files, output):
    """Where the picture of each file goes."""
    if output and output.lower().endswith(FORMATS):
        if len(files) > 1:
            raise ValueError(f"{output}: is one picture, but there are {len(files)} files to draw; name a folder")
        return [output]
    pictures = []
    for path in files:
        folder, name = os.path.split(os.path.splitext(path)[0])
        pictures.append(os.path.join(output or folder, name + ".png"))
    twice = next((picture for picture in pictures if pictures.count(picture) > 1), None)
    if twice:
        raise ValueError(f"{twice}: two files would be drawn to it")
    if output:
        os.makedirs(output, exist_ok=True)
    return pictures


def write_picture(figure, path):
    """Whole or not at all, and alike for the same data."""
    kind = os.path.splitext(path)[1][1:].lower()
    metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(kind)
    try:
        with partial_file(path) as name, open(name, "wb") as file:
            figure.savefig(file, format=kind, metadata=metadata)
    except OSError as error:
        raise OSError(f"{path}: cannot be written ({error.strerror})") from error


def main(argv=None):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", nargs="+", help="a CSV file of a sample, or a folder: all in it that can be drawn")
    parser.add_argument("-o", "--output", metavar="PATH",
                        help="the picture (.png, .svg or .pdf), or a folder for PNG pictures, which is made; "
                        "without it each picture goes beside its data")
    arguments = parser.parse_args(argv)
    try:
        import pictures  # here, so that --help needs no matplotlib
    except ImportError as error:
        print(f"draw.py: {error}; it needs matplotlib (Debian: python3-matplotlib)", file=sys.stderr)
        return 1
    try:
        files = data_files(arguments.data)
        for path, target in zip(files, targets(files, arguments.output)):
            write_picture(pictures.draw(path), target)
            print(target)
    except (OSError, ValueError) as error:
        print(f"draw.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

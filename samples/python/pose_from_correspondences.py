#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""The camera pose from files of 2D-3D correspondences, by OpenCV's solvers and this module's, with their errors and
times; then what only this module gives: the noise of the data and the uncertainty of the pose."""

import argparse
import os
import statistics
import sys
import time

import numpy as np

import gmlpnp

METHODS = ("EPNP", "ITERATIVE", "SQPNP", "GMLPNP", "GMLPNP_MARGINAL")
HEADER_LENGTHS = {
    "image_size": (2,),
    "dist": (0, 4, 5, 8, 12, 14),
    "true_rvec": (3,),
    "true_tvec": (3,),
    "true_camera_centre": (3,),
    "true_R_world_from_camera": (9,),
}


def rotation_matrix(rvec):
    """Rodrigues' formula."""
    rvec = np.ravel(rvec)
    angle = np.linalg.norm(rvec)
    x, y, z = rvec / angle if angle > 0.0 else rvec
    hat = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * hat + (1.0 - np.cos(angle)) * hat @ hat


class CorrespondenceSet:
    """A file of correspondences; samples/common/correspondences.hpp describes the format."""

    def __init__(self, path):
        self.path = path
        self.name = os.path.splitext(os.path.basename(path))[0]
        self.unit, self.source, self.header = "", [], {}
        self.camera_matrix = None
        rows = []
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                words = line.lstrip("# \t").split()
                try:
                    if line.lstrip().startswith("#"):
                        self._read_header(words)
                    elif words:
                        rows.append(self._numbers(words, (5,)))
                except ValueError as error:
                    raise ValueError(f"{path}:{number}: {error}") from None
        if len(rows) < 4:
            raise ValueError(f"{path}: {len(rows)} points; at least 4 are needed")
        if self.camera_matrix is None:
            raise ValueError(f"{path}: no '# fx fy cx cy' line")
        table = np.array(rows)
        self.object_points, self.image_points = table[:, :3], table[:, 3:]
        self.distortion = np.array(self.header.get("dist", []))
        self.truth = self._truth()

    @staticmethod
    def _numbers(words, counts):
        if len(words) not in counts:
            raise ValueError(f"expected {' or '.join(map(str, counts))} numbers, found {len(words)}")
        values = [float(word) for word in words]
        if not np.all(np.isfinite(values)):
            raise ValueError("a number is not finite")
        return values

    def _read_header(self, words):
        key = words[0] if words else ""
        if words[:4] == ["fx", "fy", "cx", "cy"]:
            fx, fy, cx, cy = self._numbers(words[4:], (4,))
            self.camera_matrix = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
        elif key in HEADER_LENGTHS:
            self.header[key] = self._numbers(words[1:], HEADER_LENGTHS[key])
        elif key == "unit" and len(words) == 2:
            self.unit = words[1]
        elif key == "source":
            self.source.append(" ".join(words[1:]))

    def _truth(self):
        """(R, t), object to camera, or None."""
        if "true_rvec" in self.header and "true_tvec" in self.header:
            return rotation_matrix(self.header["true_rvec"]), np.array(self.header["true_tvec"])
        if "true_camera_centre" in self.header and "true_R_world_from_camera" in self.header:
            R = np.reshape(self.header["true_R_world_from_camera"], (3, 3)).T
            return R, -R @ np.array(self.header["true_camera_centre"])
        return None


def estimate_pose(data, method, repeat):
    """(rvec, tvec, microseconds) as arrays of 3, or None where the method finds nothing.

    The points are taken relative to their centroid: with map coordinates of 1e6 m OpenCV's ITERATIVE is off by
    kilometres; all methods get the same points, so that the table compares estimators and not their rounding.
    """
    flags = getattr(gmlpnp, "SOLVEPNP_" + method)
    centroid = data.object_points.mean(axis=0)
    points = data.object_points - centroid
    times = []
    for _ in range(repeat):
        start = time.thread_time()
        try:
            solved, rvec, tvec = gmlpnp.solvePnP(
                points, data.image_points, data.camera_matrix, data.distortion, flags=flags
            )
        except gmlpnp.error:  # ITERATIVE raises for fewer than six points
            return None
        times.append(1e6 * (time.thread_time() - start))
    if not solved:
        return None
    return rvec.ravel(), tvec.ravel() - rotation_matrix(rvec) @ centroid, statistics.median(times)


def errors(rvec, tvec, truth):
    """The angle between two rotations, degrees, and the distance of the camera centres."""
    R, (true_R, true_t) = rotation_matrix(rvec), truth
    D = R @ true_R.T
    sine = np.linalg.norm([D[2, 1] - D[1, 2], D[0, 2] - D[2, 0], D[1, 0] - D[0, 1]])
    return np.degrees(np.arctan2(sine, np.trace(D) - 1.0)), np.linalg.norm(R.T @ tvec - true_R.T @ true_t)


def print_table(rows):
    """The first row is the title; the first column goes to the left, numbers to the right."""
    widths = [max(len(row[c]) for row in rows if c < len(row)) for c in range(len(rows[0]))]
    for number, row in enumerate(rows):
        cells = [cell.ljust(width) if c == 0 else cell.rjust(width) for c, (cell, width) in enumerate(zip(row, widths))]
        print("  ".join(cells))
        if number == 0:
            print("-" * (sum(widths) + 2 * (len(widths) - 1)))


def triple(values):
    return " ".join(f"{value:+8.3f}" for value in values)


def shown_unit(unit):
    """Metres are shown as centimetres, anything else as it is."""
    return ("cm", 100.0) if unit == "m" else (unit or "units", 1.0)


def print_covariance(covariance, describe):
    """The matrix row by row, beside it the standard deviations along its principal axes, the largest first."""
    values, vectors = np.linalg.eigh(covariance)
    for i, column in enumerate((2, 1, 0)):
        axis = vectors[:, column] * np.sign(vectors[np.argmax(np.abs(vectors[:, column])), column])
        row = " ".join(f"{value:+11.4g}" for value in covariance[i])
        along = " ".join(f"{value:+.2f}" for value in axis)
        print(f"    {row}     {describe(np.sqrt(max(0.0, values[column])))}  along ({along})")


def print_noise(result, data):
    """What solve() knows beside the pose."""
    unit, per_file_unit = shown_unit(data.unit)
    focal_length = data.camera_matrix[0, 0]
    print(f"  Sigma, noise of the points, object frame [{unit}^2], and its principal standard deviations")
    print_covariance(result.objectNoise * per_file_unit**2, lambda deviation: f"{deviation:9.4f} {unit}")
    print("  Gamma, noise of the bearings, camera frame [mrad^2], and its principal standard deviations")
    print_covariance(
        result.bearingNoise * 1e6,
        lambda deviation: f"{deviation:9.4f} mrad = {1e-3 * deviation * focal_length:.3f} px",
    )
    print("  Standard deviations of the pose")
    if result.poseCovariance is None:
        print("    unknown: no residuals are left to judge it by")
        return
    rotation = np.degrees(np.sqrt(np.diag(result.poseCovariance)[:3]))
    position = np.sqrt(np.diag(result.cameraCenterCovariance)) * per_file_unit
    for name, values in (
        ("rotation about the camera's x, y, z [deg]", rotation),
        (f"position along the object's x, y, z [{unit}]", position),
    ):
        print(f"    {name:<44} " + " ".join(f"{value:9.4f}" for value in values))


def report(data, methods, repeat, brief):
    """Prints one file's answers; returns, per method, rotation error [deg], position error [shown unit] and time."""
    unit, per_file_unit = shown_unit(data.unit)
    print(f"{data.name}: {len(data.object_points)} points")
    if not brief:
        print("".join(f"  {line}\n" for line in data.source))
    rows = [("method", "rvec [deg]", f"tvec [{unit}]", "rotation error [deg]", f"position error [{unit}]", "time [us]")]
    figures = {}
    for method in methods:
        estimate = estimate_pose(data, method, repeat)
        if estimate is None:
            rows.append((method, "not solved"))
            continue
        rvec, tvec, microseconds = estimate
        row = [method, triple(np.degrees(rvec)), triple(tvec * per_file_unit)]
        if data.truth:
            rotation, position = errors(rvec, tvec, data.truth)
            figures[method] = (rotation, position * per_file_unit, microseconds)
            row += [f"{rotation:.4f}", f"{position * per_file_unit:.4f}"]
        else:
            row += ["-", "-"]
        rows.append((*row, f"{microseconds:.0f}"))
    print_table(rows)

    if not brief and methods[-1].startswith("GMLPNP"):
        params = gmlpnp.Params(method=getattr(gmlpnp, "SOLVEPNP_" + methods[-1]))
        solved, result = gmlpnp.solve(
            data.object_points, data.image_points, data.camera_matrix, data.distortion, params
        )
        if not solved:
            raise ValueError(f"{data.path}: no pose by {methods[-1]}: {result}")
        print(f"\n{methods[-1]} also gives")
        print_noise(result, data)
    return figures


def print_summary(all_figures, unit):
    """Mean errors per method over the files with truth."""
    rows = [
        ("mean over the files", "files", "rotation error [deg]", f"position error [{shown_unit(unit)[0]}]", "time [us]")
    ]
    for method in METHODS:
        figures = [f[method] for f in all_figures if method in f]
        if figures:
            rotation, position, microseconds = np.mean(figures, axis=0)
            rows.append((method, str(len(figures)), f"{rotation:.4f}", f"{position:.4f}", f"{microseconds:.0f}"))
    print()
    print_table(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+", help="correspondence files (format: samples/common/correspondences.hpp)")
    parser.add_argument("--method", choices=METHODS, help="only this one")
    parser.add_argument("--repeat", type=int, default=21, help="calls per method and file; the time is their median")
    parser.add_argument("--brief", action="store_true", help="tables only: no noise, no uncertainty")
    arguments = parser.parse_args()
    if arguments.repeat < 1:
        parser.error("--repeat must be positive")
    methods = (arguments.method,) if arguments.method else METHODS
    try:
        all_figures, unit = [], None
        for path in arguments.files:
            if unit is not None:
                print()
            data = CorrespondenceSet(path)
            unit = data.unit if unit is None else unit
            figures = report(data, methods, arguments.repeat, arguments.brief)
            all_figures.append(figures if data.unit == unit else {})  # means of metres and feet mean nothing
        if len(arguments.files) > 1:
            print_summary(all_figures, unit)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

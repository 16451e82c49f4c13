"""Where aerial photographs were taken, by SQPNP and by gmlpnp, with 95 % ellipses: positions.py FOLDER PICTURE

Each photograph of FOLDER is found on the map by each other one, whose pixels an elevation model lifts to the ground;
features, matches and the rejection of wrong ones are those of samples/uav_localization. FOLDER holds dem.tif, the
photographs *_RGB.tif and their true poses *_xyz_opk.csv (filename, x, y, z, omega, phi, kappa). PYTHONPATH must name
the package gmlpnp; Debian has the other modules as python3-opencv, python3-matplotlib and python3-gdal.
"""

import csv
import itertools
import pathlib
import sys

import cv2
import gmlpnp
import numpy as np
from osgeo import gdal

from panels import plt
from figure_style import BLUE, ORANGE, ellipse

gdal.UseExceptions()

K = np.array([[833.333333, 0, 319.5], [0, 833.333333, 575.5], [0, 0, 1]])  # no distortion
FEATURES, RATIO, RANSAC_PIXELS, FEWEST = 8000, 0.8, 8, 10
SIFT_SHIFT = 0.25  # px, of all points that cv2.SIFT finds: see samples/common/pixel_matches.cpp
LIFTINGS = 60  # half the way to the ground below in each, which does not swing on slopes that face the camera
INSIDE = 5.991  # chi square of two degrees of freedom, 95 %
REACH = 60  # m, of the picture to either side of the truth


def rotation(axis, degrees):
    return cv2.Rodrigues(np.radians(degrees) * np.eye(3)[axis])[0]


class Terrain:
    def __init__(self, path):
        dataset = gdal.Open(str(path))
        self.x, self.dx, _, self.y, _, self.dy = dataset.GetGeoTransform()
        self.elevations = dataset.ReadAsArray().astype(float)

    def elevation(self, places):
        """Bilinear between the cells' centres; NaN where a place is not on the map."""
        column, row = (places[:, 0] - self.x) / self.dx - 0.5, (places[:, 1] - self.y) / self.dy - 0.5
        height, width = self.elevations.shape
        inside = (column >= 0) & (row >= 0) & (column <= width - 1) & (row <= height - 1)
        i = np.where(inside, row, 0).astype(int).clip(0, height - 2)
        j = np.where(inside, column, 0).astype(int).clip(0, width - 2)
        a, b, z = column - j, row - i, self.elevations
        return np.where(inside, (1 - b) * ((1 - a) * z[i, j] + a * z[i, j + 1]) +
                        b * ((1 - a) * z[i + 1, j] + a * z[i + 1, j + 1]), np.nan)


class Photograph:
    def __init__(self, path, pose):
        self.centre = np.array([float(pose[key]) for key in "xyz"])
        turns = [rotation(axis, float(pose[key])) for axis, key in enumerate(("omega", "phi", "kappa"))]
        self.map_from_camera = turns[0] @ turns[1] @ turns[2] @ np.diag([1.0, -1.0, -1.0])
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        keypoints, self.descriptors = cv2.SIFT_create(FEATURES).detectAndCompute(grey, None)
        self.pixels = cv2.KeyPoint_convert(keypoints).astype(float) - SIFT_SHIFT

    def lift(self, pixels, terrain):
        """The places of the ground that pixels show; NaN where the terrain ends."""
        rays = np.c_[pixels, np.ones(len(pixels))] @ np.linalg.inv(K).T @ self.map_from_camera.T
        elevation = np.full(len(pixels), np.nanmean(terrain.elevations))
        for _ in range(LIFTINGS):
            ground = self.centre + rays * ((elevation - self.centre[2]) / rays[:, 2])[:, None]
            elevation = 0.5 * (elevation + terrain.elevation(ground))
        return ground


def correspondences(query, reference, terrain):
    """Places relative to the true position of the query, and their pixels in it; none where fewer than FEWEST agree."""
    nearest = cv2.BFMatcher(cv2.NORM_L2).knnMatch(query.descriptors, reference.descriptors, 2)
    good = [first for first, second in nearest if first.distance < RATIO * second.distance]
    ground = reference.lift(reference.pixels[[match.trainIdx for match in good]], terrain)
    pixels = query.pixels[[match.queryIdx for match in good]]
    known = np.isfinite(ground[:, 2])
    ground, pixels = ground[known] - query.centre, pixels[known]
    cv2.setRNGSeed(1)
    _, _, _, agreeing = cv2.solvePnPRansac(ground - ground.mean(0), pixels, K, None, iterationsCount=1000,
                                           reprojectionError=RANSAC_PIXELS, confidence=0.999, flags=cv2.SOLVEPNP_EPNP)
    agreeing = [] if agreeing is None or len(agreeing) < FEWEST else agreeing.ravel()
    return ground[agreeing], pixels[agreeing]


def by_sqpnp(ground, pixels):
    """The position and its covariance as least squares has it, s^2 (J^T J)^-1 with s^2 = e^T e / (2 n - 6)."""
    _, rvec, tvec = cv2.solvePnP(ground, pixels, K, None, flags=cv2.SOLVEPNP_SQPNP)
    projected, J = cv2.projectPoints(ground, rvec, tvec, K, None)
    e, J = (projected[:, 0] - pixels).ravel(), J[:, :6]
    pose = np.linalg.inv(J.T @ J) * (e @ e) / (len(e) - 6)
    R, by_rvec = cv2.Rodrigues(rvec)
    centre = np.c_[[-(row.reshape(3, 3).T @ tvec).ravel() for row in by_rvec]].T  # derivative of -R^T t by rvec
    centre = np.c_[centre, -R.T]
    return (-R.T @ tvec).ravel(), centre @ pose @ centre.T


def by_gmlpnp(ground, pixels):
    found, result = gmlpnp.solve(ground, pixels, K, None)
    assert found, result.status
    return result.cameraCenter.ravel(), result.cameraCenterCovariance


def localize(folder):
    """What draw() shows: the ground that was matched, the true positions, and of each pair errors and covariances."""
    terrain = Terrain(folder / "dem.tif")
    with open(next(folder.glob("*_xyz_opk.csv")), newline="") as file:
        poses = {row["filename"]: row for row in csv.DictReader(file)}
    photographs = [Photograph(path, poses[path.stem]) for path in sorted(folder.glob("*_RGB.tif"))]
    places, pairs = [], []
    for query, reference in itertools.permutations(photographs, 2):
        ground, pixels = correspondences(query, reference, terrain)
        if len(ground) > 0:
            places.append(ground + query.centre)
            pairs.append({"SQPNP": by_sqpnp(ground, pixels), "gmlpnp": by_gmlpnp(ground, pixels)})
    return np.concatenate(places), np.array([photograph.centre for photograph in photographs]), pairs


def holds_truth(error, C):
    """Whether the 95 % ellipse on the map does."""
    return error[:2] @ np.linalg.solve(C[:2, :2], error[:2]) < INSIDE


def draw_map(ax, places, centres):
    corner = places.min(0)
    km = lambda points: ((points - corner) / 1000).T
    ground = ax.scatter(*km(places)[:2], c=places[:, 2], s=2, cmap="viridis", linewidths=0, rasterized=True)
    ax.scatter(*km(centres)[:2], marker="^", s=55, color="white", edgecolor="black", zorder=3)
    ax.set_aspect("equal")
    ax.set_xlabel("east [km]")
    ax.set_ylabel("north [km]")
    ax.set_title("matched places\nand true cameras (△)")
    ax.figure.colorbar(ground, ax=ax, label="elevation [m]", fraction=0.08, pad=0.04)


def draw_positions(ax, estimates, title, colour):
    for error, C in estimates:
        shape = ellipse(C[:2, :2], edgecolor=colour, linewidth=1.3, linestyle="-" if holds_truth(error, C) else "--")
        shape.set_center(error[:2])
        ax.add_patch(shape)
        area = ellipse(C[:2, :2], linewidth=0)
        area.set(center=error[:2], fill=True, facecolor=colour, alpha=0.07)
        ax.add_patch(area)
        ax.plot(*error[:2], "o", color=colour, markersize=3.5)
    ax.plot(0, 0, "+", color="black", markersize=13, markeredgewidth=1.6, zorder=5)
    ax.set_xlim(-REACH, REACH)
    ax.set_ylim(-REACH, REACH)
    ax.set_aspect("equal")
    ax.set_xlabel("east of the true position [m]")
    mean = np.mean([np.linalg.norm(error) for error, _ in estimates])
    held = sum(holds_truth(error, C) for error, C in estimates)
    ax.set_title(f"mean error {mean:.1f} m; {held} of {len(estimates)} ellipses hold the truth")
    ax.text(0.5, 1.1, title, transform=ax.transAxes, color=colour, fontsize=12, fontweight="bold", ha="center")


def draw(places, centres, pairs):
    fig, axes = plt.subplots(1, 3, figsize=(12, 4.6), gridspec_kw={"width_ratios": (0.8, 1, 1)})
    draw_map(axes[0], places, centres)
    draw_positions(axes[1], [pair["SQPNP"] for pair in pairs], "cv::SOLVEPNP_SQPNP", BLUE)
    draw_positions(axes[2], [pair["gmlpnp"] for pair in pairs], "cv::gmlpnp::solve", ORANGE)
    axes[1].set_ylabel("north of the true position [m]")
    fig.tight_layout(rect=(0, 0, 1, 0.97))
    return fig


def report(pairs):
    for method in ("SQPNP", "gmlpnp"):
        lengths = [np.linalg.norm(pair[method][0]) for pair in pairs]
        print(f"{method}: {len(pairs)} pairs, position error mean {np.mean(lengths):.2f} m, median "
              f"{np.median(lengths):.2f} m; {sum(holds_truth(*pair[method]) for pair in pairs)} ellipses hold it")
    area = lambda C: np.sqrt(np.linalg.det(C[:2, :2]))
    ratios = [area(pair["gmlpnp"][1]) / area(pair["SQPNP"][1]) for pair in pairs]
    print(f"ratio of the areas: median {np.median(ratios):.2f}, {min(ratios):.2f} to {max(ratios):.2f}")


def main(folder, picture):
    places, centres, pairs = localize(pathlib.Path(folder))
    report(pairs)
    draw(places, centres, pairs).savefig(picture, dpi=100, metadata={"Software": None})


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])

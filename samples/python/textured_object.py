#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html

"""A textured box found in every frame of a video: OpenCV's real_time_pose_estimation with our RANSAC, and with how sure
each pose is. The twin of samples/textured_object.cpp."""

import argparse
import contextlib
import csv
import io
import os
import statistics
import sys
import time

import cv2
import numpy as np

import gmlpnp
from output_file import partial_file, write_text

COLUMNS = "frame found matches inliers ms rx ry rz tx_cm ty_cm tz_cm cx_cm cy_cm cz_cm camera_sd_cm".split()
BLUE, ORANGE, WHITE = (178, 114, 0), (0, 94, 213), (255, 255, 255)


class Model:
    """Points [cm] with ORB descriptors, and the corners of the mesh."""

    def __init__(self, folder):
        path = os.path.join(folder, "cookies_ORB.yml")
        if not os.path.exists(path):
            raise ValueError(f"{path}: cannot be opened")
        file = cv2.FileStorage(path, cv2.FILE_STORAGE_READ)
        self.points = file.getNode("points_3d").mat().reshape(-1, 3).astype(float)
        self.descriptors = file.getNode("descriptors").mat()
        self.corners = self.read_corners(os.path.join(folder, "box.ply"))

    @staticmethod
    def read_corners(path):
        with open(path, encoding="ascii") as file:
            header, _, body = file.read().partition("end_header\n")
        count = int(header.partition("element vertex ")[2].split()[0])
        return np.array([line.split() for line in body.splitlines()[:count]], float)


def camera_of(path):
    """55 mm on a sensor of 22.3 x 14.9 mm, 640 x 480 px, is what OpenCV's program takes."""
    if path:
        return gmlpnp.CameraModel.load(path)
    return gmlpnp.CameraModel.pinhole([[640 * 55 / 22.3, 0, 320], [0, 480 * 55 / 14.9, 240], [0, 0, 1]])


def match(frame, detector, matcher, model, ratio):
    """Object points and pixels, clearest first, which is where RANSAC then looks first."""
    keypoints, descriptors = detector.detectAndCompute(frame, None)
    pairs = matcher.knnMatch(descriptors, model.descriptors, 2) if descriptors is not None else ()
    clear = [(a.distance / b.distance, a) for a, b in pairs if a.distance < ratio * b.distance]
    clear.sort(key=lambda item: item[0])
    points = model.points[[item.trainIdx for _, item in clear]]
    pixels = np.array([keypoints[item.queryIdx].pt for _, item in clear]).reshape(-1, 2)
    return points, pixels


def camera_deviation(result):
    """Largest standard deviation of the camera's centre."""
    return float(np.sqrt(np.linalg.eigvalsh(result.cameraCenterCovariance)[-1]))


def draw(frame, pixels, inliers, camera, result, model):
    for u, v in pixels:
        cv2.circle(frame, (int(u), int(v)), 2, ORANGE, -1, cv2.LINE_AA)
    text = "no pose"
    if inliers is not None:
        for u, v in pixels[inliers.ravel()]:
            cv2.circle(frame, (int(u), int(v)), 2, BLUE, -1, cv2.LINE_AA)
        gmlpnp.drawPoseUncertainty(frame, camera, result, 10.0, model.corners, 2)
        text = f"{len(inliers)} of {len(pixels)} matches; camera +-{camera_deviation(result):.2f} cm"
    cv2.putText(frame, text, (10, 24), cv2.FONT_HERSHEY_SIMPLEX, 0.6, WHITE, 2, cv2.LINE_AA)


@contextlib.contextmanager
def video_file(path):
    """Yields a function that adds a frame. In the end the video has them all, or there is none."""
    if not path:
        yield lambda frame: None
        return
    out, frames = cv2.VideoWriter(), 0
    with partial_file(path) as name:

        def add(frame):
            nonlocal frames
            if not out.isOpened() and not out.open(name, cv2.VideoWriter_fourcc(*"MJPG"), 30, frame.shape[1::-1]):
                raise OSError(f"{path}: cannot be written")
            out.write(frame)
            frames += 1

        yield add
        out.release()
        # It does not say whether the disk was full, so the video is looked at.
        if cv2.VideoCapture(name).get(cv2.CAP_PROP_FRAME_COUNT) != frames:
            raise OSError(f"{path}: cannot be written")


def write_csv(path, rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([COLUMNS] + rows)
    write_text(path, text.getvalue())


def track(options, add_to_video):
    """The rows of all frames."""
    model, camera = Model(options.data), camera_of(options.camera)
    detector, matcher = cv2.ORB_create(options.features), cv2.BFMatcher(cv2.NORM_HAMMING)
    source = os.path.join(options.data, "box.mp4")
    video, params = cv2.VideoCapture(source), gmlpnp.Params()
    if not video.isOpened():
        raise ValueError(f"{source}: cannot be opened as a video")
    ransac = gmlpnp.RansacParams(threshold=options.threshold, ordered=True)
    rows = []
    while not options.frames or len(rows) < options.frames:
        good, frame = video.read()
        if not good:
            break
        points, pixels = match(frame, detector, matcher, model, options.ratio)
        start, found, inliers, result = time.perf_counter(), False, None, None
        if len(points) >= 4:
            found, result, inliers = gmlpnp.solveRansac(points, pixels, camera, ransac, params)
        row = [len(rows), int(found), len(points), len(inliers) if found else 0]
        row.append(f"{1e3 * (time.perf_counter() - start):.3f}")
        params.useExtrinsicGuess = found
        if found:
            params.rvec, params.tvec = result.rvec, result.tvec
            vectors = np.concatenate([result.rvec, result.tvec, result.cameraCenter]).ravel()
            row += [f"{x:.6f}" for x in (*vectors, camera_deviation(result))]
        rows.append(row + [""] * (len(COLUMNS) - len(row)))
        draw(frame, pixels, inliers, camera, result, model)
        add_to_video(frame)
        if options.show:
            cv2.imshow("textured_object", frame)
            if cv2.waitKey(1) >= 0:
                break
        if len(rows) % 50 == 0:
            print(f"frame {len(rows)}, {sum(r[1] for r in rows)} poses", file=sys.stderr)
    if not rows:
        raise ValueError(f"{source}: has no frame")
    return rows


def run(options):
    with video_file(options.video) as add_to_video:
        rows = track(options, add_to_video)
        write_csv(options.csv, rows)
    poses = [row for row in rows if row[1]]
    if poses:
        inliers, times = statistics.median(row[3] for row in poses), statistics.median(float(row[4]) for row in rows)
        print(f"{len(poses)} poses in {len(rows)} frames; medians: {inliers:.0f} inliers, {times:.2f} ms for a pose")
    else:
        print(f"0 poses in {len(rows)} frames")
    print(f"Poses: {options.csv}" + (f"; video: {options.video}" if options.video else ""))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("data", help="folder Data of OpenCV's real_time_pose_estimation, in its tutorial_code/calib3d")
    parser.add_argument("--camera", help="calibration file; none: that of OpenCV's program")
    parser.add_argument("--features", type=int, default=2000, help="ORB features per frame")
    parser.add_argument("--ratio", type=float, default=0.8, help="largest distance of a match over the next best's")
    parser.add_argument("--threshold", type=float, default=6.0, help="largest reprojection error of an inlier, px")
    parser.add_argument("--frames", type=int, default=0, help="frames to read; 0: all")
    parser.add_argument("--csv", default="textured_object.csv", help="write the poses to this file")
    parser.add_argument("--video", default="textured_object.avi", help="write the drawn frames to this video")
    parser.add_argument("--show", action="store_true", help="show the frames in a window; any key ends")
    try:
        run(parser.parse_args())
    except (ValueError, OSError, gmlpnp.error) as error:
        print(f"textured_object.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

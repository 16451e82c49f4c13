"""Runs a program of OpenCV and its twin that calls cv::gmlpnp instead, and compares the poses they log.

    compare_poses.py <rad> <relative> <their program> <our program> [arguments of ours...]

Half of the calls must differ by no more than <rad> in rotation and <relative> in translation, and ours must find a pose
as often.
"""

import math
import os
import subprocess
import sys
import tempfile


def poses(command):
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "poses.txt")
        subprocess.run(command, env=dict(os.environ, POSE_LOG=log), check=True, stdout=subprocess.DEVNULL)
        with open(log) as lines:
            return [[float(word) for word in line.split()] for line in lines]


def quaternion(rvec):
    angle = math.sqrt(sum(x * x for x in rvec))
    scale = math.sin(angle / 2) / angle if angle > 0 else 0.5
    return [math.cos(angle / 2)] + [scale * x for x in rvec]


def rotation_between(a, b):
    dot = abs(sum(x * y for x, y in zip(quaternion(a), quaternion(b))))
    return 2 * math.acos(min(1.0, dot))


def median(values):
    return sorted(values)[(len(values) - 1) // 2]


def main():
    angle, relative = float(sys.argv[1]), float(sys.argv[2])
    theirs, ours = poses(sys.argv[3:4]), poses(sys.argv[4:])
    found = [sum(pose[0] for pose in log) for log in (theirs, ours)]
    both = [(a, b) for a, b in zip(theirs, ours) if a[0] and b[0]]
    print("calls: %d and %d; poses: %d and %d" % (len(theirs), len(ours), found[0], found[1]))
    if len(theirs) != len(ours) or not both or found[1] < found[0]:
        sys.exit("the programs differ in calls or in poses found")
    angles = [rotation_between(a[1:4], b[1:4]) for a, b in both]
    distances = [math.dist(a[4:], b[4:]) / math.dist(a[4:], (0, 0, 0)) for a, b in both]
    print("rotation: median %.2g rad, largest %.2g; translation: median %.2g, largest %.2g of its length"
          % (median(angles), max(angles), median(distances), max(distances)))
    if not (median(angles) <= angle and median(distances) <= relative):
        sys.exit("poses differ by more than %g rad, %g of the translation" % (angle, relative))


main()

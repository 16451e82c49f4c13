#!/usr/bin/env python

'''
The program of the tutorial in Python: a pose by cv.solvePnP, by its replacement, with its uncertainty, and from a wide lens.
'''

import numpy as np
import cv2 as cv

rng = np.random.default_rng(1)
true_rvec = np.array([0.3, -0.4, 0.5])
true_tvec = np.array([0.1, -0.2, 6.0])
K = np.array([[800., 0, 320], [0, 800, 240], [0, 0, 1]])
D = np.array([-0.1, 0.01, 0.001, -0.001])

object_points = rng.uniform(-2, 2, (100, 3))
image_points, _ = cv.projectPoints(object_points, true_rvec, true_tvec, K, D)
object_points += rng.normal(0, [0.02, 0.02, 0.1], (100, 3))

## [before]
ok, rvec, tvec = cv.solvePnP(object_points, image_points, K, D)
## [before]
print('cv.solvePnP:        t =', tvec.ravel())

## [after]
ok, rvec, tvec = cv.gmlpnp.solvePnP(object_points, image_points, K, D)
## [after]
print('cv.gmlpnp.solvePnP: t =', tvec.ravel())

## [solve]
ok, result = cv.gmlpnp.solve(object_points, image_points, K, D)
## [solve]
assert ok and np.linalg.norm(np.array(result.tvec) - true_tvec) < 0.05

## [uncertainty]
sigmas = np.sqrt(np.diag(result.poseCovarianceRt))
print('t =', result.tvec, '+-', sigmas[3:])
## [uncertainty]

## [noise]
print('Covariance of the object points:', result.objectNoise, sep='\n')
print('Covariance of the rays:', result.bearingNoise, sep='\n')
## [noise]

## [camera]
camera = cv.gmlpnp.CameraModel.fisheye(np.array([[300., 0, 640], [0, 300, 480], [0, 0, 1]]))
## [camera]

# A camera in the middle of the points: some are beside it, some behind it. This lens sees the whole sphere.
points = rng.uniform(-2, 2, (100, 3))
inside = np.array([0.1, -0.2, 0.3])
camera_points = points @ cv.Rodrigues(true_rvec)[0].T + inside
pixels, visible = camera.project(camera_points)
assert visible.all()

## [wide]
ok, result = cv.gmlpnp.solve(points, pixels, camera)
## [wide]
print('Fisheye,', result.usedPoints, 'points: t =', result.tvec)
assert ok and np.linalg.norm(np.array(result.tvec) - inside) < 1e-6

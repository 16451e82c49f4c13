// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_PROBLEM_HPP
#define GMLPNP_RELIABILITY_PROBLEM_HPP

#include <string>

#include "test/synthetic.hpp"

namespace reliability {

using synthetic::Matrix3d;
using synthetic::Pose;
using synthetic::Vector3d;

/** What the points are; of size 1 before scale and offset. */
enum class Shape
{
    SOLID,        //!< a cube before the camera
    FLAT,         //!< a square
    NEARLY_FLAT,  //!< a slab, 1e-9 to 0.1 thick
    LINE,         //!< on one line
    NEARLY_LINE,  //!< a rod, 1e-9 to 0.1 thick
    REPEATED,     //!< a cube's points, each several times; down to one place
    BEHIND,       //!< a cube, some or all of its points behind the camera, where a pinhole mirrors them
    AROUND,       //!< rays of all directions; no pixels
    UNRELATED     //!< pixels that have nothing to do with the points
};
constexpr int SHAPES = 9;

enum class Guess
{
    NONE,
    NEAR,   //!< the truth, 0.1 rad and a tenth of the distance off
    WRONG,  //!< any rotation, any distance
    NOT_FINITE
};

/** A problem as a caller has it, and how it came about. Lengths of the second part are in sizes of the object. */
struct Problem
{
    cv::Mat_<double> points, rays, pixels;  //!< Nx3, Nx3, Nx2 of synthetic::paperCamera(); no pixels: empty
    cv::Vec3d rvec, tvec;                   //!< the guess
    Pose truth;
    Vector3d centre = Vector3d::Zero();  //!< of the object

    Shape shape = Shape::SOLID;
    Guess guess = Guess::NONE;
    int n = 0;
    int places = 0;          //!< distinct ones among the points, before noise
    double scale = 1;        //!< size of the object, the caller's length: 1e-6 to 1e9
    double offset = 0;       //!< of its centre from the origin: 0, or 1 to 1e8
    double thickness = 1;    //!< of a slab or rod
    double distance = 0;     //!< of the camera from its centre
    double objectNoise = 0;  //!< largest standard deviation
    double rayNoise = 0;     //!< standard deviation, rad
    double outliers = 0;     //!< share of rays that point anywhere
    bool corrupt = false;    //!< one number is NaN, infinite, huge or denormal

    //! Of the information matrix of the pose at the truth, scaled to a unit diagonal.
    double condition = 0;
    //! Cramer-Rao bounds at the truth: largest standard deviations of the rotation, rad, and of the object's centre,
    //! in distances.
    double rotationDeviation = 0, centreDeviation = 0;

    bool hasGuess() const { return guess != Guess::NONE; }
    /** n >= 6 at four places or more (three have several exact poses), condition at most 1e6, deviations at most 0.05;
    no outliers, nothing behind the camera; a guess, if there is one, is near. */
    bool solvable() const;
};

/** The same problem for the same numbers, on any machine. */
Problem randomProblem(int seed, int index);

std::string nameOf(Shape shape);
std::string nameOf(Guess guess);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_PROBLEM_HPP

// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/photographs.hpp"

#include <filesystem>
#include <stdexcept>

namespace samples {

std::string required(const Arguments& arguments, const std::string& name)
{
    std::string value = arguments.get<std::string>(name);
    if (value.empty())
        throw std::runtime_error("--" + name + " is needed");
    return value;
}

std::map<std::string, Pose> orientationsOf(const Arguments& arguments)
{
    const std::string path = arguments.get<std::string>("poses");
    return path.empty() ? std::map<std::string, Pose>() : readOrientations(path);
}

const Pose& poseOf(const std::string& picture, const std::map<std::string, Pose>& poses)
{
    const auto pose = poses.find(pictureName(picture));
    if (pose == poses.end())
        throw std::runtime_error(picture + ": --poses does not know it");
    return pose->second;
}

std::string pictureName(const std::string& path)
{
    return std::filesystem::path(path).stem().string();
}

}  // namespace samples

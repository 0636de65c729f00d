#pragma once
#include <string>
#include <vector>

#include "scene/camera/camera.h"

namespace vantage::exported {

/// A photo with a lens model that most programs support: k1 k2 k3 and OpenCV's p1 p2.
struct Photo {
    std::string name;
    int width, height;
    double fx, fy, cx, cy;  ///< pixels from the upper left corner of the first pixel
    double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< world to camera: x right, y down, z ahead
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
};

/// These functions return files like those that other programs write, according to the descriptions of the
/// formats. They share no code with the readers.
std::string colmap_cameras(const std::vector<Photo>& photos);
std::string colmap_images(const std::vector<Photo>& photos);
/// `chunk_R`, `chunk_t` and `chunk_scale` transform the chunk's frame to the world.
std::string metashape(const std::vector<Photo>& photos, const Eigen::Matrix3d& chunk_R,
                      const Eigen::Vector3d& chunk_t, double chunk_scale);
/// The sidecar file of one photo. `as_attributes`: the syntax of other versions.
std::string realitycapture_xmp(const Photo& photo, bool as_attributes);
/// Rotations are written as yaw, pitch and roll.
std::string realitycapture_csv(const std::vector<Photo>& photos);
std::string meshroom(const std::vector<Photo>& photos);
std::string openmvg(const std::vector<Photo>& photos);
std::string opensfm(const std::vector<Photo>& photos);
/// `applied` and `applied_t`: the rotation and translation that the program applied to the world.
std::string transforms(const std::vector<Photo>& photos, const Eigen::Matrix3d& applied,
                       const Eigen::Vector3d& applied_t);
/// In the camera axes, y points up and x to the left.
std::string blocks_exchange(const std::vector<Photo>& photos);

}  // namespace vantage::exported

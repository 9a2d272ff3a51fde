// Far-field approximation of the solid angle of a cluster of triangles.
#pragma once

#include <Eigen/Core>
#include <array>

namespace voluta::geometry {

// Moments of a cluster of triangles about a fixed origin; additive.
struct FarFieldSums {
  double area = 0.0;
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero(); // integral of x
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // integral of n
  Eigen::Matrix3d first = Eigen::Matrix3d::Zero();    // integral of x n^T
  std::array<Eigen::Matrix3d, 3> second = {           // integral of n_i x x^T
      Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};

  // Vertices relative to the origin.
  void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  void add(const FarFieldSums& other);
};

// Taylor expansion of the solid angle to second order about the area-weighted centre (Barill et al.
// 2018, eq. 14-19; triangles integrated exactly).
class FarField {
public:
  FarField() = default;
  // `origin`: of the sums; `low`, `high`: bounding box of the cluster.
  FarField(const FarFieldSums& sums, const Eigen::Vector3d& origin, const Eigen::Vector3d& low,
           const Eigen::Vector3d& high);

  // Returns whether p is further from the centre than `ratio` times the furthest corner of the box.
  bool isFar(const Eigen::Vector3d& p, double ratio) const {
    return (centre_ - p).squaredNorm() > ratio * ratio * radius_ * radius_;
  }
  // Precondition: isFar(p, 1).
  double solidAngle(const Eigen::Vector3d& p) const;

private:
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double radius_ = 0.0;
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  double trace_ = 0.0;                // of the first moment
  std::array<double, 6> quadratic_{}; // xx yy zz xy xz yz of its symmetric part
  std::array<double, 10> cubic_{};    // of the second moment's symmetric part
  Eigen::Vector3d cubicTrace_ = Eigen::Vector3d::Zero();
};

} // namespace voluta::geometry

// Flat arrays for building VTK meshes.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

struct MeshBuffers {
  std::vector<float> points, normals; // x y z per point; normals may be empty
  std::vector<std::uint8_t> rgb;      // one colour per point, or empty
  std::vector<std::int32_t> corners;  // three per triangle
  std::vector<std::int32_t> lineEnds; // two per line

  std::int32_t addPoint(const Eigen::Vector3d& p) {
    for (int k = 0; k < 3; ++k)
      points.push_back(static_cast<float>(p[k]));
    return static_cast<std::int32_t>(points.size() / 3 - 1);
  }
  std::int32_t addPoint(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    for (int k = 0; k < 3; ++k)
      normals.push_back(static_cast<float>(normal[k]));
    return addPoint(p);
  }
  void addTriangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    corners.insert(corners.end(), {a, b, c});
  }
  void addQuad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    addTriangle(a, b, c);
    addTriangle(a, c, d);
  }
  void addLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const std::int32_t first = addPoint(a);
    lineEnds.insert(lineEnds.end(), {first, addPoint(b)});
  }
};

// Returns the mesh with its bounds already computed, so that several threads can read it.
vtkSmartPointer<vtkPolyData> polyDataOf(const MeshBuffers& buffers);

// Adds a named float array over the points of `data`.
void addPointArray(vtkPolyData* data, const char* name, int components,
                   const std::vector<float>& values);

} // namespace voluta::scene

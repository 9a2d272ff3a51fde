// Larger triangles in place of those of layers, for fast frames. Private to the module.
#pragma once

#include "scene/drawing_data.h"
#include "scene/layered_faces.h"
#include "scene/mesh_buffers.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::scene {

// Triangles of slabs before they are sorted. Those of a patch, and their points, are together.
struct SlabFaces {
  std::vector<LayeredFace> bands, upper, lower;       // face: index of the triangle
  std::vector<std::array<std::int32_t, 3>> triangles; // points
  std::vector<std::uint32_t> patchOf;                 // per triangle

  void add(std::vector<LayeredFace>& to, const LayeredFace& face,
           const std::array<std::int32_t, 3>& triangle, std::uint32_t patch) {
    to.push_back({face.layer, face.key, static_cast<std::int32_t>(triangles.size())});
    triangles.push_back(triangle);
    patchOf.push_back(patch);
  }
};

// Per point of `buffers`: on the upper side of its layer, of a band.
struct SlabPoint {
  bool upper = false, band = false;
};

// Joins the points of a patch's side that lie in the same cell of that width. Adds the joined
// points, with the values of one of theirs, to `buffers` and `values`, and returns the triangles
// that are left.
SlabFaces coarseSlabs(const SlabFaces& fine, const std::vector<SlabPoint>& points, double cellMm,
                      MeshBuffers& buffers, ColourValues& values);

} // namespace voluta::scene

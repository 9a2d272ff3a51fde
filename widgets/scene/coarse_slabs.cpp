#include "scene/coarse_slabs.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace voluta::scene {

namespace {

struct TripleHash {
  std::size_t operator()(const std::array<std::int32_t, 3>& t) const {
    std::size_t hash = 0;
    for (const std::int32_t part : t)
      hash = hash * 0x9E3779B97F4A7C15ULL + static_cast<std::uint32_t>(part);
    return hash ^ hash >> 32;
  }
};
using Triple = std::array<std::int32_t, 3>;
template <typename Value> using TripleMap = std::unordered_map<Triple, Value, TripleHash>;

// The joined points of one patch at a time.
class Joined {
public:
  Joined(const std::vector<SlabPoint>& points, double cellMm, MeshBuffers& buffers,
         ColourValues& values)
      : points_(points), cellMm_(cellMm), buffers_(buffers), values_(values) {}

  void beginPatch() {
    for (auto& map : places_)
      map.clear();
    for (auto& map : ids_)
      map.clear();
  }

  // Bands and faces meet in the same places, with normals of their own.
  std::int32_t of(std::int32_t point) {
    const SlabPoint& kind = points_[static_cast<std::size_t>(point)];
    const Triple cell = cellOf(point);
    const std::int32_t place = places_[kind.upper].try_emplace(cell, point).first->second;
    const auto [entry, isNew] = ids_[2 * kind.upper + kind.band].try_emplace(cell, 0);
    if (isNew)
      entry->second = copyOf(point, place);
    return entry->second;
  }

private:
  Triple cellOf(std::int32_t point) const {
    Triple cell;
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int32_t>(
          std::floor(double(buffers_.points[3 * static_cast<std::size_t>(point) + k]) / cellMm_));
    return cell;
  }
  std::int32_t copyOf(std::int32_t point, std::int32_t place) {
    const auto from = static_cast<std::size_t>(point), at = static_cast<std::size_t>(place);
    for (std::size_t k = 0; k < 3; ++k) {
      buffers_.points.push_back(float(buffers_.points[3 * at + k]));
      buffers_.normals.push_back(float(buffers_.normals[3 * from + k]));
    }
    for (auto* list : {&values_.layer, &values_.group, &values_.item})
      list->push_back(std::int32_t((*list)[from]));
    for (auto* list : {&values_.height, &values_.tiltDeg})
      list->push_back(float((*list)[from]));
    return static_cast<std::int32_t>(buffers_.points.size() / 3 - 1);
  }

  const std::vector<SlabPoint>& points_;
  double cellMm_;
  MeshBuffers& buffers_;
  ColourValues& values_;
  std::array<TripleMap<std::int32_t>, 2> places_; // the point whose place is the cell's
  std::array<TripleMap<std::int32_t>, 4> ids_;
};

} // namespace

SlabFaces coarseSlabs(const SlabFaces& fine, const std::vector<SlabPoint>& points, double cellMm,
                      MeshBuffers& buffers, ColourValues& values) {
  SlabFaces coarse;
  // By triangle, so that those of a patch come together.
  std::vector<std::pair<const LayeredFace*, std::vector<LayeredFace>*>> faces(
      fine.triangles.size());
  for (const auto& [from, to] :
       {std::pair(&fine.bands, &coarse.bands), std::pair(&fine.upper, &coarse.upper),
        std::pair(&fine.lower, &coarse.lower)})
    for (const LayeredFace& face : *from)
      faces[static_cast<std::size_t>(face.face)] = {&face, to};

  Joined joined(points, cellMm, buffers, values);
  TripleMap<std::pair<std::vector<LayeredFace>*, std::size_t>> known;
  for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
    if (t == 0 || fine.patchOf[t] != fine.patchOf[t - 1]) {
      joined.beginPatch();
      known.clear();
    }
    Triple triangle;
    std::ranges::transform(fine.triangles[t], triangle.begin(),
                           [&](std::int32_t point) { return joined.of(point); });
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      continue;
    Triple sorted = triangle;
    std::ranges::sort(sorted);
    const auto& [face, to] = faces[t];
    const auto [entry, isNew] = known.try_emplace(sorted, to, to->size());
    if (isNew) {
      coarse.add(*to, *face, triangle, fine.patchOf[t]);
    } else {
      // It is shown as long as any of its triangles is.
      std::int32_t& key = (*entry->second.first)[entry->second.second].key;
      key = std::max(key, face->key);
    }
  }
  return coarse;
}

} // namespace voluta::scene

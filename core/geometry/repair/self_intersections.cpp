#include "geometry/repair/self_intersections.h"

#include "base/parallel.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <algorithm>

namespace voluta::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

class PairTest {
public:
  explicit PairTest(const TriangleMesh& mesh) : mesh_(mesh) {
    points_.reserve(mesh.vertices.size());
    for (const auto& v : mesh.vertices)
      points_.emplace_back(v.x(), v.y(), v.z());
  }

  Kernel::Triangle_3 triangle(int t) const { return {at(t, 0), at(t, 1), at(t, 2)}; }

  bool cut(int a, int b) const {
    int shared = 0, lastA = 0, lastB = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (vertex(a, i) == vertex(b, j)) {
          ++shared;
          lastA = i;
          lastB = j;
        }
    if (shared == 0)
      return CGAL::do_intersect(triangle(a), triangle(b));
    if (shared == 1)
      return CGAL::do_intersect(triangle(a),
                                Kernel::Segment_3(at(b, lastB + 1), at(b, lastB + 2))) ||
             CGAL::do_intersect(triangle(b), Kernel::Segment_3(at(a, lastA + 1), at(a, lastA + 2)));
    return shared == 3 || folded(a, b);
  }

private:
  int vertex(int t, int k) const {
    return mesh_.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k % 3)];
  }
  const Kernel::Point_3& at(int t, int k) const {
    return points_[static_cast<std::size_t>(vertex(t, k))];
  }
  // Coplanar and on the same side of the shared edge.
  bool folded(int a, int b) const {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const bool same = vertex(a, i) == vertex(b, j) && vertex(a, i + 1) == vertex(b, j + 1);
        const bool opposite = vertex(a, i) == vertex(b, j + 1) && vertex(a, i + 1) == vertex(b, j);
        if (same || opposite)
          return CGAL::coplanar(at(a, i), at(a, i + 1), at(a, i + 2), at(b, j + 2)) &&
                 CGAL::coplanar_orientation(at(a, i), at(a, i + 1), at(a, i + 2), at(b, j + 2)) ==
                     CGAL::POSITIVE;
      }
    return false;
  }

  const TriangleMesh& mesh_;
  std::vector<Kernel::Point_3> points_;
};

} // namespace

std::vector<std::pair<int, int>> selfIntersections(const TriangleMesh& mesh,
                                                   const base::RunContext& ctx) {
  const PairTest test(mesh);
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Kernel::Triangle_3 triangle = test.triangle(t);
    if (!triangle.is_degenerate())
      boxes.emplace_back(triangle.bbox(), t);
  }
  // Candidates are found on one thread and tested on all, in batches that limit the memory.
  constexpr std::size_t kBatch = 1 << 20, kGrain = 4096;
  std::vector<std::pair<int, int>> pairs, candidates;
  const auto testCandidates = [&] {
    std::vector<char> cuts(candidates.size());
    base::parallelChunks(ctx, candidates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        cuts[i] = test.cut(candidates[i].first, candidates[i].second) ? 1 : 0;
    });
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (cuts[i])
        pairs.push_back(candidates[i]);
    candidates.clear();
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    candidates.emplace_back(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
    if (candidates.size() == kBatch)
      testCandidates();
  });
  testCandidates();
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace voluta::geometry

#include "layers/stack_checker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace voluta::test {

namespace {

using Eigen::Vector3d;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Ericson's point-to-triangle test, with the weights of the corners.
Vector3d closestWeights(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                        const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0)
    return {1, 0, 0};
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3)
    return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 > d3 ? d1 / (d1 - d3) : 0.0;
    return {1 - v, v, 0};
  }
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6)
    return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 > d6 ? d2 / (d2 - d6) : 0.0;
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double s = (d4 - d3) + (d5 - d6), w = s > 0 ? (d4 - d3) / s : 0.0;
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return sum > 0 ? Vector3d(va / sum, vb / sum, vc / sum) : Vector3d(1, 0, 0);
}

// Triangles in a hash of cubes.
class Grid {
public:
  explicit Grid(double cell) : cell_(cell) {}

  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const int id = static_cast<int>(corners_.size());
    corners_.push_back({a, b, c});
    const Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    eachCell(low, high, [&](std::uint64_t key) { cells_[key].push_back(id); });
  }

  struct Found {
    int triangle = -1;
    double distance = std::numeric_limits<double>::infinity();
    Vector3d weights = Vector3d::Zero();
  };
  // The nearest accepted triangle within `reach`.
  template <typename Accept> Found nearest(const Vector3d& p, double reach, Accept&& accept) const {
    Found best;
    best.distance = reach;
    const Vector3d r = Vector3d::Constant(reach);
    eachCell(p - r, p + r, [&](std::uint64_t key) {
      const auto found = cells_.find(key);
      if (found == cells_.end())
        return;
      for (int id : found->second) {
        if (!accept(id))
          continue;
        const auto& t = corners_[at(id)];
        const Vector3d w = closestWeights(p, t[0], t[1], t[2]);
        const double d = (w[0] * t[0] + w[1] * t[1] + w[2] * t[2] - p).norm();
        if (d < best.distance)
          best = {id, d, w};
      }
    });
    return best;
  }
  template <typename Visit>
  void near(const Vector3d& low, const Vector3d& high, Visit&& visit) const {
    std::set<int> seen;
    eachCell(low, high, [&](std::uint64_t key) {
      const auto found = cells_.find(key);
      if (found != cells_.end())
        for (int id : found->second)
          if (seen.insert(id).second)
            visit(id);
    });
  }
  const std::array<Vector3d, 3>& corners(int id) const { return corners_[at(id)]; }

private:
  template <typename F> void eachCell(const Vector3d& low, const Vector3d& high, F&& f) const {
    const auto of = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    for (std::int64_t k = of(low.z()); k <= of(high.z()); ++k)
      for (std::int64_t j = of(low.y()); j <= of(high.y()); ++j)
        for (std::int64_t i = of(low.x()); i <= of(high.x()); ++i)
          f((static_cast<std::uint64_t>(i + (1 << 20)) << 42) |
            (static_cast<std::uint64_t>(j + (1 << 20)) << 21) |
            static_cast<std::uint64_t>(k + (1 << 20)));
  }

  double cell_;
  std::vector<std::array<Vector3d, 3>> corners_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

// Sine of the angle to the layers from which on an edge runs through them.
constexpr double kThroughLayers = 0.5;

// Cosine of the angle to the layers within which a top should end on the surface.
constexpr double kNearlyAlong = 0.9063;

const auto kAny = [](int) { return true; };

struct Facet {
  int patch;
  std::array<double, 3> thickness;
  std::array<Vector3d, 3> direction;
};

class Checker {
public:
  Checker(const layers::LayerStack& stack, const geometry::TriangleMesh& part, double minimum,
          double maximum)
      : stack_(stack), part_(part), minimum_(minimum), maximum_(maximum), middles_(1.0), tops_(1.0),
        feet_(1.0), surface_(2.0), rims_(1.0) {
    for (const auto& t : part.triangles)
      surface_.add(part.vertices[at(t[0])], part.vertices[at(t[1])], part.vertices[at(t[2])]);
    for (std::size_t p = 0; p < stack.patches.size(); ++p) {
      const layers::Patch& patch = stack.patches[p];
      for (const auto& t : patch.surface.triangles) {
        std::array<Vector3d, 3> m, top, foot;
        Facet f{static_cast<int>(p), {}, {}};
        for (std::size_t k = 0; k < 3; ++k) {
          m[k] = patch.surface.vertices[at(t[k])];
          f.thickness[k] = patch.thicknessMm[at(t[k])];
          f.direction[k] = patch.direction[at(t[k])];
          top[k] = m[k] + 0.5 * f.thickness[k] * f.direction[k];
          foot[k] = m[k] - 0.5 * f.thickness[k] * f.direction[k];
        }
        middles_.add(m[0], m[1], m[2]);
        tops_.add(top[0], top[1], top[2]);
        feet_.add(foot[0], foot[1], foot[2]);
        facets_.push_back(f);
      }
    }
  }

  StackVerdict run() {
    volume();
    boundaries();
    thickness();
    coverage();
    sharpEdges();
    ends();
    int last = 0;
    for (std::size_t p = 0; p < stack_.patches.size(); ++p) {
      const int layer = stack_.patches[p].layer;
      v_.layersRise &= layer >= last && layer <= last + 1 && (p > 0 || layer == 0);
      last = layer;
    }
    v_.layersRise &= stack_.patches.empty() || stack_.layerCount == last + 1;
    return v_;
  }

private:
  void volume() {
    double part = 0.0, deposited = 0.0;
    for (const auto& t : part_.triangles)
      part +=
          part_.vertices[at(t[0])].dot(part_.vertices[at(t[1])].cross(part_.vertices[at(t[2])])) /
          6.0;
    for (std::size_t id = 0; id < facets_.size(); ++id) {
      const auto& c = middles_.corners(static_cast<int>(id));
      const auto& t = facets_[id].thickness;
      deposited += 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm() * (t[0] + t[1] + t[2]) / 3.0;
    }
    v_.volumeRatio = deposited / part;
  }

  void boundaries() {
    struct Inside {
      Vector3d point;
      double thickness;
      int patch;
    };
    std::vector<Inside> inside;
    for (std::size_t p = 0; p < stack_.patches.size(); ++p) {
      const layers::Patch& patch = stack_.patches[p];
      std::map<std::pair<int, int>, int> directed;
      for (const auto& t : patch.surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          ++directed[{t[k], t[(k + 1) % 3]}];
      std::map<int, int> ends;
      std::vector<std::pair<int, int>> rim;
      bool simple = true;
      for (const auto& [edge, count] : directed) {
        simple &= count == 1;
        if (directed.count({edge.second, edge.first}) != 0)
          continue;
        ++ends[edge.first];
        ++ends[edge.second];
        rim.push_back(edge);
      }
      std::set<int> off;
      for (const auto& [vertex, count] : ends) {
        simple &= count == 2;
        const Vector3d& x = patch.surface.vertices[at(vertex)];
        const double d = surface_.nearest(x, 2.0, kAny).distance;
        if (d <= 1e-3)
          v_.boundaryFarthestMm = std::max(v_.boundaryFarthestMm, d);
        else
          off.insert(vertex);
      }
      for (int vertex : off)
        inside.push_back({patch.surface.vertices[at(vertex)], patch.thicknessMm[at(vertex)],
                          static_cast<int>(p)});
      for (const auto& [a, b] : rim) {
        const Vector3d &x = patch.surface.vertices[at(a)], &y = patch.surface.vertices[at(b)];
        rims_.add(x, y, y);
        rimFacts_.push_back({static_cast<int>(p), off.count(a) + off.count(b) > 0});
      }
      v_.notSimple += !simple;
    }
    for (const Inside& i : inside) {
      const auto beside = rims_.nearest(i.point, i.thickness + 0.2, [&](int id) {
        return rimFacts_[at(id)].isInside && rimFacts_[at(id)].patch != i.patch;
      });
      if (beside.triangle >= 0) {
        ++v_.seamVertices;
        continue;
      }
      if (surface_.nearest(i.point, 0.5 * i.thickness, kAny).triangle >= 0) {
        ++v_.nearVertices;
        continue;
      }
      ++v_.looseVertices;
      // Distances beyond this need not be exact.
      v_.boundaryFarthestMm =
          std::max(v_.boundaryFarthestMm, surface_.nearest(i.point, 10.0, kAny).distance);
    }
  }

  void thickness() {
    std::vector<double> areaOf(stack_.patches.size(), 0.0), onOf(areaOf), onLaterOf(areaOf);
    std::vector<Vector3d> someOf(stack_.patches.size(), Vector3d::Zero());
    std::vector<std::pair<double, double>> found; // thickness, area
    double all = 0.0, lying = 0.0, within = 0.0, reported = 0.0, sum = 0.0;
    const std::size_t step = std::max<std::size_t>(1, facets_.size() / 60000);
    std::vector<std::size_t> countOf(stack_.patches.size(), 0);
    for (std::size_t id = 0; id < facets_.size(); ++id) {
      const Facet& f = facets_[id];
      // Small patches are looked at whole.
      const std::size_t size = stack_.patches[at(f.patch)].surface.triangles.size();
      if (countOf[at(f.patch)]++ % std::max<std::size_t>(1, std::min(step, size / 50)) != 0)
        continue;
      const auto& c = middles_.corners(static_cast<int>(id));
      const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
      const double t = (f.thickness[0] + f.thickness[1] + f.thickness[2]) / 3.0;
      const Vector3d d = (f.direction[0] + f.direction[1] + f.direction[2]).normalized();
      const Vector3d middle = (c[0] + c[1] + c[2]) / 3.0, foot = middle - 0.5 * t * d,
                     top = middle + 0.5 * t * d;
      const auto earlier = [&](int o) { return facets_[at(o)].patch < f.patch; };
      all += area;
      areaOf[at(f.patch)] += area;
      someOf[at(f.patch)] += area * middle;
      const bool onPlate = foot.z() <= 0.25 * t;
      const int lower = tops_.nearest(foot, 0.25 * t, earlier).triangle;
      if (!onPlate && lower < 0) {
        const int own = stack_.patches[at(f.patch)].layer;
        const auto under = tops_.nearest(foot, 0.25 * t, [&](int o) {
          return facets_[at(o)].patch > f.patch ||
                 stack_.patches[at(facets_[at(o)].patch)].layer > own;
        });
        if (under.triangle >= 0)
          onLaterOf[at(f.patch)] += area;
        continue;
      }
      onOf[at(f.patch)] += area;
      // To the patch below it: another may end beside it, where a level ends.
      double measured = onPlate ? top.z() : 2.0 * t;
      if (lower >= 0)
        measured = std::min(
            measured,
            tops_
                .nearest(top, 2.0 * t,
                         [&](int o) { return facets_[at(o)].patch == facets_[at(lower)].patch; })
                .distance);
      lying += area;
      sum += area * measured;
      found.emplace_back(measured, area);
      if (measured >= minimum_ - 0.01 && measured <= maximum_ + 0.01)
        within += area;
      if (std::abs(measured - t) <= 0.1 * t)
        reported += area;
    }
    v_.unsupported = all > 0 ? 1.0 - lying / all : 0.0;
    for (std::size_t p = 0; p < areaOf.size(); ++p)
      if (onOf[p] < 0.02 * areaOf[p]) {
        ++v_.patchesInTheAir;
        v_.air.push_back({someOf[p] / areaOf[p], areaOf[p], static_cast<int>(p)});
        v_.outOfOrder += onLaterOf[p] > 0.25 * areaOf[p];
      }
    if (lying <= 0.0)
      return;
    v_.thicknessMeanMm = sum / lying;
    v_.within = within / lying;
    v_.asReported = reported / lying;
    std::sort(found.begin(), found.end());
    double passed = 0.0;
    for (const auto& [t, area] : found) {
      if (passed < 0.01 * lying)
        v_.thicknessP01Mm = t;
      passed += area;
      v_.thicknessP99Mm = t;
      if (passed >= 0.99 * lying)
        break;
    }
  }

  // By parity along +x, a little aslant so that edges are not met.
  bool isInside(const Vector3d& p, double far) const {
    const Vector3d d = Vector3d(1.0, 0.00137, 0.00071);
    int crossings = 0;
    std::set<int> seen;
    // In steps, so that the box stays slim.
    for (double from = 0.0; from < far; from += 4.0) {
      const Vector3d a = p + from * d, b = p + (from + 4.0) * d;
      surface_.near(a.cwiseMin(b), a.cwiseMax(b), [&](int id) {
        if (!seen.insert(id).second)
          return;
        const auto& c = surface_.corners(id);
        const Vector3d e1 = c[1] - c[0], e2 = c[2] - c[0], h = d.cross(e2), s = p - c[0];
        const double det = e1.dot(h);
        if (std::abs(det) < 1e-14)
          return;
        const double u = s.dot(h) / det;
        const Vector3d q = s.cross(e1);
        const double v = d.dot(q) / det, t = e2.dot(q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0)
          ++crossings;
      });
    }
    return crossings % 2 == 1;
  }

  void coverage() {
    Eigen::AlignedBox3d box;
    for (const Vector3d& x : part_.vertices)
      box.extend(x);
    std::mt19937 random(11);
    int inside = 0, none = 0, several = 0;
    for (int n = 0; n < 100000 && inside < 4000; ++n) {
      Vector3d x;
      for (int axis = 0; axis < 3; ++axis)
        x[axis] = std::uniform_real_distribution<double>(box.min()[axis], box.max()[axis])(random);
      if (!isInside(x, box.sizes().x() + 4.0))
        continue;
      ++inside;
      // Per patch the nearest point; inside where its foot is no boundary of the patch.
      std::map<int, std::pair<double, double>> best; // distance, half thickness
      const Vector3d r = Vector3d::Constant(0.6 * maximum_ + 0.1);
      middles_.near(x - r, x + r, [&](int id) {
        const auto& c = middles_.corners(id);
        const Vector3d w = closestWeights(x, c[0], c[1], c[2]);
        const Vector3d at0 = w[0] * c[0] + w[1] * c[1] + w[2] * c[2];
        const Facet& f = facets_[at(id)];
        const double distance = (x - at0).norm();
        const double half =
            0.5 * (w[0] * f.thickness[0] + w[1] * f.thickness[1] + w[2] * f.thickness[2]);
        const auto [entry, isNew] = best.try_emplace(f.patch, distance, half);
        if (!isNew && distance < entry->second.first)
          entry->second = {distance, half};
      });
      int loosely = 0, surely = 0;
      for (const auto& [patch, found] : best) {
        loosely += found.first <= 1.03 * found.second + 0.01;
        surely += found.first <= 0.97 * found.second - 0.01;
      }
      none += loosely == 0;
      several += surely > 1;
    }
    v_.inNone = inside > 0 ? static_cast<double>(none) / inside : 0.0;
    v_.inSeveral = inside > 0 ? static_cast<double>(several) / inside : 0.0;
  }

  void sharpEdges() {
    std::map<std::pair<int, int>, std::vector<std::size_t>> around;
    for (std::size_t t = 0; t < part_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = part_.triangles[t][k], b = part_.triangles[t][(k + 1) % 3];
        around[{std::min(a, b), std::max(a, b)}].push_back(t);
      }
    const auto normal = [&](std::size_t t) {
      const auto& c = surface_.corners(static_cast<int>(t));
      return Vector3d((c[1] - c[0]).cross(c[2] - c[0]).normalized());
    };
    std::vector<std::pair<double, Vector3d>> off;
    for (const auto& [edge, triangles] : around) {
      if (triangles.size() != 2 || normal(triangles[0]).dot(normal(triangles[1])) > 0.766)
        continue;
      const Vector3d &a = part_.vertices[at(edge.first)], &b = part_.vertices[at(edge.second)];
      const int count = std::max(1, static_cast<int>((b - a).norm() / 0.2));
      int patch = -1;
      double height = 0.0;
      for (int k = 0; k <= count; ++k) {
        const Vector3d x = a + static_cast<double>(k) / count * (b - a);
        const auto near = middles_.nearest(x, maximum_, kAny);
        const int before = std::exchange(patch, -1);
        if (near.triangle < 0)
          continue;
        const Facet& f = facets_[at(near.triangle)];
        const auto& c = middles_.corners(near.triangle);
        patch = f.patch;
        const double was = std::exchange(
            height, (x - near.weights[0] * c[0] - near.weights[1] * c[1] - near.weights[2] * c[2])
                        .dot(f.direction[0]));
        if (patch != before || was * height > 0.0 ||
            std::abs(f.direction[0].dot(b - a)) < kThroughLayers * (b - a).norm())
          continue;
        const Vector3d pierced = x - (b - a) / count * (height / (height - was));
        off.emplace_back(
            rims_.nearest(pierced, 5.0, [&](int id) { return rimFacts_[at(id)].patch == patch; })
                .distance,
            pierced);
      }
    }
    v_.sharpCrossings = off.size();
    if (off.empty())
      return;
    std::sort(off.begin(), off.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    v_.sharpOffP99Mm = off[off.size() * 99 / 100].first;
    v_.sharpOffMaxMm = off.back().first;
    v_.sharpOffAt = off.back().second;
  }

  void ends() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double area = 0.0;
    for (std::size_t t = 0; t < part_.triangles.size(); ++t)
      area += areaOf(static_cast<int>(t));
    std::vector<double> off, flatOff;
    double sum = 0.0, flatSum = 0.0;
    std::size_t drawn = 0;
    // Evenly by walking along the triangles' areas.
    const double step = area / 20000.0;
    double passed = unit(random) * step;
    for (std::size_t t = 0; t < part_.triangles.size(); ++t) {
      const auto& c = surface_.corners(static_cast<int>(t));
      const Vector3d n = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      for (double a = areaOf(static_cast<int>(t)); passed < a; passed += step) {
        double u = unit(random), v = unit(random);
        if (u + v > 1.0) {
          u = 1.0 - u;
          v = 1.0 - v;
        }
        const Vector3d x = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        if (x.z() < 1e-3 && n.z() < -0.99)
          v_.plateMaxMm = std::max(v_.plateMaxMm, feet_.nearest(x, 1.0, kAny).distance);
        ++drawn;
        const auto near = middles_.nearest(x, 2.0, kAny);
        const double along =
            near.triangle < 0 ? 0.0 : facets_[at(near.triangle)].direction[0].dot(n);
        if (along <= 0.5)
          continue;
        off.push_back(tops_.nearest(x, 2.0, kAny).distance);
        sum += off.back();
        if (along <= kNearlyAlong)
          continue;
        flatOff.push_back(off.back());
        flatSum += off.back();
      }
      passed -= areaOf(static_cast<int>(t));
    }
    if (off.empty())
      return;
    std::sort(off.begin(), off.end());
    v_.topMeanMm = sum / static_cast<double>(off.size());
    v_.topP99Mm = off[off.size() * 99 / 100];
    if (flatOff.empty())
      return;
    std::sort(flatOff.begin(), flatOff.end());
    v_.flatTopMeanMm = flatSum / static_cast<double>(flatOff.size());
    v_.flatTopP99Mm = flatOff[flatOff.size() * 99 / 100];
    v_.flatTopShare = static_cast<double>(flatOff.size()) / static_cast<double>(drawn);
  }

  double areaOf(int triangle) const {
    const auto& c = surface_.corners(triangle);
    return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
  }

  const layers::LayerStack& stack_;
  const geometry::TriangleMesh& part_;
  double minimum_, maximum_;
  Grid middles_, tops_, feet_, surface_, rims_;
  std::vector<Facet> facets_;
  struct Rim {
    int patch;
    bool isInside;
  };
  std::vector<Rim> rimFacts_; // of an edge in rims_
  StackVerdict v_;
};

} // namespace

StackVerdict checkStack(const layers::LayerStack& stack, const geometry::TriangleMesh& part,
                        double heightMinMm, double heightMaxMm) {
  return Checker(stack, part, heightMinMm, heightMaxMm).run();
}

} // namespace voluta::test

#include "planar/search/cut_candidates.h"

#include "base/parallel.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<Vector3d> evenDirections(int count, double zMin) {
  const double golden = base::kPi * (3.0 - std::sqrt(5.0));
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (1.0 - zMin) * (i + 0.5) / count;
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    directions.emplace_back(r * std::cos(golden * i), r * std::sin(golden * i), z);
  }
  return directions;
}

std::vector<Vector3d> flatDirections(const geometry::TriangleMesh& mesh, double leastShare,
                                     std::size_t count, double zMin) {
  constexpr double kSame = 0.9998; // cosine: about a degree
  struct Look {
    Vector3d normal;
    double area = 0.0;
  };
  std::vector<Look> looks;
  const double all = geometry::area(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = geometry::triangleArea(mesh, t);
    if (area < 1e-4 * all)
      continue;
    const Vector3d n = geometry::triangleNormal(mesh, t);
    const auto same = std::find_if(looks.begin(), looks.end(),
                                   [&](const Look& l) { return l.normal.dot(n) > kSame; });
    if (same == looks.end())
      looks.push_back({n, area});
    else
      same->area += area;
  }
  std::erase_if(looks, [&](const Look& l) { return l.area < leastShare * all; });
  std::stable_sort(looks.begin(), looks.end(),
                   [](const Look& a, const Look& b) { return a.area > b.area; });
  std::vector<Vector3d> out;
  const auto add = [&](const Vector3d& n) {
    if (n.z() >= zMin &&
        std::none_of(out.begin(), out.end(), [&](const Vector3d& o) { return o.dot(n) > kSame; }))
      out.push_back(n);
  };
  for (int k = 0; k < 3; ++k) {
    add(Vector3d::Unit(k));
    add(-Vector3d::Unit(k));
  }
  for (const Look& l : looks) {
    if (out.size() >= count + 6)
      break;
    add(l.normal);
    add(-l.normal);
  }
  return out;
}

namespace {

// What hangs together above the falling plane.
struct Above {
  double before = 0.0, after = 0.0; // risky area
  double stands = 0.0;
  int top = -1; // its highest face
  // The best offset since the last that was kept.
  double bestGain = -1.0, bestAfter = 0.0, bestOffset = 0.0;
};

struct Entry {
  double low;
  int face;
};

// Highest first; in steps of 2^-32 of their range, within a step by face (radix sort: there are as
// many of these as normals). Precondition: in order of faces.
void sortFalling(std::vector<Entry>& entries) {
  constexpr int kBits = 11;
  constexpr std::size_t kBuckets = 1U << kBits;
  if (entries.empty())
    return;
  const auto [least, most] = std::minmax_element(
      entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.low < b.low; });
  const double high = most->low;
  const double scale = 4294967295.0 / std::max(1e-9, high - least->low);
  struct Keyed {
    std::uint32_t key;
    Entry entry;
  };
  std::vector<Keyed> from, to(entries.size());
  from.reserve(entries.size());
  for (const Entry& e : entries)
    from.push_back({static_cast<std::uint32_t>((high - e.low) * scale), e});
  for (int shift = 0; shift < 32; shift += kBits) {
    std::vector<std::size_t> at(kBuckets + 1, 0);
    for (const Keyed& k : from)
      ++at[((k.key >> shift) & (kBuckets - 1)) + 1];
    for (std::size_t b = 1; b < at.size(); ++b)
      at[b] += at[b - 1];
    for (const Keyed& k : from)
      to[at[(k.key >> shift) & (kBuckets - 1)]++] = k;
    from.swap(to);
  }
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries[i] = from[i].entry;
}

void sweep(const geometry::TriangleMesh& mesh, const FaceTable& f, const Vector3d& normal,
           const RiskRule& rule, const CandidateOptions& options, std::vector<CutCandidate>& out) {
  constexpr double kLevel = 1e-6; // mm: corners so near in height are at one offset
  const std::size_t n = f.area.size();
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v)
    height[v] = normal.dot(mesh.vertices[v]);
  // A face is above a plane when its lowest corner is.
  std::vector<Entry> order(n);
  double lowest = 1e300;
  for (std::size_t t = 0; t < n; ++t) {
    const auto& c = mesh.triangles[t];
    const double low =
        std::min({height[static_cast<std::size_t>(c[0])], height[static_cast<std::size_t>(c[1])],
                  height[static_cast<std::size_t>(c[2])]});
    order[t] = {low, static_cast<int>(t)};
    lowest = std::min(lowest, low);
  }
  sortFalling(order);
  const double riskyCosine = -std::sin(rule.overhangRad); // risky below this cosine
  geometry::UnionFind sets(n);
  std::vector<Above> part(n);
  std::vector<std::uint8_t> above(n, 0);
  std::vector<int> fresh; // roots with a best to keep
  std::vector<CutCandidate> found;
  const auto keep = [&] {
    for (const int r : fresh) {
      Above& p = part[static_cast<std::size_t>(r)];
      if (sets.find(r) != r || p.bestGain < options.leastMm2)
        continue;
      CutCandidate c;
      c.plane = {normal, p.bestOffset};
      c.gainMm2 = p.bestGain;
      c.afterMm2 = p.bestAfter;
      c.top = p.top;
      found.push_back(c);
      p.bestGain = -1.0;
    }
    fresh.clear();
  };
  double kept = order.empty() ? 0.0 : order.front().low;
  for (std::size_t begin = 0; begin < n;) {
    std::size_t end = begin;
    const double level = order[begin].low;
    if (level <= lowest + kLevel)
      break;
    for (; end < n && order[end].low > level - kLevel; ++end) {
      const auto t = static_cast<std::size_t>(order[end].face);
      above[t] = 1;
      Above& own = part[t];
      own.before = f.risky[t];
      own.after = !f.laid[t] && f.normal[t].dot(normal) < riskyCosine ? f.area[t] : 0.0;
      own.stands = f.stands[t] ? f.area[t] : 0.0;
      own.top = static_cast<int>(t);
      for (const int w : f.neighbour[t]) {
        if (w < 0 || !above[static_cast<std::size_t>(w)])
          continue;
        const int a = sets.find(static_cast<int>(t)), b = sets.find(w);
        if (!sets.join(a, b))
          continue;
        const auto root = static_cast<std::size_t>(sets.find(a));
        const auto other = root == static_cast<std::size_t>(a) ? static_cast<std::size_t>(b)
                                                               : static_cast<std::size_t>(a);
        Above &p = part[root], &q = part[other];
        const bool higher =
            height[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(p.top)][0])] >=
            height[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(q.top)][0])];
        p.before += q.before;
        p.after += q.after;
        p.stands += q.stands;
        p.top = higher ? p.top : q.top;
        p.bestGain = -1.0;
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      const int r = sets.find(order[i].face);
      Above& p = part[static_cast<std::size_t>(r)];
      const double gain = p.before - p.after - options.footPrice * p.stands;
      if (p.stands > options.maxContactLossMm2 || gain < options.leastMm2 || gain <= p.bestGain)
        continue;
      if (p.bestGain < 0.0)
        fresh.push_back(r);
      p.bestGain = gain;
      p.bestAfter = p.after;
      p.bestOffset = level;
    }
    begin = end;
    if (kept - level >= options.stepMm) {
      keep();
      kept = level;
    }
  }
  keep();
  std::stable_sort(found.begin(), found.end(), [](const CutCandidate& a, const CutCandidate& b) {
    return a.gainMm2 > b.gainMm2;
  });
  if (found.size() > options.perNormal)
    found.resize(options.perNormal);
  for (CutCandidate& c : found)
    for (int k = 0; k < 3; ++k)
      c.topMm += mesh.corner(static_cast<std::size_t>(c.top), k) / 3.0;
  out = std::move(found);
}

} // namespace

std::vector<CutCandidate> cutCandidates(const Piece& piece, const FaceTable& faces,
                                        const RiskRule& rule, const std::vector<Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx) {
  std::vector<std::vector<CutCandidate>> found(normals.size());
  base::parallelChunks(ctx, normals.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!isRisky(normals[i], piece.base.normal, rule))
        sweep(piece.solid.mesh, faces, normals[i], rule, options, found[i]);
  });
  std::vector<CutCandidate> all;
  for (const auto& of : found)
    all.insert(all.end(), of.begin(), of.end());
  std::stable_sort(all.begin(), all.end(), [](const CutCandidate& a, const CutCandidate& b) {
    return a.gainMm2 > b.gainMm2;
  });
  return all;
}

} // namespace voluta::planar

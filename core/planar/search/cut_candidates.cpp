#include "planar/search/cut_candidates.h"

#include "base/parallel.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "geometry/edges.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<Vector3d> evenDirections(int count, double zMin) {
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i)
    directions.push_back(geometry::onSpiral(i, 1.0 - (1.0 - zMin) * (i + 0.5) / count));
  return directions;
}

std::vector<Vector3d> flatDirections(const geometry::TriangleMesh& mesh, double minShare,
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
  std::erase_if(looks, [&](const Look& l) { return l.area < minShare * all; });
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

// A connected component above the falling plane.
struct Above {
  double before = 0.0, after = 0.0; // risky area
  double stands = 0.0;
  int top = -1; // its highest face
  // The best offset since the last one kept.
  double bestGain = -1.0, bestAfter = 0.0, bestOffset = 0.0;
};

struct Entry {
  double low;
  int face;
};

// Sorts by height, highest first, in steps of 2^-32 of the range, within a step by face (radix
// sort, as there is a list for every normal). Precondition: sorted by face.
void sortFalling(std::vector<Entry>& entries) {
  constexpr int kBits = 11;
  constexpr std::size_t kBuckets = 1U << kBits;
  if (entries.empty())
    return;
  const auto [minimum, maximum] = std::minmax_element(
      entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.low < b.low; });
  const double high = maximum->low;
  const double scale = 4294967295.0 / std::max(1e-9, high - minimum->low);
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

// Lowers a plane of one normal through a piece, face by face.
class Sweep {
public:
  Sweep(const geometry::TriangleMesh& mesh, const FaceTable& faces, const Vector3d& normal,
        const RiskRule& rule, const CandidateOptions& options)
      : mesh_(mesh), faces_(faces), options_(options), normal_(normal),
        riskyCosine_(-std::sin(rule.overhangRad)), height_(mesh.vertices.size()),
        sets_(faces.area.size()), part_(faces.area.size()), above_(faces.area.size(), 0) {
    for (std::size_t v = 0; v < height_.size(); ++v)
      height_[v] = normal.dot(mesh.vertices[v]);
  }

  std::vector<CutCandidate> run() {
    constexpr double kLevel = 1e-6; // mm: vertices this close in height have the same offset
    double lowest = 1e300;
    const std::vector<Entry> order = fallingFaces(lowest);
    double kept = order.empty() ? 0.0 : order.front().low;
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin;
      const double level = order[begin].low;
      if (level <= lowest + kLevel)
        break;
      for (; end < order.size() && order[end].low > level - kLevel; ++end)
        add(order[end].face);
      for (std::size_t i = begin; i < end; ++i)
        noteGain(sets_.find(order[i].face), level);
      begin = end;
      if (kept - level >= options_.stepMm) {
        keep();
        kept = level;
      }
    }
    keep();
    return strongest();
  }

private:
  // A face is above a plane if its lowest vertex is.
  std::vector<Entry> fallingFaces(double& lowest) const {
    std::vector<Entry> order(faces_.area.size());
    for (std::size_t t = 0; t < order.size(); ++t) {
      const auto& c = mesh_.triangles[t];
      const double low = std::min({height_[static_cast<std::size_t>(c[0])],
                                   height_[static_cast<std::size_t>(c[1])],
                                   height_[static_cast<std::size_t>(c[2])]});
      order[t] = {low, static_cast<int>(t)};
      lowest = std::min(lowest, low);
    }
    sortFalling(order);
    return order;
  }

  // Adds the face to the region above the plane and joins it with its neighbours there.
  void add(int face) {
    const auto t = static_cast<std::size_t>(face);
    above_[t] = 1;
    Above& own = part_[t];
    own.before = faces_.risky[t];
    own.after =
        !faces_.onPrinted[t] && faces_.normal[t].dot(normal_) < riskyCosine_ ? faces_.area[t] : 0.0;
    own.stands = faces_.stands[t] ? faces_.area[t] : 0.0;
    own.top = face;
    for (const int w : faces_.neighbour[t]) {
      if (w < 0 || !above_[static_cast<std::size_t>(w)])
        continue;
      const int a = sets_.find(face), b = sets_.find(w);
      if (sets_.join(a, b))
        merge(a, b);
    }
  }

  double heightOf(int face) const {
    return height_[static_cast<std::size_t>(mesh_.triangles[static_cast<std::size_t>(face)][0])];
  }

  // Merges the figures of two roots, one of which is now the root of both.
  void merge(int a, int b) {
    const auto root = static_cast<std::size_t>(sets_.find(a));
    const auto other = static_cast<std::size_t>(root == static_cast<std::size_t>(a) ? b : a);
    Above &p = part_[root], &q = part_[other];
    const bool higher = heightOf(p.top) >= heightOf(q.top);
    p.before += q.before;
    p.after += q.after;
    p.stands += q.stands;
    p.top = higher ? p.top : q.top;
    p.bestGain = -1.0;
  }

  void noteGain(int root, double level) {
    Above& p = part_[static_cast<std::size_t>(root)];
    const double gain = p.before - p.after - options_.footPrice * p.stands;
    if (p.stands > options_.maxContactLossMm2 || gain < options_.minMm2 || gain <= p.bestGain)
      return;
    if (p.bestGain < 0.0)
      fresh_.push_back(root);
    p.bestGain = gain;
    p.bestAfter = p.after;
    p.bestOffset = level;
  }

  void keep() {
    for (const int r : fresh_) {
      Above& p = part_[static_cast<std::size_t>(r)];
      if (sets_.find(r) != r || p.bestGain < options_.minMm2)
        continue;
      CutCandidate c;
      c.plane = {normal_, p.bestOffset};
      c.gainMm2 = p.bestGain;
      c.afterMm2 = p.bestAfter;
      c.top = p.top;
      found_.push_back(c);
      p.bestGain = -1.0;
    }
    fresh_.clear();
  }

  std::vector<CutCandidate> strongest() {
    std::stable_sort(
        found_.begin(), found_.end(),
        [](const CutCandidate& a, const CutCandidate& b) { return a.gainMm2 > b.gainMm2; });
    if (found_.size() > options_.perNormal)
      found_.resize(options_.perNormal);
    for (CutCandidate& c : found_)
      for (int k = 0; k < 3; ++k)
        c.topMm += mesh_.corner(static_cast<std::size_t>(c.top), k) / 3.0;
    return std::move(found_);
  }

  const geometry::TriangleMesh& mesh_;
  const FaceTable& faces_;
  const CandidateOptions& options_;
  Vector3d normal_;
  double riskyCosine_; // faces with a lower cosine are risky
  std::vector<double> height_;
  geometry::UnionFind sets_;
  std::vector<Above> part_; // per root
  std::vector<std::uint8_t> above_;
  std::vector<int> fresh_; // roots with a best offset to keep
  std::vector<CutCandidate> found_;
};

} // namespace

std::vector<CutCandidate> cutCandidates(const Piece& piece, const FaceTable& faces,
                                        const RiskRule& rule, const std::vector<Vector3d>& normals,
                                        const CandidateOptions& options,
                                        const base::RunContext& ctx) {
  std::vector<std::vector<CutCandidate>> found(normals.size());
  base::parallelChunks(ctx, normals.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!isRisky(normals[i], piece.base.normal, rule))
        found[i] = Sweep(piece.solid.mesh, faces, normals[i], rule, options).run();
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

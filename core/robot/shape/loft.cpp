#include "robot/shape/loft.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kAround = 48;         // Points around a circle
constexpr int kMinOfDisc = 6;       // Minimum points around one of several discs
constexpr int kEdgeSteps = 5;       // Steps along a rounded edge
constexpr double kSharpMm = 0.2;    // Edges with less room are sharp
constexpr double kEdgeShare = 0.45; // Maximum share of the adjacent faces that an edge may use
constexpr double kSamePointMm = 1e-7;

// A section at its place along the loft. Its discs are reduced by `inset` where an end is rounded.
struct Station {
  double at = 0.0, inset = 0.0;
  std::vector<LoftDisc> discs;
};

Station combined(const Station& a, double weightA, const Station& b, double weightB) {
  Station out{weightA * a.at + weightB * b.at, weightA * a.inset + weightB * b.inset, a.discs};
  for (std::size_t i = 0; i < a.discs.size(); ++i) {
    out.discs[i].centre = weightA * a.discs[i].centre + weightB * b.discs[i].centre;
    out.discs[i].radius = weightA * a.discs[i].radius + weightB * b.discs[i].radius;
  }
  return out;
}

// Returns an upper bound of the surface length from one station to the next.
double lengthOf(const Station& a, const Station& b) {
  double lateral = std::abs(b.inset - a.inset);
  for (std::size_t i = 0; i < a.discs.size(); ++i)
    lateral = std::max(lateral, (b.discs[i].centre - a.discs[i].centre).norm() +
                                    std::abs(b.discs[i].radius - a.discs[i].radius));
  return std::hypot(b.at - a.at, lateral);
}

// Returns the angle of the outward normal of the hull's side from disc a to disc b.
double sideAngle(const LoftDisc& a, const LoftDisc& b) {
  const Vector2d along = b.centre - a.centre;
  const double share = std::clamp((a.radius - b.radius) / along.norm(), -1.0, 1.0);
  return std::atan2(along.y(), along.x()) - std::acos(share);
}

struct RimPoint {
  std::size_t disc;
  Vector2d normal;
};

// Returns points around the hull; the number is the same for all stations with that number of
// discs.
std::vector<RimPoint> rimOf(const std::vector<LoftDisc>& discs) {
  std::vector<RimPoint> rim;
  const std::size_t count = discs.size();
  const auto add = [&](std::size_t disc, double angle) {
    rim.push_back({disc, {std::cos(angle), std::sin(angle)}});
  };
  if (count == 1) {
    for (int i = 0; i < kAround; ++i)
      add(0, base::kTwoPi * i / kAround);
    return rim;
  }
  const int steps = std::max(kMinOfDisc, kAround / static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const double from = sideAngle(discs[(i + count - 1) % count], discs[i]);
    double sweep = std::fmod(sideAngle(discs[i], discs[(i + 1) % count]) - from, base::kTwoPi);
    if (sweep < 0.0)
      sweep += base::kTwoPi;
    for (int k = 0; k <= steps; ++k)
      add(i, from + sweep * k / steps);
  }
  return rim;
}

class Lofter {
public:
  explicit Lofter(const Loft& loft) : loft_(loft) {
    const LoftSection &first = loft.sections.front(), &last = loft.sections.back();
    path_.push_back(inner(first));
    for (const LoftSection& section : loft.sections)
      path_.push_back({section.at, 0.0, section.discs});
    path_.push_back(inner(last));
  }

  LoftMesh mesh() {
    for (std::size_t i = 1; i + 1 < path_.size(); ++i)
      addEdge(path_[i - 1], path_[i], path_[i + 1]);
    const int last = static_cast<int>(out_.mesh.vertices.size()) - rimSize_;
    addEnd(0, loft_.sections.front().at, -1.0);
    addEnd(last, loft_.sections.back().at, 1.0);
    return std::move(out_);
  }

private:
  // The inner end of an end face's edge: as far inwards as the smallest disc allows.
  static Station inner(const LoftSection& section) {
    double minimum = section.discs.front().radius;
    for (const LoftDisc& disc : section.discs)
      minimum = std::min(minimum, disc.radius);
    return {section.at, minimum, section.discs};
  }

  // Rounds the corner at `here` by a quadratic Bezier curve.
  void addEdge(const Station& before, const Station& here, const Station& after) {
    const double in = lengthOf(before, here), out = lengthOf(here, after);
    const double room = std::min({loft_.roundMm, kEdgeShare * in, kEdgeShare * out});
    if (room < kSharpMm) {
      addRing(here, combined(here, 1.0, before, -1.0), false);
      addRing(here, combined(after, 1.0, here, -1.0), true);
      return;
    }
    const Station from = combined(here, 1.0 - room / in, before, room / in);
    const Station to = combined(here, 1.0 - room / out, after, room / out);
    const Station leaving = combined(here, 1.0, from, -1.0), coming = combined(to, 1.0, here, -1.0);
    for (int k = 0; k <= kEdgeSteps; ++k) {
      const double t = static_cast<double>(k) / kEdgeSteps;
      const Station a = combined(from, 1.0 - t, here, t), b = combined(here, 1.0 - t, to, t);
      addRing(combined(a, 1.0 - t, b, t), combined(leaving, 1.0 - t, coming, t), false);
    }
  }

  // `rate`: change of the station along the loft. `doubled`: same position as the previous ring.
  void addRing(const Station& station, const Station& rate, bool doubled) {
    const std::vector<RimPoint> rim = rimOf(station.discs);
    const int first = static_cast<int>(out_.mesh.vertices.size());
    for (const RimPoint& point : rim) {
      const LoftDisc &disc = station.discs[point.disc], &change = rate.discs[point.disc];
      const Vector2d p = disc.centre + (disc.radius - station.inset) * point.normal;
      const double outwards = change.centre.dot(point.normal) + change.radius - rate.inset;
      addPoint({p.x(), p.y(), station.at},
               Vector3d(rate.at * point.normal.x(), rate.at * point.normal.y(), -outwards));
    }
    const int size = static_cast<int>(rim.size());
    if (rimSize_ > 0 && !doubled)
      for (int i = 0; i < size; ++i) {
        const int next = (i + 1) % size, below = first - size;
        addTriangle(below + i, below + next, first + next);
        addTriangle(below + i, first + next, first + i);
      }
    rimSize_ = size;
  }

  void addEnd(int ring, double at, double side) {
    Vector2d middle = Vector2d::Zero();
    const auto& discs = (side < 0.0 ? loft_.sections.front() : loft_.sections.back()).discs;
    for (const LoftDisc& disc : discs)
      middle += disc.centre / static_cast<double>(discs.size());
    addPoint({middle.x(), middle.y(), at}, side * Vector3d::UnitZ());
    const int centre = static_cast<int>(out_.mesh.vertices.size()) - 1;
    for (int i = 0; i < rimSize_; ++i) {
      const int a = ring + i, b = ring + (i + 1) % rimSize_;
      addTriangle(centre, side > 0.0 ? a : b, side > 0.0 ? b : a);
    }
  }

  void addPoint(const Vector3d& p, const Vector3d& normal) {
    out_.mesh.vertices.push_back(loft_.frame_T_loft * p);
    out_.normals.push_back(loft_.frame_T_loft.linear() * normal.normalized());
  }

  void addTriangle(int a, int b, int c) {
    const auto apart = [&](int i, int j) {
      return (out_.mesh.vertices[static_cast<std::size_t>(i)] -
              out_.mesh.vertices[static_cast<std::size_t>(j)])
                 .norm() > kSamePointMm;
    };
    if (apart(a, b) && apart(b, c) && apart(c, a))
      out_.mesh.triangles.push_back({a, b, c});
  }

  const Loft& loft_;
  std::vector<Station> path_;
  LoftMesh out_;
  int rimSize_ = 0;
};

} // namespace

LoftSection circleSection(double at, double radius) {
  return {at, {{Vector2d::Zero(), radius}}};
}

LoftSection rectangleSection(double at, const Vector2d& size, double roundMm,
                             const Vector2d& centre) {
  const Vector2d half = 0.5 * size - Vector2d::Constant(roundMm);
  LoftSection section{at, {}};
  for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
    section.discs.push_back({centre + Vector2d(x * half.x(), y * half.y()), roundMm});
  return section;
}

Eigen::Isometry3d loftPose(const Vector3d& origin, const Vector3d& axis, const Vector3d& across) {
  base::require(axis.norm() > 0.0, "a loft along no axis");
  const Vector3d z = axis.normalized();
  Vector3d x = across - across.dot(z) * z;
  x = x.norm() > 1e-9 ? x.normalized().eval() : z.unitOrthogonal();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = origin;
  return pose;
}

LoftMesh meshOf(const Loft& loft) {
  base::require(loft.sections.size() >= 2, "a loft of two sections or more");
  for (const LoftSection& section : loft.sections)
    base::require(!section.discs.empty() &&
                      section.discs.size() == loft.sections.front().discs.size(),
                  "sections of a loft with as many discs each");
  return Lofter(loft).mesh();
}

} // namespace voluta::robot

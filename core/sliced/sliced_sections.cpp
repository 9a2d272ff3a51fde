#include "sliced/sliced_sections.h"

#include "process/bead_model.h"
#include "process/bead_to.h"
#include "sliced/rising_heights.h"
#include "sliced/sliced_heights.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace voluta::sliced {

namespace {
using Eigen::Vector3d;

constexpr double kMinLengthMm = 1e-6;
constexpr double kClosedMm = 0.002;   // Rounding of coordinates in files
constexpr double kNearlyClosed = 1.5; // [bead widths] seam gap of a loop
constexpr double kStepMm = 0.25;      // Length over which a step of the section is spread
constexpr double kSameShare = 0.05;   // Sections within it do not count as a step

struct Segment {
  Vector3d to, direction;
  double lengthMm, areaMm2, heightMm, speedMmPerS;
};

// Returns the areas of the sections on the way to each point of a path.
std::vector<double> areasOf(const SlicedPath& path, double filamentMm2) {
  std::vector<double> areas(path.points.size(), 0.0);
  for (std::size_t i = 1; i < areas.size(); ++i) {
    const double moveMm = (path.points[i].position - path.points[i - 1].position).norm();
    areas[i] = moveMm < kMinLengthMm ? 0.0 : path.points[i].extruded * filamentMm2 / moveMm;
  }
  return areas;
}

// Returns the usual width of a bead, for a bead three times as wide as high.
double usualWidth(const SlicedFile& file, double filamentMm2) {
  std::vector<double> areas;
  for (const SlicedPath& path : file.paths)
    for (const double area : areasOf(path, filamentMm2))
      if (area > 0.0)
        areas.push_back(area);
  if (areas.empty())
    return 1.0;
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::nth_element(areas.begin(), middle, areas.end());
  constexpr double kWidthPerHeight = 3.0;
  return std::sqrt(kWidthPerHeight * *middle);
}

// `rising`: heights on the way to each point that replace those of the file; 0 or empty: none.
std::vector<Segment> segmentsOf(const SlicedPath& path, double filamentMm2, double layerMm,
                                const std::vector<double>& rising) {
  std::vector<Segment> segments;
  Vector3d at = path.points.front().position;
  double carried = 0.0; // Volume of ways that are too short
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const SlicedPoint& p = path.points[i];
    const double moveMm = (p.position - at).norm();
    carried += p.extruded * filamentMm2;
    if (moveMm < kMinLengthMm)
      continue;
    const double stated = p.heightMm > 0.0 ? p.heightMm : layerMm;
    segments.push_back({p.position, p.direction, moveMm, carried / moveMm,
                        !rising.empty() && rising[i] > 0.0 ? rising[i] : stated, p.speedMmPerS});
    carried = 0.0;
    at = p.position;
  }
  if (carried > 0.0 && !segments.empty())
    segments.back().areaMm2 += carried / segments.back().lengthMm;
  return segments;
}

bool isStep(const Segment& a, const Segment& b) {
  const auto differ = [](double x, double y) {
    return std::abs(x - y) > kSameShare * std::max(x, y);
  };
  return differ(a.areaMm2, b.areaMm2) || differ(a.heightMm, b.heightMm);
}

// Divides segments beside a step, so that it does not spread over all their length.
std::vector<Segment> dividedAtSteps(const std::vector<Segment>& segments, const Vector3d& start) {
  std::vector<Segment> divided;
  Vector3d from = start;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Segment& s = segments[k];
    const double near = std::min(kStepMm, 0.25 * s.lengthMm);
    const bool before = k > 0 && isStep(segments[k - 1], s);
    const bool after = k + 1 < segments.size() && isStep(s, segments[k + 1]);
    double done = 0.0;
    const auto cut = [&](double atMm) {
      Segment piece = s;
      piece.to = from + atMm / s.lengthMm * (s.to - from);
      piece.lengthMm = atMm - done;
      divided.push_back(piece);
      done = atMm;
    };
    if (before)
      cut(near);
    if (after)
      cut(s.lengthMm - near);
    Segment rest = s;
    rest.lengthMm = s.lengthMm - done;
    divided.push_back(rest);
    from = s.to;
  }
  return divided;
}

class Laying {
public:
  explicit Laying(plan::ToolPlan& into) : into_(into) {}

  // Adds the waypoints of a path. Precondition: at least one segment.
  void lay(const SlicedPoint& start, const std::vector<Segment>& segments) {
    const Segment& first = segments.front();
    add(start.position, start.direction, first.areaMm2, first.heightMm, first.speedMmPerS);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const Segment &a = segments[k], &b = segments[std::min(k + 1, segments.size() - 1)];
      const double all = a.lengthMm + b.lengthMm;
      add(a.to, a.direction, (a.lengthMm * a.areaMm2 + b.lengthMm * b.areaMm2) / all,
          (a.lengthMm * a.heightMm + b.lengthMm * b.heightMm) / all, a.speedMmPerS);
    }
  }

private:
  void add(const Vector3d& at, const Vector3d& direction, double areaMm2, double heightMm,
           double speed) {
    const double round = std::sqrt(areaMm2 / (base::kPi / 4.0));
    const double height = std::min(heightMm, round);
    into_.position.push_back(at);
    into_.direction.push_back(direction);
    into_.heightMm.push_back(static_cast<float>(height));
    into_.widthMm.push_back(static_cast<float>(height <= 0.0 ? 0.0
                                               : height == round
                                                   ? round
                                                   : process::widthOfArea(areaMm2, height)));
    into_.speedMmPerS.push_back(static_cast<float>(speed));
  }

  plan::ToolPlan& into_;
};

} // namespace

namespace {
// Returns the straight runs of a path, as vectors.
std::vector<Vector3d> runsOf(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  constexpr double kStraight = 0.999;
  std::vector<Vector3d> runs;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
    const Vector3d step = plan.position[i] - plan.position[i - 1];
    if (!(step.norm() > kMinLengthMm))
      continue;
    if (!runs.empty() && runs.back().dot(step) > kStraight * runs.back().norm() * step.norm())
      runs.back() += step;
    else
      runs.push_back(step);
  }
  return runs;
}

// Returns whether a path goes to and fro in rows beside each other, as infill does. Its ends may
// meet by chance.
bool isZigzag(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  constexpr double kLink = 10.0; // [bead widths] from a row to the next
  constexpr double kReverse = -0.9;
  constexpr int kMinRevolutions = 4;
  const std::vector<Vector3d> runs = runsOf(plan, path);
  const double link = kLink * static_cast<double>(plan.widthMm[path.first]);
  const auto reverses = [&](std::size_t a, std::size_t b) {
    return runs[a].dot(runs[b]) < kReverse * runs[a].norm() * runs[b].norm();
  };
  int turns = 0;
  double rows = 0.0, all = 0.0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    all += runs[k].norm();
    const bool sharp = k + 1 < runs.size() && reverses(k, k + 1);
    const bool linked = k + 2 < runs.size() && runs[k + 1].norm() <= link &&
                        runs[k].norm() > runs[k + 1].norm() && reverses(k, k + 2);
    if (sharp || linked) {
      ++turns;
      rows += runs[k].norm();
    }
  }
  return turns >= kMinRevolutions && rows > 0.5 * all;
}

// Returns whether a path goes round while it rises, as a spiral vase does.
bool isSpiral(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  constexpr double kRoundingMm = 1e-4, kSlope = 0.2;
  double length = 0.0;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
    const Vector3d step = plan.position[i] - plan.position[i - 1];
    if (step.z() < -kRoundingMm)
      return false;
    length += step.norm();
  }
  const double rise =
      plan.position[path.first + path.count - 1].z() - plan.position[path.first].z();
  return path.count >= 4 &&
         rise > static_cast<double>(plan.heightMm[path.first + path.count - 1]) &&
         rise < kSlope * length && !isZigzag(plan, path);
}

bool isLoop(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  const double gap =
      (plan.position[path.first + path.count - 1] - plan.position[path.first]).norm();
  return path.count >= 4 && gap <= kNearlyClosed * static_cast<double>(plan.widthMm[path.first]) &&
         !isZigzag(plan, path);
}
} // namespace

plan::ToolPlan beadsOf(const SlicedFile& file, double filamentMm2,
                       std::vector<std::size_t>* lines) {
  plan::ToolPlan plan;
  const LayerHeights heights(file);
  Laying laying(plan);
  std::optional<BeadTops> tops;
  if (std::ranges::any_of(file.paths, isRising))
    tops.emplace(usualWidth(file, filamentMm2));
  for (const SlicedPath& path : file.paths) {
    const LayerHeights::Layer layer = heights.of(path);
    const double lastStated = path.points.back().heightMm;
    const std::vector<Segment> segments =
        segmentsOf(path, filamentMm2, layer.heightMm,
                   tops ? tops->add(path, areasOf(path, filamentMm2),
                                    lastStated > 0.0 ? lastStated : layer.heightMm)
                        : std::vector<double>());
    if (segments.empty())
      continue;
    plan::ToolPath made;
    made.first = plan.waypointCount();
    laying.lay(path.points.front(), dividedAtSteps(segments, path.points.front().position));
    made.count = plan.waypointCount() - made.first;
    const double gap = (plan.position.back() - plan.position[made.first]).norm();
    made.closed = made.count >= 4 && gap <= kClosedMm;
    if (made.closed)
      plan.position.back() = plan.position[made.first];
    made.kind = path.kind                                    ? *path.kind
                : isLoop(plan, made) || isSpiral(plan, made) ? plan::PathKind::Wall
                                                             : plan::PathKind::Infill;
    made.tool = path.tool;
    made.layer = path.layer >= 0 ? path.layer : layer.index;
    made.ring = made.kind == plan::PathKind::Wall && path.kind && !path.outermost ? 1 : 0;
    plan.paths.push_back(made);
    if (lines)
      lines->push_back(path.line);
  }
  return plan;
}

double beadsMm3(const plan::ToolPlan& plan) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    volume += beadsMm3(plan, path);
  return volume;
}

double beadsMm3(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  double volume = 0.0;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
    volume += process::beadTo(plan, i);
  return volume;
}

} // namespace voluta::sliced

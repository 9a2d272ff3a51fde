#include "toolpath/prime_path.h"

#include "base/units.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "robot/plate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace voluta::toolpath {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kSides = 24;

Vector2d side(int k) {
  const double a = 2.0 * base::kPi * k / kSides;
  return {std::cos(a), std::sin(a)};
}

// Returns the maximum extent of the points in a direction.
template <typename Points> double reach(const Points& points, const Vector2d& heading) {
  double maximum = -std::numeric_limits<double>::infinity();
  for (const auto& p : points)
    maximum = std::max(maximum, p.x() * heading.x() + p.y() * heading.y());
  return maximum;
}

bool inside(const std::vector<Vector2d>& plate, const Vector2d& p, double fromEdgeMm) {
  for (std::size_t i = 0; i < plate.size(); ++i) {
    const Vector2d along = plate[(i + 1) % plate.size()] - plate[i], to = p - plate[i];
    if (along.norm() > 0.0 && along.x() * to.y() - along.y() * to.x() < fromEdgeMm * along.norm())
      return false;
  }
  return true;
}

// Returns a line perpendicular to `out`, at this distance along it, centred on `middle`.
std::vector<Vector2d> lineAt(const Vector2d& out, double distanceMm, const Vector2d& middle,
                             double lengthMm) {
  const Vector2d along(-out.y(), out.x());
  const Vector2d centre = distanceMm * out + along.dot(middle) * along;
  return {centre - 0.5 * lengthMm * along, centre + 0.5 * lengthMm * along};
}

// Returns a polygon around all points, with its sides at this distance from them.
std::vector<Vector2d> ringAround(const std::vector<Vector3d>& points, double offsetMm) {
  std::vector<Vector2d> corners;
  for (int k = 0; k <= kSides; ++k) {
    Eigen::Matrix2d sides;
    sides << side(k % kSides).transpose(), side((k + 1) % kSides).transpose();
    corners.emplace_back(sides.inverse() *
                         Vector2d(reach(points, side(k % kSides)) + offsetMm,
                                  reach(points, side((k + 1) % kSides)) + offsetMm));
  }
  return corners;
}

double inAirMm(double beadWidthMm) {
  return std::max(kPrimeInAirMm, 3.0 * beadWidthMm);
}

} // namespace

PrimePlace primePlace(const std::vector<Vector2d>& plate, const std::vector<Vector3d>& positions,
                      const Vector2d& rest, bool skirt, double lengthMm, double beadWidthMm) {
  const double offsetMm = std::max(kPrimeOffsetMm, 2.0 * beadWidthMm);
  const double fromEdgeMm = std::max(kPrimeFromEdgeMm, beadWidthMm);
  const auto fits = [&](const std::vector<Vector2d>& corners) {
    return std::ranges::all_of(corners,
                               [&](const Vector2d& p) { return inside(plate, p, fromEdgeMm); });
  };
  if (skirt)
    if (auto ring = ringAround(positions, offsetMm); fits(ring))
      return {std::move(ring), true};
  Vector2d middle = Vector2d::Zero();
  for (const Vector3d& p : positions)
    middle += p.head<2>() / static_cast<double>(positions.size());
  // Chooses the line with an end nearest to `to` and puts that end first or last.
  const auto nearest = [&](const Vector2d& to, bool first, auto&& line) {
    std::optional<std::vector<Vector2d>> best;
    double minimum = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kSides; ++k) {
      std::vector<Vector2d> corners = line(side(k));
      if (corners.empty())
        continue;
      const double front = (corners.front() - to).norm(), back = (corners.back() - to).norm();
      if (first ? back < front : front < back)
        std::ranges::reverse(corners);
      if (const double d = std::min(front, back); d < minimum - 1e-9) {
        minimum = d;
        best = std::move(corners);
      }
    }
    return best;
  };
  const Vector2d begin = positions.front().head<2>();
  for (const double length : {lengthMm, 0.5 * lengthMm})
    if (auto line = nearest(begin, false, [&](const Vector2d& out) {
          auto corners = lineAt(out, reach(positions, out) + offsetMm, middle, length);
          return fits(corners) ? corners : std::vector<Vector2d>();
        }))
      return {*std::move(line), true};
  return {*nearest(rest, true,
                   [&](const Vector2d& out) {
                     return lineAt(out, reach(plate, out) + std::max(kPrimeOutsideMm, offsetMm),
                                   Vector2d::Zero(), inAirMm(beadWidthMm));
                   }),
          false};
}

bool hasRoomForPrime(const std::vector<Vector2d>& plate, const std::vector<Vector3d>& positions,
                     bool skirt, double lengthMm, double beadWidthMm) {
  return primePlace(plate, positions, Vector2d::Zero(), skirt, lengthMm, beadWidthMm).onPlate;
}

std::optional<plan::Finding> addPrimePath(plan::ToolPlan& plan, const robot::Cell& cell,
                                          const process::Tooling& tooling,
                                          const ToolpathOptions& options,
                                          std::span<const Vector3d> others) {
  const robot::Prism* plate = robot::plateOf(cell);
  if (options.prime == "none" || plan.paths.empty() || !plate || options.platform.mesh ||
      options.platform.rod)
    return std::nullopt;
  // It fills the nozzle of the tool that prints first.
  const bool isTape = tooling.of(plan.paths.front()).process.tape.has_value();
  const int tool = isTape ? 0 : plan.paths.front().tool;
  const process::Process& process = tooling.at(tool).process;
  std::vector<Vector3d> printed = plan.position;
  printed.insert(printed.end(), others.begin(), others.end());
  const PrimePlace place =
      primePlace(plate->polygon, printed, cell.work_T_tool(cell.home()).translation().head<2>(),
                 options.prime == "skirt", options.primeLengthMm, process.beadWidthMm);
  const double height = process.layerHeightMm, width = process.beadWidthMm;
  const double z = place.onPlate ? height : std::max(kPrimeAboveMm, 2.0 * height);
  std::vector<Vector3d> points;
  for (std::size_t c = 0; c + 1 < place.corners.size(); ++c) {
    const Vector2d step = place.corners[c + 1] - place.corners[c];
    const int n = std::max(1, static_cast<int>(std::ceil(step.norm() / options.stepMm - 1e-9)));
    for (int i = c == 0 ? 0 : 1; i <= n; ++i) {
      const Vector2d at = place.corners[c] + step * i / n;
      points.emplace_back(at.x(), at.y(), z);
    }
  }
  const std::size_t count = points.size();
  const double speed =
      std::min(process.speedMmPerS, process::flowLimit(process) / process::beadArea(width, height));
  const auto before = [&](auto& list, const auto& value) {
    list.insert(list.begin(), count, value);
  };
  plan.position.insert(plan.position.begin(), points.begin(), points.end());
  before(plan.direction, Vector3d::UnitZ().eval());
  before(plan.widthMm, static_cast<float>(width));
  before(plan.heightMm, static_cast<float>(height));
  before(plan.speedMmPerS, static_cast<float>(speed));
  for (plan::ToolPath& path : plan.paths)
    path.first += count;
  plan::ToolPath path;
  path.count = count;
  path.layer = plan.paths.front().layer;
  path.patch = plan.paths.front().patch;
  path.group = plan.paths.front().group;
  path.item = plan.paths.front().item;
  path.tool = tool;
  path.closed = place.corners.size() > 2;
  path.kind = path.closed ? plan::PathKind::Skirt : plan::PathKind::Prime;
  plan.paths.insert(plan.paths.begin(), path);
  if (place.onPlate)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::PrimeFalls, {{"length", base::mm(inAirMm(width))}},
                           points.front());
}

} // namespace voluta::toolpath

#include "robot/cell/platform_reader.h"

#include "base/error.h"
#include "robot/cell/shape_reader.h"
#include "robot/plate.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace voluta::robot {

namespace {
constexpr double kStepMm = 1e-9; // sections of a rod closer than this are a step, not a frustum

// Returns the rod in the cell: the job's if it has one.
platform::RodShape rodOf(const CellRod& own, const std::optional<platform::RodShape>& wanted,
                         const std::string& cell) {
  constexpr double kSlackMm = 1e-9;
  if (!wanted)
    return platform::straightRod(own.diameterMm, own.lengthMm);
  platform::checkRod(*wanted);
  const double reach =
      std::max(-wanted->profile.front().x(), wanted->profile.back().x()) - kSlackMm;
  const auto refuse = [&](const base::Message& what, const base::Message& remedy) {
    return base::Error(base::ErrorCode::UnusableInput, what,
                       base::message("cell {cell}"_text, cell), remedy);
  };
  if (reach > 0.5 * own.lengthMm)
    throw refuse(
        base::message(
            "the rod extends {reach} mm from its middle; the cell has room for {room} mm"_text,
            base::number(reach), base::number(0.5 * own.lengthMm)),
        "choose a shorter rod"_text);
  for (const Eigen::Vector2d& at : wanted->profile)
    if (at.y() > own.printableRadiusMm)
      throw refuse(
          base::message("the rod's radius is {radius} mm; the cell prints up to {most} mm"_text,
                        base::number(at.y()), base::number(own.printableRadiusMm)),
          "choose a thinner rod"_text);
  return *wanted;
}

void requireConvex(const std::vector<Eigen::Vector2d>& polygon) {
  base::require(polygon.size() >= 3, "a platform's polygon has three corners or more");
  const std::size_t n = polygon.size();
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    const Eigen::Vector2d ab = b - a, bc = c - b;
    base::require(ab.x() * bc.y() - ab.y() * bc.x() >= -1e-9 * (1.0 + ab.norm() * bc.norm()),
                  "a platform's polygon is convex and counter-clockwise");
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  base::require(area > 0.0, "a platform's polygon has an area");
}
} // namespace

CellRod readRod(const base::JsonNode& node) {
  node.allowOnly({"diameterMm", "lengthMm", "printableRadiusMm"});
  const CellRod rod{node.at("diameterMm").positive(), node.at("lengthMm").positive(),
                    node.at("printableRadiusMm").positive()};
  if (rod.printableRadiusMm <= 0.5 * rod.diameterMm)
    node.at("printableRadiusMm").fail("must be greater than the rod's radius"_text);
  return rod;
}

// A rod is on the work frame's x and turns about it.
void requireTurnsRod(const base::JsonNode& axes, const std::vector<ExternalAxis>& chain,
                     const Eigen::Isometry3d& axis_T_work) {
  constexpr double kSame = 1e-9;
  if (chain.size() != 1 || chain.front().limits.kind != JointKind::Turning)
    axes.fail("must have exactly one axis, which turns the rod"_text);
  if ((axis_T_work.linear().col(0) - Eigen::Vector3d::UnitX()).norm() > kSame ||
      axis_T_work.translation().tail<2>().norm() > kSame)
    axes.fail("must turn the rod about its own axis, the work frame's x"_text);
}

// Replaces a prism by the round rod through its vertices. A step of the radius needs no frustum.
Body rodBody(const CellRod& own, const std::optional<platform::RodShape>& wanted,
             const std::string& cell, int workFrame) {
  const platform::RodShape rod = rodOf(own, wanted, cell);
  Body body{"platform", BodyRole::Platform, workFrame, {}};
  for (std::size_t i = 1; i < rod.profile.size(); ++i) {
    const Eigen::Vector2d &a = rod.profile[i - 1], &b = rod.profile[i];
    if (b.x() - a.x() > kStepMm)
      body.shapes.push_back(
          Frustum{Eigen::Vector3d(a.x(), 0, 0), Eigen::Vector3d(b.x(), 0, 0), a.y(), b.y()});
  }
  return body;
}

Body plateBody(const base::JsonNode& platform, std::vector<Eigen::Vector2d> polygon,
               int workFrame) {
  requireConvex(polygon);
  Body plate{"platform", BodyRole::Platform, workFrame, {}};
  plate.shapes.push_back(Prism{std::move(polygon), -platform.at("thicknessMm").positive(), 0.0});
  if (platform.has("stem"))
    for (Shape& shape : readShapes(platform.at("stem")))
      plate.shapes.push_back(std::move(shape));
  if (auto foot = footOf(std::get<Prism>(plate.shapes.front()), plate.shapes))
    plate.shapes.push_back(*std::move(foot));
  return plate;
}

} // namespace voluta::robot

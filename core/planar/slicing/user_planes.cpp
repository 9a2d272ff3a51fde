#include "planar/slicing/user_planes.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "layers/order.h"
#include "layers/patches.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;
using Json = nlohmann::json;

namespace {

constexpr double kFlatMm = 0.01; // maximum distance of corners from their plane
// Minimum cosine between the normals of layers on top of each other
constexpr double kMinFacing = 0.1;
constexpr double kThinnestMm = 0.01;  // closer layers are side by side, or cross
constexpr double kBeyondShare = 0.01; // share of the area with thickness outside the limits

[[noreturn]] void unusable(const base::Message& what, const base::Value& where) {
  throw base::Error(base::ErrorCode::UnusableInput, what, where,
                    "give a list of {\"point\": [x, y, z], \"normal\": [x, y, z]} or {\"corners\": "
                    "[four points]}, in mm"_text);
}

Vector3d pointOf(const Json& j, const base::Value& where) {
  if (!j.is_array() || j.size() != 3 ||
      !std::all_of(j.begin(), j.end(), [](const Json& x) { return x.is_number(); }))
    unusable("a point needs three numbers"_text, where);
  const Vector3d p(j[0].get<double>(), j[1].get<double>(), j[2].get<double>());
  if (!p.allFinite() || p.cwiseAbs().maxCoeff() > 1e6)
    unusable("point too far from the origin"_text, where);
  return p;
}

UserPlane quadrilateral(const Json& corners, const base::Value& where) {
  if (!corners.is_array() || corners.size() != 4)
    unusable("a quadrilateral needs four corners"_text, where);
  UserPlane out;
  Vector3d middle = Vector3d::Zero();
  for (const Json& c : corners) {
    out.corners.push_back(pointOf(c, where));
    middle += out.corners.back() / 4.0;
  }
  const Vector3d across = (out.corners[2] - out.corners[0]).cross(out.corners[3] - out.corners[1]);
  if (across.norm() < 1e-9)
    unusable("the quadrilateral has no area"_text, where);
  out.plane.normal = across.normalized();
  out.plane.offsetMm = out.plane.normal.dot(middle);
  out.point = middle;
  for (std::size_t k = 0; k < 4; ++k) {
    if (std::abs(out.plane.heightOf(out.corners[k])) > kFlatMm)
      unusable("the quadrilateral is not flat"_text, where);
    const Vector3d a = out.corners[(k + 1) % 4] - out.corners[k],
                   b = out.corners[(k + 2) % 4] - out.corners[(k + 1) % 4];
    if (a.cross(b).dot(out.plane.normal) <= 0.0)
      unusable("the quadrilateral is not convex"_text, where);
  }
  return out;
}

// Returns the distance inside the side that starts at corner k; negative outside.
double insideOf(const UserPlane& p, std::size_t k, const Vector3d& point) {
  const Vector3d along = p.corners[(k + 1) % 4] - p.corners[k];
  return p.plane.normal.cross(along).normalized().dot(point - p.corners[k]);
}

bool holds(const UserPlane& p, const Vector3d& point) {
  for (std::size_t k = 0; k < p.corners.size(); ++k)
    if (insideOf(p, k, point) < -kFlatMm)
      return false;
  return true;
}

// Returns the distance along -normal to the nearest earlier layer.
std::optional<double> thicknessAt(const Vector3d& p, const std::vector<UserPlane>& planes,
                                  std::size_t layer) {
  const Vector3d& n = planes[layer].plane.normal;
  std::optional<double> minimum;
  const auto take = [&](double distance) {
    if (distance > kThinnestMm && (!minimum || distance < *minimum))
      minimum = distance;
  };
  if (n.z() > kMinFacing)
    take(2.0 * p.z() / n.z());
  for (std::size_t j = 0; j < layer; ++j) {
    const double facing = n.dot(planes[j].plane.normal);
    if (facing <= kMinFacing)
      continue;
    const double distance = planes[j].plane.heightOf(p) / facing;
    if (holds(planes[j], p - distance * n))
      take(distance);
  }
  return minimum;
}

} // namespace

std::vector<UserPlane> readUserPlanes(const std::string& text, const std::string& where) {
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array() || list.empty())
    unusable("the planes are not a JSON list"_text, where);
  std::vector<UserPlane> out;
  for (const Json& entry : list) {
    const base::Value place = base::message("{where}, entry {number}"_text, where, out.size() + 1);
    if (entry.is_object() && entry.contains("corners")) {
      out.push_back(quadrilateral(entry["corners"], place));
    } else if (entry.is_object() && entry.contains("point") && entry.contains("normal")) {
      const Vector3d normal = pointOf(entry["normal"], place);
      if (normal.norm() < 1e-9)
        unusable("the normal has zero length"_text, place);
      const Vector3d unit = normal.normalized();
      const Vector3d point = pointOf(entry["point"], place);
      out.push_back({{unit, unit.dot(point)}, {}, point});
    } else {
      unusable("neither a plane nor a quadrilateral"_text, place);
    }
  }
  return out;
}

SliceResult sliceByPlanes(const geometry::TriangleMesh& part, const std::vector<UserPlane>& planes,
                          const SliceOptions& options, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  SliceResult result;
  result.layersOfPiece = {static_cast<int>(planes.size())};
  result.volumeOfPiece = {0.0};
  std::vector<layers::Patch> slivers;
  std::size_t misses = 0;
  std::string missing;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    ctx.report(0.8 * static_cast<double>(i) / static_cast<double>(planes.size()), "slicing"_text);
    const UserPlane& p = planes[i];
    layers::LevelSurface s =
        sectionSurface(Sections(part, p.plane.normal).at(p.plane.offsetMm), options.edgeMm, ctx);
    for (std::size_t k = 0; k < p.corners.size(); ++k) {
      std::vector<double> inside;
      for (const Vector3d& v : s.surface.vertices)
        inside.push_back(insideOf(p, k, v));
      layers::keepPositive(s, inside);
    }
    s.level = static_cast<int>(i);
    s.thicknessMm.clear();
    // Points without an earlier layer below are reported as unsupported.
    for (const Vector3d& v : s.surface.vertices)
      s.thicknessMm.push_back(
          std::max(kThinnestMm, thicknessAt(v, planes, i).value_or(options.heights.wantedMm)));
    layers::PatchesOfLevel made = layers::makePatches(s, {options.beadWidthMm});
    if (made.patches.empty() && made.slivers.empty()) {
      ++misses;
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", i + 1);
    }
    std::move(made.patches.begin(), made.patches.end(), std::back_inserter(result.stack.patches));
    std::move(made.slivers.begin(), made.slivers.end(), std::back_inserter(slivers));
  }
  layers::orderForPrinting(result.stack);
  if (misses > 0)
    result.findings.push_back(plan::makeFinding(plan::FindingKind::PlaneMisses,
                                                {{"planes", missing}}, std::nullopt, misses));
  finishStack(result, slivers, options, ctx);
  if (const double beyond = 1.0 - result.statistics.withinLimitsFraction; beyond > kBeyondShare)
    result.findings.push_back(plan::makeFinding(plan::FindingKind::HeightBeyondLimits,
                                                {{"share", base::percent(100.0 * beyond)},
                                                 {"least", base::mm(options.heights.minMm)},
                                                 {"most", base::mm(options.heights.maxMm)}}));
  result.seconds.extract = watch.seconds();
  return result;
}

} // namespace voluta::planar

#include "process/head_shapes.h"

#include "base/error.h"
#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::process {

namespace {
using Eigen::Vector3d;

constexpr double kTipShare = 0.01; // Of the height: vertices that form the tip
constexpr double kMaxLevels = 4096.0;
constexpr double kSameMm = 1e-9;
constexpr double kMinHeightMm = 1.0;     // Lower meshes were drawn in another unit
constexpr std::size_t kMaxSections = 48; // Each costs time in collision checks

[[noreturn]] void refuse(base::Message reason, base::Message remedy = {}) {
  throw base::Error(base::ErrorCode::UnusableInput, std::move(reason), {}, std::move(remedy));
}

void checkPositive(double value, base::Text name) {
  if (!(value > 0.0))
    refuse(base::message("{name} must be greater than 0"_text, name));
}

geometry::TriangleMesh turnedOver(geometry::TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices)
    v = {v.x(), -v.y(), -v.z()};
  return mesh;
}

// The mesh with its tip at the origin, heights rounded to multiples of `levelMm`.
std::vector<Vector3d> aroundAxis(const geometry::TriangleMesh& mesh, double levelMm) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : mesh.vertices)
    box.extend(v);
  const double bottom = box.min().z();
  Eigen::AlignedBox3d tip;
  for (const Vector3d& v : mesh.vertices)
    if (v.z() <= bottom + kTipShare * box.sizes().z())
      tip.extend(v);
  const Vector3d origin(tip.center().x(), tip.center().y(), bottom);
  std::vector<Vector3d> all;
  all.reserve(mesh.vertices.size());
  for (const Vector3d& v : mesh.vertices) {
    Vector3d at = v - origin;
    at.z() = levelMm * std::round(at.z() / levelMm);
    all.push_back(at);
  }
  return all;
}

// Radii just above the lower end and just below the upper end of a slab between two levels.
struct Slab {
  double lower = 0.0, upper = 0.0;
};

double radiusAt(const Vector3d& a, const Vector3d& b, double z) {
  const double share = (z - a.z()) / (b.z() - a.z());
  return (a + share * (b - a)).head<2>().norm();
}

// A radius along an edge is a convex function of the height, so that straight lines between levels
// contain it.
std::vector<Slab> slabsOf(const geometry::TriangleMesh& mesh, const std::vector<Vector3d>& vertices,
                          const std::vector<double>& levels) {
  std::vector<Slab> slabs(levels.size() - 1);
  for (const std::array<int, 3>& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d* a = &vertices[static_cast<std::size_t>(triangle[k])];
      const Vector3d* b = &vertices[static_cast<std::size_t>(triangle[(k + 1) % 3])];
      if (a->z() > b->z())
        std::swap(a, b);
      const auto from = std::ranges::lower_bound(levels, a->z());
      for (auto i = static_cast<std::size_t>(from - levels.begin());
           i + 1 < levels.size() && levels[i + 1] <= b->z(); ++i) {
        slabs[i].lower = std::max(slabs[i].lower, radiusAt(*a, *b, levels[i]));
        slabs[i].upper = std::max(slabs[i].upper, radiusAt(*a, *b, levels[i + 1]));
      }
    }
  return slabs;
}

double radiusBetween(const HeadSection& a, const HeadSection& b, double zMm) {
  return b.zMm > a.zMm ? a.radiusMm + (b.radiusMm - a.radiusMm) * (zMm - a.zMm) / (b.zMm - a.zMm)
                       : std::max(a.radiusMm, b.radiusMm);
}

// Keeps the points of sections[first..last] that the chord would miss by more than the tolerance.
void keepFar(const std::vector<HeadSection>& sections, std::size_t first, std::size_t last,
             double toleranceMm, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double worst = toleranceMm;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double off =
          std::abs(sections[i].radiusMm - radiusBetween(sections[a], sections[b], sections[i].zMm));
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (at == a)
      continue;
    kept[at] = true;
    open.emplace_back(a, at);
    open.emplace_back(at, b);
  }
}

// Drops sections within the tolerance, then widens the rest until they contain those dropped.
HeadShape simplified(const std::vector<HeadSection>& sections, double toleranceMm) {
  std::vector<bool> kept(sections.size(), false);
  kept.front() = kept.back() = true;
  std::size_t first = 0;
  for (std::size_t i = 1; i < sections.size(); ++i)
    if (sections[i].zMm == sections[i - 1].zMm || i + 1 == sections.size()) {
      const std::size_t last = i + 1 == sections.size() ? i : i - 1;
      kept[last] = kept[i] = true;
      keepFar(sections, first, last, 0.5 * toleranceMm, kept);
      first = i;
    }
  HeadShape head;
  std::vector<double> wider;
  for (std::size_t i = 0, before = 0; i < sections.size(); ++i) {
    if (!kept[i])
      continue;
    double missing = 0.0;
    for (std::size_t k = before + 1; k < i; ++k)
      missing =
          std::max(missing, sections[k].radiusMm -
                                radiusBetween(sections[before], sections[i], sections[k].zMm));
    if (!wider.empty())
      wider.back() = std::max(wider.back(), missing);
    head.sections.push_back(sections[i]);
    wider.push_back(missing);
    before = i;
  }
  for (std::size_t i = 0; i < wider.size(); ++i)
    head.sections[i].radiusMm += wider[i];
  return head;
}
} // namespace

HeadShape headFromNumbers(const HeadNumbers& n) {
  checkPositive(n.tipRadiusMm, "nozzle tip radius"_text);
  checkPositive(n.coneAngleDeg, "cone angle"_text);
  checkPositive(n.coneHeightMm, "cone height"_text);
  checkPositive(n.blockWidthMm, "block width"_text);
  checkPositive(n.blockHeightMm, "block height"_text);
  if (n.coneAngleDeg >= 180.0)
    refuse("cone angle must be below 180°"_text);
  const double top =
      n.tipRadiusMm + n.coneHeightMm * std::tan(0.5 * n.coneAngleDeg * base::kPi / 180.0);
  const double block = n.blockWidthMm / std::sqrt(2.0);
  if (block < top)
    refuse(base::message(
               "the cone is {cone} wide at its top, more than the block's corners, {block}"_text,
               base::mm(2.0 * top), base::mm(2.0 * block)),
           "reduce angle or height of the cone"_text);
  const double end = n.coneHeightMm + n.blockHeightMm;
  return {{{0.0, n.tipRadiusMm}, {n.coneHeightMm, top}, {n.coneHeightMm, block}, {end, block}}};
}

HeadShape headFromMesh(const geometry::TriangleMesh& given, double toleranceMm,
                       NozzlePoints nozzle) {
  base::require(toleranceMm > 0.0, "headFromMesh: a tolerance");
  const geometry::TriangleMesh mesh = nozzle == NozzlePoints::Up ? turnedOver(given) : given;
  if (mesh.empty())
    refuse("the mesh has no triangles"_text);
  const auto [low, high] =
      std::ranges::minmax(mesh.vertices, {}, [](const Vector3d& v) { return v.z(); });
  const double heightMm = high.z() - low.z();
  if (heightMm > 0.0 && heightMm < kMinHeightMm)
    refuse(base::message("the mesh is only {height} high"_text, base::mm(heightMm)),
           "export it in millimetres"_text);
  const double levelMm = std::max(0.1 * toleranceMm, heightMm / kMaxLevels);
  const std::vector<Vector3d> vertices = aroundAxis(mesh, levelMm);
  std::vector<double> levels;
  for (const Vector3d& v : vertices)
    levels.push_back(v.z());
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (levels.size() < 2)
    refuse("the mesh is flat: it has no height along z"_text,
           "export the head with its nozzle pointing down"_text);
  const std::vector<Slab> slabs = slabsOf(mesh, vertices, levels);
  std::vector<HeadSection> sections;
  const auto add = [&](double zMm, double radiusMm) {
    const HeadSection section{zMm, radiusMm};
    if (sections.empty() || sections.back().zMm != zMm ||
        std::abs(sections.back().radiusMm - radiusMm) > kSameMm)
      sections.push_back(section);
  };
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    add(levels[i], slabs[i].lower);
    add(levels[i + 1], slabs[i].upper);
  }
  HeadShape head = simplified(sections, toleranceMm);
  for (double mm = 2.0 * toleranceMm; head.sections.size() > kMaxSections && mm < heightMm;
       mm *= 2.0)
    head = simplified(sections, mm);
  return head;
}

std::optional<base::Message> upsideDown(const HeadShape& head) {
  constexpr double kWider = 2.0;
  if (head.sections.empty())
    return std::nullopt;
  const double tip = head.sections.front().radiusMm, end = head.sections.back().radiusMm;
  if (tip <= kWider * end)
    return std::nullopt;
  return base::message("the head is {tip:.3g} wide at its tip and {end:.3g} at its other end: its "
                       "nozzle seems to point away from the part"_text,
                       base::mm(2.0 * tip), base::mm(2.0 * end));
}

} // namespace voluta::process

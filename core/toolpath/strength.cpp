#include "toolpath/strength.h"

#include "base/error.h"
#include "base/number_list.h"
#include "base/units.h"
#include "process/bead_to.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kSectionMm = 1.0;
constexpr double kAlignedDeg = 30.0;

// A triangle of a layer with its thickness, seen along the load.
struct Prism {
  std::array<double, 3> at{};  // of its corners along the load, ascending
  double halfMm = 0.0;         // half of the thickness along the load
  double mm2 = 0.0, mm3 = 0.0; // area of its mid-surface, volume
  double across = 0.0;         // |layer's normal . load|
};

// Returns the mean of (x - X)+ for X uniform over a triangle: twice the divided difference of
// (x - t)+^3 / 6 at its corners (Hermite, Genocchi).
double meanPositive(double x, const std::array<double, 3>& at) {
  if (x <= at[0])
    return 0.0;
  if (x >= at[2])
    return x - (at[0] + at[1] + at[2]) / 3.0;
  constexpr double kApartMm = 1e-4;
  const std::array<double, 3> t{at[0], std::max(at[1], at[0] + kApartMm),
                                std::max(at[2], std::max(at[1], at[0] + kApartMm) + kApartMm)};
  const auto cube = [&](double from) {
    const double d = std::max(0.0, x - from);
    return d * d * d / 6.0;
  };
  const double first = (cube(t[1]) - cube(t[0])) / (t[1] - t[0]),
               second = (cube(t[2]) - cube(t[1])) / (t[2] - t[1]);
  return 2.0 * (second - first) / (t[2] - t[0]);
}

// Returns the share of a triangle below x.
double shareOfTriangle(double x, const std::array<double, 3>& at) {
  if (x <= at[0] || x >= at[2])
    return x <= at[0] ? 0.0 : 1.0;
  const double whole = at[2] - at[0];
  if (x < at[1])
    return (x - at[0]) * (x - at[0]) / ((at[1] - at[0]) * whole);
  return at[2] > at[1] ? 1.0 - (at[2] - x) * (at[2] - x) / ((at[2] - at[1]) * whole) : 1.0;
}

// Returns the share of a prism below x.
double shareBelow(double x, const Prism& prism) {
  constexpr double kThinMm = 0.01; // differences of larger numbers would lose their digits
  const double half = prism.halfMm;
  if (half < kThinMm)
    return shareOfTriangle(x, prism.at);
  return std::clamp((meanPositive(x + half, prism.at) - meanPositive(x - half, prism.at)) /
                        (2.0 * half),
                    0.0, 1.0);
}

std::vector<Prism> prismsOf(const layers::Patch& patch, const Vector3d& load) {
  std::vector<Prism> prisms;
  for (const auto& triangle : patch.surface.triangles) {
    std::array<std::size_t, 3> v{};
    std::ranges::transform(triangle, v.begin(), [](int i) { return static_cast<std::size_t>(i); });
    const auto& p = patch.surface.vertices;
    Prism prism;
    prism.mm2 = 0.5 * (p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]).norm();
    const double thickness =
        (patch.thicknessMm[v[0]] + patch.thicknessMm[v[1]] + patch.thicknessMm[v[2]]) / 3.0;
    prism.mm3 = prism.mm2 * thickness;
    prism.across = std::abs((patch.direction[v[0]] + patch.direction[v[1]] + patch.direction[v[2]])
                                .normalized()
                                .dot(load));
    prism.halfMm = 0.5 * thickness * prism.across;
    for (std::size_t k = 0; k < v.size(); ++k)
      prism.at[k] = load.dot(p[v[k]]);
    std::ranges::sort(prism.at);
    prisms.push_back(prism);
  }
  return prisms;
}

// Volume and interfaces of the part, slab by slab along the load.
class Slabs {
public:
  Slabs(double low, double high)
      : low_(low), high_(high),
        volume_(static_cast<std::size_t>(std::clamp((high - low) / kSectionMm, 10.0, 2000.0))),
        interface_(volume_.size()) {}

  void add(const Prism& prism) {
    const double first = prism.at[0] - prism.halfMm, last = prism.at[2] + prism.halfMm;
    double below = 0.0;
    for (std::size_t i = indexOf(first); i < volume_.size(); ++i) {
      const double top = low_ + widthMm() * static_cast<double>(i + 1);
      const double share = i + 1 == volume_.size() ? 1.0 : shareBelow(top, prism);
      volume_[i] += prism.mm3 * (share - below);
      interface_[i] += prism.mm3 * prism.across * (share - below);
      below = share;
      if (top >= last)
        break;
    }
  }

  // Where the load enters, sections carry only a part of it.
  void addSections(plan::StrengthStatistics& s) const {
    constexpr double kEndShare = 0.1;
    const auto count = static_cast<double>(volume_.size());
    double volume = 0.0, interfaces = 0.0;
    s.minSectionMm2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < volume_.size(); ++i) {
      const double at = (static_cast<double>(i) + 0.5) / count;
      if (at < kEndShare || at > 1.0 - kEndShare)
        continue;
      volume += volume_[i];
      interfaces += interface_[i];
      const double area = volume_[i] / widthMm(), atMm = at * (high_ - low_);
      const double share = volume_[i] > 0.0 ? interface_[i] / volume_[i] : 0.0;
      if (area < s.minSectionMm2 - kSame) {
        s.minSectionMm2 = area;
        s.minSectionAtMm = atMm;
      }
      if (share > s.maxInterfaceFraction + kSame) {
        s.maxInterfaceFraction = share;
        s.maxInterfaceAtMm = atMm;
      }
    }
    s.interfaceFraction = volume > 0.0 ? interfaces / volume : 0.0;
  }

private:
  // The first of equal sections counts, whatever their rounding.
  static constexpr double kSame = 1e-6;

  double widthMm() const { return (high_ - low_) / static_cast<double>(volume_.size()); }
  std::size_t indexOf(double at) const {
    const double index = std::floor((at - low_) / widthMm());
    return static_cast<std::size_t>(
        std::clamp(index, 0.0, static_cast<double>(volume_.size() - 1)));
  }

  double low_, high_;
  std::vector<double> volume_, interface_;
};

void addAngles(const plan::ToolPlan& plan, int item, const Vector3d& load,
               plan::StrengthStatistics& s) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths) {
    if (path.item != item || plan::isWaste(path.kind) || path.kind == plan::PathKind::Support ||
        path.kind == plan::PathKind::Tape || path.kind == plan::PathKind::Shot)
      continue;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const Vector3d step = plan.position[i] - plan.position[i - 1];
      const double length = step.norm();
      if (length <= 0.0)
        continue;
      const double mm3 = process::beadTo(plan, i);
      const double along = std::abs(step.dot(load)), lateral = step.cross(load).norm();
      const double angleDeg = base::radiansToDegrees(std::atan2(lateral, along));
      volume += mm3;
      s.angleMeanDeg += mm3 * angleDeg;
      s.alignedFraction += angleDeg <= kAlignedDeg ? mm3 : 0.0;
    }
  }
  if (volume <= 0.0)
    return;
  s.angleMeanDeg /= volume;
  s.alignedFraction /= volume;
}

} // namespace

std::optional<Vector3d> loadDirection(const std::string& text) {
  if (text.empty())
    return std::nullopt;
  Vector3d load;
  if (!base::readNumbers(text, ',', {&load.x(), &load.y(), &load.z()}) || !(load.norm() > 0.0) ||
      !std::isfinite(load.norm()))
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}' is not a direction"_text, text), "loadDirection"_name,
                      "give x,y,z, for example 1,0,0"_text);
  return load.normalized();
}

plan::StrengthStatistics strengthOf(const layers::LayerStack& stack, const plan::ToolPlan& plan,
                                    int item, const Vector3d& load) {
  plan::StrengthStatistics s;
  std::vector<Prism> prisms;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const layers::Patch& patch : stack.patches) {
    if (patch.item != item || patch.group == layers::kSupportGroup)
      continue;
    for (const Prism& prism : prismsOf(patch, load)) {
      low = std::min(low, prism.at[0] - prism.halfMm);
      high = std::max(high, prism.at[2] + prism.halfMm);
      s.interfaceMm2 += patch.layer > 0 ? prism.mm2 * prism.across : 0.0;
      prisms.push_back(prism);
    }
  }
  if (!(high > low))
    return s;
  Slabs slabs(low, high);
  for (const Prism& prism : prisms)
    slabs.add(prism);
  slabs.addSections(s);
  addAngles(plan, item, load, s);
  return s;
}

} // namespace voluta::toolpath

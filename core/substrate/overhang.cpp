#include "substrate/overhang.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>

namespace voluta::substrate {

using Eigen::Vector3d;

Overhang findOverhang(const geometry::TriangleMesh& part, const layers::Ground& ground,
                      const std::function<Vector3d(const Vector3d&)>& outward,
                      const OverhangRule& rule) {
  constexpr int kMaxSteps = 16;
  base::require(rule.sampleMm > 0.0, "samples of some size");
  Overhang found;
  const double minimum = -std::sin(rule.overhangRad);
  double worst = minimum;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Vector3d &a = part.corner(t, 0), &b = part.corner(t, 1), &c = part.corner(t, 2);
    const Vector3d n = geometry::triangleNormal(part, t);
    const double widest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int m = std::clamp(static_cast<int>(std::ceil(widest / rule.sampleMm)), 1, kMaxSteps);
    const double area = geometry::triangleArea(part, t) / (m * m);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < 2 * (m - i) - 1; ++j) {
        // The centroid of the j-th small triangle of strip i.
        const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
        const double u = (i + third) / m, v = (j / 2 + third) / m;
        const Vector3d p = a + u * (b - a) + v * (c - a);
        const double cosine = n.dot(outward(p));
        if (cosine >= minimum - 1e-9 || ground.over(p) <= rule.contactMm)
          continue;
        found.areaMm2 += area;
        if (cosine < worst - 1e-9) {
          worst = cosine;
          found.worstAt = p;
        }
      }
  }
  return found;
}

std::optional<plan::Finding> overhangFinding(const Overhang& overhang, const OverhangRule& rule,
                                             GroundKind ground) {
  if (overhang.areaMm2 <= 0.0)
    return std::nullopt;
  const Vector3d& at = overhang.worstAt;
  const base::Quantity area = base::mm2(overhang.areaMm2);
  const base::Quantity angle = base::degrees(base::radiansToDegrees(rule.overhangRad));
  if (ground == GroundKind::Rod)
    return plan::makeFinding(plan::FindingKind::OverhangOverRod,
                             {{"area", area},
                              {"angle", angle},
                              {"x", base::mm(at.x())},
                              {"radius", base::mm(at.tail<2>().norm())}},
                             at);
  return plan::makeFinding(plan::FindingKind::OverhangOverSurface,
                           {{"area", area}, {"angle", angle}, {"at", plan::pointOf(at)}}, at);
}

} // namespace voluta::substrate

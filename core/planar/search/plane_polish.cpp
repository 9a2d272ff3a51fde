#include "planar/search/plane_polish.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

using Eigen::Vector3d;

PlaneGain planeGain(const Piece& piece, const FaceTable& faces, const RiskRule& rule,
                    const Plane& plane, int top, double maxContactLossMm2) {
  constexpr double kOn = 1e-7; // mm
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  PlaneGain out;
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v)
    height[v] = plane.heightOf(mesh.vertices[v]);
  const auto heightAt = [&](std::size_t t, std::size_t k) {
    return height[static_cast<std::size_t>(mesh.triangles[t][k])];
  };
  const auto reaches = [&](std::size_t t) {
    return std::max({heightAt(t, 0), heightAt(t, 1), heightAt(t, 2)}) > kOn;
  };
  if (!reaches(static_cast<std::size_t>(top)))
    return out;
  const double riskyCosine = -std::sin(rule.overhangRad); // faces with a lower cosine are risky
  std::vector<std::uint8_t> seen(faces.area.size(), 0);
  std::vector<int> todo{top};
  seen[static_cast<std::size_t>(top)] = 1;
  const Vector3d origin = plane.offsetMm * plane.normal;
  double section = 0.0;
  while (!todo.empty()) {
    const auto t = static_cast<std::size_t>(todo.back());
    todo.pop_back();
    // Compute the share of the face above the plane, and its edge of the section.
    int ups = 0;
    for (std::size_t k = 0; k < 3; ++k)
      ups += heightAt(t, k) > kOn;
    double share = 1.0;
    if (ups == 1 || ups == 2) {
      std::size_t lone = 0;
      while ((heightAt(t, lone) > kOn) != (ups == 1))
        ++lone;
      const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
      const double h = heightAt(t, lone), hn = heightAt(t, next), hl = heightAt(t, last);
      const double sn = std::clamp(h / (h - hn), 0.0, 1.0), sl = std::clamp(h / (h - hl), 0.0, 1.0);
      share = ups == 1 ? sn * sl : 1.0 - sn * sl;
      const Vector3d &a = mesh.corner(t, static_cast<int>(lone)),
                     &b = mesh.corner(t, static_cast<int>(next)),
                     &c = mesh.corner(t, static_cast<int>(last));
      const Vector3d p = a + sn * (b - a) - origin, q = a + sl * (c - a) - origin;
      const double twice = plane.normal.dot(p.cross(q));
      section += 0.5 * (ups == 1 ? twice : -twice);
    }
    const double area = share * faces.area[t];
    if (faces.stands[t])
      out.footMm2 += area;
    if (faces.risky[t] > 0.0)
      out.gainMm2 += area;
    if (!faces.onPrinted[t] && faces.normal[t].dot(plane.normal) < riskyCosine)
      out.gainMm2 -= area;
    for (std::size_t k = 0; k < 3; ++k) {
      const int w = faces.neighbour[t][k];
      if (w < 0 || seen[static_cast<std::size_t>(w)] ||
          std::max(heightAt(t, k), heightAt(t, (k + 1) % 3)) <= kOn)
        continue;
      seen[static_cast<std::size_t>(w)] = 1;
      todo.push_back(w);
    }
  }
  out.sectionMm2 = std::abs(section);
  out.allowed =
      out.footMm2 <= maxContactLossMm2 + 1e-9 && !isRisky(plane.normal, piece.base.normal, rule);
  return out;
}

Plane polished(const Piece& piece, const FaceTable& faces, const RiskRule& rule, const Plane& plane,
               int top, const PolishOptions& options) {
  const auto gainOf = [&](const Plane& p) {
    const PlaneGain w = planeGain(piece, faces, rule, p, top, options.maxContactLossMm2);
    return w.allowed
               ? w.gainMm2 - options.sectionWeight * w.sectionMm2 - options.footPrice * w.footMm2
               : -1e300;
  };
  // Tilt about a point of the piece near the plane, not about the distant origin.
  const Vector3d& pivot = piece.solid.mesh.corner(static_cast<std::size_t>(top), 0);
  Plane best = plane;
  double maximum = gainOf(best);
  double tilt = 0.5 * options.tiltRad, shift = 0.5 * options.shiftMm;
  for (int round = 0; round < options.rounds; ++round) {
    bool better = false;
    for (int move = 0; move < 6; ++move) {
      const double sign = move % 2 == 0 ? 1.0 : -1.0;
      Plane tried = best;
      if (move < 2) {
        tried.offsetMm += sign * shift;
      } else {
        const PlaneFrame frame = frameOf(best.normal);
        const Vector3d direction = move < 4 ? frame.across : frame.along;
        tried.normal = (best.normal + sign * std::tan(tilt) * direction).normalized();
        const Vector3d foot = pivot - best.heightOf(pivot) * best.normal;
        tried.offsetMm = tried.normal.dot(foot);
      }
      const double gain = gainOf(tried);
      if (gain > maximum + 1e-9) {
        maximum = gain;
        best = tried;
        better = true;
      }
    }
    if (!better) {
      tilt *= 0.5;
      shift *= 0.5;
    }
  }
  return best;
}

} // namespace voluta::planar

#include "planar/plan_checker.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace voluta::test {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;

namespace {

constexpr double kBesideMm = 0.02;     // points beside a face
constexpr double kSliverMm = 0.1;      // the sides of lower faces are not checked
constexpr double kCrossesMm = 0.02;    // sections that pass less far through one another touch
constexpr double kSamplesMayHit = 5.0; // at least, of a piece's
constexpr double kTouchesMm = 0.05;    // depth to which the head may be in printed material

Vector3d middleOf(const TriangleMesh& m, std::size_t t) {
  return (m.corner(t, 0) + m.corner(t, 1) + m.corner(t, 2)) / 3.0;
}
Vector3d crossOf(const TriangleMesh& m, std::size_t t) {
  return (m.corner(t, 1) - m.corner(t, 0)).cross(m.corner(t, 2) - m.corner(t, 0));
}
double minHeight(const TriangleMesh& m, std::size_t t) {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, (m.corner(t, (k + 1) % 3) - m.corner(t, k)).norm());
  return longest > 0.0 ? crossOf(m, t).norm() / longest : 0.0;
}

double volumeOf(const TriangleMesh& m) {
  double six = 0.0;
  const Vector3d o = m.vertices.empty() ? Vector3d::Zero() : m.vertices.front();
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    six += (m.corner(t, 0) - o).dot((m.corner(t, 1) - o).cross(m.corner(t, 2) - o));
  return six / 6.0;
}

bool closes(const TriangleMesh& m) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  return std::all_of(sides.begin(), sides.end(), [](const auto& s) { return s.second == 0; });
}

// Inside a closed mesh: signed crossings of the ray along +z.
class Inside {
public:
  explicit Inside(const TriangleMesh& mesh) : mesh_(mesh) {
    low_ = Vector2d::Constant(1e300);
    high_ = -low_;
    for (const Vector3d& v : mesh.vertices) {
      low_ = low_.cwiseMin(v.head<2>());
      high_ = high_.cwiseMax(v.head<2>());
    }
    if (mesh.vertices.empty())
      return;
    cell_ = std::max(1e-3, (high_ - low_).maxCoeff() / 64.0);
    nx_ = static_cast<int>((high_.x() - low_.x()) / cell_) + 1;
    ny_ = static_cast<int>((high_.y() - low_.y()) / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(nx_ * ny_));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Vector2d a = mesh.corner(t, 0).head<2>(), b = a;
      for (int k = 1; k < 3; ++k) {
        a = a.cwiseMin(mesh.corner(t, k).head<2>());
        b = b.cwiseMax(mesh.corner(t, k).head<2>());
      }
      for (int i = column(a.x(), low_.x()); i <= column(b.x(), low_.x()); ++i)
        for (int j = column(a.y(), low_.y()); j <= column(b.y(), low_.y()); ++j)
          cells_[static_cast<std::size_t>(j * nx_ + i)].push_back(t);
    }
  }

  bool operator()(const Vector3d& at) const {
    // Off the edges that round numbers put in the ray's way.
    const Vector2d p = at.head<2>() + Vector2d(3.1e-7, 1.7e-7);
    if (mesh_.vertices.empty() || (p.array() < low_.array()).any() ||
        (p.array() > high_.array()).any())
      return false;
    int winding = 0;
    const int i = column(p.x(), low_.x()), j = column(p.y(), low_.y());
    for (const std::size_t t : cells_[static_cast<std::size_t>(j * nx_ + i)]) {
      const Vector3d &a = mesh_.corner(t, 0), &b = mesh_.corner(t, 1), &c = mesh_.corner(t, 2);
      const auto doubleArea = [&](const Vector3d& u, const Vector3d& v) {
        return (u.x() - p.x()) * (v.y() - p.y()) - (u.y() - p.y()) * (v.x() - p.x());
      };
      const double wc = doubleArea(a, b), wa = doubleArea(b, c), wb = doubleArea(c, a);
      const bool up = wa > 0.0 && wb > 0.0 && wc > 0.0, down = wa < 0.0 && wb < 0.0 && wc < 0.0;
      if (!up && !down)
        continue;
      const double z = (wa * a.z() + wb * b.z() + wc * c.z()) / (wa + wb + wc);
      if (z > at.z())
        winding += up ? 1 : -1;
    }
    return winding > 0;
  }

private:
  int column(double x, double low) const { return static_cast<int>((x - low) / cell_); }

  const TriangleMesh& mesh_;
  Vector2d low_, high_;
  double cell_ = 1.0;
  int nx_ = 0, ny_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
};

// About one point a spacing squared, at random places that are the same each time.
std::vector<Vector3d> strewn(const TriangleMesh& m, double spacing) {
  std::vector<Vector3d> out;
  std::uint32_t state = 12345;
  const auto random = [&] {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8U) / 16777216.0;
  };
  double owed = 0.0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    owed += 0.5 * crossOf(m, t).norm() / (spacing * spacing);
    for (; owed > 0.0; owed -= 1.0) {
      double u = random(), v = random();
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      out.push_back(m.corner(t, 0) + u * (m.corner(t, 1) - m.corner(t, 0)) +
                    v * (m.corner(t, 2) - m.corner(t, 0)));
    }
  }
  return out;
}

// Points on top of a convex polygon on z = 0.
std::vector<Vector3d> plateTop(const std::vector<Vector2d>& polygon, double spacing) {
  TriangleMesh fan;
  for (const Vector2d& p : polygon)
    fan.vertices.emplace_back(p.x(), p.y(), 0.0);
  for (int i = 1; i + 1 < static_cast<int>(polygon.size()); ++i)
    fan.triangles.push_back({0, i, i + 1});
  std::vector<Vector3d> points = strewn(fan, spacing);
  points.insert(points.end(), fan.vertices.begin(), fan.vertices.end());
  return points;
}

// Samples of the piece at which the head has an obstacle inside it.
std::size_t hits(const std::vector<Vector3d>& tips, const std::vector<Vector3d>& obstacles,
                 const Vector3d& direction, const process::HeadShape& head) {
  double widest = 0.0, lowest = 1e300;
  for (const process::HeadSection& s : head.sections)
    widest = std::max(widest, s.radiusMm - kTouchesMm);
  for (const Vector3d& tip : tips)
    lowest = std::min(lowest, direction.dot(tip));
  std::vector<std::pair<double, Vector3d>> falling; // obstacles by height along the direction
  for (const Vector3d& o : obstacles)
    if (const double height = direction.dot(o); height - lowest > kTouchesMm)
      falling.emplace_back(height, o);
  std::sort(falling.begin(), falling.end(),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  std::size_t count = 0;
  for (const Vector3d& tip : tips) {
    const double height = direction.dot(tip);
    for (const auto& [above, o] : falling) {
      const double z = above - height;
      if (z <= kTouchesMm)
        break;
      const double squared = (o - tip).squaredNorm() - z * z;
      if (z > head.sections.back().zMm || squared >= widest * widest)
        continue;
      const double reach = headRadius(head, z) - kTouchesMm;
      if (reach > 0.0 && squared < reach * reach) {
        ++count;
        break;
      }
    }
  }
  return count;
}

// Whether a side of `a` passes through the inside of `b`.
bool passesThrough(const std::array<Vector3d, 3>& a, const std::array<Vector3d, 3>& b) {
  const Vector3d n = (b[1] - b[0]).cross(b[2] - b[0]).stableNormalized();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d &p = a[k], &q = a[(k + 1) % 3];
    const double hp = n.dot(p - b[0]), hq = n.dot(q - b[0]);
    if (std::min(hp, hq) > -kCrossesMm || std::max(hp, hq) < kCrossesMm)
      continue;
    const Vector3d x = p + hp / (hp - hq) * (q - p);
    bool in = true;
    for (std::size_t s = 0; s < 3; ++s) {
      const Vector3d side = b[(s + 1) % 3] - b[s];
      in = in && n.dot(side.cross(x - b[s])) > kCrossesMm * side.norm();
    }
    if (in)
      return true;
  }
  return false;
}

std::string line(const char* what, std::size_t piece, double amount) {
  return "piece " + std::to_string(piece) + ": " + what + " (" + std::to_string(amount) + ")";
}

} // namespace

double headRadius(const process::HeadShape& head, double zMm) {
  double radius = 0.0;
  for (std::size_t s = 0; s + 1 < head.sections.size(); ++s) {
    const auto &a = head.sections[s], &b = head.sections[s + 1];
    if (zMm >= a.zMm && zMm <= b.zMm && b.zMm > a.zMm)
      radius = std::max(radius,
                        a.radiusMm + (b.radiusMm - a.radiusMm) * (zMm - a.zMm) / (b.zMm - a.zMm));
  }
  return radius;
}

PlanVerdict checkPlan(const TriangleMesh& part, const std::vector<planar::Piece>& pieces,
                      const PlanCheck& check) {
  PlanVerdict out;
  const Inside inPart(part);
  std::vector<Inside> inPiece;
  inPiece.reserve(pieces.size());
  std::vector<std::vector<std::array<Vector3d, 3>>> sections(pieces.size());
  double volume = 0.0;
  for (const planar::Piece& piece : pieces) {
    inPiece.emplace_back(piece.solid.mesh);
    volume += volumeOf(piece.solid.mesh);
  }
  const double whole = volumeOf(part);
  if (std::abs(volume - whole) > 1e-6 * whole)
    out.faults.push_back("volumes do not add up (" + std::to_string(volume / whole - 1.0) + ")");
  std::vector<Vector3d> printed; // samples of the printed pieces, and of the plate
  if (!check.head.sections.empty())
    printed = plateTop(check.plate, check.spacingMm);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const TriangleMesh& mesh = pieces[i].solid.mesh;
    const Vector3d up = pieces[i].base.normal;
    const bool onPlate = pieces[i].baseTag == planar::kPlate;
    if (!closes(mesh) || !(volumeOf(mesh) > 0.0))
      out.faults.push_back(line("not closed", i, volumeOf(mesh)));
    double lowest = 0.0;
    for (const Vector3d& v : mesh.vertices)
      lowest = std::min(lowest, up.dot(v) - pieces[i].base.offsetMm);
    if (lowest < -1e-3)
      out.faults.push_back(line("reaches below its base, mm", i, lowest));
    double stands = 0.0, unheld = 0.0, shared = 0.0, gap = 0.0, all = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vector3d cross = crossOf(mesh, t), n = cross.stableNormalized();
      const double area = 0.5 * cross.norm();
      const Vector3d middle = middleOf(mesh, t), outside = middle + kBesideMm * n;
      double highest = -1e300;
      for (int k = 0; k < 3; ++k)
        highest = std::max(highest, up.dot(mesh.corner(t, k)) - pieces[i].base.offsetMm);
      all += area;
      const bool sliver = minHeight(mesh, t) < kSliverMm;
      bool supported = onPlate && n.dot(up) < 0.0 && highest <= check.contactMm + 1e-6;
      if (supported)
        stands += area;
      const bool base = !onPlate && highest < 1e-3 && n.dot(up) < -0.999;
      if (inPart(outside)) {
        std::size_t behind = pieces.size();
        for (std::size_t j = 0; j < pieces.size(); ++j)
          if (j != i && inPiece[j](outside))
            behind = std::min(behind, j);
        if (behind == pieces.size() && !sliver)
          gap += area;
        supported = supported || behind < i;
        if (base) {
          sections[i].push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
          (behind < i || sliver ? stands : unheld) += area;
        }
      }
      if (!supported && !(base && sliver) && n.dot(up) + std::sin(check.overhangRad) < 0.0)
        out.riskyMm2 += area;
      if (const Vector3d inside = middle - kBesideMm * n; !sliver && inPiece[i](inside))
        for (std::size_t j = 0; j < pieces.size(); ++j)
          if (j != i && inPiece[j](inside)) {
            shared += area;
            break;
          }
    }
    // Points beside an edge may be on the wrong side of it: a thousandth of the surface may.
    const double slack = 1e-3 * all;
    if (!(stands > 0.0))
      out.faults.push_back(line("stands on nothing", i, stands));
    if (unheld > slack)
      out.faults.push_back(line("its base is not held by pieces before it, mm2", i, unheld));
    if (gap > slack)
      out.faults.push_back(line("nothing behind its sections, mm2", i, gap));
    if (shared > slack)
      out.faults.push_back(line("overlaps others, mm2", i, shared));
    if (check.head.sections.empty())
      continue;
    // So many, even of a small piece, that one of them is less than the area that may be hit.
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      area += 0.5 * crossOf(mesh, t).norm();
    const double fine = std::sqrt(area * check.mayHitShare / kSamplesMayHit);
    std::vector<Vector3d> tips = strewn(mesh, std::min(check.spacingMm, fine));
    // Nearer to its base than where it lays the first layer the nozzle's tip never comes.
    for (Vector3d& tip : tips)
      tip += std::max(0.0, pieces[i].base.offsetMm + 2.0 * check.contactMm - up.dot(tip)) * up;
    const auto hit = static_cast<double>(hits(tips, printed, up, check.head));
    out.blockedPieces += hit > check.mayHitShare * static_cast<double>(tips.size());
    const std::vector<Vector3d> samples = strewn(mesh, check.spacingMm);
    printed.insert(printed.end(), samples.begin(), samples.end());
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < pieces.size(); ++j)
      if (i != j && std::any_of(sections[i].begin(), sections[i].end(), [&](const auto& a) {
            return std::any_of(sections[j].begin(), sections[j].end(),
                               [&](const auto& b) { return passesThrough(a, b); });
          }))
        out.faults.push_back(
            line("its base passes through the base of", i, static_cast<double>(j)));
  return out;
}

} // namespace voluta::test

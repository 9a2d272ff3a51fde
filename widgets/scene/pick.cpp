#include "scene/pick.h"

#include "voxel/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace voluta::scene {

namespace {

// Returns the distance along the ray to a triangle (Möller and Trumbore 1997); nullopt if it is
// missed or behind the origin.
std::optional<double> meet(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const Eigen::Vector3d p = ray.direction.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-12)
    return std::nullopt;
  const Eigen::Vector3d from = ray.origin - a;
  const double u = from.dot(p) / det;
  if (u < 0.0 || u > 1.0)
    return std::nullopt;
  const Eigen::Vector3d q = from.cross(ab);
  const double v = ray.direction.dot(q) / det;
  if (v < 0.0 || u + v > 1.0)
    return std::nullopt;
  const double t = ac.dot(q) / det;
  return t > 0.0 ? std::optional(t) : std::nullopt;
}

// The triangles of a VTK mesh created by this module: 32-bit ids, three per cell.
class Triangles {
public:
  explicit Triangles(vtkPolyData* data)
      : points_(vtkFloatArray::SafeDownCast(data->GetPoints()->GetData())),
        ids_(data->GetPolys()->GetConnectivityArray32()), count_(data->GetNumberOfPolys()) {}

  std::size_t count() const { return static_cast<std::size_t>(count_); }
  Eigen::Vector3d corner(std::size_t triangle, int k) const {
    const vtkIdType id = ids_->GetValue(static_cast<vtkIdType>(3 * triangle) + k);
    const float* p = points_->GetPointer(3 * id);
    return {double(p[0]), double(p[1]), double(p[2])};
  }

private:
  vtkFloatArray* points_;
  vtkTypeInt32Array* ids_;
  vtkIdType count_;
};

void keepNearer(std::optional<RayHit>& best, double t, const Hit& hit) {
  if (!best || t < best->t)
    best = RayHit{t, hit};
}

} // namespace

std::optional<RayHit> pickPart(const PartDrawing& part, const Ray& ray, const IsShown& shown) {
  std::optional<RayHit> best;
  for (std::size_t i = 0; i < part.mesh.triangles.size(); ++i) {
    const Eigen::Vector3d &a = part.mesh.corner(i, 0), &b = part.mesh.corner(i, 1),
                          &c = part.mesh.corner(i, 2);
    const auto t = meet(ray, a, b, c);
    if (!t || (best && *t >= best->t) || !shown(ray.at(*t)))
      continue;
    Hit hit;
    hit.what = Hit::What::Part;
    hit.point = ray.at(*t);
    hit.normal = (b - a).cross(c - a).normalized();
    best = RayHit{*t, hit};
  }
  return best;
}

std::optional<RayHit> pickOther(const std::vector<std::shared_ptr<const PartDrawing>>& parts,
                                const Ray& ray, const IsShown& shown) {
  std::optional<RayHit> best;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::optional<RayHit> hit = parts[i] ? pickPart(*parts[i], ray, shown) : std::nullopt;
    if (!hit)
      continue;
    hit->hit.what = Hit::What::OtherPart;
    hit->hit.item = i;
    keepNearer(best, hit->t, hit->hit);
  }
  return best;
}

namespace {
std::optional<RayHit> pickPlate(const PlatformDrawing& platform, const Ray& ray) {
  if (std::abs(ray.direction.z()) < 1e-9)
    return std::nullopt;
  const double t = -ray.origin.z() / ray.direction.z();
  const Eigen::Vector3d p = ray.at(t);
  if (t <= 0.0 || platform.polygon.size() < 3)
    return std::nullopt;
  for (std::size_t i = 0; i < platform.polygon.size(); ++i) {
    const Eigen::Vector2d &a = platform.polygon[i],
                          &b = platform.polygon[(i + 1) % platform.polygon.size()];
    const Eigen::Vector2d ab = b - a, ap = p.head<2>() - a;
    if (ab.x() * ap.y() - ab.y() * ap.x() < 0.0)
      return std::nullopt;
  }
  Hit hit;
  hit.what = Hit::What::Platform;
  hit.point = p;
  hit.normal = Eigen::Vector3d::UnitZ();
  return RayHit{t, hit};
}
} // namespace

std::optional<RayHit> pickPlatform(const PlatformDrawing& platform, const Ray& ray) {
  std::optional<RayHit> best = pickPlate(platform, ray);
  for (const auto& solid : {platform.rod, platform.body})
    if (solid)
      if (auto hit = pickPart(*solid, ray, [](const Eigen::Vector3d&) { return true; }))
        if (!best || hit->t < best->t) {
          hit->hit.what = Hit::What::Platform;
          best = hit;
        }
  return best;
}

std::optional<RayHit> pickVoxel(const VoxelDrawing& voxels, const Ray& ray, int first, int last,
                                const IsShown& shown) {
  const voxel::VoxelGrid& grid = voxels.grid;
  // Parameters at which the ray enters and leaves the grid.
  double from = 0.0, to = 1e12;
  int enteredBy = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.origin[axis], high = low + grid.pitch * grid.size[axis];
    if (std::abs(ray.direction[axis]) < 1e-12) {
      if (ray.origin[axis] < low || ray.origin[axis] > high)
        return std::nullopt;
      continue;
    }
    double a = (low - ray.origin[axis]) / ray.direction[axis];
    double b = (high - ray.origin[axis]) / ray.direction[axis];
    if (a > b)
      std::swap(a, b);
    if (a > from) {
      from = a;
      enteredBy = axis;
    }
    to = std::min(to, b);
  }
  if (from >= to)
    return std::nullopt;
  Eigen::Vector3i cell = grid.cellOf(ray.at(from + 1e-9 * grid.pitch));
  cell = cell.cwiseMax(0).cwiseMin(grid.size.array().matrix() - Eigen::Vector3i::Ones());
  double t = from;
  while (grid.contains(cell.x(), cell.y(), cell.z())) {
    const std::size_t index = grid.index(cell.x(), cell.y(), cell.z());
    const std::int32_t rank = voxels.rank[index];
    if ((rank < 0 || (rank > 0 && rank - 1 >= first && rank - 1 <= last)) && shown(ray.at(t))) {
      Hit hit;
      hit.what = Hit::What::Voxel;
      hit.point = ray.at(t);
      if (enteredBy >= 0)
        hit.normal[enteredBy] = ray.direction[enteredBy] > 0 ? -1.0 : 1.0;
      hit.layer = rank > 0 ? rank - 1 : -1;
      hit.voxel = index;
      return RayHit{t, hit};
    }
    double next = 1e12;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(ray.direction[axis]) < 1e-12)
        continue;
      const double edge =
          grid.origin[axis] + grid.pitch * (cell[axis] + (ray.direction[axis] > 0 ? 1 : 0));
      const double at = (edge - ray.origin[axis]) / ray.direction[axis];
      if (at < next) {
        next = at;
        enteredBy = axis;
      }
    }
    cell[enteredBy] += ray.direction[enteredBy] > 0 ? 1 : -1;
    t = next;
  }
  return std::nullopt;
}

std::optional<RayHit> pickPiece(const PiecesDrawing& pieces, const Ray& ray,
                                const std::vector<Eigen::Vector3d>& offsets, const IsShown& shown) {
  std::optional<RayHit> best;
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    std::optional<RayHit> hit =
        pickPart(*pieces.pieces[i].solid, {ray.origin - offsets[i], ray.direction},
                 [&](const Eigen::Vector3d& p) { return shown(p + offsets[i]); });
    if (!hit)
      continue;
    hit->hit.what = Hit::What::Piece;
    hit->hit.piece = i;
    keepNearer(best, hit->t, hit->hit);
  }
  return best;
}

std::optional<RayHit> pickLayer(const LayersDrawing& layers, const Ray& ray,
                                const std::vector<Stretch>& stretches, const IsShown& shown) {
  const Triangles triangles(layers.surface);
  std::optional<RayHit> best;
  for (const Stretch& s : stretches)
    for (std::size_t i = s.first; i < s.first + s.count; ++i) {
      const Eigen::Vector3d a = triangles.corner(i, 0), b = triangles.corner(i, 1),
                            c = triangles.corner(i, 2);
      const auto t = meet(ray, a, b, c);
      if (!t || (best && *t >= best->t) || !shown(ray.at(*t)))
        continue;
      Hit hit;
      hit.what = Hit::What::Layer;
      hit.point = ray.at(*t);
      hit.normal = (b - a).cross(c - a).normalized();
      hit.patch = layers.patchOfTriangle[i];
      hit.layer = layers.values.layer[static_cast<std::size_t>(
          layers.surface->GetPolys()->GetConnectivityArray32()->GetValue(
              static_cast<vtkIdType>(3 * i)))];
      best = RayHit{*t, hit};
    }
  return best;
}

std::optional<RayHit> pickPath(const PathsDrawing& paths, const Ray& ray,
                               const std::vector<Stretch>& stretches, const IsShown& shown) {
  const auto* points = vtkFloatArray::SafeDownCast(paths.beads->GetPoints()->GetData());
  const auto centre = [&](std::size_t waypoint) {
    const float* p =
        const_cast<vtkFloatArray*>(points)->GetPointer(static_cast<vtkIdType>(6 * waypoint));
    return Eigen::Vector3d(double(p[0]), double(p[1]), double(p[2]));
  };
  std::optional<RayHit> best;
  for (const Stretch& s : stretches)
    for (std::size_t i = s.first / 2; i < (s.first + s.count) / 2; ++i) {
      const std::size_t arrival = paths.arrival[i];
      const Eigen::Vector3d a = centre(arrival - 1), b = centre(arrival);
      // Closest approach of ray and segment.
      const Eigen::Vector3d along = b - a, from = a - ray.origin;
      const double length2 = along.squaredNorm(), d = ray.direction.dot(along);
      const double denominator = length2 - d * d;
      double u = 0.5;
      if (denominator > 1e-12)
        u = std::clamp((d * ray.direction.dot(from) - along.dot(from)) / denominator, 0.0, 1.0);
      const Eigen::Vector3d p = a + u * along;
      const double t = ray.direction.dot(p - ray.origin);
      const double reach = 0.5 * double(paths.values.width[arrival]);
      if (t <= 0.0 || (ray.at(t) - p).squaredNorm() > reach * reach || !shown(p))
        continue;
      Hit hit;
      hit.what = Hit::What::Path;
      hit.point = p;
      hit.waypoint = u < 0.5 ? arrival - 1 : arrival;
      hit.path = paths.pathOf[arrival];
      hit.layer = paths.layerOfPath[hit.path];
      keepNearer(best, t - reach, hit);
    }
  return best;
}

namespace {

// Returns whether the ray passes through the bounding ball of a surface.
bool mayMeet(const Ray& ray, vtkPolyData* surface) {
  const double* b = surface->GetBounds();
  const Eigen::AlignedBox3d box(Eigen::Vector3d(b[0], b[2], b[4]),
                                Eigen::Vector3d(b[1], b[3], b[5]));
  const Eigen::Vector3d lateral = (box.center() - ray.origin).cross(ray.direction);
  return lateral.norm() <= 0.5 * box.diagonal().norm();
}

std::optional<RayHit> pickPiece(const CellPiece& piece,
                                const std::vector<Eigen::Isometry3d>& work_T_frame,
                                const Ray& ray) {
  const Eigen::Isometry3d frame_T_work =
      work_T_frame[static_cast<std::size_t>(piece.frame)].inverse();
  const Ray local{frame_T_work * ray.origin, frame_T_work.linear() * ray.direction};
  if (!mayMeet(local, piece.surface))
    return std::nullopt;
  std::optional<RayHit> best;
  const Triangles triangles(piece.surface);
  for (std::size_t i = 0; i < triangles.count(); ++i)
    if (const auto t =
            meet(local, triangles.corner(i, 0), triangles.corner(i, 1), triangles.corner(i, 2))) {
      Hit hit;
      hit.what = Hit::What::Cell;
      hit.point = ray.at(*t);
      hit.body = piece.body;
      keepNearer(best, *t, hit);
    }
  return best;
}

} // namespace

std::optional<RayHit> pickBody(const CellDrawing& cell, std::size_t body,
                               const std::vector<Eigen::Isometry3d>& work_T_frame, const Ray& ray) {
  std::optional<RayHit> best;
  for (const CellPiece& piece : cell.pieces)
    if (piece.body == body)
      if (const auto hit = pickPiece(piece, work_T_frame, ray))
        keepNearer(best, hit->t, hit->hit);
  return best;
}

} // namespace voluta::scene

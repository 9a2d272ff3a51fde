#include "panels/stand_picture.h"

#include "base/error.h"
#include "geometry/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voluta::panels {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kFine = 3; // samples per pixel in each direction
constexpr double kRoom = 0.06, kRim = 0.03;
// Red, green, blue: between those of the light and the dark scene.
const Vector3d kPart(0.62, 0.71, 0.80), kPlate(0.52, 0.54, 0.57);
constexpr double kPlateAlpha = 0.28, kShadowAlpha = 0.34;

// The initial view direction of the viewport.
struct Eye {
  Vector3d back = Vector3d(0.75, -1.0, 0.62).normalized();
  Vector3d right = Vector3d::UnitZ().cross(back).normalized();
  Vector3d up = back.cross(right);
  Vector3d light = (0.5 * back + 0.75 * up - 0.45 * right).normalized();

  Vector2d seen(const Vector3d& p) const { return {p.dot(right), p.dot(up)}; }
};

struct Standing {
  geometry::TriangleMesh mesh; // on the plate
  std::array<Vector3d, 4> plate;
  Eigen::AlignedBox2d box; // of both, as seen
};

Standing stood(const geometry::TriangleMesh& mesh, const Eigen::Quaterniond& rotation,
               const Eye& eye) {
  Standing out;
  geometry::Placement placement;
  placement.rotation = rotation;
  out.mesh = geometry::place(mesh, 1.0, placement);
  Eigen::AlignedBox3d box;
  for (std::size_t t = 0; t < out.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      box.extend(out.mesh.corner(t, k));
      out.box.extend(eye.seen(out.mesh.corner(t, k)));
    }
  const double rim = kRim * box.diagonal().norm();
  const Vector3d low = box.min() - Vector3d(rim, rim, 0.0),
                 high = box.max() + Vector3d(rim, rim, 0);
  out.plate = {Vector3d(low.x(), low.y(), 0), Vector3d(high.x(), low.y(), 0),
               Vector3d(high.x(), high.y(), 0), Vector3d(low.x(), high.y(), 0)};
  for (const Vector3d& corner : out.plate)
    out.box.extend(eye.seen(corner));
  return out;
}

// Samples in rows from the top.
class Canvas {
public:
  Canvas(const QSize& pixels, const Eye& eye, double perMm, const Vector2d& middle)
      : eye_(eye), width_(kFine * pixels.width()), height_(kFine * pixels.height()),
        perMm_(perMm * kFine), middle_(middle),
        depth_(static_cast<std::size_t>(width_ * height_), -std::numeric_limits<float>::infinity()),
        tone_(depth_.size(), 0.0F), ground_(depth_.size(), 0) {}

  void drawPlate(const Standing& standing) {
    const auto& p = standing.plate;
    mark({p[0], p[1], p[2]}, 1);
    mark({p[0], p[2], p[3]}, 1);
    for (std::size_t t = 0; t < standing.mesh.triangles.size(); ++t) {
      std::array<Vector3d, 3> fallen;
      for (int k = 0; k < 3; ++k) {
        fallen[static_cast<std::size_t>(k)] = standing.mesh.corner(t, k);
        fallen[static_cast<std::size_t>(k)].z() = 0.0;
      }
      mark(fallen, 2);
    }
  }

  void drawPart(const geometry::TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::array<Vector3d, 3> corners{mesh.corner(t, 0), mesh.corner(t, 1),
                                            mesh.corner(t, 2)};
      Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
      const double size = normal.norm();
      if (size == 0.0)
        continue;
      normal *= (normal.dot(eye_.back) < 0.0 ? -1.0 : 1.0) / size;
      const double tone = 0.5 + 0.58 * std::max(0.0, normal.dot(eye_.light));
      fill(corners, [&](std::size_t dot, double depth) {
        if (static_cast<float>(depth) > depth_[dot]) {
          depth_[dot] = static_cast<float>(depth);
          tone_[dot] = static_cast<float>(tone);
        }
      });
    }
  }

  QImage image() const {
    QImage image(width_ / kFine, height_ / kFine, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < image.height(); ++y) {
      auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
      for (int x = 0; x < image.width(); ++x)
        row[x] = pixel(x, y);
    }
    return image;
  }

private:
  void mark(const std::array<Vector3d, 3>& corners, std::uint8_t what) {
    fill(corners, [&](std::size_t dot, double) { ground_[dot] = std::max(ground_[dot], what); });
  }

  // Calls put(sample, depth towards the eye) for the samples whose centre is in the triangle.
  template <typename Put> void fill(const std::array<Vector3d, 3>& corners, Put put) {
    std::array<Vector2d, 3> at;
    std::array<double, 3> depth{};
    Eigen::AlignedBox2d box;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d seen = perMm_ * (eye_.seen(corners[k]) - middle_);
      at[k] = {0.5 * width_ + seen.x(), 0.5 * height_ - seen.y()};
      depth[k] = corners[k].dot(eye_.back);
      box.extend(at[k]);
    }
    const auto edge = [](const Vector2d& a, const Vector2d& b, const Vector2d& p) {
      return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    };
    const double area = edge(at[0], at[1], at[2]);
    if (area == 0.0)
      return;
    const auto first = [](double low) {
      return std::max(0, static_cast<int>(std::ceil(low - 0.5)));
    };
    const int right = std::min(width_ - 1, static_cast<int>(std::floor(box.max().x() - 0.5)));
    const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(box.max().y() - 0.5)));
    for (int y = first(box.min().y()); y <= bottom; ++y)
      for (int x = first(box.min().x()); x <= right; ++x) {
        const Vector2d p(x + 0.5, y + 0.5);
        const double a = edge(at[1], at[2], p) / area, b = edge(at[2], at[0], p) / area;
        if (a >= 0.0 && b >= 0.0 && a + b <= 1.0)
          put(static_cast<std::size_t>(y * width_ + x),
              a * depth[0] + b * depth[1] + (1.0 - a - b) * depth[2]);
      }
  }

  QRgb pixel(int x, int y) const {
    Vector3d colour = Vector3d::Zero(); // premultiplied by alpha
    double alpha = 0.0;
    for (int j = 0; j < kFine; ++j)
      for (int i = 0; i < kFine; ++i) {
        const auto dot = static_cast<std::size_t>((kFine * y + j) * width_ + kFine * x + i);
        if (std::isfinite(depth_[dot])) {
          colour += (static_cast<double>(tone_[dot]) * kPart).cwiseMin(1.0);
          alpha += 1.0;
        } else if (ground_[dot] == 1) {
          colour += kPlateAlpha * kPlate;
          alpha += kPlateAlpha;
        } else if (ground_[dot] == 2) {
          colour += kShadowAlpha * 0.35 * kPlate;
          alpha += kShadowAlpha + kPlateAlpha * 0.35;
        }
      }
    const auto byte = [](double sum) {
      return static_cast<int>(std::lround(255.0 * std::min(1.0, sum / (kFine * kFine))));
    };
    return qRgba(byte(colour.x()), byte(colour.y()), byte(colour.z()), byte(alpha));
  }

  const Eye& eye_;
  int width_, height_;
  double perMm_;
  Vector2d middle_;
  std::vector<float> depth_, tone_;
  std::vector<std::uint8_t> ground_; // 1: plate, 2: in the part's shadow
};

} // namespace

std::vector<QImage> standPictures(const geometry::TriangleMesh& mesh,
                                  const std::vector<Eigen::Quaterniond>& turns,
                                  const QSize& pixels) {
  base::require(!mesh.empty() && pixels.width() >= 16 && pixels.height() >= 16,
                "standPictures: facets, 16 pixels");
  const Eye eye;
  std::vector<QImage> pictures;
  for (const Eigen::Quaterniond& rotation : turns) {
    const Standing standing = stood(mesh, rotation, eye);
    const Vector2d size = standing.box.sizes().cwiseMax(1e-9);
    const double perMm =
        (1.0 - kRoom) * std::min(pixels.width() / size.x(), pixels.height() / size.y());
    Canvas canvas(pixels, eye, perMm, standing.box.center());
    canvas.drawPlate(standing);
    canvas.drawPart(standing.mesh);
    pictures.push_back(canvas.image());
  }
  return pictures;
}

} // namespace voluta::panels

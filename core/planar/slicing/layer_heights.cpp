#include "planar/slicing/layer_heights.h"

#include "base/error.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::planar {

namespace {

constexpr double kFlat = 0.999;     // cosine: about 2.5 degrees
constexpr double kSameMm = 1e-3;    // heights closer than this are equal
constexpr double kRounding = 1e-9;  // of heights and numbers of layers
constexpr double kStretched = 1.25; // factor by which a last layer may be stretched
constexpr double kShelfMm = 0.03;   // maximum height difference within a flat face
// Minimum area of a flat face, as a share of the piece's volume^(2/3)
constexpr double kShelfShare = 0.02;

// A facet's height range and steepness.
struct Slope {
  double low, high, cosine; // |n . d|
  double areaMm2;
};

std::vector<Slope> slopesOf(const Piece& piece) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  std::vector<Slope> slopes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double a = piece.base.heightOf(mesh.corner(t, 0)),
                 b = piece.base.heightOf(mesh.corner(t, 1)),
                 c = piece.base.heightOf(mesh.corner(t, 2));
    slopes.push_back({std::min({a, b, c}), std::max({a, b, c}),
                      std::abs(geometry::triangleNormal(mesh, t).dot(piece.base.normal)),
                      geometry::triangleArea(mesh, t)});
  }
  std::sort(slopes.begin(), slopes.end(),
            [](const Slope& a, const Slope& b) { return a.low < b.low; });
  return slopes;
}

double topOf(const Piece& piece) {
  double top = 0.0;
  for (const auto& t : piece.solid.mesh.triangles)
    for (const int v : t)
      top = std::max(top,
                     piece.base.heightOf(piece.solid.mesh.vertices[static_cast<std::size_t>(v)]));
  return top;
}

// Returns the heights, ascending, of the relevant flat faces above `from` that layers can all end
// on; includes the top if it is flat.
std::vector<double> shelvesOf(const Piece& piece, double fromMm, double top, double minGapMm) {
  struct Face {
    double height, areaMm2;
  };
  std::vector<Face> faces;
  for (const Slope& slope : slopesOf(piece))
    if (slope.cosine > kFlat && slope.high - slope.low < kShelfMm)
      faces.push_back({0.5 * (slope.low + slope.high), slope.areaMm2});
  std::ranges::sort(faces, {}, &Face::height);
  const double counts =
      kShelfShare * std::pow(std::abs(geometry::volume(piece.solid.mesh)), 2.0 / 3.0);
  std::vector<Face> shelves;
  for (std::size_t from = 0, to = 0; from < faces.size(); from = to) {
    double area = 0.0;
    for (; to < faces.size() && faces[to].height <= faces[from].height + kShelfMm; ++to)
      area += faces[to].areaMm2;
    if (area <= counts)
      continue;
    // Use the median, so that fillets at its rim do not move a shelf.
    std::size_t middle = from;
    for (double below = faces[from].areaMm2; below < 0.5 * area; below += faces[middle].areaMm2)
      ++middle;
    shelves.push_back({faces[middle].height, area});
  }
  std::vector<double> chosen;
  if (!shelves.empty() && shelves.back().height > top - kShelfMm)
    chosen.push_back(top);
  std::ranges::stable_sort(shelves, std::ranges::greater(), &Face::areaMm2);
  for (const Face& shelf : shelves) {
    const auto near = [&](double height) {
      return std::abs(shelf.height - height) < minGapMm - kRounding;
    };
    if (shelf.height > fromMm && !near(fromMm) && !near(top) && std::ranges::none_of(chosen, near))
      chosen.push_back(shelf.height);
  }
  std::ranges::sort(chosen);
  return chosen;
}

// Appends the boundaries of `count` equal layers from the last boundary up to `to`.
void appendEven(std::vector<double>& bounds, double to, int count) {
  const double from = bounds.back();
  for (int k = 1; k < count; ++k)
    bounds.push_back(from + (to - from) * k / count);
  bounds.push_back(to);
}

// Returns the number of equal layers whose height is nearest to the wanted one within the limits;
// if none is within them, the smallest number that does not exceed the maximum height.
int evenCount(double height, const HeightOptions& o) {
  const int count = std::max(1, static_cast<int>(std::lround(height / o.wantedMm)));
  const int maximum = std::max(1, static_cast<int>(std::floor(height / o.minMm + kRounding)));
  const int minimum = std::max(1, static_cast<int>(std::ceil(height / o.maxMm - kRounding)));
  return std::max(minimum, std::min(count, maximum));
}

// Returns the height of the layer above `z` that the surface alone requires.
double adaptiveHeight(const std::vector<Slope>& slopes, double z, const HeightOptions& o) {
  double height = o.maxMm;
  for (const Slope& s : slopes) {
    if (s.low >= z + height + o.minMm)
      break;
    if (s.cosine > kFlat) {
      // Split the distance to a flat face into two layers if one would leave too little for the
      // next.
      const double remaining = s.high - z;
      if (remaining > kSameMm && remaining < height + o.minMm - kSameMm)
        height = std::max(o.minMm, remaining <= height + kSameMm ? remaining : 0.5 * remaining);
      continue;
    }
    if (s.low >= z + height)
      continue;
    if (s.high <= z + kSameMm)
      continue;
    const double allowed = s.cosine * o.maxMm > o.cuspMm ? o.cuspMm / s.cosine : o.maxMm;
    // Below its lowest point the facet does not limit the layer.
    height = std::min(height, std::max({o.minMm, allowed, s.low - z}));
  }
  return height;
}

} // namespace

std::vector<double> layerBounds(const Piece& piece, const HeightOptions& o) {
  base::require(o.minMm > 0.0 && o.minMm <= o.wantedMm && o.wantedMm <= o.maxMm && o.cuspMm > 0.0,
                "layerBounds: heights in order");
  base::require(o.firstMm == 0.0 || (o.firstMm >= o.minMm && o.firstMm <= o.maxMm),
                "layerBounds: the first height is within the limits");
  const double top = topOf(piece);
  std::vector<double> bounds{0.0};
  if (o.firstMm > 0.0 && top >= o.firstMm + o.minMm)
    bounds.push_back(o.firstMm);
  if (const double remaining = top - bounds.back(); remaining <= o.maxMm) {
    appendEven(bounds, top, evenCount(remaining, o));
    return bounds;
  }
  if (!o.adaptive)
    for (const double shelf : shelvesOf(piece, bounds.back(), top, o.minMm))
      appendEven(bounds, shelf, evenCount(shelf - bounds.back(), o));
  const std::vector<Slope> slopes = o.adaptive ? slopesOf(piece) : std::vector<Slope>{};
  while (top - bounds.back() > kSameMm) {
    const double z = bounds.back(), remaining = top - z;
    const double height = o.adaptive ? adaptiveHeight(slopes, z, o) : o.wantedMm;
    if (remaining > height + o.minMm) {
      bounds.push_back(z + height);
      continue;
    }
    const bool tooHigh = remaining > std::min(o.maxMm, kStretched * height);
    appendEven(bounds, top, remaining > o.maxMm || (tooHigh && remaining >= 2.0 * o.minMm) ? 2 : 1);
  }
  bounds.back() = top;
  return bounds;
}

} // namespace voluta::planar

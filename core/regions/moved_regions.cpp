#include "regions/moved_regions.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace voluta::regions {

namespace {
using Eigen::Vector3d;
using geometry::TriangleMesh;
using project::Region;

constexpr double kTurned = 1e-9;

std::string textOf(std::string_view word, const std::vector<double>& numbers) {
  constexpr double kDigits = 1e6;
  std::vector<double> rounded;
  for (const double number : numbers)
    rounded.push_back(std::round(number * kDigits) / kDigits + 0.0);
  return fmt::format("{}:{}", word, fmt::join(rounded, ","));
}

std::shared_ptr<const TriangleMesh> moved(TriangleMesh mesh, const PieceOfPart& piece) {
  for (Vector3d& v : mesh.vertices)
    v = piece.work_T_file * (piece.scale * v);
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

// Returns the numbers of a box, cylinder or sphere after the move; nullopt: it would be tilted.
std::optional<std::vector<double>> movedNumbers(const Shape& shape, const PieceOfPart& piece) {
  const Eigen::Matrix3d turn = piece.work_T_file.linear();
  const Vector3d middle =
      piece.work_T_file *
      (piece.scale * Vector3d(shape.numbers[0], shape.numbers[1], shape.numbers[2]));
  std::vector<double> numbers{middle.x(), middle.y(), middle.z()};
  if (shape.kind->word == "sphere") {
    numbers.push_back(piece.scale * shape.numbers[3]);
    return numbers;
  }
  if (shape.kind->word == "cylinder") {
    if (std::abs(turn(2, 2)) < 1.0 - kTurned)
      return std::nullopt;
    for (const std::size_t k : {3u, 4u})
      numbers.push_back(piece.scale * shape.numbers[k]);
    return numbers;
  }
  const Eigen::Matrix3d sides = turn.cwiseAbs();
  if ((sides.colwise().maxCoeff().array() < 1.0 - kTurned).any())
    return std::nullopt;
  const Vector3d size =
      piece.scale * (sides * Vector3d(shape.numbers[3], shape.numbers[4], shape.numbers[5])).eval();
  for (const double side : size)
    numbers.push_back(side);
  return numbers;
}

Region boxOfHeights(Region region, const Shape& shape, const PieceOfPart& piece) {
  constexpr double kBesideMm = 1.0; // around the piece
  const Vector3d middle = piece.partBox.center(),
                 size = piece.partBox.sizes() + Vector3d::Constant(2.0 * kBesideMm);
  const double low = shape.numbers[0], high = shape.numbers[1];
  region.shape =
      textOf("box", {middle.x(), middle.y(), 0.5 * (low + high), size.x(), size.y(), high - low});
  return region;
}

Region movedRegion(Region region, const Shape& shape, const PieceOfPart& piece) {
  // The axes of the piece's file are those of the work frame.
  if (findUse(region.use).load == RegionLoad::Force) {
    const Vector3d force = piece.work_T_file.linear() * forceOf(region.use);
    region.use = textOf(findUse(region.use).id, {force.x(), force.y(), force.z()});
  }
  if (findUse(region.use).isInsert) // the piece counts its own layers
    region.use = findUse(region.use).id;
  switch (shape.kind->frame) {
  case ShapeFrame::Part:
    return region;
  case ShapeFrame::Plate:
    return piece.keepsHeight || !(shape.numbers[1] > shape.numbers[0])
               ? region
               : boxOfHeights(std::move(region), shape, piece);
  case ShapeFrame::File:
    break;
  }
  if (shape.kind->mesh != ShapeMesh::None) {
    if (region.mesh)
      region.mesh = moved(*region.mesh, piece);
    return region;
  }
  if (const auto numbers = movedNumbers(shape, piece)) {
    region.shape = textOf(shape.kind->word, *numbers);
    return region;
  }
  region.mesh = moved(shape.kind->body(shape.numbers, piece.partBox), piece);
  region.shape = fmt::format("mesh:{}", shape.kind->word);
  return region;
}

bool touches(const Region& region, const Shape& shape, const PieceOfPart& piece) {
  Eigen::AlignedBox3d box;
  if (region.mesh)
    box = geometry::bounds(*region.mesh);
  else if (shape.kind->body)
    box = geometry::bounds(shape.kind->body(shape.numbers, piece.partBox));
  else
    return true;
  if (shape.kind->mesh == ShapeMesh::Painted) {
    const Vector3d depth = Vector3d::Constant(shape.numbers[0]);
    box = Eigen::AlignedBox3d(box.min() - depth, box.max() + depth);
  }
  return box.intersects(piece.box);
}
} // namespace

std::vector<Region> regionsOfPiece(std::span<const Region> all, const PieceOfPart& piece) {
  std::vector<Region> kept;
  for (const Region& region : all) {
    try {
      const RegionUse& use = findUse(region.use);
      if (use.cuts && !use.isInsert) // the piece ends there already
        continue;
      Region own = movedRegion(region, parsedShape(region.shape), piece);
      if (touches(own, parsedShape(own.shape), piece))
        kept.push_back(std::move(own));
    } catch (const base::Error&) { // the text is invalid, which the plan reports
      kept.push_back(region);
    }
  }
  return kept;
}

} // namespace voluta::regions

#include "regions/region_kinds.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/number_list.h"
#include "base/units.h"
#include "geometry/prism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace voluta::regions {

namespace {
using base::Error;
using base::ErrorCode;
using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;
using Numbers = std::vector<double>;

constexpr double kFarMm = 1e5, kMinMm = 0.01, kMaxMm = 1e4;
constexpr std::size_t kMostShown = 60; // characters of a number that is wrong
constexpr int kSides = 180;            // of cylinders; a sphere has half as many from pole to pole

ShapeField place(std::string_view name, base::Text label) {
  return {name, label, -kFarMm, kFarMm};
}
ShapeField length(std::string_view name, base::Text label) {
  return {name, label, kMinMm, kMaxMm};
}

std::vector<Vector2d> rectangle(const Vector2d& middle, const Vector2d& size) {
  const Vector2d half = 0.5 * size;
  return {middle - half, middle + Vector2d(half.x(), -half.y()), middle + half,
          middle + Vector2d(-half.x(), half.y())};
}

// Returns a regular polygon with the area of the circle.
std::vector<Vector2d> circle(const Vector2d& middle, double radius) {
  const double step = 2.0 * base::kPi / kSides;
  const double same = radius * std::sqrt(step / std::sin(step));
  std::vector<Vector2d> polygon;
  for (int i = 0; i < kSides; ++i)
    polygon.emplace_back(middle + same * Vector2d(std::cos(i * step), std::sin(i * step)));
  return polygon;
}

TriangleMesh box(const Numbers& n, const AlignedBox3d&) {
  return geometry::prismOver(rectangle({n[0], n[1]}, {n[3], n[4]}), n[2] - 0.5 * n[5],
                             n[2] + 0.5 * n[5]);
}

TriangleMesh cylinder(const Numbers& n, const AlignedBox3d&) {
  return geometry::prismOver(circle({n[0], n[1]}, 0.5 * n[3]), n[2] - 0.5 * n[4],
                             n[2] + 0.5 * n[4]);
}

TriangleMesh sphere(const Numbers& n, const AlignedBox3d&) {
  constexpr int kRings = kSides / 2 - 1; // without the poles
  const Vector3d middle(n[0], n[1], n[2]);
  const double radius = 0.5 * n[3];
  TriangleMesh mesh;
  for (int r = 1; r <= kRings; ++r) {
    const double polar = base::kPi * r / (kRings + 1);
    for (int i = 0; i < kSides; ++i) {
      const double a = 2.0 * base::kPi * i / kSides;
      mesh.vertices.emplace_back(middle + radius * Vector3d(std::sin(polar) * std::cos(a),
                                                            std::sin(polar) * std::sin(a),
                                                            std::cos(polar)));
    }
  }
  const int top = static_cast<int>(mesh.vertices.size()), bottom = top + 1;
  mesh.vertices.emplace_back(middle + Vector3d(0.0, 0.0, radius));
  mesh.vertices.emplace_back(middle - Vector3d(0.0, 0.0, radius));
  for (int i = 0; i < kSides; ++i) {
    const int j = (i + 1) % kSides, last = (kRings - 1) * kSides;
    mesh.triangles.push_back({top, i, j});
    mesh.triangles.push_back({bottom, last + j, last + i});
    for (int r = 0; r + 1 < kRings; ++r) {
      const int a = r * kSides, b = a + kSides;
      mesh.triangles.push_back({a + i, b + i, b + j});
      mesh.triangles.push_back({a + i, b + j, a + j});
    }
  }
  return mesh;
}

// A slab that is wider than the part.
TriangleMesh heights(const Numbers& n, const AlignedBox3d& around) {
  constexpr double kBeyondMm = 10.0;
  if (n[0] >= n[1])
    throw Error(ErrorCode::Usage,
                base::message("the range of heights from {from} to {to} is empty"_text,
                              base::mm(n[0]), base::mm(n[1])),
                {}, "give the lower height first"_text);
  const Vector3d size = around.sizes().array() + 2.0 * kBeyondMm;
  return geometry::prismOver(rectangle(around.center().head<2>(), size.head<2>()), n[0], n[1]);
}
} // namespace

const std::vector<RegionKind>& regionKinds() {
  static const std::vector<RegionKind> kKinds{
      {.word = "box",
       .label = "Box"_text,
       .fields = {place("X", "Middle X"_text), place("Y", "Middle Y"_text),
                  place("Z", "Middle Z"_text), length("WIDTH", "Width (X)"_text),
                  length("DEPTH", "Depth (Y)"_text), length("HEIGHT", "Height (Z)"_text)},
       .body = box},
      {.word = "cylinder",
       .label = "Cylinder along Z"_text,
       .fields = {place("X", "Middle X"_text), place("Y", "Middle Y"_text),
                  place("Z", "Middle Z"_text), length("DIAMETER", "Diameter"_text),
                  length("HEIGHT", "Height (Z)"_text)},
       .body = cylinder},
      {.word = "sphere",
       .label = "Sphere"_text,
       .fields = {place("X", "Middle X"_text), place("Y", "Middle Y"_text),
                  place("Z", "Middle Z"_text), length("DIAMETER", "Diameter"_text)},
       .body = sphere},
      {.word = "height",
       .label = "Range of heights over the plate"_text,
       .fields = {place("FROM", "From"_text), place("TO", "To"_text)},
       .frame = ShapeFrame::Plate,
       .body = heights},
      {.word = "skin",
       .label = "Skin below the upper surface"_text,
       .fields = {length("DEPTH", "Depth"_text),
                  {"SLOPE", "Steepest slope (degrees)"_text, 0.0, 179.0, 60.0}},
       .frame = ShapeFrame::Part,
       .usualUse = "surface"},
      {.word = "painted",
       .label = "Painted surface"_text,
       .fields = {length("DEPTH", "Depth"_text)},
       .mesh = ShapeMesh::Painted},
      {.word = "mesh", .label = "Body from a file"_text, .mesh = ShapeMesh::File},
  };
  return kKinds;
}

std::string formOf(const std::vector<ShapeField>& fields) {
  std::string form;
  for (const ShapeField& field : fields) {
    const std::string name = fmt::format("{}{}", form.empty() ? "" : ",", field.name);
    form += field.usual ? fmt::format("[{}]", name) : name;
  }
  return form;
}

bool followsSurface(const RegionKind& kind) {
  return kind.frame == ShapeFrame::Part || kind.mesh == ShapeMesh::Painted;
}

std::string formOf(const RegionKind& kind) {
  return fmt::format("{}:{}", kind.word,
                     kind.mesh == ShapeMesh::File ? std::string("FILE") : formOf(kind.fields));
}

std::string allForms() {
  std::string all;
  for (const RegionKind& kind : regionKinds())
    all += fmt::format("{}{}", all.empty() ? "" : ", ", formOf(kind));
  return all;
}

Shape parsedShape(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view word = text.substr(0, colon);
  const auto& kinds = regionKinds();
  const auto kind = std::ranges::find(kinds, word, &RegionKind::word);
  if (kind == kinds.end()) {
    std::vector<std::string> words;
    for (const RegionKind& one : kinds)
      words.emplace_back(one.word);
    throw Error(ErrorCode::Usage, base::message("unknown region '{name}'"_text, word), {},
                base::didYouMean(word, words));
  }
  Shape shape{&*kind, {}, {}};
  if (kind->mesh == ShapeMesh::File) {
    if (colon == std::string_view::npos || colon + 1 == text.size())
      throw Error(ErrorCode::Usage, base::message("'{text}' is incomplete"_text, text), {},
                  base::message("write {form}"_text, formOf(*kind)));
    shape.file = text.substr(colon + 1);
    return shape;
  }
  shape.numbers = parsedNumbers(text, kind->fields, formOf(*kind));
  return shape;
}

std::vector<double> parsedNumbers(std::string_view text, const std::vector<ShapeField>& fields,
                                  const std::string& form) {
  const std::size_t colon = text.find(':');
  std::string_view left =
      colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  const auto malformed = [&] {
    return Error(ErrorCode::Usage, base::message("'{text}' is incomplete"_text, text), {},
                 base::message("write {form}, lengths in mm"_text, form));
  };
  const std::size_t given =
      left.empty() ? 0 : 1 + static_cast<std::size_t>(std::ranges::count(left, ','));
  if (given > fields.size() || (colon != std::string_view::npos && given == 0))
    throw malformed();
  std::vector<double> numbers;
  for (const ShapeField& field : fields) {
    double number = field.usual.value_or(0.0);
    std::string_view word;
    if (numbers.size() < given) {
      const std::size_t comma = left.find(',');
      word = left.substr(0, comma);
      if (word.empty())
        throw malformed();
      if (!base::readNumbers(word, ',', {&number}))
        throw Error(ErrorCode::Usage,
                    base::message("'{text}': {field} '{word}' is not a number"_text, text,
                                  field.name, word.substr(0, kMostShown)),
                    {}, base::message("write {form}"_text, form));
      left = comma == std::string_view::npos ? std::string_view() : left.substr(comma + 1);
    } else if (!field.usual) {
      throw malformed();
    }
    if (!(number >= field.minimum && number <= field.maximum))
      throw Error(ErrorCode::Usage,
                  base::message("'{text}': {field} {number} is out of range"_text, text, field.name,
                                word.substr(0, kMostShown)), // as written: 1e300 is long
                  {},
                  base::message("give {field} from {least} to {most}"_text, field.name,
                                base::number(field.minimum), base::number(field.maximum)));
    if (field.isWhole && number != std::floor(number))
      throw Error(ErrorCode::Usage,
                  base::message("'{text}': {field} is no whole number"_text, text, field.name), {},
                  base::message("write {form}"_text, form));
    numbers.push_back(number);
  }
  return numbers;
}

} // namespace voluta::regions

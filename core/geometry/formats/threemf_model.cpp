#include "geometry/formats/threemf_model.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/xml_scan.h"

#include <algorithm>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

constexpr std::string_view kCoreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
// Extensions that are read here, or that do not change an object's shape.
constexpr std::array<std::string_view, 7> kKnownSpaces{
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/balls/2020/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
    "http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03"};

constexpr std::array<std::pair<std::string_view, ThreemfObjectType>, 5> kTypes{
    {{"model", ThreemfObjectType::Model},
     {"solidsupport", ThreemfObjectType::SolidSupport},
     {"support", ThreemfObjectType::Support},
     {"surface", ThreemfObjectType::Surface},
     {"other", ThreemfObjectType::Other}}};

[[noreturn]] void fail(const base::Message& what) {
  throw Error(ErrorCode::UnreadableFile, what);
}

// Returns the value of an attribute in any namespace; empty if there is none.
std::string_view textAnywhere(const XmlAttributes& attributes, std::string_view word) {
  std::string_view value;
  attributes.each([&](XmlName name, std::string_view text) {
    if (name.word == word)
      value = text;
  });
  return value;
}

double numberOr(const XmlAttributes& attributes, std::string_view word, double otherwise) {
  const std::string_view text = textAnywhere(attributes, word);
  if (text.empty())
    return otherwise;
  const std::optional<double> value = numberOf(text);
  if (!value || !(*value >= 0.0))
    fail(base::message("'{attribute}' is not a number"_text, word));
  return *value;
}

// Twelve numbers in column order; if missing: the identity.
Eigen::Affine3d transformOf(const XmlAttributes& attributes) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  const std::string_view all = attributes.text("transform");
  if (all.empty())
    return transform;
  std::vector<std::string_view> words;
  LineScanner(all).nextLine(words);
  if (words.size() != 12)
    fail("a transform does not have twelve numbers"_text);
  for (Eigen::Index i = 0; i < 12; ++i) {
    const std::optional<double> value = numberOf(words[static_cast<std::size_t>(i)]);
    if (!value)
      fail("a transform contains a value that is not a number"_text);
    transform.matrix()(i % 3, i / 3) = *value;
  }
  return transform;
}

ThreemfUse useOf(const XmlAttributes& attributes) {
  const std::string_view printable = textAnywhere(attributes, "printable");
  return {std::string(textAnywhere(attributes, "path")), std::string(attributes.text("objectid")),
          transformOf(attributes), printable != "0" && printable != "false"};
}

class ModelParser {
public:
  ThreemfModel parse(std::string_view text, const std::string& where) {
    XmlHandler handler;
    handler.declares = [&](std::string_view prefix, std::string_view space) {
      spaces_[std::string(prefix)] = space;
    };
    handler.begin = [&](XmlName name, const XmlAttributes& attributes) { begin(name, attributes); };
    handler.end = [&](XmlName name) { end(name); };
    scanXml(text, where, handler);
    return std::move(model_);
  }

private:
  void begin(XmlName name, const XmlAttributes& attributes) {
    const bool isCore = name.space.empty() || name.space == kCoreSpace;
    if (isCore && name.word == "model") {
      if (const std::string_view unit = attributes.text("unit"); !unit.empty())
        model_.unit = unit;
      requireKnown(attributes.text("requiredextensions"));
    } else if (isCore && name.word == "object") {
      beginObject(attributes);
    } else if (isCore && name.word == "item") {
      model_.build.push_back(useOf(attributes));
    } else if (object_ && isCore) {
      partOfObject(name.word, attributes);
    } else if (object_) {
      partOfLattice(name.word, attributes);
    }
  }
  void end(XmlName name) {
    if (object_ && name.word == "beamlattice")
      addDefaultBalls();
    if (name.word == "object")
      object_ = nullptr;
  }

  // `prefixes`: of the extensions that the model requires for its shape.
  void requireKnown(std::string_view prefixes) const {
    std::vector<std::string_view> words;
    LineScanner(prefixes).nextLine(words);
    for (const std::string_view prefix : words) {
      const auto declared = spaces_.find(std::string(prefix));
      const std::string extension(declared == spaces_.end() ? prefix : declared->second);
      if (std::ranges::find(kKnownSpaces, extension) == kKnownSpaces.end())
        fail(base::message("requires the unknown extension '{name}'"_text, extension));
    }
  }

  void beginObject(const XmlAttributes& attributes) {
    object_ = &model_.objects[std::string(attributes.text("id"))];
    object_->name = attributes.text("name");
    if (const std::string_view word = attributes.text("type"); !word.empty()) {
      const auto* known =
          std::ranges::find(kTypes, word, [](const auto& row) { return row.first; });
      if (known == kTypes.end())
        fail(base::message("an object of the unknown type '{type}'"_text, word));
      object_->type = known->second;
    }
    object_->hasSlices = !textAnywhere(attributes, "slicestackid").empty();
    object_->lowResolution = textAnywhere(attributes, "meshresolution") == "lowres";
  }

  void partOfObject(std::string_view word, const XmlAttributes& attributes) {
    if (word == "vertex") {
      object_->vertices.emplace_back(attributes.number("x"), attributes.number("y"),
                                     attributes.number("z"));
    } else if (word == "triangle") {
      object_->triangles.push_back(
          {attributes.integer("v1"), attributes.integer("v2"), attributes.integer("v3")});
      for (const long long v : object_->triangles.back())
        if (!hasVertex(v))
          fail(base::message("a triangle refers to the missing vertex {vertex}"_text, v));
    } else if (word == "component") {
      object_->components.push_back(useOf(attributes));
    }
  }

  void partOfLattice(std::string_view word, const XmlAttributes& attributes) {
    if (word == "beamlattice") {
      lattice_ = {.radius = numberOr(attributes, "radius", 0.0),
                  .minLength = numberOr(attributes, "minlength", 0.0),
                  .ballRadius = numberOr(attributes, "ballradius", 0.0),
                  .ballsEverywhere = textAnywhere(attributes, "ballmode") == "all",
                  .round = textAnywhere(attributes, "cap") != "butt"};
      const std::string_view clipping = textAnywhere(attributes, "clippingmode");
      object_->hasClippedBeams = !clipping.empty() && clipping != "none";
    } else if (word == "beam") {
      addBeam(attributes);
    } else if (word == "ball") {
      const long long vertex = attributes.integer("vindex");
      if (!hasVertex(vertex))
        fail(base::message("a ball refers to the missing vertex {vertex}"_text, vertex));
      object_->balls[vertex] = numberOr(attributes, "r", lattice_.ballRadius);
    }
  }

  void addBeam(const XmlAttributes& attributes) {
    ThreemfBeam beam;
    beam.ends = {attributes.integer("v1"), attributes.integer("v2")};
    for (const long long v : beam.ends)
      if (!hasVertex(v))
        fail(base::message("a beam refers to the missing vertex {vertex}"_text, v));
    beam.radii[0] = numberOr(attributes, "r1", lattice_.radius);
    beam.radii[1] = numberOr(attributes, "r2", beam.radii[0]);
    constexpr std::array<std::string_view, 2> kCaps{"cap1", "cap2"};
    for (std::size_t end = 0; end < 2; ++end) {
      if (!(beam.radii[end] > 0.0))
        fail("a beam without a radius"_text);
      const std::string_view cap = textAnywhere(attributes, kCaps[end]);
      beam.round[end] = cap.empty() ? lattice_.round : cap != "butt";
    }
    const auto& at = object_->vertices;
    const double length =
        (at[static_cast<std::size_t>(beam.ends[1])] - at[static_cast<std::size_t>(beam.ends[0])])
            .norm();
    if (length > 0.0 && length >= lattice_.minLength)
      object_->beams.push_back(beam);
  }

  void addDefaultBalls() {
    if (!lattice_.ballsEverywhere)
      return;
    for (const ThreemfBeam& beam : object_->beams)
      for (const long long v : beam.ends)
        object_->balls.emplace(v, lattice_.ballRadius);
  }

  bool hasVertex(long long v) const {
    return v >= 0 && static_cast<std::size_t>(v) < object_->vertices.size();
  }

  struct Lattice {
    double radius = 0.0, minLength = 0.0, ballRadius = 0.0;
    bool ballsEverywhere = false, round = true;
  };

  ThreemfModel model_;
  std::map<std::string, std::string> spaces_; // by prefix
  ThreemfObject* object_ = nullptr;           // being read
  Lattice lattice_;                           // being read
};

} // namespace

std::string ThreemfModel::nameOf(const std::string& id) const {
  const auto found = objects.find(id);
  return found == objects.end() ? std::string() : found->second.name;
}

ThreemfModel parseThreemfModel(std::string_view text, const std::string& where) {
  return ModelParser().parse(text, where);
}

} // namespace voluta::geometry

#include "geometry/formats/threemf_model.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/threemf_notes.h"
#include "geometry/formats/xml_scan.h"

#include <algorithm>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

constexpr std::string_view kCoreSpace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kCuraSpace = "http://software.ultimaker.com/xml/cura/3mf/2015/10";
// Extensions that are read here, or that do not change an object's shape.
constexpr std::array<std::string_view, 8> kKnownSpaces{
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/balls/2020/07",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
    "http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03",
    "urn:voluta:toolpath:2026"};

constexpr std::array<std::string_view, 16> kCoreWords{
    "model",      "metadata",  "metadatagroup", "resources", "basematerials", "base",
    "object",     "mesh",      "vertices",      "vertex",    "triangles",     "triangle",
    "components", "component", "build",         "item"};
// Of objects, uses and triangles: read here, or without effect on the shape.
constexpr std::array<std::string_view, 23> kKnownAttributes{"id",
                                                            "type",
                                                            "name",
                                                            "partnumber",
                                                            "pid",
                                                            "pindex",
                                                            "p1",
                                                            "p2",
                                                            "p3",
                                                            "v1",
                                                            "v2",
                                                            "v3",
                                                            "UUID",
                                                            "path",
                                                            "thumbnail",
                                                            "objectid",
                                                            "transform",
                                                            "printable",
                                                            "slicestackid",
                                                            "meshresolution",
                                                            "face_property",
                                                            "preserve",
                                                            "toolpathid"};
// Of metadata that name a version or describe the file.
constexpr std::array<std::string_view, 4> kPlainPrefixes{"slic3rpe", "BambuStudio", "OrcaSlicer",
                                                         "xml"};

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
  ModelParser(const std::string& name, const std::string& member) : name_(name), notes_(member) {}

  ThreemfModel parse(std::string_view text) {
    XmlHandler handler;
    handler.declares = [&](std::string_view prefix, std::string_view space) {
      spaces_[std::string(prefix)] = space;
    };
    handler.begin = [&](XmlName name, const XmlAttributes& attributes) { begin(name, attributes); };
    handler.end = [&](XmlName name) { end(name); };
    handler.text = [&](std::string_view more) {
      if (takesText_)
        text_ += more;
    };
    scanXml(text, name_ + ", " + notes_.member(), handler);
    if (!material_.empty() && !hasMaterials_)
      notes_.add(base::message("not used: the material or colour of objects and triangles, from "
                               "line {line} of {where}"_text,
                               materialLine_, notes_.member()));
    model_.notes = notes_.sentences();
    return std::move(model_);
  }

private:
  void begin(XmlName name, const XmlAttributes& attributes) {
    if (depth_++ == 0 && name.word == "model")
      takeRoot(name);
    const bool isCore = name.space.empty() || name.space == core_;
    if (isCore && name.word == "model") {
      if (const std::string_view unit = attributes.text("unit"); !unit.empty())
        model_.unit = unit;
      requireKnown(attributes.text("requiredextensions"));
      for (const std::string& extension : unknownOf(attributes.text("recommendedextensions")))
        notes_.add(base::message("not used: the recommended extension '{name}' ({where})"_text,
                                 extension, notes_.member()));
    } else if (isCore && name.word == "object") {
      beginObject(attributes);
    } else if (isCore && name.word == "item") {
      model_.build.push_back(useOf(attributes));
      noteAttributes(name, attributes);
    } else if (isCore && name.word == "metadata") {
      beginMetadata(attributes.text("name"));
    } else if (name.word == "setting" && (isCore || name.space == kCuraSpace)) {
      beginMetadata("cura:" + std::string(attributes.text("key")));
    } else if (object_ && isCore) {
      partOfObject(name, attributes);
    } else if (object_) {
      partOfLattice(name.word, attributes);
    }
    noteElement(name, isCore, attributes);
  }
  void end(XmlName name) {
    --depth_;
    if (unknownDepth_ > depth_)
      unknownDepth_ = 0;
    if (takesText_ && (name.word == "metadata" || name.word == "setting"))
      endMetadata();
    if (object_ && name.word == "beamlattice")
      addDefaultBalls();
    if (name.word == "object")
      object_ = nullptr;
  }

  // The namespace of the root is the core's, whatever it is called.
  void takeRoot(XmlName name) {
    if (name.space.empty() || name.space == kCoreSpace)
      return;
    core_ = name.space;
    notes_.add(
        base::message("read although its namespace is '{space}' and not that of 3MF ({where})"_text,
                      name.space, notes_.member()));
  }

  // Names an element that neither this reader knows nor a reader of its extension, with the
  // outermost one for all within it.
  void noteElement(XmlName name, bool isCore, const XmlAttributes& attributes) {
    if (unknownDepth_ > 0)
      return;
    const bool isKnown = isCore
                             ? std::ranges::find(kCoreWords, name.word) != kCoreWords.end()
                             : std::ranges::find(kKnownSpaces, name.space) != kKnownSpaces.end() ||
                                   name.space == kCuraSpace || name.space == kCoreSpace;
    if (isKnown)
      return;
    unknownDepth_ = depth_;
    notes_.addElement(std::string(name.word), std::string(name.space), attributes.line());
  }

  // Of the last triangle.
  void addPaint(const std::string& attribute, std::string_view code, long long line) {
    ThreemfPaint& paint = object_->paints[attribute];
    if (paint.triangles++ == 0)
      paint.line = line;
    if (!paintSetting(attribute).empty())
      paint.codes.emplace_back(object_->triangles.size() - 1, code);
  }

  // Names attributes of an object, a use or a triangle that are not read.
  void noteAttributes(XmlName element, const XmlAttributes& attributes) {
    attributes.each([&](XmlName name, std::string_view text) {
      if (object_ && element.word == "triangle" && !paintWord(name.word).empty())
        addPaint(std::string(name.word), text, attributes.line());
      else if (std::ranges::find(kKnownAttributes, name.word) == kKnownAttributes.end())
        notes_.addAttribute(std::string(name.word), std::string(element.word), attributes.line());
    });
  }

  // Names the materials of objects and triangles, once, and whether there are several.
  void noteMaterial(std::string material, long long line) {
    if (material.empty())
      return;
    if (material_.empty()) {
      material_ = std::move(material);
      materialLine_ = line;
    } else if (material_ != material && !std::exchange(hasMaterials_, true)) {
      notes_.add(base::message(
          "not used: materials and colours of objects and triangles, more than one from line "
          "{line} of {where}"_text,
          line, notes_.member()));
    }
  }

  // `name`: with the prefix of its namespace.
  void beginMetadata(std::string_view name) {
    takesText_ = true;
    text_.clear();
    metadata_ = name;
  }
  void endMetadata() {
    takesText_ = false;
    const std::size_t colon = metadata_.find(':');
    if (colon == std::string::npos)
      return;
    const std::string prefix = metadata_.substr(0, colon), key = metadata_.substr(colon + 1);
    const auto declared = spaces_.find(prefix);
    // Also for files with exchanged namespaces
    if (prefix == "cura" || (declared != spaces_.end() && declared->second == kCuraSpace)) {
      if (object_)
        object_->settings.emplace_back(key, text_);
      else
        notes_.addMetadata(metadata_);
    } else if (std::ranges::find(kPlainPrefixes, prefix) == kPlainPrefixes.end()) {
      notes_.addMetadata(metadata_);
    }
  }

  // Returns the extensions of these prefixes that are not read here.
  std::vector<std::string> unknownOf(std::string_view prefixes) const {
    std::vector<std::string_view> words;
    LineScanner(prefixes).nextLine(words);
    std::vector<std::string> unknown;
    for (const std::string_view prefix : words) {
      const auto declared = spaces_.find(std::string(prefix));
      const std::string extension(declared == spaces_.end() ? prefix : declared->second);
      if (std::ranges::find(kKnownSpaces, extension) == kKnownSpaces.end())
        unknown.push_back(extension);
    }
    return unknown;
  }

  // `prefixes`: of the extensions that the model requires for its shape.
  void requireKnown(std::string_view prefixes) const {
    if (const std::vector<std::string> unknown = unknownOf(prefixes); !unknown.empty())
      fail(base::message("requires the unknown extension '{name}'"_text, unknown.front()));
  }

  void beginObject(const XmlAttributes& attributes) {
    const auto [object, isNew] = model_.objects.try_emplace(std::string(attributes.text("id")));
    if (!isNew)
      fail(base::message("a second object of the id '{id}'"_text, object->first));
    object_ = &object->second;
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
    objectMaterial_ = attributes.text("pid");
    objectMaterialAt_ = attributes.text("pindex");
    noteMaterial(materialOf(objectMaterial_, objectMaterialAt_), attributes.line());
    noteAttributes({{}, "object"}, attributes);
  }

  static std::string materialOf(std::string_view group, std::string_view index) {
    return group.empty() ? std::string() : std::string(group) + ":" + std::string(index);
  }

  void partOfTriangle(XmlName name, const XmlAttributes& attributes) {
    const auto given = [&](std::string_view word, const std::string& otherwise) {
      const std::string_view text = attributes.text(word);
      return text.empty() ? otherwise : std::string(text);
    };
    const std::string group = given("pid", objectMaterial_);
    const std::string first = given("p1", objectMaterialAt_);
    for (const std::string& index : {first, given("p2", first), given("p3", first)})
      noteMaterial(materialOf(group, index), attributes.line());
    noteAttributes(name, attributes);
  }

  void partOfObject(XmlName name, const XmlAttributes& attributes) {
    const std::string_view word = name.word;
    if (word == "vertex") {
      object_->vertices.emplace_back(attributes.number("x"), attributes.number("y"),
                                     attributes.number("z"));
    } else if (word == "triangle") {
      object_->triangles.push_back(
          {attributes.integer("v1"), attributes.integer("v2"), attributes.integer("v3")});
      for (const long long v : object_->triangles.back())
        if (!hasVertex(v))
          fail(base::message("a triangle refers to the missing vertex {vertex}"_text, v));
      if (attributes.size() > 3)
        partOfTriangle(name, attributes);
    } else if (word == "component") {
      object_->components.push_back(useOf(attributes));
      noteAttributes(name, attributes);
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

  const std::string& name_;
  ThreemfModel model_;
  ThreemfNotes notes_;
  std::string core_{kCoreSpace};              // the namespace of the core's elements
  std::map<std::string, std::string> spaces_; // by prefix
  int depth_ = 0, unknownDepth_ = 0;          // of elements; of the unknown one being read, 0: none
  bool takesText_ = false;
  std::string text_, metadata_;                   // being read
  std::string objectMaterial_, objectMaterialAt_; // of the object being read
  std::string material_;                          // the first one of the model
  long long materialLine_ = 0;                    // where it is
  bool hasMaterials_ = false;                     // further ones
  ThreemfObject* object_ = nullptr;               // being read
  Lattice lattice_;                               // being read
};

} // namespace

std::string ThreemfModel::nameOf(const std::string& id) const {
  const auto found = objects.find(id);
  return found == objects.end() ? std::string() : found->second.name;
}

ThreemfModel parseThreemfModel(std::string_view text, const std::string& name,
                               const std::string& member) {
  return ModelParser(name, member).parse(text);
}

} // namespace voluta::geometry

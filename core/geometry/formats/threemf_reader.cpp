// 3MF core specification 1.3, with the paths of its production extension. Read here and not by
// assimp 5.2, whose asserts end the program on damaged files.
#include "base/error.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/zip_package.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <expat.h>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

// What a package may unfold to: components may be used again and again.
constexpr std::size_t kMostFacets = 30'000'000, kMostUses = 1'000'000;
constexpr int kDeepest = 100;

struct Use {            // of an object, in the build or in another object
  std::string path, id; // path empty: of the same model
  Eigen::Affine3d parent_T_object = Eigen::Affine3d::Identity();
};
struct Object {
  std::vector<Vector3d> vertices;
  std::vector<std::array<long long, 3>> triangles;
  std::vector<Use> components;
};
struct Model {
  std::string unit = "millimeter";
  std::map<std::string, Object> objects;
  std::vector<Use> build;
};

std::string_view localName(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

class Attributes {
public:
  explicit Attributes(const XML_Char** pairs) : pairs_(pairs) {}
  // Empty where there is none.
  std::string_view text(std::string_view name) const {
    for (const XML_Char** pair = pairs_; *pair; pair += 2)
      if (localName(*pair) == name)
        return pair[1];
    return {};
  }
  double number(std::string_view name) const {
    const std::optional<double> value = numberOf(text(name));
    if (!value)
      throw Error(ErrorCode::UnreadableFile,
                  base::message("'{attribute}' is no number"_text, name));
    return *value;
  }
  long long integer(std::string_view name) const {
    const std::optional<long long> value = integerOf(text(name));
    if (!value)
      throw Error(ErrorCode::UnreadableFile,
                  base::message("'{attribute}' is no whole number"_text, name));
    return *value;
  }
  // Twelve numbers, a column of the transform after the other; missing: the identity.
  Eigen::Affine3d transform() const {
    Eigen::Affine3d t = Eigen::Affine3d::Identity();
    const std::string_view all = text("transform");
    if (all.empty())
      return t;
    std::vector<std::string_view> words;
    LineScanner(all).nextLine(words);
    if (words.size() != 12)
      throw Error(ErrorCode::UnreadableFile, "a transform has not twelve numbers"_text);
    for (Eigen::Index i = 0; i < 12; ++i) {
      const std::optional<double> value = numberOf(words[static_cast<std::size_t>(i)]);
      if (!value)
        throw Error(ErrorCode::UnreadableFile, "a transform is not of numbers"_text);
      t.matrix()(i % 3, i / 3) = *value;
    }
    return t;
  }

private:
  const XML_Char** pairs_;
};

class ModelParser {
public:
  // `where`: the model, for errors.
  static Model parse(const std::string& text, const std::string& where) {
    ModelParser self;
    const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
        XML_ParserCreate(nullptr), &XML_ParserFree);
    base::require(parser != nullptr, "an XML parser");
    self.parser_ = parser.get();
    XML_SetUserData(parser.get(), &self);
    XML_SetElementHandler(
        parser.get(),
        [](void* user, const XML_Char* name, const XML_Char** attributes) {
          static_cast<ModelParser*>(user)->guarded(name, Attributes(attributes));
        },
        [](void* user, const XML_Char* name) { static_cast<ModelParser*>(user)->end(name); });
    const XML_Status status =
        XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (status != XML_STATUS_OK && self.wrong_.empty())
      self.wrong_ =
          base::message("{why}"_text, std::string(XML_ErrorString(XML_GetErrorCode(parser.get()))));
    if (!self.wrong_.empty())
      throw Error(
          ErrorCode::UnreadableFile, self.wrong_,
          base::lineOf(where, static_cast<long long>(XML_GetCurrentLineNumber(parser.get()))));
    return std::move(self.model_);
  }

private:
  // Exceptions may not cross the parser, which is C.
  void guarded(std::string_view name, const Attributes& attributes) {
    try {
      element(localName(name), attributes);
    } catch (const Error& e) {
      wrong_ = e.message();
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  void element(std::string_view name, const Attributes& attributes) {
    if (name == "model") {
      if (const std::string_view unit = attributes.text("unit"); !unit.empty())
        model_.unit = unit;
    } else if (name == "object") {
      object_ = &model_.objects[std::string(attributes.text("id"))];
    } else if (name == "item") {
      model_.build.push_back(useOf(attributes));
    } else if (!object_) {
      return;
    } else if (name == "vertex") {
      object_->vertices.emplace_back(attributes.number("x"), attributes.number("y"),
                                     attributes.number("z"));
    } else if (name == "triangle") {
      object_->triangles.push_back(
          {attributes.integer("v1"), attributes.integer("v2"), attributes.integer("v3")});
      for (const long long v : object_->triangles.back())
        if (v < 0 || static_cast<std::size_t>(v) >= object_->vertices.size())
          throw Error(ErrorCode::UnreadableFile,
                      base::message("a triangle of vertex {vertex}, which is not there"_text, v));
    } else if (name == "component") {
      object_->components.push_back(useOf(attributes));
    }
  }
  // Extensions have vertices too, elsewhere.
  void end(std::string_view name) {
    if (localName(name) == "object")
      object_ = nullptr;
  }
  static Use useOf(const Attributes& attributes) {
    return {std::string(attributes.text("path")), std::string(attributes.text("objectid")),
            attributes.transform()};
  }

  XML_Parser parser_ = nullptr;
  Model model_;
  Object* object_ = nullptr; // being read
  base::Message wrong_;
};

// Lays out what is built, each object where it is used.
class Unfolding {
public:
  Unfolding(const ZipPackage& package, const std::string& name) : package_(package), name_(name) {}

  const Model& model(const std::string& member) {
    const auto known = models_.find(member);
    if (known != models_.end())
      return known->second;
    return models_
        .emplace(member, ModelParser::parse(package_.member(member), name_ + ", " + member))
        .first->second;
  }
  void add(const Use& use, const std::string& member, const Eigen::Affine3d& build_T_parent,
           int depth, std::vector<Facet>& facets) {
    const std::string where = use.path.empty() ? member : memberOf(use.path);
    const Model& of = model(where);
    const auto object = of.objects.find(use.id);
    if (object == of.objects.end())
      throw Error(ErrorCode::UnreadableFile,
                  base::message("object '{id}' is not there"_text, use.id), name_ + ", " + where);
    const Object& o = object->second;
    if (depth > kDeepest || ++uses_ > kMostUses || o.triangles.size() > kMostFacets - facets.size())
      throw Error(ErrorCode::UnreadableFile,
                  "objects hold one another without end, or more than can be read"_text, name_);
    const Eigen::Affine3d build_T_object = build_T_parent * use.parent_T_object;
    // A mirrored object would be inside out.
    const bool mirrored = build_T_object.linear().determinant() < 0.0;
    for (const auto& t : o.triangles) {
      Facet facet;
      for (std::size_t k = 0; k < 3; ++k)
        facet[mirrored ? 2 - k : k] = build_T_object * o.vertices[static_cast<std::size_t>(t[k])];
      facets.push_back(facet);
    }
    for (const Use& component : o.components)
      add(component, where, build_T_object, depth + 1, facets);
  }

private:
  const ZipPackage& package_;
  const std::string& name_;
  std::map<std::string, Model> models_;
  std::size_t uses_ = 0;
};

} // namespace

FacetSoup read3mf(std::string_view bytes, const std::string& name) {
  const ZipPackage package(bytes, name);
  Unfolding unfolding(package, name);
  const std::string member = mainModel(package, name);
  const Model& model = unfolding.model(member);
  FacetSoup soup;
  soup.format = "3MF";
  const std::optional<double> scale = threemfUnitMm(model.unit);
  if (!scale)
    soup.repairs.push_back(
        base::message("lengths taken as mm: the unit '{unit}' is not known"_text, model.unit));
  else if (*scale != 1.0)
    soup.repairs.push_back(base::message("lengths turned from {unit} into mm"_text, model.unit));
  const Eigen::Affine3d mm_T_build(Eigen::Scaling(scale.value_or(1.0)));
  for (const Use& item : model.build)
    unfolding.add(item, member, mm_T_build, 0, soup.facets);
  return soup;
}

} // namespace voluta::geometry

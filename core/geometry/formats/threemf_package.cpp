#include "geometry/formats/threemf_package.h"

#include "base/error.h"
#include "geometry/formats/xml_scan.h"

#include <map>

namespace voluta::geometry {

std::string memberOf(std::string_view path) {
  return std::string(path.starts_with('/') ? path.substr(1) : path);
}

namespace {
constexpr const char* kRelations = "_rels/.rels";

// Returns the target of the relation of that type, else one that is a model by its name, as some
// programs write wrong types; an empty string if the relations name no model.
std::string relatedModel(const ZipPackage& package, const std::string& where) {
  constexpr std::string_view kType = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
  std::string target, named;
  XmlHandler handler;
  handler.begin = [&](XmlName element, const XmlAttributes& attributes) {
    if (element.word != "Relationship")
      return;
    const std::string_view at = attributes.text("Target");
    if (attributes.text("Type") == kType)
      target = at;
    else if (at.ends_with(".model") && package.has(memberOf(at)))
      named = at;
  };
  scanXml(package.member(kRelations), where, handler);
  return memberOf(target.empty() ? named : target);
}
} // namespace

bool namesModel(const ZipPackage& package, const std::string& name) {
  return package.has(kRelations) && !relatedModel(package, name + ", " + kRelations).empty();
}

std::string mainModel(const ZipPackage& package, const std::string& name) {
  const std::string where = name + ", " + kRelations;
  std::string member = relatedModel(package, where);
  if (member.empty())
    throw base::Error(base::ErrorCode::UnreadableFile, "names no model"_text, where);
  return member;
}

std::set<std::string> toolpathLayers(const ZipPackage& package, const std::string& model,
                                     const std::string& name) {
  const std::size_t slash = model.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : model.substr(0, slash + 1);
  const std::string member = folder + "_rels/" + model.substr(folder.size()) + ".rels";
  std::set<std::string> targets;
  if (!package.has(member))
    return targets;
  XmlHandler handler;
  handler.begin = [&](XmlName element, const XmlAttributes& attributes) {
    if (element.word != "Relationship" || attributes.text("Type") != kToolpathLayerRelation)
      return;
    const std::string target(attributes.text("Target"));
    targets.insert(target.starts_with('/') ? target : "/" + folder + target);
  };
  scanXml(package.member(member), name + ", " + member, handler);
  return targets;
}

std::optional<double> threemfUnitMm(const std::string& unit) {
  static const std::map<std::string, double> kUnits{{"micron", 1e-3},     {"millimeter", 1.0},
                                                    {"centimeter", 10.0}, {"inch", 25.4},
                                                    {"foot", 304.8},      {"meter", 1000.0}};
  const auto found = kUnits.find(unit);
  return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

} // namespace voluta::geometry

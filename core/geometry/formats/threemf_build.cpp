#include "geometry/formats/threemf_build.h"

#include "base/error.h"
#include "geometry/formats/beam_solids.h"
#include "geometry/formats/threemf_model.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/xml_scan.h"
#include "geometry/formats/zip_package.h"

#include <array>
#include <map>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

// Limits of the unfolded size, as components may be used repeatedly.
constexpr std::size_t kMaxFacets = 30'000'000, kMaxUses = 1'000'000;
constexpr int kDeepest = 100;

// Returns the names of objects by id; none if the settings are damaged, as no shape depends on
// them.
std::map<std::string, std::string> slicerNames(const std::string& settings,
                                               const std::string& where) {
  std::map<std::string, std::string> names;
  std::string id;
  int depth = 0;
  XmlHandler handler;
  handler.begin = [&](XmlName element, const XmlAttributes& attributes) {
    if (++depth == 2)
      id = element.word == "object" ? attributes.text("id") : std::string_view();
    else if (depth == 3 && !id.empty() && attributes.text("key") == "name")
      names.emplace(id, attributes.text("value"));
  };
  handler.end = [&](XmlName) { --depth; };
  try {
    scanXml(settings, where, handler);
  } catch (const Error&) {
    names.clear();
  }
  return names;
}

// Places everything that is built, each object at every use.
class Unfolding {
public:
  Unfolding(const ZipPackage& package, const std::string& name) : package_(package), name_(name) {}

  const ThreemfModel& model(const std::string& member) {
    const auto known = models_.find(member);
    if (known != models_.end())
      return known->second;
    ThreemfModel& read =
        models_.emplace(member, parseThreemfModel(package_.member(member), name_ + ", " + member))
            .first->second;
    if (models_.size() == 1) // the main model
      addSlicerNames(read);
    return read;
  }

  void addItem(const ThreemfUse& item, const std::string& member,
               const Eigen::Affine3d& mm_T_build) {
    if (!item.printable) {
      ++unprintable_;
      return;
    }
    itemName_ = model(item.path.empty() ? member : memberOf(item.path)).nameOf(item.id);
    add(item, member, mm_T_build, 0);
    ++items_;
  }

  std::vector<ThreemfPiece> takePieces() { return std::move(pieces_); }

  // Returns a sentence for each kind of skipped or changed items.
  std::vector<base::Message> notes() const {
    std::vector<base::Message> notes;
    const auto note = [&](std::size_t count, base::Text what) {
      if (count > 0)
        notes.emplace_back(what, std::vector<base::Value>{count});
    };
    note(unprintable_, "skipped: {count} item marked as not printable|"
                       "skipped: {count} items marked as not printable"_plural);
    const auto skipped = [&](ThreemfObjectType type) {
      return skipped_[static_cast<std::size_t>(type)];
    };
    note(skipped(ThreemfObjectType::SolidSupport) + skipped(ThreemfObjectType::Support),
         "skipped: {count} support object|skipped: {count} support objects"_plural);
    note(skipped(ThreemfObjectType::Surface),
         "skipped: {count} object of type 'surface', which is not a solid|"
         "skipped: {count} objects of type 'surface', which are not solids"_plural);
    note(skipped(ThreemfObjectType::Other),
         "skipped: {count} object of type 'other', which is not printed|"
         "skipped: {count} objects of type 'other', which are not printed"_plural);
    note(empty_, "skipped: {count} object without a mesh|"
                 "skipped: {count} objects without a mesh"_plural);
    note(beams_, "converted {count} lattice beam into a round bar|"
                 "converted {count} lattice beams into round bars"_plural);
    return notes;
  }

private:
  // Slicers store the names of objects outside of the model.
  void addSlicerNames(ThreemfModel& model) const {
    for (const char* member : {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"})
      if (package_.has(member))
        for (const auto& [id, name] : slicerNames(package_.member(member), member))
          if (const auto object = model.objects.find(id);
              object != model.objects.end() && object->second.name.empty())
            object->second.name = name;
  }

  void add(const ThreemfUse& use, const std::string& member, const Eigen::Affine3d& build_T_parent,
           int depth) {
    const std::string where = use.path.empty() ? member : memberOf(use.path);
    const ThreemfModel& of = model(where);
    const auto found = of.objects.find(use.id);
    if (found == of.objects.end())
      throw Error(ErrorCode::UnreadableFile, base::message("object '{id}' is missing"_text, use.id),
                  name_ + ", " + where);
    const ThreemfObject& object = found->second;
    if (depth > kDeepest || ++uses_ > kMaxUses)
      throw endless();
    const Eigen::Affine3d build_T_object = build_T_parent * use.parent_T_object;
    // The type of an object with components is that of its components.
    if (!object.components.empty() || object.type == ThreemfObjectType::Model)
      addShape(object, use.id, where, build_T_object);
    else
      ++skipped_[static_cast<std::size_t>(object.type)];
    for (const ThreemfUse& component : object.components)
      add(component, where, build_T_object, depth + 1);
  }

  void addShape(const ThreemfObject& object, const std::string& id, const std::string& where,
                const Eigen::Affine3d& build_T_object) {
    const auto refuse = [&](const base::Message& what) {
      return Error(ErrorCode::UnusableInput, what, name_ + ", " + where,
                   "export it as a triangle mesh"_text);
    };
    const bool isEmpty = object.triangles.empty() && object.beams.empty();
    if (object.hasSlices && (object.lowResolution || (isEmpty && object.components.empty())))
      throw refuse(base::message(
          "object '{id}' is stored as slices (slicestack), which cannot be read"_text, id));
    if (object.hasClippedBeams)
      throw refuse(base::message(
          "object '{id}' has a beam lattice clipped by a mesh, which cannot be read"_text, id));
    ThreemfPiece piece{items_, object.name, itemName_, {}, build_T_object};
    std::vector<Facet>& facets = piece.facets;
    for (const auto& t : object.triangles)
      facets.push_back({object.vertices[static_cast<std::size_t>(t[0])],
                        object.vertices[static_cast<std::size_t>(t[1])],
                        object.vertices[static_cast<std::size_t>(t[2])]});
    if (!object.beams.empty() || !object.balls.empty()) {
      const std::vector<Facet> solids = beamSolids(object);
      facets.insert(facets.end(), solids.begin(), solids.end());
      beams_ += object.beams.size();
    }
    if (facets.size() > kMaxFacets - facets_)
      throw endless();
    facets_ += facets.size();
    if (!facets.empty())
      pieces_.push_back(std::move(piece));
    else if (object.components.empty())
      ++empty_;
  }

  Error endless() const {
    return Error(ErrorCode::UnreadableFile,
                 "objects contain each other, or there are too many to read"_text, name_);
  }

  const ZipPackage& package_;
  const std::string& name_;
  std::vector<ThreemfPiece> pieces_;
  std::map<std::string, ThreemfModel> models_;
  std::string itemName_; // of the item being unfolded
  std::size_t facets_ = 0, items_ = 0;
  std::size_t uses_ = 0, unprintable_ = 0, beams_ = 0, empty_ = 0;
  std::array<std::size_t, 5> skipped_{}; // by type
};

void refuseSliced(const ZipPackage& package, const std::string& name) {
  if (const std::optional<std::string> gcode = package.firstEndingIn(".gcode"))
    throw Error(ErrorCode::UnusableInput,
                base::message("contains sliced G-code ('{member}') and no model"_text, *gcode),
                name, "open the model that it was sliced from"_text);
}

} // namespace

void appendPlaced(const ThreemfPiece& piece, const Eigen::Affine3d& mm_T_object,
                  std::vector<Facet>& facets) {
  const bool isMirrored = mm_T_object.linear().determinant() < 0.0;
  facets.reserve(facets.size() + piece.facets.size());
  for (const Facet& f : piece.facets) {
    Facet placed;
    for (std::size_t k = 0; k < 3; ++k)
      placed[isMirrored ? 2 - k : k] = mm_T_object * f[k];
    facets.push_back(placed);
  }
}

ThreemfBuild read3mfBuild(std::string_view bytes, const std::string& name) {
  const ZipPackage package(bytes, name);
  if (!namesModel(package, name))
    refuseSliced(package, name);
  const std::string member = mainModel(package, name);
  Unfolding unfolding(package, name);
  const ThreemfModel& model = unfolding.model(member);
  ThreemfBuild build;
  const std::optional<double> scale = threemfUnitMm(model.unit);
  if (!scale)
    build.notes.push_back(
        base::message("lengths taken as mm: unknown unit '{unit}'"_text, model.unit));
  else if (*scale != 1.0)
    build.notes.push_back(base::message("lengths converted from {unit} to mm"_text, model.unit));
  const Eigen::Affine3d mm_T_build(Eigen::Scaling(scale.value_or(1.0)));
  for (const ThreemfUse& item : model.build)
    unfolding.addItem(item, member, mm_T_build);
  const std::vector<base::Message> notes = unfolding.notes();
  build.pieces = unfolding.takePieces();
  if (build.pieces.empty()) {
    refuseSliced(package, name);
    if (!notes.empty())
      throw Error(ErrorCode::UnusableInput,
                  base::message("contains nothing to print: {what}"_text, notes), name);
  }
  build.notes.insert(build.notes.end(), notes.begin(), notes.end());
  return build;
}

} // namespace voluta::geometry

// 3MF core specification 1.3 with its extensions for paths, beam lattices and slices. Not read by
// assimp 5.2, whose asserts abort the program on damaged files.
#include "base/error.h"
#include "geometry/formats/beam_solids.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/threemf_model.h"
#include "geometry/formats/threemf_package.h"
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

// Places everything that is built, each object at every use.
class Unfolding {
public:
  Unfolding(const ZipPackage& package, const std::string& name, std::vector<Facet>& facets)
      : package_(package), name_(name), facets_(facets) {}

  const ThreemfModel& model(const std::string& member) {
    const auto known = models_.find(member);
    if (known != models_.end())
      return known->second;
    return models_
        .emplace(member, parseThreemfModel(package_.member(member), name_ + ", " + member))
        .first->second;
  }

  void addItem(const ThreemfUse& item, const std::string& member,
               const Eigen::Affine3d& mm_T_build) {
    if (item.printable)
      add(item, member, mm_T_build, 0);
    else
      ++unprintable_;
  }

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
    note(beams_, "converted {count} lattice beam into a round bar|"
                 "converted {count} lattice beams into round bars"_plural);
    return notes;
  }

private:
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
    std::vector<Facet> facets;
    for (const auto& t : object.triangles)
      facets.push_back({object.vertices[static_cast<std::size_t>(t[0])],
                        object.vertices[static_cast<std::size_t>(t[1])],
                        object.vertices[static_cast<std::size_t>(t[2])]});
    if (!object.beams.empty() || !object.balls.empty()) {
      const std::vector<Facet> solids = beamSolids(object);
      facets.insert(facets.end(), solids.begin(), solids.end());
      beams_ += object.beams.size();
    }
    if (facets.size() > kMaxFacets - facets_.size())
      throw endless();
    // A mirrored object would be inside out.
    const bool mirrored = build_T_object.linear().determinant() < 0.0;
    for (const Facet& f : facets) {
      Facet placed;
      for (std::size_t k = 0; k < 3; ++k)
        placed[mirrored ? 2 - k : k] = build_T_object * f[k];
      facets_.push_back(placed);
    }
  }

  Error endless() const {
    return Error(ErrorCode::UnreadableFile,
                 "objects contain each other, or there are too many to read"_text, name_);
  }

  const ZipPackage& package_;
  const std::string& name_;
  std::vector<Facet>& facets_;
  std::map<std::string, ThreemfModel> models_;
  std::size_t uses_ = 0, unprintable_ = 0, beams_ = 0;
  std::array<std::size_t, 5> skipped_{}; // by type
};

void refuseSliced(const ZipPackage& package, const std::string& name) {
  if (const std::optional<std::string> gcode = package.firstEndingIn(".gcode"))
    throw Error(ErrorCode::UnusableInput,
                base::message("contains sliced G-code ('{member}') and no model"_text, *gcode),
                name, "open the model that it was sliced from"_text);
}

} // namespace

FacetSoup read3mf(std::string_view bytes, const std::string& name) {
  const ZipPackage package(bytes, name);
  if (!namesModel(package, name))
    refuseSliced(package, name);
  const std::string member = mainModel(package, name);
  FacetSoup soup;
  soup.format = "3MF";
  Unfolding unfolding(package, name, soup.facets);
  const ThreemfModel& model = unfolding.model(member);
  const std::optional<double> scale = threemfUnitMm(model.unit);
  if (!scale)
    soup.repairs.push_back(
        base::message("lengths taken as mm: unknown unit '{unit}'"_text, model.unit));
  else if (*scale != 1.0)
    soup.repairs.push_back(base::message("lengths converted from {unit} to mm"_text, model.unit));
  const Eigen::Affine3d mm_T_build(Eigen::Scaling(scale.value_or(1.0)));
  for (const ThreemfUse& item : model.build)
    unfolding.addItem(item, member, mm_T_build);
  const std::vector<base::Message> notes = unfolding.notes();
  if (soup.facets.empty()) {
    refuseSliced(package, name);
    if (!notes.empty())
      throw Error(ErrorCode::UnusableInput,
                  base::message("contains nothing to print: {what}"_text, notes), name);
  }
  soup.repairs.insert(soup.repairs.end(), notes.begin(), notes.end());
  return soup;
}

} // namespace voluta::geometry

#include "geometry/formats/threemf_build.h"

#include "base/error.h"
#include "geometry/formats/beam_solids.h"
#include "geometry/formats/threemf_cut.h"
#include "geometry/formats/threemf_model.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/zip_package.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

// Limits of the unfolded size, as components may be used repeatedly.
constexpr std::size_t kMaxFacets = 30'000'000, kMaxUses = 1'000'000;
constexpr int kDeepest = 100;

using Kind = ThreemfVolumeKind;

// Returns whether volumes of the kind are places with settings.
bool isPlace(Kind kind) {
  return kind == Kind::Modifier || kind == Kind::SupportEnforcer || kind == Kind::SupportBlocker;
}

base::Text wordOf(Kind kind) {
  switch (kind) {
  case Kind::Part:
    return "volume"_text;
  case Kind::Negative:
    return "negative volume"_text;
  case Kind::Modifier:
    return "modifier volume"_text;
  case Kind::SupportEnforcer:
    return "support enforcer"_text;
  case Kind::SupportBlocker:
    break;
  }
  return "support blocker"_text;
}

const std::string& firstNamed(const std::string& name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

// Adds a sentence for each setting of an object and its volumes that is not acted on, without
// modifiers. `otherName`: for objects without a name.
void noteSettings(const ThreemfObjectSettings& object, const std::string& otherName,
                  const std::string& member, std::vector<base::Message>& notes) {
  const std::string& name = firstNamed(object.name, otherName);
  const auto noteExtruder = [&](int extruder, int usual, const std::string& of) {
    if (extruder != 0 && extruder != usual)
      notes.push_back(base::message(
          "not used: extruder {number} of '{object}' ({where}): choose the tool of the part"_text,
          extruder, of, member));
  };
  const auto noteKeys = [&](const ThreemfValues& settings, const std::string& of) {
    if (!settings.empty())
      notes.push_back(base::message("not used: settings of '{object}' ({where}): {keys}"_text, of,
                                    member, keysInQuotes(settings)));
  };
  noteExtruder(object.extruder, 1, name);
  noteKeys(object.settings, name);
  for (const ThreemfVolume& volume : object.volumes) {
    if (volume.kind == Kind::Modifier)
      continue;
    const std::string& own = firstNamed(volume.name, volume.objectId);
    const std::string of = own.empty() || own == name ? name : name + " / " + own;
    if (volume.kind == Kind::Part)
      noteExtruder(volume.extruder, object.extruder == 0 ? 1 : object.extruder, of);
    noteKeys(volume.settings, of);
  }
}

// Returns the settings of a volume that is a place. `usual`: extruder of its object, 0: the first.
ThreemfValues modifierSettings(const ThreemfVolume& volume, int usual) {
  if (volume.kind == Kind::SupportEnforcer || volume.kind == Kind::SupportBlocker)
    return {{"volume_type",
             volume.kind == Kind::SupportEnforcer ? "SupportEnforcer" : "SupportBlocker"}};
  ThreemfValues settings = volume.settings;
  if (volume.extruder != 0 && volume.extruder != std::max(usual, 1))
    settings.emplace_back("extruder", std::to_string(volume.extruder));
  return settings;
}

// Places everything that is built, each object at every use.
class Unfolding {
public:
  Unfolding(const ZipPackage& package, const std::string& model, const std::string& name)
      : package_(package), name_(name), settings_(slicerSettings(package, model)),
        heights_(slicerHeights(package)) {}

  const ThreemfModel& model(const std::string& member) {
    const auto known = models_.find(member);
    if (known != models_.end())
      return known->second;
    ThreemfModel& read =
        models_.emplace(member, parseThreemfModel(package_.member(member), name_, member))
            .first->second;
    if (models_.size() == 1) { // the main model
      addSlicerNames(read);
      unit_ = read.unit;
    } else if (read.unit != unit_) {
      said_.push_back(base::message(
          "not used: the unit {unit} of {where}: its lengths are taken in {main}, the unit of the "
          "main model"_text,
          read.unit, member, unit_));
    }
    return read;
  }

  void addItem(const ThreemfUse& given, const std::string& member,
               const Eigen::Affine3d& mm_T_build) {
    const ThreemfUse item = original(given, member);
    const std::size_t number = numberOf(item);
    if (!item.printable) {
      ++unprintable_;
      return;
    }
    if (const auto ranges = heights_.ranges.find(static_cast<long long>(number));
        ranges != heights_.ranges.end())
      ranges_[items_] = ranges->second;
    itemName_ = model(item.path.empty() ? member : memberOf(item.path)).nameOf(item.id);
    itemId_ = item.id;
    const auto settings = settings_.objects.find(item.id);
    itemSettings_ = settings == settings_.objects.end() ? nullptr : &settings->second;
    if (itemSettings_ && noted_.insert(item.id).second)
      noteSettings(*itemSettings_, firstNamed(itemName_, item.id), itemSettings_->member, said_);
    mm_T_item_ = mm_T_build * item.parent_T_object;
    ThreemfUse inItem = item;
    inItem.parent_T_object.setIdentity();
    add(inItem, {member, Eigen::Affine3d::Identity(), Kind::Part, {}, {}, 0});
    ++items_;
  }

  std::vector<ThreemfPiece> takePieces() { return std::move(pieces_); }
  std::vector<ThreemfPiece> takePaints() { return std::move(paints_); }
  std::vector<EventOfFile> takeEvents() { return std::move(heights_.events); }
  std::map<std::size_t, std::vector<ThreemfRange>> takeRanges() { return std::move(ranges_); }
  std::vector<base::Message> modifierNotes() const {
    std::vector<base::Message> notes = modifiers_;
    if (!ranges_.empty())
      notes.push_back(base::message("not used: settings of ranges of height ('{member}')"_text,
                                    heights_.rangesMember));
    constexpr std::size_t kMaxNamed = 20;
    const std::size_t named = std::min(kMaxNamed, heights_.events.size());
    for (std::size_t i = 0; i < named; ++i)
      notes.push_back(unusedEvent(heights_.events[i], heights_.eventsMember));
    if (named < heights_.events.size())
      notes.push_back(base::message("not used: {count} further events at heights ('{member}')"_text,
                                    heights_.events.size() - named, heights_.eventsMember));
    return notes;
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
    note(empty_, "skipped: {count} object without a mesh|"
                 "skipped: {count} objects without a mesh"_plural);
    note(beams_, "converted {count} lattice beam into a round bar|"
                 "converted {count} lattice beams into round bars"_plural);
    notes.insert(notes.end(), said_.begin(), said_.end());
    for (const auto& [member, model] : models_)
      notes.insert(notes.end(), model.notes.begin(), model.notes.end());
    notes.insert(notes.end(), settings_.notes.begin(), settings_.notes.end());
    notes.insert(notes.end(), heights_.notes.begin(), heights_.notes.end());
    for (const auto& [number, ranges] : heights_.ranges)
      if (number < 1 || number > static_cast<long long>(originals_.size()))
        notes.push_back(base::message(
            "not used: settings of ranges of height of object {number}, which does not exist ('{member}')"_text,
            number, heights_.rangesMember));
    return notes;
  }

private:
  // Where an object is used: within which one, and as which kind of volume.
  struct Place {
    std::string member; // of the model with the use
    Eigen::Affine3d item_T_parent;
    Kind kind = Kind::Part;
    std::string volumeName;
    ThreemfValues settings; // of a modifier
    int depth = 0;          // below the build item
  };

  // PrusaSlicer writes a further instance as an object with the first as its only component.
  // Returns the use of the first one, which has the settings.
  ThreemfUse original(ThreemfUse use, const std::string& member) {
    for (int depth = 0; depth < kDeepest && use.path.empty(); ++depth) {
      const auto& objects = model(member).objects;
      const auto found = objects.find(use.id);
      if (found == objects.end() || settings_.objects.contains(use.id))
        break;
      const ThreemfObject& object = found->second;
      if (object.components.size() != 1 || !object.triangles.empty() ||
          !object.components.front().path.empty() ||
          !settings_.objects.contains(object.components.front().id))
        break;
      const ThreemfUse& inner = object.components.front();
      use.parent_T_object = use.parent_T_object * inner.parent_T_object;
      use.id = inner.id;
    }
    return use;
  }

  // Returns the number of the object among those that are built, from 1, as in settings of heights.
  std::size_t numberOf(const ThreemfUse& item) {
    const std::string key = item.path + '\n' + item.id;
    const auto known = std::ranges::find(originals_, key);
    if (known != originals_.end())
      return static_cast<std::size_t>(known - originals_.begin()) + 1;
    originals_.push_back(key);
    return originals_.size();
  }

  // Slicers store the names of objects outside of the model.
  void addSlicerNames(ThreemfModel& model) const {
    for (const auto& [id, settings] : settings_.objects)
      if (const auto object = model.objects.find(id);
          object != model.objects.end() && object->second.name.empty())
        object->second.name = settings.name;
  }

  void add(const ThreemfUse& use, const Place& place) {
    const std::string where = use.path.empty() ? place.member : memberOf(use.path);
    const ThreemfModel& of = model(where);
    const auto found = of.objects.find(use.id);
    if (found == of.objects.end())
      throw Error(ErrorCode::UnreadableFile, base::message("object '{id}' is missing"_text, use.id),
                  name_ + ", " + where);
    const ThreemfObject& object = found->second;
    if (place.depth > kDeepest || ++uses_ > kMaxUses)
      throw endless();
    Place inside{where,          place.item_T_parent * use.parent_T_object,
                 place.kind,     place.volumeName,
                 place.settings, place.depth + 1};
    takeKind(object, use.id, place.depth, inside);
    // The type of an object with components is that of its components.
    if (!object.components.empty() || object.type == ThreemfObjectType::Model)
      addShape(object, use.id, inside);
    else
      ++skipped_[static_cast<std::size_t>(object.type)];
    for (const ThreemfUse& component : object.components)
      add(component, inside);
  }

  // Sets the kind of the object and all within it, as its own settings or those of the item say.
  void takeKind(const ThreemfObject& object, const std::string& id, int depth, Place& inside) {
    if (!object.settings.empty()) {
      const ThreemfObjectSettings own = curaSettings(object.settings);
      if (!own.volumes.empty())
        inside.kind = own.volumes.front().kind;
      if (isPlace(inside.kind)) {
        ThreemfVolume whole = own.volumes.empty() ? ThreemfVolume() : own.volumes.front();
        whole.kind = inside.kind;
        whole.extruder = own.extruder;
        whole.settings = own.settings;
        inside.settings = modifierSettings(whole, 0);
      } else if (noted_.insert(inside.member + '\n' + id).second)
        noteSettings(own, firstNamed(object.name, id), inside.member, said_);
    }
    if (!itemSettings_ || depth > 1 || (depth == 0 && !object.components.empty()))
      return;
    for (const ThreemfVolume& volume : itemSettings_->volumes)
      if (!volume.objectId.empty() && volume.objectId == id) {
        inside.kind = volume.kind;
        inside.volumeName = volume.name;
        inside.settings = modifierSettings(volume, itemSettings_->extruder);
      }
  }

  void addShape(const ThreemfObject& object, const std::string& id, const Place& place) {
    const auto refuse = [&](const base::Message& what) {
      return Error(ErrorCode::UnusableInput, what, name_ + ", " + place.member,
                   "export it as a triangle mesh"_text);
    };
    const bool isEmpty = object.triangles.empty() && object.beams.empty();
    if (object.hasSlices && (object.lowResolution || (isEmpty && object.components.empty())))
      throw refuse(base::message(
          "object '{id}' is stored as slices (slicestack), which cannot be read"_text, id));
    if (object.hasSlices && noted_.insert(place.member + "\nslices\n" + id).second)
      said_.push_back(base::message(
          "not used: the slice stack of object '{id}' ({where}): its mesh is printed"_text, id,
          place.member));
    if (object.hasClippedBeams)
      throw refuse(base::message(
          "object '{id}' has a beam lattice clipped by a mesh, which cannot be read"_text, id));
    if (isEmpty && object.balls.empty()) {
      empty_ += object.components.empty() ? 1 : 0;
      return;
    }
    ThreemfPiece piece{items_,
                       firstNamed(place.volumeName, object.name),
                       itemName_,
                       {},
                       {},
                       place.kind,
                       mm_T_item_ * place.item_T_parent,
                       place.item_T_parent,
                       place.settings};
    addTriangles(object, place, piece);
    addPaints(object, place, piece, id);
    if (!object.beams.empty() || !object.balls.empty()) {
      const std::vector<Facet> solids = beamSolids(object);
      piece.facets.insert(piece.facets.end(), solids.begin(), solids.end());
      piece.volumeEnds.push_back(piece.facets.size());
      beams_ += object.beams.size();
    }
    keep(std::move(piece), id);
  }

  // Adds the painted surfaces of the object's parts, one for each kind of paint and its state.
  // `piece`: without facets of its own.
  void addPaints(const ThreemfObject& object, const Place& place, const ThreemfPiece& like,
                 const std::string& id) {
    if (object.paints.empty())
      return;
    const bool isFirst = noted_.insert(place.member + "\npaint\n" + id).second;
    const std::string& name = firstNamed(like.name, firstNamed(itemName_, id));
    const std::vector<Kind> kinds = kindsOf(object, place);
    for (const auto& [attribute, paint] : object.paints) {
      const std::string setting(paintSetting(attribute));
      std::map<int, std::vector<Facet>> byState;
      std::size_t damaged = 0;
      for (const auto& [triangle, code] : paint.codes) {
        if (kinds[triangle] != Kind::Part)
          continue;
        const auto pieces = paintedFacets(code, facetOf(object, triangle));
        const bool isSound = pieces && std::ranges::all_of(*pieces, [&](const PaintedFacet& p) {
                               return setting == "paint_color" || p.state <= 2;
                             });
        damaged += isSound ? 0 : 1;
        if (isSound)
          for (const PaintedFacet& p : *pieces)
            byState[p.state].push_back(p.facet);
      }
      if (isFirst)
        notePaint(attribute, paint, name, place.member, damaged);
      for (auto& [state, facets] : byState)
        addPaint(like, name, setting, state, std::move(facets));
    }
  }

  void addPaint(const ThreemfPiece& like, const std::string& name, const std::string& setting,
                int state, std::vector<Facet> facets) {
    if (setting == "paint_color" &&
        state == std::max(1, itemSettings_ ? itemSettings_->extruder : 0))
      return; // that of the part
    if (facets.size() > kMaxFacets - facets_)
      throw endless();
    facets_ += facets.size();
    ThreemfPiece paint{like.item,
                       name,
                       like.itemName,
                       {},
                       {},
                       Kind::Modifier,
                       like.mm_T_object,
                       like.item_T_object,
                       {{setting, std::to_string(state)}},
                       true};
    paint.volumeEnds = {facets.size()};
    paint.facets = std::move(facets);
    paints_.push_back(std::move(paint));
  }

  // For all readers the paint that cannot be used, for those of a mesh alone all of it.
  void notePaint(const std::string& attribute, const ThreemfPaint& paint, const std::string& name,
                 const std::string& member, std::size_t damaged) {
    (paintSetting(attribute).empty() ? said_ : modifiers_)
        .emplace_back(
            "not used: {paint} on {count} triangle of '{object}' ({attribute}, line {line} of "
            "{where})|"
            "not used: {paint} on {count} triangles of '{object}' ({attribute}, from line {line} of {where})"_plural,
            std::vector<base::Value>{paintWord(attribute), paint.triangles, name, attribute,
                                     paint.line, member});
    if (damaged > 0)
      said_.emplace_back(
          "not used, as it is damaged: {paint} on {count} triangle of '{object}' ({attribute}, "
          "{where})|"
          "not used, as it is damaged: {paint} on {count} triangles of '{object}' ({attribute}, {where})"_plural,
          std::vector<base::Value>{paintWord(attribute), damaged, name, attribute, member});
  }

  static Facet facetOf(const ThreemfObject& object, std::size_t triangle) {
    const auto& t = object.triangles[triangle];
    return {object.vertices[static_cast<std::size_t>(t[0])],
            object.vertices[static_cast<std::size_t>(t[1])],
            object.vertices[static_cast<std::size_t>(t[2])]};
  }

  // Returns per triangle the volume that it belongs to, of volumesOf(), 0: of none.
  std::vector<std::size_t> volumeOfTriangles(const ThreemfObject& object,
                                             const Place& place) const {
    std::vector<std::size_t> volumeOf(object.triangles.size(), 0);
    if (!itemSettings_ || place.depth != 1)
      return volumeOf;
    const auto count = static_cast<long long>(object.triangles.size());
    std::size_t number = 0;
    for (const ThreemfVolume& volume : itemSettings_->volumes) {
      ++number;
      const long long end = std::min(count - 1, volume.lastTriangle);
      for (long long t = std::max(0ll, volume.firstTriangle); t <= end; ++t)
        volumeOf[static_cast<std::size_t>(t)] = number;
    }
    return volumeOf;
  }

  // Returns the kind of each triangle.
  std::vector<Kind> kindsOf(const ThreemfObject& object, const Place& place) const {
    std::vector<Kind> kinds;
    for (const std::size_t volume : volumeOfTriangles(object, place))
      kinds.push_back(volume == 0 || place.kind != Kind::Part
                          ? place.kind
                          : itemSettings_->volumes[volume - 1].kind);
    return kinds;
  }

  // Adds the triangles to the piece by volumes; those of volumes that are not solid become pieces.
  void addTriangles(const ThreemfObject& object, const Place& place, ThreemfPiece& piece) {
    std::vector<const ThreemfVolume*> volumes{nullptr}; // The first: triangles of no volume
    if (itemSettings_ && place.depth == 1)
      for (const ThreemfVolume& volume : itemSettings_->volumes)
        volumes.push_back(&volume);
    const std::vector<std::size_t> volumeOf = volumeOfTriangles(object, place);
    std::vector<std::vector<Facet>> facets(volumes.size());
    for (std::size_t i = 0; i < object.triangles.size(); ++i)
      facets[volumeOf[i]].push_back(facetOf(object, i));
    for (std::size_t v = 0; v < volumes.size(); ++v) {
      if (facets[v].empty())
        continue;
      if (!volumes[v] || volumes[v]->kind == Kind::Part) {
        piece.facets.insert(piece.facets.end(), facets[v].begin(), facets[v].end());
        piece.volumeEnds.push_back(piece.facets.size());
        continue;
      }
      ThreemfPiece other = piece;
      other.name = firstNamed(volumes[v]->name, piece.name);
      other.kind = volumes[v]->kind;
      if (isPlace(other.kind))
        other.settings = modifierSettings(*volumes[v], itemSettings_->extruder);
      other.volumeEnds = {facets[v].size()};
      other.facets = std::move(facets[v]);
      keep(std::move(other), std::to_string(v));
    }
  }

  // `id`: of the volume within the item.
  void keep(ThreemfPiece piece, const std::string& id) {
    if (piece.facets.size() > kMaxFacets - facets_)
      throw endless();
    facets_ += piece.facets.size();
    if (piece.facets.empty())
      return;
    if (piece.kind != Kind::Part && noted_.insert(itemId_ + '\n' + piece.name + '\n' + id).second)
      noteVolume(piece, firstNamed(piece.name, id));
    pieces_.push_back(std::move(piece));
  }

  void noteVolume(const ThreemfPiece& piece, const std::string& name) {
    Eigen::AlignedBox3d box;
    for (const Facet& facet : piece.facets)
      for (const Eigen::Vector3d& v : facet)
        box.extend(piece.mm_T_object * v);
    const Eigen::Vector3d middle = box.center();
    const base::Point at{middle.x(), middle.y(), middle.z()};
    const std::string& object = firstNamed(itemName_, itemId_);
    if (piece.kind == Kind::Negative)
      said_.push_back(base::message(
          "cut away: {kind} '{name}' of '{object}', its middle at {place} in the file"_text,
          wordOf(piece.kind), name, object, at));
    else
      modifiers_.push_back(base::message(
          "not used: {kind} '{name}' of '{object}', its middle at {place} in the file"_text,
          wordOf(piece.kind), name, object, at));
  }

  Error endless() const {
    return Error(ErrorCode::UnreadableFile,
                 "objects contain each other, or there are too many to read"_text, name_);
  }

  const ZipPackage& package_;
  const std::string& name_;
  ThreemfSettings settings_;
  ThreemfHeights heights_;
  std::vector<ThreemfPiece> pieces_, paints_;
  std::map<std::size_t, std::vector<ThreemfRange>> ranges_; // by item
  std::vector<std::string> originals_;                      // objects that are built
  std::map<std::string, ThreemfModel> models_;
  std::string unit_; // of the main model
  // Of the item being unfolded; itemSettings_ may be null
  std::string itemId_, itemName_;
  const ThreemfObjectSettings* itemSettings_ = nullptr;
  Eigen::Affine3d mm_T_item_ = Eigen::Affine3d::Identity();
  std::vector<base::Message> said_; // about objects and volumes
  std::vector<base::Message> modifiers_;
  std::set<std::string> noted_; // those of them that have their sentence
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
  Unfolding unfolding(package, member, name);
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
  build.modifierNotes = unfolding.modifierNotes();
  build.events = unfolding.takeEvents();
  build.ranges = unfolding.takeRanges();
  for (ThreemfPiece& piece : build.pieces)
    if (isPlace(piece.kind))
      build.modifiers.push_back(std::move(piece));
  std::ranges::move(unfolding.takePaints(), std::back_inserter(build.modifiers));
  cutNegatives(build.pieces, name);
  if (build.pieces.empty()) {
    refuseSliced(package, name);
    std::vector<base::Message> all = notes;
    all.insert(all.end(), build.modifierNotes.begin(), build.modifierNotes.end());
    if (!all.empty())
      throw Error(ErrorCode::UnusableInput,
                  base::message("contains nothing to print: {what}"_text, all), name);
  }
  build.notes.insert(build.notes.end(), notes.begin(), notes.end());
  return build;
}

} // namespace voluta::geometry

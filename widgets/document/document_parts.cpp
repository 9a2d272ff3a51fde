// The parts of a document: opened, added, copied and removed.
#include "document/document_parts.h"
#include "document/document.h"
#include "document/free_place.h"
#include "document/item_choices.h"
#include "document/mode_switch.h"
#include "geometry/measures.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "modes/platform_body.h"
#include "pipeline/automatic.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "regions/moved_regions.h"
#include "robot/cell.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace voluta::document {

using project::Stage;

namespace {
constexpr double kSameHeightMm = 1e-6;

Eigen::AlignedBox2d onPlate(const Eigen::AlignedBox3d& box) {
  return {box.min().head<2>(), box.max().head<2>()};
}
// Returns the distance [mm] at which the head clears the added part and the others, whichever of
// two is printed first. The outlines are not used.
double gapFor(const pipeline::Footprint& added, const std::vector<pipeline::Footprint>& others,
              const project::Choices& choices) {
  constexpr double kMinMm = 10.0, kSpareMm = 4.0;
  double gap = kMinMm;
  try {
    const process::HeadShape head = pipeline::resolve(choices).tooling.first().process.head;
    for (const pipeline::Footprint& other : others)
      gap = std::max(gap, kSpareMm + std::min(pipeline::headNeedsMm(head, added, other),
                                              pipeline::headNeedsMm(head, other, added)));
  } catch (const base::Error&) { // The plan reports the process's error
  }
  return gap;
}
// Returns the plates on which the last item may stand, the smallest first; empty: the plan makes
// one that fits, or there is none.
std::vector<std::vector<Eigen::Vector2d>> platesFor(const project::Choices& choices) {
  std::vector<std::vector<Eigen::Vector2d>> plates;
  try {
    const project::Choices own =
        pipeline::strategyOrFirst(project::onlyItem(choices, choices.items.size() - 1));
    const project::Platform& platform = own.item().platform;
    if (platform.isOfCell()) {
      const robot::Cell cell = pipeline::fittingCell(own, pipeline::resolve(own).process());
      for (const auto& plate : cell.plates())
        plates.push_back(project::Platform(plate).plateAround({}));
    } else if (platform.isFor(project::PlatformUse::Plate) && !platform.marginMm()) {
      plates.push_back(platform.plateAround({}));
    }
  } catch (const base::Error&) {
    // The plan reports the error of the cell or the process.
  }
  return plates;
}
// Returns the factor from the part's file to mm on the plate; that of scale "fit" is not known yet.
double ownScale(const project::LoadedPart& part, const project::Choices& own) {
  const double scale = project::parsedScale(own.item().scale);
  return pipeline::unitMm(part, own) * (scale > 0.0 ? scale : 1.0);
}
// Gives the last items of `choices` the places of their file, if there are several.
void takePlaces(project::Choices& choices, const std::vector<project::PartInFile>& parts) {
  if (parts.size() < 2)
    return;
  const std::size_t first = choices.items.size() - parts.size();
  const project::Choices own = project::onlyItem(choices, first);
  const std::vector<geometry::Placement> places = project::placesInFile(
      parts, ownScale(*parts.front().part, own), own.item().placement.rotation);
  for (std::size_t i = 0; i < places.size(); ++i)
    choices.item(first + i).placement = places[i];
}
// Gives the last items of `choices` the regions and events of their file.
void takeRegions(project::Choices& choices, const std::vector<project::PartInFile>& parts) {
  const std::size_t first = choices.items.size() - parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i)
    project::takeFromFile(choices.item(first + i), *parts[i].part);
}
QString shownName(const std::vector<project::PartInFile>& parts, const QString& path) {
  return parts.size() == 1 ? QString::fromStdString(parts.front().part->name)
                           : QFileInfo(path).fileName();
}
} // namespace

std::shared_ptr<Document::Source> Document::activeSourceOf(const std::shared_ptr<Parts>& parts,
                                                           std::size_t active) {
  return parts ? parts->items.at(active) : nullptr;
}

bool Document::haveSameContent(const std::shared_ptr<Parts>& a, const std::shared_ptr<Parts>& b) {
  return a && b && std::ranges::equal(a->items, b->items, [](const auto& one, const auto& other) {
           return one->part->hash == other->part->hash;
         });
}

std::shared_ptr<const project::LoadedPart> Document::source() const {
  return parts_ ? activeSource()->part : nullptr;
}

QString Document::sourcePath() const {
  return parts_ ? activeSource()->path : QString();
}

bool Document::sourceReady() const {
  return parts_ &&
         std::ranges::all_of(parts_->items, [](const auto& source) { return source->ready; });
}

std::size_t Document::partCount() const {
  return parts_ ? parts_->items.size() : 0;
}

std::vector<std::shared_ptr<const project::LoadedPart>> Document::sources() const {
  std::vector<std::shared_ptr<const project::LoadedPart>> all;
  if (parts_)
    for (const auto& source : parts_->items)
      all.push_back(source->part);
  return all;
}

std::shared_ptr<Document::Source>
Document::newSource(std::shared_ptr<const project::LoadedPart> part, const QString& path,
                    bool ready) {
  std::erase_if(sources_, [](const std::weak_ptr<Source>& s) { return s.expired(); });
  const auto opened = std::make_shared<Source>(Source{std::move(part), path, ready});
  sources_.push_back(opened);
  return opened;
}

std::vector<std::shared_ptr<Document::Source>>
Document::newSources(const std::vector<project::PartInFile>& parts, const QString& path,
                     bool ready) {
  std::vector<std::shared_ptr<Source>> sources;
  for (const project::PartInFile& part : parts)
    sources.push_back(newSource(part.part, path, ready));
  return sources;
}

void Document::openPart(std::shared_ptr<const project::LoadedPart> part, const QString& path,
                        bool ready) {
  base::require(part != nullptr, "Document: a part to open");
  openParts({{std::move(part)}}, path, ready);
}

void Document::openParts(const std::vector<project::PartInFile>& parts, const QString& path,
                         bool ready) {
  base::require(!parts.empty(), "Document: parts to open");
  project::Choices choices = choicesOfNextPart(path);
  choices.items.resize(parts.size(), choices.item());
  takePlaces(choices, parts);
  // The same file opened again keeps its settings.
  if (!parts_ || path.isEmpty() || path != sourcePath() || parts.size() > 1)
    takeRegions(choices, parts);
  const auto opened = std::make_shared<Parts>();
  opened->items = newSources(parts, path, ready);
  if (!projectFile_.isEmpty()) {
    replaceAll({choices, opened, 0}, {}, true);
    emit stateChanged();
    emitDirtyAndName();
    emit edited();
    return;
  }
  push({choices, opened, 0}, tr("Open %1").arg(shownName(parts, path)));
}

Eigen::AlignedBox3d Document::placedBox(std::size_t item) const {
  const project::LoadedPart& loaded = *parts_->items[item]->part;
  // A part in the work frame of its file keeps that place only as long as it is alone.
  if (const auto placed = result(Stage::Load);
      placed && upToDate(Stage::Load) && !(loaded.inWorkFrame && parts_->items.size() == 1))
    if (const auto& part = placed->job.item(item).part)
      return geometry::bounds(*part);
  const project::Choices own = project::onlyItem(choices_, item);
  return geometry::bounds(
      geometry::place(*loaded.mesh, ownScale(loaded, own), own.item().placement));
}

// Where the part is printed, as far as it is known.
regions::PieceOfPart Document::pieceOf(std::size_t item) const {
  const project::LoadedPart& loaded = *parts_->items[item]->part;
  const project::Choices own = project::onlyItem(choices_, item);
  double scale = ownScale(loaded, own);
  geometry::Placement placement = own.item().placement;
  if (const auto placed = result(Stage::Load); placed && upToDate(Stage::Load))
    if (const project::JobItem& job = placed->job.item(item); job.part && job.placement) {
      scale = job.scale * pipeline::unitMm(loaded, own);
      placement = *job.placement;
    }
  regions::PieceOfPart piece;
  piece.work_T_file = modes::motionOf(*loaded.mesh, scale, placement);
  piece.scale = scale;
  piece.partBox = placedBox(item);
  return piece;
}

Document::State Document::withSources(project::Choices choices,
                                      const std::vector<std::shared_ptr<Source>>& sources) const {
  std::vector<Eigen::AlignedBox2d> others;
  std::vector<pipeline::Footprint> heights;
  for (std::size_t i = 0; i < parts_->items.size(); ++i) {
    const Eigen::AlignedBox3d box = placedBox(i);
    others.push_back(onPlate(box));
    heights.push_back({{}, box.max().z(), pipeline::mayLean(choices.item(i))});
  }
  const std::size_t first = choices.items.size() - sources.size();
  Eigen::AlignedBox3d whole;
  pipeline::Footprint added;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const project::Choices own = project::onlyItem(choices, first + i);
    whole.extend(geometry::bounds(geometry::place(
        *sources[i]->part->mesh, ownScale(*sources[i]->part, own), own.item().placement)));
    added.leans = added.leans || pipeline::mayLean(own.item());
  }
  added.heightMm = whole.max().z();
  const Eigen::Vector2d centre = nextFreePlace(others, whole.sizes().head<2>(),
                                               gapFor(added, heights, choices), platesFor(choices));
  if (sources.size() == 1)
    choices.items.back().placement.centreMm = centre;
  else
    for (std::size_t i = first; i < choices.items.size(); ++i)
      choices.item(i).placement.centreMm += centre - whole.center().head<2>();
  const auto parts = std::make_shared<Parts>();
  parts->items = parts_->items;
  parts->items.insert(parts->items.end(), sources.begin(), sources.end());
  return {std::move(choices), parts, parts->items.size() - 1};
}

void Document::addPart(std::shared_ptr<const project::LoadedPart> part, const QString& path,
                       bool ready) {
  base::require(part != nullptr, "Document: a part to add");
  addParts({{std::move(part)}}, path, ready);
}

void Document::addParts(const std::vector<project::PartInFile>& parts, const QString& path,
                        bool ready) {
  base::require(!parts.empty(), "Document: parts to add");
  if (!parts_) {
    openParts(parts, path, ready);
    return;
  }
  project::Choices choices = choices_;
  for (std::size_t i = 0; i < parts.size(); ++i)
    choices = withNewItem(choices, active_, start_.item());
  takePlaces(choices, parts);
  takeRegions(choices, parts);
  push(withSources(std::move(choices), newSources(parts, path, ready)),
       tr("Add %1").arg(shownName(parts, path)));
}

void Document::replacePart(std::size_t item, const std::vector<Successor>& by,
                           const QString& editName) {
  base::require(item < partCount() && !by.empty(), "Document: a part and its successors");
  std::vector<Eigen::AlignedBox2d> others;
  std::vector<pipeline::Footprint> heights;
  for (std::size_t i = 0; i < parts_->items.size(); ++i)
    if (i != item) {
      const Eigen::AlignedBox3d box = placedBox(i);
      others.push_back(onPlate(box));
      heights.push_back({{}, box.max().z(), pipeline::mayLean(choices_.item(i))});
    }
  project::ItemChoices own = choices_.item(item);
  own.scale = "1";
  own.units = "mm";
  // By places on the mesh that is replaced, or directions of its file
  for (const char* ofPlaces : {"cutPlanes", "layerPlanes", "loadDirection", "pieceRoot"})
    own.parameters.erase(ofPlaces);
  const std::vector<project::Region> regions = std::exchange(own.regions, {});
  regions::PieceOfPart piece = pieceOf(item);
  project::Choices choices = choices_;
  const auto parts = std::make_shared<Parts>();
  parts->items = parts_->items;
  const auto at = static_cast<std::ptrdiff_t>(item);
  choices.items.erase(choices.items.begin() + at);
  parts->items.erase(parts->items.begin() + at);
  for (std::size_t k = 0; k < by.size(); ++k) {
    own.placement = by[k].placement;
    piece.box = geometry::bounds(*by[k].part->mesh);
    piece.keepsHeight = own.placement.rotation.isApprox(Eigen::Quaterniond::Identity()) &&
                        std::abs(own.placement.liftMm - piece.box.min().z()) < kSameHeightMm;
    own.regions =
        by[k].hasRegions ? regions::regionsOfPiece(regions, piece) : std::vector<project::Region>();
    const Eigen::AlignedBox3d box =
        geometry::bounds(geometry::place(*by[k].part->mesh, 1.0, own.placement));
    const pipeline::Footprint added{{}, box.max().z(), pipeline::mayLean(own)};
    const bool isTaken = std::any_of(
        others.end() - static_cast<std::ptrdiff_t>(k), others.end(), [&](const auto& before) {
          return (before.intersection(onPlate(box)).sizes().array() > 1e-6).all();
        });
    if (!by[k].keepsPlace || isTaken) {
      project::Choices last = choices;
      last.items.push_back(own);
      own.placement.centreMm = nextFreePlace(others, box.sizes().head<2>(),
                                             gapFor(added, heights, last), platesFor(last));
    }
    others.push_back(
        onPlate(geometry::bounds(geometry::place(*by[k].part->mesh, 1.0, own.placement))));
    heights.push_back(added);
    const auto to = at + static_cast<std::ptrdiff_t>(k);
    choices.items.insert(choices.items.begin() + to, own);
    parts->items.insert(parts->items.begin() + to, newSource(by[k].part, {}, true));
  }
  push({std::move(choices), parts, item}, editName);
}

void Document::renamePart(const QString& name) {
  base::require(parts_ && sourceReady(), "Document: a part to rename");
  QString own = name.trimmed();
  own.replace('/', '-').replace('\\', '-');
  if (own.isEmpty())
    return;
  const project::LoadedPart& before = *activeSource()->part;
  const QString ending = QFileInfo(QString::fromStdString(before.name)).suffix();
  if (!ending.isEmpty() || own.contains('.'))
    own += '.' + (ending.isEmpty() ? QStringLiteral("stl") : ending);
  if (own == QString::fromStdString(before.name))
    return;
  auto named = std::make_shared<project::LoadedPart>(before);
  named->name = own.toStdString();
  const auto parts = std::make_shared<Parts>();
  parts->items = parts_->items;
  parts->items[active_] = newSource(std::move(named), activeSource()->path, true);
  push({choices_, parts, active_}, tr("Rename %1").arg(QString::fromStdString(before.name)));
}

void Document::duplicatePart() {
  base::require(parts_ != nullptr, "Document: a part to duplicate");
  project::Choices choices = choices_;
  choices.items.push_back(choices.item(active_));
  push(withSources(std::move(choices), {activeSource()}),
       tr("Duplicate %1").arg(QString::fromStdString(activeSource()->part->name)));
}

void Document::copyParts(const std::vector<std::size_t>& items) {
  copied_.clear();
  for (const std::size_t item : items)
    copied_.push_back({choices_.item(item), parts_->items.at(item)});
}

void Document::pasteParts() {
  base::require(!copied_.empty(), "Document: copied parts to paste");
  project::Choices choices = choices_;
  if (!parts_)
    choices.items.clear();
  std::vector<std::shared_ptr<Source>> sources;
  for (const CopiedPart& copy : copied_) {
    choices.items.push_back(copy.choices);
    sources.push_back(copy.source);
    sources_.push_back(copy.source);
  }
  const QString name = copied_.size() > 1
                           ? tr("Paste %1 parts").arg(copied_.size())
                           : tr("Paste %1").arg(QString::fromStdString(sources[0]->part->name));
  if (parts_)
    return push(withSources(std::move(choices), sources), name);
  const auto parts = std::make_shared<Parts>();
  parts->items = sources;
  push({std::move(choices), parts, 0}, name);
}

void Document::removeParts(std::vector<std::size_t> items) {
  base::require(!items.empty() && std::ranges::max(items) < partCount(),
                "Document: parts to remove");
  std::ranges::sort(items, std::greater{});
  const QString name =
      items.size() > 1
          ? tr("Remove %1 parts").arg(items.size())
          : tr("Remove %1").arg(QString::fromStdString(parts_->items[items.front()]->part->name));
  if (items.size() == partCount()) {
    project::Choices choices = choices_;
    choices.items.resize(1);
    push({std::move(choices), nullptr, 0}, name);
    return;
  }
  project::Choices choices = choices_;
  const auto parts = std::make_shared<Parts>();
  parts->items = parts_->items;
  std::size_t active = active_;
  for (const std::size_t item : items) {
    choices.items.erase(choices.items.begin() + static_cast<std::ptrdiff_t>(item));
    parts->items.erase(parts->items.begin() + static_cast<std::ptrdiff_t>(item));
    active -= item < active;
  }
  push({std::move(choices), parts, std::min(active, parts->items.size() - 1)}, name);
}

std::size_t Document::copiesOfActive() const {
  return parts_ ? static_cast<std::size_t>(std::ranges::count(parts_->items, activeSource())) : 0;
}

void Document::setCopies(const pipeline::PlanRequest& made) {
  base::require(parts_ && made.items.size() == made.choices.items.size(), "Document: copies");
  const auto parts = std::make_shared<Parts>();
  const std::shared_ptr<const project::LoadedPart> active = source();
  std::size_t activeItem = 0;
  for (const pipeline::RequestedItem& item : made.items) {
    const auto source =
        std::ranges::find(parts_->items, item.loaded, [](const auto& one) { return one->part; });
    base::require(source != parts_->items.end(), "Document: copies of parts that are open");
    if (item.loaded == active)
      activeItem = parts->items.size();
    parts->items.push_back(*source);
  }
  push({made.choices, parts, activeItem}, tr("%1 of %2")
                                              .arg(std::ranges::count(parts->items, activeSource()))
                                              .arg(QString::fromStdString(active->name)));
}

void Document::arrangeParts() {
  base::require(parts_ != nullptr, "Document: parts to arrange");
  pipeline::PlanRequest request;
  request.items.clear();
  for (const auto& source : parts_->items)
    request.items.push_back({{}, source->part});
  request.choices = choices_;
  push({pipeline::withArrangedParts(std::move(request), {}).choices, parts_, active_},
       tr("Arrange parts"));
}

void Document::setPrintOrder(layers::PrintOrder order) {
  project::Choices choices = activeChoices_;
  choices.printOrder = order;
  setChoices(choices, tr("Change print order"));
}

void Document::setActive(std::size_t item) {
  base::require(item < partCount(), "Document: a part to make active");
  if (item == active_)
    return;
  const auto before = activeSource();
  set({choices_, parts_, item});
  if (activeSource() != before)
    emit sourceChanged();
  emit choicesChanged();
  emit partsChanged();
  emit stateChanged();
}

project::Choices Document::choicesOfNextPart(const QString& path) const {
  const project::Choices usual;
  project::Choices same = activeChoices_;
  same.item().placement = usual.item().placement;
  same.item().scale = usual.item().scale;
  if (!parts_ || (!path.isEmpty() && path == sourcePath()))
    return same;
  project::Choices next =
      choices_.preset == start_.preset ? start_ : withPresetOr(start_, choices_.preset);
  // A cell and a process that were set by the way of building are reset with it.
  const modes::Mode* mode =
      choices().item().automatic ? nullptr : modes::modeNamed(choices().item().mode);
  if (mode && mode->usual.cell == choices_.cell && mode->usual.cell != start_.cell)
    return next;
  next.cell = choices_.cell;
  next.tools = choices_.tools;
  next.formats = choices_.formats;
  try {
    next = next.item().automatic ? pipeline::automaticChoices(next).front() : fitting(next);
    next.formats = writableFormats(next);
    return next;
  } catch (const base::Error&) {
    return next; // the plan reports the cell's error
  }
}

void Document::replaceSource(const std::shared_ptr<const project::LoadedPart>& part,
                             std::shared_ptr<const project::LoadedPart> repaired) {
  for (const std::weak_ptr<Source>& held : sources_) {
    const std::shared_ptr<Source> any = held.lock();
    if (any && any->part == part) {
      any->part = repaired;
      any->ready = true;
    }
  }
  const std::vector<std::shared_ptr<const project::LoadedPart>> open = this->sources();
  if (std::ranges::find(open, repaired) == open.end())
    return;
  refreshKeys();
  emit sourceChanged();
  emit stateChanged();
}

} // namespace voluta::document

#include "window/pages/reach_view.h"

#include "base/units.h"
#include "document/document.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/resolved.h"
#include "window/background.h"
#include "window/pages/part_handles.h"
#include "window/presenters/presenter.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace voluta::window {

using project::Stage;

namespace {

// Parts of similar height share a map.
double mappedHeight(double heightMm) {
  constexpr double kStepMm = 25.0;
  return kStepMm * std::max(1.0, std::ceil(heightMm / kStepMm));
}

constexpr std::size_t kKeptMaps = 8;

} // namespace

struct ReachView::Found {
  std::string key;
  std::shared_ptr<const cells::ReachMap> map; // null: the cell cannot be mapped
  std::shared_ptr<const scene::ReachDrawing> drawing;
};

// The maps found last, of any window: a part or a cell that is chosen again has its map at once.
std::deque<ReachView::Found>& ReachView::kept() {
  static std::deque<Found> maps;
  return maps;
}

ReachView::ReachView(const Workspace& workspace, const PartHandles& handles, QObject* parent)
    : QObject(parent), work_(workspace), handles_(handles), panel_(new panels::ReachPanel) {
  panel_->setObjectName(QStringLiteral("reach"));
  connect(panel_, &panels::ReachPanel::mapToggled, this, [this](bool shown) {
    mapShown_ = shown;
    work_.shell.showView();
  });
  connect(panel_, &panels::ReachPanel::moveRequested, this, &ReachView::move);
  using document::Document;
  connect(&work_.document, &Document::choicesChanged, this, &ReachView::refresh);
  connect(&work_.document, &Document::sourceChanged, this, &ReachView::refresh);
  connect(&work_.document, &Document::resultChanged, this, &ReachView::refresh);
  refresh();
}

void ReachView::refresh() {
  const document::Document& document = work_.document;
  const bool onPlate = document.source() && !document.unusable() &&
                       !modes::findMode(document.choices().item().mode).aroundRod;
  panel_->setVisible(onPlate);
  if (!onPlate) {
    runner_.cancel();
    key_.clear();
    map_.reset();
    standing_.reset();
    panel_->setLooking(false);
    showReach();
    return;
  }
  const auto placed = document.itemResult(Stage::Load);
  if (!placed || !placed->job.item().part || placed->job.item().part->empty() ||
      !document.upToDate(Stage::Load))
    return;
  standing_ = pipeline::standingOf(*placed->job.item().part);
  middle_ = pipeline::middleOf(*placed->job.item().part);
  const double height = mappedHeight(standing_->heightMm);
  std::string key;
  try {
    key = pipeline::cellReachKey(pipeline::resolve(document.choices()), height);
  } catch (const base::Error&) {
    // Planning reports the cell's error.
  }
  if (key == key_ && (map_ || runner_.running()))
    showReach();
  else
    look(key, height);
}

void ReachView::look(const std::string& key, double heightMm) {
  key_ = key;
  map_.reset();
  best_.reset();
  work_.viewport.scene().setReach(nullptr);
  if (key.empty()) {
    runner_.cancel();
    panel_->setLooking(false);
    showReach();
    return;
  }
  const auto before = std::ranges::find(kept(), key, &Found::key);
  if (before != kept().end()) {
    runner_.cancel();
    return take(Found(*before));
  }
  panel_->setLooking(true);
  inBackground(
      runner_,
      [choices = work_.document.choices(), key, heightMm](const base::RunContext& ctx) {
        Found found{key, nullptr, nullptr};
        try {
          found.map = std::make_shared<const cells::ReachMap>(
              pipeline::cellReach(pipeline::resolve(choices), heightMm, ctx));
        } catch (const base::Error&) {
          return found;
        }
        std::vector<scene::ReachPoint> points;
        for (std::size_t n = 0; n < found.map->points().size(); ++n)
          points.push_back(
              {found.map->points()[n], found.map->share(n, heightMm, pipeline::kMappedTiltRad)});
        found.drawing = scene::drawReach(points, found.map->grid().spacingMm, found.map->plate());
        return found;
      },
      [this](Found&& found) {
        if (found.map)
          kept().push_back(found);
        if (kept().size() > kKeptMaps)
          kept().pop_front();
        take(std::move(found));
      });
}

void ReachView::take(Found&& found) {
  map_ = std::move(found.map);
  work_.viewport.scene().setReach(found.drawing);
  panel_->setLooking(false);
  showReach();
  // The view's content depends on whether there is a map.
  work_.shell.showView();
}

std::optional<cells::Place> ReachView::placeNow() const {
  if (!map_ || !standing_ || map_->points().empty())
    return std::nullopt;
  return cells::placeAt(*map_, *standing_, middle_);
}

void ReachView::showReach() {
  const std::optional<cells::Place> now = placeNow();
  best_ = now ? std::optional(cells::bestPlace(*map_, *standing_)) : std::nullopt;
  setBeyond(now && !now->good());
  if (!now) {
    panel_->setReach(std::nullopt);
    return;
  }
  panels::ShownReach shown;
  shown.upright = now->uprightShare;
  shown.tilted = now->share;
  shown.tiltDeg = base::radiansToDegrees(map_->grid().tiltsRad.back());
  shown.onPlate = now->onPlate;
  shown.better = best_->onPlate && cells::isBetter(*best_, *now);
  shown.betterUpright = best_->uprightShare;
  shown.betterTilted = best_->share;
  panel_->setReach(shown);
}

void ReachView::setBeyond(bool beyond) {
  if (beyond == beyond_)
    return;
  beyond_ = beyond;
  work_.shell.showView();
}

void ReachView::draw(scene::ViewState& view) const {
  view.reach = mapShown_ && map_;
  view.partBeyond = beyond_;
}

void ReachView::gizmoDragged(const viewer::GizmoChange& change, bool finished) {
  if (!map_ || !standing_ || finished || work_.viewport.tool() == viewer::Tool::MoveRegion)
    return;
  setBeyond(!cells::placeAt(*map_, *standing_, middle_ + change.moveMm.head<2>()).good());
}

void ReachView::move() {
  if (!best_)
    return;
  geometry::Placement placement = handles_.placed();
  placement.centreMm = best_->at;
  work_.document.place(placement, tr("move to best place"));
}

} // namespace voluta::window

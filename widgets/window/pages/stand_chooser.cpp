#include "window/pages/stand_chooser.h"

#include "document/document.h"
#include "forms/duration_text.h"
#include "geometry/placement.h"
#include "panels/stand_picture.h"
#include "pipeline/part_ways.h"
#include "pipeline/resolved.h"
#include "window/background.h"
#include "window/pages/part_handles.h"
#include "window/presenters/presenter.h"

#include <cmath>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kSame = 0.003; // of unit vectors: a sixth of a degree

// Rounded to minutes, since it is an estimate.
QString roughTime(double seconds) {
  const double minutes = std::max(1.0, std::round(seconds / 60.0));
  return minutes < 60.0 ? StandChooser::tr("%1 min").arg(minutes)
                        : forms::durationText(60.0 * minutes);
}

panels::ShownOrientation shownOrientation(const placement::StandingOrientation& orientation,
                                          const QImage& picture) {
  panels::ShownOrientation shown;
  shown.picture = picture;
  shown.contactMm2 = orientation.score.contactMm2;
  shown.overhangMm2 = orientation.score.riskyMm2;
  shown.heightMm = orientation.score.heightMm;
  shown.missed = orientation.missed;
  shown.voxels = orientation.voxels;
  return shown;
}
} // namespace

struct StandChooser::Found {
  std::vector<placement::StandingOrientation> ways;
  std::vector<QImage> pictures;
  Eigen::Quaterniond rotation; // of the part's file; the orientations are relative to it
};

StandChooser::StandChooser(const Workspace& workspace, const PartHandles& handles, QObject* parent)
    : QObject(parent), work_(workspace), handles_(handles), list_(new panels::WaysList) {
  list_->setObjectName(QStringLiteral("waysToStand"));
  connect(list_, &panels::WaysList::chosen, this,
          [this](int orientation) { lay(static_cast<std::size_t>(orientation)); });
  using document::Document;
  connect(&work_.document, &Document::choicesChanged, this, &StandChooser::refresh);
  connect(&work_.document, &Document::sourceChanged, this, &StandChooser::refresh);
  connect(&work_.document, &Document::resultChanged, this, &StandChooser::refresh);
  // Frame the view again, because the new orientation may not be in view.
  connect(&work_.presenter, &Presenter::partDrawn, this, [this] {
    if (std::exchange(oriented_, false))
      work_.viewport.frameAll();
  });
  refresh();
}

Eigen::Vector3d StandChooser::down() const {
  return handles_.placed().rotation.normalized().conjugate() * -Eigen::Vector3d::UnitZ();
}

std::optional<std::size_t> StandChooser::orientationWithDown(const Eigen::Vector3d& down) const {
  for (std::size_t n = 0; n < downs_.size(); ++n)
    if ((downs_[n] - down).norm() < kSame)
      return n;
  return std::nullopt;
}

void StandChooser::refresh() {
  const document::Document& document = work_.document;
  const bool free =
      document.source() && !document.unusable() && pipeline::standsFreely(document.choices());
  list_->setVisible(free);
  if (!free) {
    key_.clear();
    runner_.cancel();
    list_->setLooking(false);
    return;
  }
  const auto placed = document.itemResult(Stage::Load);
  if (!placed || !placed->item().placed || !placed->item().resolved ||
      !document.upToDate(Stage::Load))
    return;
  const std::string key = pipeline::partWaysKey(*document.source(), placed->job.item().scale,
                                                pipeline::resolve(document.choices()));
  // A custom orientation is shown beside the others; while the part has one of the computed ones,
  // they stay.
  if (key == key_ && (orientationWithDown(down()) || (lookedFrom_ - down()).norm() < kSame)) {
    showTimes();
    showNow();
  } else {
    look(key);
  }
}

void StandChooser::look(const std::string& key) {
  if (key != key_) {
    downs_.clear();
    ways_.clear();
    shown_.clear();
    list_->setWays({});
  }
  key_ = key;
  lookedFrom_ = down();
  list_->setLooking(true);
  const auto plan = work_.document.itemResult(Stage::Load);
  inBackground(
      runner_,
      [plan, choices = work_.document.choices()](const base::RunContext& ctx) {
        const modes::LoadStage& placed = *plan->item().placed;
        Found found{pipeline::partWays(placed, pipeline::resolve(choices), ctx),
                    {},
                    placed.placement.rotation.normalized()};
        std::vector<Eigen::Quaterniond> turns;
        for (const placement::StandingOrientation& orientation : found.ways)
          turns.push_back(orientation.rotation);
        found.pictures =
            panels::standPictures(*placed.part, turns, panels::WaysList::pictureSize());
        return found;
      },
      [this](Found&& found) { take(std::move(found)); });
}

void StandChooser::take(Found found) {
  downs_.clear();
  shown_.clear();
  for (std::size_t n = 0; n < found.ways.size(); ++n) {
    downs_.push_back((found.ways[n].rotation * found.rotation).conjugate() *
                     -Eigen::Vector3d::UnitZ());
    shown_.push_back(shownOrientation(found.ways[n], found.pictures[n]));
  }
  ways_ = std::move(found.ways);
  list_->setLooking(false);
  list_->setWays(shown_);
  showTimes();
  showNow();
}

void StandChooser::showTimes() {
  const auto placed = work_.document.itemResult(Stage::Load);
  if (!placed || !placed->item().resolved || work_.document.unusable())
    return;
  const auto now = base::outcomeOf([&] { return pipeline::resolve(work_.document.choices()); });
  const auto* resolved = std::get_if<pipeline::Resolved>(&now);
  if (!resolved)
    return; // Planning reports it
  bool isChanged = false;
  for (std::size_t n = 0; n < ways_.size(); ++n) {
    const QString time = roughTime(pipeline::estimatedSeconds(ways_[n], *resolved));
    isChanged = isChanged || time != shown_[n].time;
    shown_[n].time = time;
  }
  if (isChanged)
    list_->setWays(shown_);
}

void StandChooser::showNow() {
  list_->setNow(orientationWithDown(down()));
}

void StandChooser::lay(std::size_t orientation) {
  if (orientation >= downs_.size())
    return;
  project::Choices choices = work_.document.choices();
  choices.item().placement = handles_.placed();
  const Eigen::Quaterniond rotation = choices.item().placement.rotation.normalized();
  choices.item().placement.rotation =
      (geometry::rotationLayingFlat(rotation * downs_[orientation]) * rotation).normalized();
  choices.item().placement.liftMm = 0.0;
  choices.item().parameters.erase("orient"); // a search would rotate it further
  oriented_ = true;
  work_.document.setChoices(choices, tr("change orientation"));
}

} // namespace voluta::window

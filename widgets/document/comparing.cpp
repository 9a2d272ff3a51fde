#include "document/comparing.h"

#include "document/document.h"
#include "language/words.h"
#include "pipeline/cell_advice.h"

#include <algorithm>

namespace voluta::document {

namespace {
constexpr std::size_t kKeptResults = 3; // equal to the capacity of the cache of plans
} // namespace

Comparing::Comparing(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&runner_, &jobs::JobRunner::progressed, this, &Comparing::progressed);
  const auto ask = [this] { upToDate_.reset(); };
  connect(&document_, &Document::choicesChanged, this, ask);
  connect(&document_, &Document::sourceChanged, this, ask);
}

Comparing::~Comparing() = default;

// Key of all inputs of the rows except the way of building, since each mode has its own inputs.
std::string Comparing::keyOf(const pipeline::PlanRequest& request) const {
  std::string key, mode, cell;
  for (const Row& row : rows_) {
    if (row.combination.mode == mode && row.combination.cell == cell)
      continue;
    mode = row.combination.mode;
    cell = row.combination.cell;
    pipeline::PlanRequest one = request;
    one.choices = pipeline::choicesOf(row.combination, one.choices);
    one.choices.item().growth = {}; // belongs to the row
    key += pipeline::stageKeys(one).back();
  }
  return key;
}

bool Comparing::upToDate() const {
  if (!upToDate_)
    upToDate_ = sameAsPlanned();
  return *upToDate_;
}

bool Comparing::sameAsPlanned() const {
  if (!document_.source())
    return false;
  const auto key =
      base::outcomeOf([&] { return keyOf(document_.itemRequest(project::Stage::Replay)); });
  const auto* text = std::get_if<std::string>(&key);
  return text && *text == key_;
}

void Comparing::run(const ComparedWays& ways) {
  base::require(document_.source() && document_.sourceReady(), "Comparing: a part that is ready");
  pipeline::CompareOptions options;
  options.plan = document_.itemRequest(ways.until);
  options.modes = ways.modes;
  options.growths = ways.growths;
  options.platforms = ways.platforms;
  options.cells = ways.cells;
  advice_ = {};
  until_ = ways.until;
  rows_.clear();
  current_.reset();
  key_.clear();
  upToDate_.reset();
  rankAgain();
  emit rowsChanged();
  const auto begun = base::outcomeOf([&] {
    for (const pipeline::Combination& built : pipeline::combinations(options))
      rows_.push_back({built, {}, {}, {}});
    key_ = keyOf(options.plan);
    upToDate_.reset();
    return rows_.size();
  });
  if (const auto* error = std::get_if<base::Error>(&begun)) {
    rows_.clear();
    emit failed(language::words(error->whole()));
    emit ended();
    return;
  }
  rankAgain();
  emit rowsChanged();
  runner_.run(
      [this, options, pictures = pictures_](const base::RunContext& ctx, const jobs::Post& post) {
        // `this` is used only in posted functions, which run on the thread of the window.
        pipeline::CompareWatch watch;
        watch.begins = [&](std::size_t row) {
          post([this, row] {
            current_ = row;
            emit rowChanged(static_cast<int>(row));
          });
        };
        watch.ended = [&](std::size_t row, const pipeline::CompareRow& compared,
                          const std::shared_ptr<pipeline::PlanResult>& result) {
          const QImage picture = result && pictures ? pictures(result->job) : QImage();
          post([this, row, compared, picture, result] { take(row, compared, picture, result); });
        };
        const double seconds = pipeline::compare(options, ctx, watch).seconds;
        if (options.cells.size() > 1) {
          const base::Message advice =
              pipeline::compareCells(options.plan, options.cells, ctx.quiet()).reason;
          post([this, advice] { advice_ = advice; });
        }
        return seconds;
      },
      [this](const base::Outcome<double>& outcome) {
        if (current_) {
          const int row = static_cast<int>(*current_);
          current_.reset();
          emit rowChanged(row);
        }
        if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
        emit ended();
      });
  emit started();
}

void Comparing::cancel() {
  runner_.cancel();
}

void Comparing::take(std::size_t row, const pipeline::CompareRow& compared, const QImage& picture,
                     std::shared_ptr<const pipeline::PlanResult> result) {
  rows_[row].compared = compared;
  rows_[row].picture = picture;
  rows_[row].result = std::move(result);
  current_.reset();
  rankAgain();
  emit rowChanged(static_cast<int>(row));
}

void Comparing::setWeights(const pipeline::Weights& weights) {
  if (weights == weights_)
    return;
  weights_ = weights;
  rankAgain();
}

void Comparing::rankAgain() {
  std::vector<pipeline::CompareRow> done;
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].compared) {
      done.push_back(*rows_[i].compared);
      place.push_back(i);
    }
  const pipeline::Ranking found = pipeline::rank(done, weights_);
  ranking_ = {};
  ranking_.score.resize(rows_.size());
  for (std::size_t i = 0; i < done.size(); ++i)
    ranking_.score[place[i]] = found.score[i];
  for (const std::size_t i : found.order)
    ranking_.order.push_back(place[i]);
  for (const std::size_t i : found.tied)
    ranking_.tied.push_back(place[i]);
  if (found.best)
    ranking_.best = place[*found.best];
  for (std::size_t at = kKeptResults; at < ranking_.order.size(); ++at)
    rows_[ranking_.order[at]].result.reset();
  emit rankingChanged();
}

} // namespace voluta::document

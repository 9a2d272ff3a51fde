#include "pipeline/compare_figures.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace voluta::pipeline {

namespace {

using Value = std::optional<double>;
constexpr double kSameScore = 1e-9;

bool came(const CompareRow& row, project::Stage stage) {
  return row.reached && *row.reached >= stage;
}

Value missedVoxels(const CompareRow& row) {
  const project::DecompositionReport& d = row.report.decomposition;
  if (!came(row, project::Stage::Decompose) || d.voxels == 0)
    return std::nullopt;
  return static_cast<double>(d.missedVoxels);
}

Value riskyArea(const CompareRow& row) {
  const project::DecompositionReport& d = row.report.decomposition;
  if (!came(row, project::Stage::Decompose) || d.pieceList.empty())
    return std::nullopt;
  return d.riskyAreaMm2;
}

Value supportVolume(const CompareRow& row) {
  if (!came(row, project::Stage::Decompose))
    return std::nullopt;
  return row.report.decomposition.supportVolumeMm3;
}

Value pieces(const CompareRow& row) {
  if (!came(row, project::Stage::Decompose))
    return std::nullopt;
  return row.report.decomposition.pieces;
}

Value layers(const CompareRow& row) {
  if (!came(row, project::Stage::Layers))
    return std::nullopt;
  return row.report.layers.count;
}

bool moves(const CompareRow& row) {
  return came(row, project::Stage::Motion) && row.report.motion.waypoints > 0;
}

Value printTime(const CompareRow& row) {
  return moves(row) ? Value(row.report.motion.durationS) : std::nullopt;
}

Value reachable(const CompareRow& row) {
  const project::MotionReport& m = row.report.motion;
  if (!moves(row))
    return std::nullopt;
  return 1.0 - static_cast<double>(m.unreachable) / static_cast<double>(m.waypoints);
}

Value collisions(const CompareRow& row) {
  return moves(row) ? Value(static_cast<double>(row.report.motion.collisions)) : std::nullopt;
}

double weightOf(const Figure& figure, const Weights& weights) {
  const auto set = weights.find(figure.key);
  return set == weights.end() ? figure.weight : set->second;
}

// Smaller is better, 0 is best.
Value lossOf(const Figure& figure, const CompareRow& row) {
  const Value value = figure.of(row);
  return value && figure.moreIsBetter ? Value(1.0 - *value) : value;
}

} // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> kFigures{
      {"missedVoxels", "missed voxels"_text, "Missed\nvoxels"_text, "", 4.0, missedVoxels, false,
       false},
      {"riskyAreaMm2", "risky area"_text, "Risky\nmm²"_text, "mm²", 4.0, riskyArea, false, false},
      {"supportVolumeMm3", "supports"_text, "Supports\nmm³"_text, "mm³", 1.0, supportVolume},
      {"pieces", "pieces"_text, "Pieces"_text, "", 0.5, pieces},
      {"layers", "layers"_text, "Layers"_text, "", 0.0, layers},
      {"printTimeS", "print time"_text, "Print\ntime"_text, "s", 1.0, printTime},
      {"reachableFraction", "reachable"_text, "Reach\n%"_text, "%", 2.0, reachable, true},
      {"collisions", "collisions"_text, "Colli-\nsions"_text, "", 2.0, collisions},
  };
  return kFigures;
}

Value uniformMisses(const CompareRow& row) {
  return row.combination.mode == "flat" ? missedVoxels(row) : std::nullopt;
}

std::optional<bool> replayPassed(const CompareRow& row) {
  return came(row, project::Stage::Replay) ? std::optional(row.report.replay.passed) : std::nullopt;
}

Weights defaultWeights() {
  Weights weights;
  for (const Figure& figure : figures())
    weights.emplace(figure.key, figure.weight);
  return weights;
}

void setWeight(Weights& weights, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  std::vector<std::string> known;
  for (const Figure& figure : figures())
    known.emplace_back(figure.key);
  if (std::find(known.begin(), known.end(), key) == known.end())
    throw base::Error(base::ErrorCode::Usage,
                      base::message("no figure is called '{key}'"_text, key), "--weight"_name,
                      base::didYouMean(key, known));
  double value = -1.0;
  if (equals != std::string::npos) {
    const char* end = assignment.data() + assignment.size();
    if (std::from_chars(assignment.data() + equals + 1, end, value).ptr != end)
      value = -1.0;
  }
  if (!std::isfinite(value) || value < 0.0)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}' is no weight"_text, assignment), "--weight"_name,
                      base::message("give {key}=NUMBER, 0 or more"_text, key));
  weights[key] = value;
}

Ranking rank(const std::vector<CompareRow>& rows, const Weights& weights) {
  Ranking ranking;
  ranking.score.resize(rows.size());
  for (const RowState state : {RowState::Clear, RowState::Blocked}) {
    std::vector<std::size_t> peers;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].state() == state) {
        peers.push_back(i);
        ranking.score[i] = 0.0;
      }
    for (const Figure& figure : figures()) {
      double largest = 0.0;
      bool any = false;
      for (const std::size_t i : peers)
        if (const Value loss = lossOf(figure, rows[i])) {
          any = true;
          largest = std::max(largest, *loss);
        }
      for (const std::size_t i : peers) {
        const Value loss = lossOf(figure, rows[i]);
        const double share = loss ? (largest > 0.0 ? *loss / largest : 0.0)
                                  : (any && figure.lossIfAbsent ? 1.0 : 0.0);
        *ranking.score[i] += weightOf(figure, weights) * share;
      }
    }
  }
  ranking.order.resize(rows.size());
  std::iota(ranking.order.begin(), ranking.order.end(), std::size_t{0});
  const auto better = [&](std::size_t a, std::size_t b) {
    if (rows[a].state() != rows[b].state())
      return rows[a].state() < rows[b].state();
    return ranking.score[a].value_or(0.0) < ranking.score[b].value_or(0.0) - kSameScore;
  };
  std::stable_sort(ranking.order.begin(), ranking.order.end(), better);
  if (ranking.order.empty() || rows[ranking.order.front()].state() != RowState::Clear)
    return ranking;
  ranking.best = ranking.order.front();
  for (const std::size_t i : ranking.order)
    if (i != *ranking.best && !better(*ranking.best, i))
      ranking.tied.push_back(i);
  return ranking;
}

std::string ruleText(const Weights& weights) {
  std::string sum;
  for (const Figure& figure : figures())
    if (const double weight = weightOf(figure, weights); weight > 0.0)
      sum += fmt::format("{}{:g} {}", sum.empty() ? "" : ", ", weight, figure.key);
  return fmt::format("nothing that blocks comes first; then the least sum of weight x share of "
                     "the largest figure ({})",
                     sum.empty() ? "all weights are 0" : sum);
}

} // namespace voluta::pipeline

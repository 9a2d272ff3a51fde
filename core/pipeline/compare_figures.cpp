#include "pipeline/compare_figures.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "modes/mode_table.h"
#include "project/report_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace voluta::pipeline {

namespace {

using project::Stage;
using Value = std::optional<double>;
constexpr double kSameScore = 1e-9;

bool came(const CompareRow& row, Stage stage) {
  return row.reached && *row.reached >= stage;
}

bool hasVoxels(const CompareRow& row) {
  return came(row, Stage::Decompose) && row.report.item().decomposition.voxels > 0;
}
bool hasPieces(const CompareRow& row) {
  return came(row, Stage::Decompose) && !row.report.item().decomposition.pieceList.empty();
}
bool decomposed(const CompareRow& row) {
  return came(row, Stage::Decompose);
}
bool layered(const CompareRow& row) {
  return came(row, Stage::Layers);
}
bool moves(const CompareRow& row) {
  return came(row, Stage::Motion) && row.report.motion.waypoints > 0;
}

// Returns a field of the report, or nullopt where it does not apply.
template <auto kPart, auto kMember, bool (*kMeans)(const CompareRow&)>
Value plain(const CompareRow& row) {
  if (!kMeans(row))
    return std::nullopt;
  if constexpr (requires { row.report.*kPart; })
    return static_cast<double>(row.report.*kPart.*kMember);
  else
    return static_cast<double>(row.report.item().*kPart.*kMember);
}
template <auto kPart, auto kMember, bool (*kMeans)(const CompareRow&)>
Figure figure(std::string_view key, base::Text label, base::Text head, double weight,
              bool lossIfAbsent = true) {
  return {key,   label,       head, project::unitOf(kMember), weight, plain<kPart, kMember, kMeans>,
          false, lossIfAbsent};
}

Value reachable(const CompareRow& row) {
  const project::MotionReport& m = row.report.motion;
  if (!moves(row))
    return std::nullopt;
  return 1.0 - static_cast<double>(m.unreachable) / static_cast<double>(m.waypoints);
}

// Returns a figure of the strength; nullopt without a load.
template <auto kMember> Value ofStrength(const CompareRow& row) {
  const plan::StrengthStatistics& s = row.report.toolpath.strength;
  return came(row, Stage::Toolpath) && s.minSectionMm2 > 0.0 ? Value(s.*kMember) : std::nullopt;
}
template <auto kMember>
Figure strengthFigure(std::string_view key, base::Text label, base::Text head) {
  return {key, label, head, project::unitOf(kMember), 0.0, ofStrength<kMember>, false, false};
}

// Returns a figure of the part between its holds and forces; nullopt without forces, and if it is
// unknown.
template <auto kMember> Value ofLoad(const CompareRow& row) {
  const plan::LoadStatistics& load = row.report.toolpath.load;
  const bool isKnown =
      came(row, Stage::Toolpath) && load.forceN > 0.0 && std::isfinite(load.*kMember);
  return isKnown ? Value(load.*kMember) : std::nullopt;
}
// By how much the forces move their places, along them [mm].
Value deflection(const CompareRow& row) {
  const Value stiffness = ofLoad<&plan::LoadStatistics::stiffnessNPerMm>(row);
  return stiffness && *stiffness > 0.0 ? Value(row.report.toolpath.load.forceN / *stiffness)
                                       : std::nullopt;
}

double weightOf(const Figure& figure, const Weights& weights) {
  const auto set = weights.find(figure.key);
  return set == weights.end() ? figure.weight : set->second;
}

// Returns the figure as a loss: smaller is better, 0 is best.
Value lossOf(const Figure& figure, const CompareRow& row) {
  const Value value = figure.of(row);
  return value && figure.moreIsBetter ? Value(1.0 - *value) : value;
}

} // namespace

const std::vector<Figure>& figures() {
  using project::DecompositionReport;
  constexpr auto kDecomposition = &project::ItemReport::decomposition;
  constexpr auto kMotion = &project::Report::motion;
  static const std::vector<Figure> kFigures{
      figure<kDecomposition, &DecompositionReport::missedVoxels, hasVoxels>(
          "missedVoxels", "missed voxels"_text, "Unprinted\nvoxels"_text, 4.0, false),
      figure<kDecomposition, &DecompositionReport::riskyAreaMm2, hasPieces>(
          "riskyAreaMm2", "risky area"_text, "Overhang\nmm²"_text, 4.0, false),
      figure<kDecomposition, &DecompositionReport::supportVolumeMm3, decomposed>(
          "supportVolumeMm3", "supports"_text, "Supports\nmm³"_text, 1.0),
      figure<kDecomposition, &DecompositionReport::pieces, decomposed>("pieces", "pieces"_text,
                                                                       "Pieces"_text, 0.5),
      figure<&project::ItemReport::layers, &plan::LayerStatistics::count, layered>(
          "layers", "layers"_text, "Layers"_text, 0.0),
      figure<kMotion, &plan::MotionStatistics::durationS, moves>("printTimeS", "planned time"_text,
                                                                 "Planned\ntime"_text, 1.0),
      {"reachableFraction", "reachable"_text, "Reach\n%"_text, "%", 2.0, reachable, true, true,
       "out of reach"_text},
      figure<kMotion, &plan::MotionStatistics::collisions, moves>("collisions", "collisions"_text,
                                                                  "Colli-\nsions"_text, 2.0),
      figure<&project::ItemReport::layers, &plan::LayerStatistics::stepMeanMm, layered>(
          "stepMeanMm", "mean step height"_text, "Mean step\nmm"_text, 0.0),
      figure<&project::ItemReport::layers, &plan::LayerStatistics::stepMaxMm, layered>(
          "stepMaxMm", "greatest step height"_text, "Greatest\nstep mm"_text, 0.0),
      strengthFigure<&plan::StrengthStatistics::angleMeanDeg>(
          "loadAngleDeg", "angle between beads and load"_text, "Bead\nangle °"_text),
      strengthFigure<&plan::StrengthStatistics::interfaceFraction>(
          "interfaceFraction", "interfaces across the load"_text, "Inter-\nfaces %"_text),
      strengthFigure<&plan::StrengthStatistics::maxInterfaceFraction>(
          "mostInterfaceFraction", "interfaces in the weakest section"_text,
          "Weakest\n% interf."_text),
      {"deflectionMm", "deflection under the forces"_text, "Deflec-\ntion mm"_text, "mm", 1.0,
       deflection, false, true},
      {"acrossLayersMPa", "tension across layers"_text, "Across\nlayers MPa"_text, "MPa", 1.0,
       ofLoad<&plan::LoadStatistics::acrossLayersMPa>, false, true},
      {"infillAlignedFraction", "infill along the stress"_text, "Along\nstress %"_text, "%", 0.0,
       ofLoad<&plan::LoadStatistics::infillAlignedFraction>, true, true,
       "infill across the stress"_text},
  };
  return kFigures;
}

Value uniformMisses(const CompareRow& row) {
  // In these modes, missed voxels are those that no layer was grown on.
  const modes::Mode* mode = modes::modeNamed(row.combination.mode);
  return mode && mode->result == project::ResultKind::InPieces
             ? plain<&project::ItemReport::decomposition,
                     &project::DecompositionReport::missedVoxels, hasVoxels>(row)
             : std::nullopt;
}

std::optional<bool> replayPassed(const CompareRow& row) {
  return came(row, Stage::Replay) ? std::optional(row.report.replay.passed) : std::nullopt;
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
    throw base::Error(base::ErrorCode::Usage, base::message("unknown figure '{key}'"_text, key),
                      "--weight"_name, base::didYouMean(key, known));
  double value = -1.0;
  if (equals != std::string::npos) {
    const char* end = assignment.data() + assignment.size();
    if (std::from_chars(assignment.data() + equals + 1, end, value).ptr != end)
      value = -1.0;
  }
  if (!std::isfinite(value) || value < 0.0)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("'{text}' is not a weight"_text, assignment), "--weight"_name,
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

base::Message cellSentence(const std::vector<CompareRow>& rows, const Ranking& ranking,
                           const base::Message& advice) {
  if (advice.empty() || !ranking.best || rows[*ranking.best].combination.cell.empty())
    return advice;
  return base::message("{cell}: best of the planned rows (row {row})"_text,
                       base::dataName(rows[*ranking.best].combination.cell), *ranking.best + 1);
}

std::string ruleText(const Weights& weights) {
  std::string sum;
  for (const Figure& figure : figures())
    if (const double weight = weightOf(figure, weights); weight > 0.0)
      sum += fmt::format("{}{:g} {}", sum.empty() ? "" : ", ", weight, figure.key);
  return fmt::format("ways without blocking findings first, then the lowest sum of weight x "
                     "share of the largest figure ({})",
                     sum.empty() ? "all weights are 0" : sum);
}

} // namespace voluta::pipeline

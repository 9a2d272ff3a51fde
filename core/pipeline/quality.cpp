#include "pipeline/quality.h"

#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace voluta::pipeline {

namespace {
using plan::FindingKind;
using replay::ReplayThresholds;

constexpr std::array<QualityFigure, 5> kFigures{
    {{"uncovered", "uncovered"_text, FindingKind::Uncovered, FindingKind::GivenUncovered,
      &ReplayThresholds::coveredMin, true},
     {"unsupported", "unsupported"_text, FindingKind::Unsupported, FindingKind::GivenUnsupported,
      &ReplayThresholds::unsupportedMax},
     {"overfill", "overfill"_text, FindingKind::Overfill, FindingKind::GivenOverfill,
      &ReplayThresholds::overfillMax},
     {"mass", "mass"_text, FindingKind::Mass, FindingKind::GivenMass,
      &ReplayThresholds::massTolerance},
     {"thin", "thin"_text, FindingKind::Thin, FindingKind::GivenThin, &ReplayThresholds::thinMax}}};

constexpr std::array<QualityLevel, 3> kLevels{
    {{"strict", "strict"_text, {0.03, 0.005, 0.03, 0.03, 0.03}},
     {"usual", "usual"_text, {0.06, 0.02, 0.06, 0.06, 0.06}, true},
     {"draft", "draft"_text, {0.12, 0.05, 0.12, 0.12, 0.12}, true}}};

const QualityLevel& levelNamed(std::string_view id) {
  return *std::ranges::find(kLevels, id, &QualityLevel::id);
}

// The shares as a table, whose messages name the figures and the range.
base::ParameterValues noShares() {
  std::vector<base::ParameterSpec> specs;
  for (const QualityFigure& figure : kFigures)
    specs.push_back(base::numberParameter(std::string(figure.id), "", 0.0, 0.0, 1.0, "Quality"_text,
                                          figure.label, figure.label));
  return base::ParameterValues(base::ParameterTable(std::move(specs)));
}

AcceptedShare parsedShare(std::string_view text) {
  const auto figure =
      std::ranges::find(kFigures, text.substr(0, text.find('=')), &QualityFigure::id);
  base::ParameterValues shares = noShares();
  shares.setAssignment(text);
  return {&*figure, shares.number(figure->id)};
}

std::vector<AcceptedShare> parsedShares(std::string_view text) {
  std::vector<AcceptedShare> shares;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view one = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    while (one.starts_with(' '))
      one.remove_prefix(1);
    while (one.ends_with(' '))
      one.remove_suffix(1);
    if (one.empty())
      continue;
    const AcceptedShare share = parsedShare(one); // the last one of a figure counts
    std::erase_if(shares, [&](const AcceptedShare& known) { return known.figure == share.figure; });
    shares.push_back(share);
  }
  return shares;
}

// Returns the share that a finding beyond a limit states.
std::optional<double> shareOf(const plan::Finding& finding) {
  double percent = 0.0;
  for (const plan::NamedValue& value : finding.values)
    if (const auto* quantity = std::get_if<base::Quantity>(&value.value.data());
        quantity && quantity->unit == base::Unit::Percent)
      percent += quantity->number;
  const bool isRatio = finding.kind == FindingKind::Mass || finding.kind == FindingKind::GivenMass;
  return isRatio ? std::abs(0.01 * percent - 1.0) : 0.01 * percent;
}
} // namespace

std::span<const QualityFigure> qualityFigures() {
  return kFigures;
}

std::span<const QualityLevel> qualityLevels() {
  return kLevels;
}

base::ParameterTable qualityParameters() {
  std::vector<base::Choice> levels;
  for (const QualityLevel& level : kLevels)
    levels.push_back({std::string(level.id), level.label});
  return base::ParameterTable(
      {base::choiceParameter(
           "quality", "usual", std::move(levels), "Quality"_text, "quality"_text,
           "How far the printed part may differ from the requested one before the plan is marked. "
           "Never changes what is safe to run."_text,
           true),
       base::textParameter("accept", "Quality"_text, "accepted differences"_text,
                           "Shares that are accepted in this job beyond the quality's limits: "
                           "uncovered, unsupported, overfill, mass and thin, such as "
                           "uncovered=0.05, mass=0.04. Verification reports list them."_text)});
}

Quality qualityOf(const base::ParameterValues& values) {
  return {values.text("quality"), parsedShares(values.text("accept"))};
}

std::string textOf(const std::vector<AcceptedShare>& accepted) {
  std::vector<std::string> texts;
  for (const AcceptedShare& one : accepted)
    texts.push_back(fmt::format("{}={:.6g}", one.figure->id, one.share));
  return fmt::format("{}", fmt::join(texts, ", "));
}

namespace {
std::size_t indexOf(const AcceptedShare& one) {
  return static_cast<std::size_t>(one.figure - kFigures.data());
}
} // namespace

std::vector<AcceptedShare> beyondLevel(const Quality& quality) {
  const QualityLevel& level = levelNamed(quality.level);
  std::vector<AcceptedShare> shares = quality.accepted;
  std::erase_if(
      shares, [&](const AcceptedShare& one) { return one.share <= level.shares.at(indexOf(one)); });
  return shares;
}

ReplayThresholds thresholdsOf(const Quality& quality) {
  const QualityLevel& level = levelNamed(quality.level);
  std::array<double, kFigures.size()> shares = level.shares;
  for (const AcceptedShare& one : beyondLevel(quality))
    shares.at(indexOf(one)) = one.share;
  ReplayThresholds limits;
  limits.bridgesMaySag = level.bridgesMaySag;
  for (std::size_t i = 0; i < kFigures.size(); ++i)
    limits.*kFigures.at(i).limit = kFigures.at(i).isMinimum ? 1.0 - shares.at(i) : shares.at(i);
  return limits;
}

std::optional<std::string> acceptedWith(const Quality& quality, const plan::Finding& finding) {
  const auto figure = std::ranges::find_if(kFigures, [&](const QualityFigure& f) {
    return f.kind == finding.kind || f.givenKind == finding.kind;
  });
  const std::optional<double> share = shareOf(finding);
  if (figure == kFigures.end() || !share)
    return std::nullopt;
  constexpr double kStep = 0.005, kRounding = 1e-9;
  double rounded = kStep * std::ceil(*share / kStep - kRounding);
  if (rounded < *share) // by rounding
    rounded += kStep;
  rounded = std::min(1.0, rounded);
  std::vector<AcceptedShare> accepted = quality.accepted;
  std::erase_if(accepted, [&](const AcceptedShare& one) { return one.figure == &*figure; });
  accepted.push_back({&*figure, rounded});
  return textOf(accepted);
}

} // namespace voluta::pipeline

// What ways of building are judged by, and the rule that ranks them.
#pragma once

#include "base/text.h"
#include "pipeline/compare.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// A figure of a row, from its report: one row of the table a figure.
struct Figure {
  std::string_view key;  // in compare.json
  base::Text label;      // in full
  base::Text head;       // of a column: short, broken where a narrow one may be
  std::string_view unit; // "" for counts; "%" for shares, which are fractions of 1
  double weight;         // in the rule unless the user sets another; 0: only shown
  // None: means nothing to the mode, or the road did not come so far.
  std::optional<double> (*of)(const CompareRow&);
  bool moreIsBetter = false; // then at most 1
  bool lossIfAbsent = true;  // the road did not come so far: counts as the worst
  // What its weight counts against: the label, but for a figure of which more is better.
  base::Text loss = label;
};

// missedVoxels, riskyAreaMm2, supportVolumeMm3, pieces, layers, printTimeS, reachableFraction,
// collisions.
const std::vector<Figure>& figures();

// Voxels that uniform slicing misses, of mode flat.
std::optional<double> uniformMisses(const CompareRow& row);
// Of the first program; none: the road did not come so far.
std::optional<bool> replayPassed(const CompareRow& row);

// By figure; all >= 0. One that is missing has the figure's own.
using Weights = std::map<std::string, double, std::less<>>;
Weights defaultWeights();
// "key=value". Throws Error{Usage}: an unknown figure (the nearest is named), a value < 0.
void setWeight(Weights& weights, const std::string& assignment);

struct Ranking {
  std::vector<std::optional<double>> score; // per row, smaller is better; none: not planned
  std::vector<std::size_t> order;           // rows, best first
  std::optional<std::size_t> best;          // none: no row is clear
  std::vector<std::size_t> tied;            // rows as good as the best, the best not among them
};

// The rule. What is clear of blocking findings comes before what is blocked, and that before what
// cannot be planned. Among equals the least score: the sum over all figures of its weight times the
// figure's share of the largest among these rows (1 - figure where more is better). Of rows with
// one score the first is best.
Ranking rank(const std::vector<CompareRow>& rows, const Weights& weights);

// The rule in a sentence or two, English.
std::string ruleText(const Weights& weights);

// compare.json. `folders` and `pictures` (paths from the comparison's own folder): of each row.
struct RowFiles {
  std::string folder;
  std::vector<std::string> pictures;
};
// Keys are added, never renamed:
//   part, cell, process, scale, until, threads, seconds, version
//   rule        {text, weights{figure: weight}}
//   best        number of a row, or null: all are blocked or failed;  tied[]: numbers;  ranking[]:
//   numbers rows        [{number (from 1), mode, growth or null, scheme (that auto came to) or
//   null,
//                 platform, state (clear, blocked, failed), reason or null, blocking, score or
//                 null, the figures or null, growthLayers, uniformMisses, replayPassed or null,
//                 reached (stage) or null, seconds, folder, pictures[]}]
std::string compareJson(const Comparison& comparison, const Weights& weights,
                        const std::vector<RowFiles>& files);
// "1-curved-auto", "7-planar": of row `index` (from 0).
std::string rowFolder(std::size_t index, const Combination& combination);
// "clear", "blocked", "failed".
std::string_view stateName(RowState state);

} // namespace voluta::pipeline

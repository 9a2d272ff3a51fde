// The figures that compare ways of building, and the rule that ranks them.
#pragma once

#include "base/text.h"
#include "pipeline/compare.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// One figure of a row, computed from its report. Each figure is a row of the printed table.
struct Figure {
  std::string_view key;  // Key in compare.json
  base::Text label;      // Full label
  base::Text head;       // Column head: short, broken where a narrow column may break it
  std::string_view unit; // Empty for counts; "%" for shares, which are fractions of 1
  double weight;         // Default weight in the rule; 0: shown only
  // Returns nullopt if the figure does not apply to the mode or its stage was not reached.
  std::optional<double> (*of)(const CompareRow&);
  bool moreIsBetter = false; // Then the maximum is 1
  bool lossIfAbsent = true;  // A missing figure counts as the worst that any has
  // Name of the loss that the weight applies to; differs from the label if more is better.
  base::Text loss = label;
};

// Returns the figures missedVoxels, riskyAreaMm2, supportVolumeMm3, pieces, layers, printTimeS,
// reachableFraction, collisions, stepMeanMm, stepMaxMm, and those of a load: loadAngleDeg,
// interfaceFraction and maxInterfaceFraction.
const std::vector<Figure>& figures();

// Returns the number of voxels that uniform slicing misses, for mode flat.
std::optional<double> uniformMisses(const CompareRow& row);
// Returns whether the first program passed its replay; nullopt if replay was not reached.
std::optional<bool> replayPassed(const CompareRow& row);

// Weight per figure; all >= 0. A figure that is missing has its default weight.
using Weights = std::map<std::string, double, std::less<>>;
Weights defaultWeights();
// Sets a weight from "key=value". Throws Error{Usage} for an unknown figure (suggests the nearest)
// and for a value < 0.
void setWeight(Weights& weights, const std::string& assignment);

struct Ranking {
  std::vector<std::optional<double>> score; // Per row, smaller is better; nullopt: not planned
  std::vector<std::size_t> order;           // Row indices, best first
  std::optional<std::size_t> best;          // nullopt: no row is clear
  std::vector<std::size_t> tied;            // Rows that score as well as the best, without the best
};

// Ranks the rows: clear before blocked, blocked before failed. Within a state the lowest score is
// first. The score is the sum over all figures of the weight times the figure's share of the
// largest among these rows (for figures where more is better, 1 - figure counts). Rows with equal
// scores keep their order.
Ranking rank(const std::vector<CompareRow>& rows, const Weights& weights);

// Returns the sentence about cells below the table: the cell of the best row; `advice`, which
// follows from reach, load and gravity alone, if there is none. Empty if one cell is compared.
base::Message cellSentence(const std::vector<CompareRow>& rows, const Ranking& ranking,
                           const base::Message& advice);

// Returns the rule in one or two English sentences.
std::string ruleText(const Weights& weights);

// Folder and pictures of a row, as paths relative to the comparison's folder.
struct RowFiles {
  std::string folder;
  std::vector<std::string> pictures;
};
// Returns the text of compare.json. Keys are added, never renamed:
//   part, cell, process, scale, until, threads, seconds, version
//   rule      {text, weights{figure: weight}}
//   best      number of a row, or null if all are blocked or failed
//   tied[]    numbers of rows
//   ranking[] numbers of rows
//   rows      [{number (from 1), mode, growth or null, scheme (that auto chose) or null,
//             platform, state (clear, blocked, failed), reason or null, blocking, score or null,
//             the figures or null, growthLayers, uniformMisses, replayPassed or null,
//             reached (stage) or null, seconds, folder, pictures[]}]
std::string compareJson(const Comparison& comparison, const Weights& weights,
                        const std::vector<RowFiles>& files);
// Returns the folder name of row `index` (from 0), e.g. "1-curved-auto", "7-planar".
std::string rowFolder(std::size_t index, const Combination& combination);
// Returns "clear", "blocked" or "failed".
std::string_view stateName(RowState state);

} // namespace voluta::pipeline

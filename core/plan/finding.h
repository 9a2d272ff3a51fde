// Findings: places that cannot be printed, reached or verified, as data (docs/design.md, Findings).
// A finding is never an error.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::plan {

enum class FindingKind : std::uint8_t; // finding_kinds.h

// A value, with the name of its placeholder in the texts of its finding kind.
struct NamedValue {
  std::string_view name;
  base::Value value;
  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

// A position in a program's text.
struct ProgramLine {
  std::string format;   // Empty: the only program in question
  std::size_t file = 0; // 1-based; 0: single-file program
  std::size_t line = 0; // 1-based; 0: no particular line
  friend bool operator==(const ProgramLine&, const ProgramLine&) = default;
};

struct Finding {
  FindingKind kind{};
  std::vector<NamedValue> values;
  std::optional<Eigen::Vector3d> where; // Work frame [mm]
  std::optional<double> whenS;          // Time from program start [s]
  std::size_t count = 1;
  bool more = false;    // Also stands for further ones, which are not listed (FindingRow::more)
  bool blocking = true; // False: informational, exit code stays 0
  ProgramLine program;  // Set by stage replay
  int item = -1;        // index in the job's items; -1: the whole job, or its only item

  // Returns nullptr if the finding has no value of this name.
  const base::Value* value(std::string_view name) const;
};

using Findings = std::vector<Finding>;

// Returns a finding of this kind; its severity decides whether it blocks. Throws Error{Internal}
// unless the values are exactly those that the texts of the kind have placeholders for.
Finding makeFinding(FindingKind kind, std::vector<NamedValue> values = {},
                    const std::optional<Eigen::Vector3d>& where = std::nullopt,
                    std::size_t count = 1);

// Returns a finding that also stands for further ones of this kind, which are not listed. Throws
// Error{Internal} as makeFinding, and for kinds without FindingRow::more.
Finding makeMoreFinding(FindingKind kind, std::vector<NamedValue> values,
                        const std::optional<Eigen::Vector3d>& where, std::size_t count);

// Returns the reason in one sentence, without its position in a program: the same fact in two
// program formats gives the same text.
base::Message factOf(const Finding& finding);
// Returns the reason preceded by its position in the program: "urscript: line 12: ...".
base::Message reasonOf(const Finding& finding);
// Returns the remedy in one sentence; may be empty.
base::Message remedyOf(const Finding& finding);
// Return the reason and the remedy in English.
std::string englishReason(const Finding& finding);
std::string englishRemedy(const Finding& finding);

// Returns whether both findings report the same fact, in whichever program format: equal kind and
// values, and places within 0.1 mm.
bool sameFact(const Finding& a, const Finding& b);

base::Point pointOf(const Eigen::Vector3d& p);

} // namespace voluta::plan

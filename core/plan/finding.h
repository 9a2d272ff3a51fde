// What cannot be printed, reached or verified, as data (docs/design.md, Findings): never an error.
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

// A value by the name that its place has in the sentences of its kind.
struct NamedValue {
  std::string_view name;
  base::Value value;
  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

// Where in the text of a program.
struct ProgramLine {
  std::string format;   // empty: of the only program in question
  std::size_t file = 0; // 1-based; 0: of a program in one file
  std::size_t line = 0; // 1-based; 0: nowhere in particular
  friend bool operator==(const ProgramLine&, const ProgramLine&) = default;
};

struct Finding {
  FindingKind kind{};
  std::vector<NamedValue> values;
  std::optional<Eigen::Vector3d> where; // work frame, mm
  std::optional<double> whenS;          // seconds from program start
  std::size_t count = 1;
  bool blocking = true; // false: worth knowing, exit code stays 0
  ProgramLine program;  // stage replay

  // nullptr where its kind has no such value.
  const base::Value* value(std::string_view name) const;
};

using Findings = std::vector<Finding>;

// A finding of that kind, blocking where its kind says so. Precondition (Error{Internal}): the
// values are just those that the sentences of its kind have places for.
Finding makeFinding(FindingKind kind, std::vector<NamedValue> values = {},
                    const std::optional<Eigen::Vector3d>& where = std::nullopt,
                    std::size_t count = 1);

// What is the matter, in one sentence, without where in a program it stands: the same for the same
// fact in another format.
base::Message factOf(const Finding& finding);
// The same with the place in the program before it: "urscript: line 12: ...".
base::Message reasonOf(const Finding& finding);
// What would help, in one sentence; may be empty.
base::Message remedyOf(const Finding& finding);
// The two in English.
std::string englishReason(const Finding& finding);
std::string englishRemedy(const Finding& finding);

// Do both tell the same, of programs in whatever format: kind, values and (within 0.1 mm) place.
bool sameFact(const Finding& a, const Finding& b);

base::Point pointOf(const Eigen::Vector3d& p);

} // namespace voluta::plan

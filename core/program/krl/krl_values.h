// Variables, aggregates and frames of KRL.
#pragma once

#include "base/text.h"
#include "program/common/line_cursor.h"
#include "program/common/procedures.h"

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

inline constexpr LineSyntax kKrlSyntax{';', '$'};

// Recognizes DEF NAME ( ) and END; `name` in small letters, empty if the line does not begin a
// procedure that the reader supports.
LinePart krlPart(LineCursor line, std::string& name);
// Adds a defect for each module except the first that is not named after its first procedure: a
// controller would not find it.
void reportOtherNames(const std::vector<plan::ProgramFile>& files, ProgramBuilder& out);

// Parses a variable's name with its index and parts, in small letters: "$vel.cp", "$out[1]", "p1".
bool takeKrlPath(LineCursor& line, std::string& path);

// Parses the condition $IN[n]==TRUE or FALSE and nothing behind it; `input`: n - 1.
bool takeKrlInput(LineCursor& line, int& input, bool& on);
// Returns the number (ProgramEmitter::setOutput) of the output $OUT[n]; 0 if the path is none.
int krlToolOf(std::string_view path);

// The parts of a value, keyed by their paths within it: {X 1,B {Y 2}} has "x" and "b.y"; a number
// has the path "". A boolean is 0 or 1.
struct KrlValue {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> words; // #BASE: "base"
};

// Returns one part; nullopt if the value has no such part.
std::optional<double> krlNumber(const KrlValue& value, std::string_view path);

inline constexpr std::array<std::string_view, 6> kKrlPose = {"x", "y", "z", "a", "b", "c"};
inline constexpr std::array<std::string_view, 6> kKrlAxes = {"a1", "a2", "a3", "a4", "a5", "a6"};
inline constexpr std::array<std::string_view, 6> kKrlExternal = {"e1", "e2", "e3",
                                                                 "e4", "e5", "e6"};

class KrlVariables {
public:
  KrlVariables();

  // Parses an assignable value: an aggregate, a sum, a boolean, a word, a string, or another
  // variable as a whole. Returns false otherwise.
  bool takeValue(LineCursor& line, KrlValue& value) const;
  bool takeNumber(LineCursor& line, double& value) const;
  // Overwrites those parts of the variable that `value` contains.
  void set(const std::string& path, const KrlValue& value);
  void set(const std::string& path, double value);
  void erase(const std::string& path);

  std::optional<double> number(std::string_view path) const;
  std::string_view word(std::string_view path) const; // empty: none
  // Returns all known parts of a variable.
  KrlValue below(const std::string& path) const;

private:
  bool takeAggregate(LineCursor& line, const std::string& within, KrlValue& value, int depth) const;
  bool takePart(LineCursor& line, const std::string& within, KrlValue& value, int depth) const;

  KrlValue all_;
};

// Returns the frame of X, Y, Z [mm] and A, B, C [degrees]; nullopt if it is out of any reach.
std::optional<Eigen::Isometry3d> krlPose(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);
// Same for {X,Y,Z,A,B,C}; nullopt also if a part is missing.
std::optional<Eigen::Isometry3d> krlFrame(const KrlValue& value);

} // namespace voluta::program

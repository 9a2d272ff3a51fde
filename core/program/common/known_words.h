// Words of controller languages that are neither motion nor flow, and where each of them is
// allowed. Words that are not in a dialect's table are refused, because their effect on a print is
// unknown.
#pragma once

#include "program/common/program_text.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Sections of a program, combined as bits.
enum : std::uint8_t {
  kBeforeMotion = 1,   // before the first motion
  kBeforeMaterial = 2, // after it, before any material flows
  kDuringPrintOff = 4, // between the first bead and the last motion, the extruder off
  kDuringPrintOn = 8,  // there, the extruder on
  kAtEnd = 16          // after the last motion
};
// Does not affect the printed part.
inline constexpr std::uint8_t kAnywhere = 31;
// Sets the machine up.
inline constexpr std::uint8_t kSetUp = kBeforeMotion;
// Affects other equipment than arm and extruder, or waits for the operator.
inline constexpr std::uint8_t kOutsidePrint = kBeforeMotion | kBeforeMaterial | kAtEnd;
// Stops the arm.
inline constexpr std::uint8_t kAtRest = kOutsidePrint | kDuringPrintOff;

struct KnownWord {
  std::string_view word; // in lower case if the language is not case-sensitive
  std::uint8_t places = 0;
  std::string_view meaning; // for readers of the table
};

// Returns nullptr if the word is not in the table.
const KnownWord* findWord(std::span<const KnownWord> table, std::string_view word);

// Reports words at places where they are not allowed, each at its own line.
class WordPlaces {
public:
  explicit WordPlaces(Defects& defects) : defects_(defects) {}

  // Checks a word at this place; extruderOn: whether the extruder is on.
  void word(std::string_view word, std::uint8_t places, std::size_t file, std::size_t line,
            bool extruderOn);
  // Begins a section that runs separately and sets the machine up again. The section before has
  // ended.
  void begin() {
    moved_ = false;
    waiting_.clear();
  }
  void motion();
  // Material flows, moving or not.
  void material();
  bool moved() const { return moved_; }

private:
  struct Waiting {
    std::string word;
    std::size_t file, line;
  };
  void refuse(std::string_view word, std::size_t file, std::size_t line);

  Defects& defects_;
  bool moved_ = false, deposited_ = false;
  std::vector<Waiting> waiting_; // allowed at the end only: refused if another motion follows
};

} // namespace voluta::program

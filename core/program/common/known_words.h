// The words of controllers' languages that are neither motion nor flow, and where each may stand. A
// word that is not in a dialect's table is refused: nobody knows what it does to a print.
#pragma once

#include "program/common/text.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Stretches of a program. Places of a word are a sum of them.
enum : std::uint8_t {
  kBeforeMotion = 1,   // before the first motion
  kBeforeMaterial = 2, // behind it, before anything flows
  kAmidOff = 4,        // between the first bead and the last motion, the extruder off
  kAmidOn = 8,         // there, the extruder on
  kAtEnd = 16          // behind the last motion
};
// Changes nothing that is printed.
inline constexpr std::uint8_t kAnywhere = 31;
// Sets the machine up.
inline constexpr std::uint8_t kSetUp = kBeforeMotion;
// Something else than arm and extruder, or a wait for the operator.
inline constexpr std::uint8_t kAside = kBeforeMotion | kBeforeMaterial | kAtEnd;
// Lets the arm come to rest.
inline constexpr std::uint8_t kAtRest = kAside | kAmidOff;

struct KnownWord {
  std::string_view word; // in small letters where the language does not tell letters
  std::uint8_t places = 0;
  std::string_view meaning; // for who reads the table
};

// nullptr: not in the table.
const KnownWord* findWord(std::span<const KnownWord> table, std::string_view word);

// Tells words that stand where they may not, each at its own line.
class WordPlaces {
public:
  explicit WordPlaces(Defects& defects) : defects_(defects) {}

  // A word stands here, while the extruder is on or not.
  void word(std::string_view word, std::uint8_t places, std::size_t file, std::size_t line,
            bool extruderOn);
  // A part that runs by itself begins: it sets the machine up anew.
  void begin() { moved_ = false; }
  void motion();
  // Something flows, moving or not.
  void material();
  bool moved() const { return moved_; }

private:
  struct Waiting {
    std::string word;
    std::size_t file, line;
  };
  void refuse(std::string_view word, std::size_t file, std::size_t line);

  Defects& defects_;
  bool moved_ = false, laid_ = false;
  std::vector<Waiting> waiting_; // may stand at the end only, if this is it
};

} // namespace voluta::program

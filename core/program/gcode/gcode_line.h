// Parses a line of G-code and detects a text's kind of G-code.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace voluta::program {

// A letter with its number, or nX, nY, nZ with one.
struct GcodeWord {
  std::string_view name;    // as written, without the number
  char letter = 'A';        // capital; the axis of nX, nY, nZ
  bool isDirection = false; // nX, nY, nZ
  bool isBare = false;      // without a number, which counts as 0
  double value = 0.0;       // within 1e9
};

// Takes the words of a line, without its `;` comment and checksum, from left to right. Accepts
// lower case and ( ) comments, with or without blanks (G1X10E5 is X10 E5: numbers have no
// exponent). The line must outlive the scanner.
class GcodeScanner {
public:
  explicit GcodeScanner(std::string_view line) : rest_(line) {}
  // Returns false at the end of the line, and before text that is no word.
  bool next(GcodeWord& word);
  // After next() returned false: whether that was the end of the line.
  bool ended() const { return rest_.empty(); }

private:
  std::string_view rest_;
};

// The value of each letter, and of nX nY nZ.
struct GcodeWords {
  std::array<std::optional<double>, 26> letter;
  std::array<std::optional<double>, 3> direction;

  std::optional<double>& operator[](char c) { return letter[static_cast<std::size_t>(c - 'A')]; }
  bool any(std::string_view letters) {
    return std::any_of(letters.begin(), letters.end(),
                       [&](char c) { return (*this)[c].has_value(); });
  }
  std::string bare; // the first letters without a number, which count as 0; empty: none
  bool anyDirection() const { return direction[0] || direction[1] || direction[2]; }
};

// Parses a line as GcodeScanner does. A letter without a number counts as 0 (GcodeWords::bare).
// Returns false if the line is not understood or has a word twice.
bool wordsOf(std::string_view line, GcodeWords& words);

enum class GcodeKind {
  None,
  Plain,    // X Y Z, the nozzle upright
  Extended, // nX nY nZ: the nozzle's direction
  Table     // B and C: a table that tilts and turns
};
// Detected by the words of the motions; comments are ignored, except for a slicer's name.
GcodeKind kindOfGcode(std::string_view text);

} // namespace voluta::program

// Small tools of the writers and readers: numbers to text and back, lines, names. Locale-free.
#pragma once

#include "plan/program.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Appends `value` rounded to `decimals` (0..9) places, never as "-0" and never with an exponent;
// with `trim` without zeros at its end ("0.5", "2"). Precondition: |value| * 10^decimals < 2^62.
void appendFixed(std::string& out, double value, int decimals, bool trim = false);
// What appendFixed appends, zeros at its end trimmed.
std::string fixedText(double value, int decimals);
// The value that appendFixed writes.
double roundedTo(double value, int decimals);
// Decimals that give `value` (> 0) the asked significant digits, at most 9.
int decimalsFor(double value, int significantDigits);

// Where `mark` begins outside of double quotes; npos: nowhere.
std::size_t findUnquoted(std::string_view text, std::string_view mark);

// A letter or underscore, then letters, digits, underscores: what all controllers take for a name.
// Other characters become underscores; at most 31 characters.
std::string identifierOf(std::string_view name);

// The pieces one after the other.
std::string joined(std::initializer_list<std::string_view> pieces);

std::string_view trimmed(std::string_view text);
// The whole of `text` as a finite number. false: it isn't one.
bool parseNumber(std::string_view text, double& value);
// A number at the beginning of `text`, which is moved behind it.
bool takeNumber(std::string_view& text, double& value);
// The same, but an E ends the number instead of beginning an exponent.
bool takeDecimal(std::string_view& text, double& value);

// Lines of a text without their ends (LF, CR LF); numbers from 1. A last line without end counts.
class LineReader {
public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line);
  std::size_t number() const { return number_; }

private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

inline constexpr std::size_t kMaxDefects = 1000;

// Collects defects up to kMaxDefects.
class Defects {
public:
  explicit Defects(std::vector<plan::ProgramDefect>& list) : list_(list) {}
  void add(std::size_t file, std::size_t line, base::Message reason);

private:
  std::vector<plan::ProgramDefect>& list_;
};

// Line i primes the nozzle: it says so, or stands within four lines of the remark that does.
bool primes(const std::vector<std::string>& lines, std::size_t i);

} // namespace voluta::program

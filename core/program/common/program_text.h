// Helpers of writers and readers: conversion of numbers, lines, names. Independent of the locale.
#pragma once

#include "plan/program.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Appends `value` rounded to `decimals` (0..9) places, never as "-0" and never with an exponent;
// with `trim` without trailing zeros ("0.5", "2"). Precondition: |value| * 10^decimals < 2^62.
void appendFixed(std::string& out, double value, int decimals, bool trim = false);
// Returns the text that appendFixed appends, without trailing zeros.
std::string fixedText(double value, int decimals);
// Returns the value that appendFixed writes.
double roundedTo(double value, int decimals);
// Returns the number of decimals, at most 9, that give `value` (> 0) that many significant digits.
int decimalsFor(double value, int significantDigits);

// Returns the position of `mark` outside of double quotes; npos if there is none.
std::size_t findUnquoted(std::string_view text, std::string_view mark);

// Returns a name that all controllers accept: a letter or underscore, then letters, digits,
// underscores. Other characters become underscores; at most 31 characters.
std::string identifierOf(std::string_view name);

// Returns the concatenated pieces.
std::string joined(std::initializer_list<std::string_view> pieces);

std::string_view trimmed(std::string_view text);
// Parses the whole of `text` as a finite number. Returns false if it is none.
bool parseNumber(std::string_view text, double& value);
// Returns the integer that `value` is; nullopt if it is none from `minimum` to `maximum`. Outputs,
// inputs and tools have such numbers.
std::optional<int> wholeNumber(double value, int minimum, int maximum);
// Parses the whole of `text`, digits only, as such a number.
std::optional<int> parseWholeNumber(std::string_view text, int minimum, int maximum);
// Parses a number at the beginning of `text` and removes it.
bool takeNumber(std::string_view& text, double& value);
// As takeNumber, but an E ends the number instead of starting an exponent.
bool takeDecimal(std::string_view& text, double& value);

// Iterates over the lines of a text without their ends (LF, CR LF); numbers from 1. A last line
// without an end counts.
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

// Returns whether line i primes the nozzle: it is marked as prime, or follows within four lines of
// such a remark.
bool primes(const std::vector<std::string>& lines, std::size_t i);

} // namespace voluta::program

#include "mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <random>
#include <string_view>

namespace voluta::fuzz {

namespace {

constexpr std::size_t kLargest = 1 << 20; // bytes an input may grow to

constexpr std::array<std::string_view, 26> kWords = {
    "0",          "-1",     "1e999", "-1e308", "1e-320",      "nan", "inf",
    "2147483648", "-32769", "256",   "65536",  "4294967296",  "0.0", "18446744073709551615",
    "null",       "{}",     "[]",    "true",   "\"\"",        "",    "1e9",
    "\n",         " ",      "\\",    "\"",     "\xff\xfe\xc0"};
constexpr std::array<std::uint64_t, 12> kNumbers = {
    0,      1,          0x7f,       0x80,       0xff,       0x7fff,
    0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7ff00000, 0xffffffffffffffff};

class Mutator {
public:
  Mutator(const std::vector<std::string>& seeds, std::uint64_t number)
      : seeds_(seeds), random_(number), text_(seeds[below(seeds.size())]) {}

  std::string run() {
    const std::size_t changes = 1 + below(8);
    for (std::size_t i = 0; i < changes; ++i)
      change();
    return std::move(text_);
  }

private:
  // In [0, n); n > 0. Not a standard distribution: those differ from library to library.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  std::size_t place() { return below(text_.size() + 1); }
  // Short ones are likelier.
  std::size_t length() { return 1 + below(std::size_t{1} << below(9)); }

  void change() {
    switch (below(9)) {
    case 0:
      if (!text_.empty())
        text_[below(text_.size())] ^= static_cast<char>(1 << below(8));
      break;
    case 1:
      text_.insert(place(), 1, static_cast<char>(below(256)));
      break;
    case 2:
      text_.erase(place(), length());
      break;
    case 3: // again, elsewhere
      insert(text_.substr(place(), length()));
      break;
    case 4: { // from another file
      const std::string& other = seeds_[below(seeds_.size())];
      insert(other.substr(below(other.size() + 1), length()));
      break;
    }
    case 5:
      insert(kWords[below(kWords.size())]);
      break;
    case 6:
      replaceWord();
      break;
    case 7:
      writeNumber();
      break;
    default:
      if (below(4) == 0)
        text_.resize(place());
      else
        replaceLine();
      break;
    }
  }

  void insert(std::string_view piece) {
    if (text_.size() + piece.size() <= kLargest)
      text_.insert(place(), piece);
  }

  static bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '_';
  }
  void replaceWord() {
    const auto from = text_.begin() + static_cast<std::ptrdiff_t>(place());
    const auto begin = std::find_if(from, text_.end(), isWord);
    const auto end = std::find_if_not(begin, text_.end(), isWord);
    const std::string_view word = kWords[below(kWords.size())];
    text_.replace(begin, end, word.begin(), word.end());
  }

  // A line moves to the place of another.
  void replaceLine() {
    const auto lineAt = [&](std::size_t at) {
      const std::size_t before = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
      const std::size_t begin = before == std::string::npos ? 0 : before + 1;
      const std::size_t end = text_.find('\n', at);
      return std::pair(begin, (end == std::string::npos ? text_.size() : end + 1) - begin);
    };
    const auto [from, count] = lineAt(place());
    const std::string line = text_.substr(from, count);
    const auto [to, replaced] = lineAt(place());
    if (text_.size() + line.size() <= kLargest)
      text_.replace(to, below(2) == 0 ? replaced : 0, line);
  }

  // Little-endian, over existing bytes.
  void writeNumber() {
    const std::size_t bytes = std::size_t{1} << below(4);
    std::uint64_t value = kNumbers[below(kNumbers.size())];
    const std::size_t at = place();
    for (std::size_t i = at; i < std::min(at + bytes, text_.size()); ++i, value >>= 8)
      text_[i] = static_cast<char>(value & 0xff);
  }

  const std::vector<std::string>& seeds_;
  std::mt19937_64 random_;
  std::string text_;
};

} // namespace

std::string mutated(const std::vector<std::string>& seeds, std::uint64_t number) {
  return Mutator(seeds, number).run();
}

} // namespace voluta::fuzz

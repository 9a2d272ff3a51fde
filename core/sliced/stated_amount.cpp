#include "sliced/stated_amount.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace voluta::sliced {

namespace {

constexpr double kMostMm = 1e6; // Of a line; beyond it the number is damaged

struct Word {
  char letter = ' ';
  std::optional<double> number;
};

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Returns the words of a line; none of one that begins with another word than a letter with a
// number, such as a firmware's macro.
std::vector<Word> wordsIn(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < line.size() && line[i] != ';' && line[i] != '*';) {
    const char c = line[i];
    if (c == '(') {
      i = std::min(line.find(')', i), line.size());
    } else if (isLetter(c)) {
      const std::size_t from = line.find_first_not_of(" \t", i + 1);
      const std::size_t begin = std::min(from, line.size());
      const std::size_t end = std::min(line.find_first_not_of("+-.0123456789", begin), line.size());
      const std::string digits(line.substr(begin, end - begin));
      char* last = nullptr;
      const double number = std::strtod(digits.c_str(), &last);
      const bool isNumber = !digits.empty() && last == digits.c_str() + digits.size();
      if (words.empty() && !isNumber)
        return {};
      words.push_back(
          {static_cast<char>(c & ~0x20), isNumber ? std::optional<double>(number) : std::nullopt});
      i = isNumber ? end : i + 1;
      continue;
    }
    ++i;
  }
  return words;
}

class Count {
public:
  explicit Count(const SlicedHeader& header) : header_(header), volumetric_(header.volumetric) {}

  void take(std::size_t line, const std::vector<Word>& words) {
    line_ = line;
    char command = ' ';
    double number = 0.0;
    bool namesAxis = false;
    std::optional<double> e, d, s, t;
    const auto end = [&] {
      if (command == 'G')
        endG(number, e, namesAxis);
      else if (command == 'M')
        endM(number, d, s, t);
      e = d = s = t = std::nullopt;
      namesAxis = false;
    };
    for (const Word& word : words) {
      if (word.letter == 'G' || word.letter == 'M') {
        end();
        command = word.letter;
        number = word.number.value_or(-1.0);
        if (command == 'M' && isText(number))
          return;
      } else if (word.letter == 'T' && command != 'M') {
        takeTool(word.number);
      } else {
        (word.letter == 'E'   ? e
         : word.letter == 'D' ? d
         : word.letter == 'S' ? s
         : word.letter == 'T' ? t
                              : other_) = word.number;
        namesAxis = namesAxis || word.letter == 'X' || word.letter == 'Y' || word.letter == 'Z' ||
                    word.letter == 'C';
      }
    }
    end();
  }

  StatedAmount taken() { return std::move(stated_); }

private:
  // M commands whose rest may be a text, or has E words of another meaning.
  static bool isText(double m) {
    constexpr std::array kOthers{3.0,   4.0,   5.0,   6.0,   7.0,   8.0,   9.0,   82.0,  83.0, 84.0,
                                 104.0, 106.0, 107.0, 109.0, 140.0, 190.0, 200.0, 220.0, 221.0};
    return std::ranges::find(kOthers, m) == kOthers.end();
  }

  // Larger numbers are commands of firmwares.
  int toolOf(const std::optional<double>& number) const {
    constexpr double kMaxTools = 16.0;
    const bool isTool =
        number && *number >= 0.0 && *number < kMaxTools && *number == std::floor(*number);
    return isTool ? static_cast<int>(*number) : tool_;
  }
  void takeTool(const std::optional<double>& number) { tool_ = toolOf(number); }

  void endG(double g, const std::optional<double>& e, bool namesAxis) {
    constexpr std::array kStill{4.0, 10.0, 11.0, 28.0, 29.0, 30.0};
    if (g == 20.0 || g == 21.0) {
      unit_ = g == 20.0 ? 25.4 : 1.0;
    } else if (g == 90.0 || g == 91.0) {
      relative_ = g == 91.0;
    } else if (g == 92.0) {
      if (e || !namesAxis)
        at_ = unit_ * e.value_or(0.0);
    } else if (e && std::ranges::find(kStill, g) == kStill.end()) {
      const double length = relative_ || relativeE_ ? unit_ * *e : unit_ * *e - at_;
      if (!(std::abs(length) <= kMostMm))
        return;
      at_ += length;
      feed(length);
    }
  }

  void endM(double m, const std::optional<double>& d, const std::optional<double>& s,
            const std::optional<double>& t) {
    if (m == 6.0)
      takeTool(t);
    else if (m == 82.0 || m == 83.0)
      relativeE_ = m == 83.0;
    else if (m == 200.0 && d)
      volumetric_ = *d > 0.0;
    else if (m == 221.0 && s && *s > 0.0)
      flows_[toolOf(t)] = *s / 100.0;
  }

  void feed(double length) {
    auto& [fed, maxFed] = nozzles_[header_.oneNozzle ? 0 : tool_];
    fed += length;
    if (fed <= maxFed)
      return;
    const auto flow = flows_.find(tool_);
    const double out = (flow == flows_.end() ? 1.0 : flow->second) *
                       header_.amountShare(tool_, volumetric_) * (fed - maxFed);
    maxFed = fed;
    stated_.sum += out;
    stated_.increments.push_back({line_, out});
  }

  const SlicedHeader& header_;
  StatedAmount stated_;
  std::optional<double> other_; // Words that state no amount
  bool volumetric_, relative_ = false, relativeE_ = false;
  double unit_ = 1.0, at_ = 0.0;
  int tool_ = 0;
  std::size_t line_ = 0;
  std::map<int, double> flows_;                      // of tools
  std::map<int, std::pair<double, double>> nozzles_; // fed in all, and the most of it so far
};
} // namespace

StatedAmount statedAmount(std::string_view text, const SlicedHeader& header) {
  Count count(header);
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    count.take(++line, wordsIn(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return count.taken();
}

} // namespace voluta::sliced

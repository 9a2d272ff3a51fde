#include "milling/mill_reader.h"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace voluta::milling {

namespace {

using Words = std::vector<std::pair<char, double>>;

// Returns the words of a line without its comments; nullopt if it is no G-code.
std::optional<Words> wordsOf(std::string_view line) {
  Words words;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == '(') {
      const std::size_t end = line.find(')', i);
      if (end == std::string_view::npos)
        return std::nullopt;
      i = end + 1;
    } else if (line[i] == ' ' || line[i] == '\r') {
      ++i;
    } else if (line[i] >= 'A' && line[i] <= 'Z') {
      double number = 0.0;
      const char* from = line.data() + i + 1;
      const auto [end, error] = std::from_chars(from, line.data() + line.size(), number);
      if (error != std::errc() || !std::isfinite(number))
        return std::nullopt;
      words.emplace_back(line[i], number);
      i = static_cast<std::size_t>(end - line.data());
    } else {
      return std::nullopt;
    }
  }
  return words;
}

class Reader {
public:
  ReadMilling read(std::string_view text) {
    for (std::size_t from = 0; from < text.size();) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      ++line_;
      take(text.substr(from, end - from));
      from = end + 1;
    }
    return std::move(out_);
  }

private:
  void defect(base::Message reason) { out_.defects.push_back({line_, std::move(reason)}); }

  void take(std::string_view text) {
    const std::optional<Words> words = wordsOf(text);
    if (!words)
      return defect("not understood"_text);
    if (words->empty())
      return;
    if (out_.complete)
      return defect("behind the end of the program"_text);
    bool isMachine = false;
    std::map<char, double> axes;
    for (const auto& [letter, number] : *words)
      if (letter == 'G')
        isMachine = code(number) || isMachine;
      else if (letter == 'M')
        function(number);
      else if (letter == 'S')
        speed_ = number;
      else if (letter == 'F')
        feed_ = number;
      else if (letter == 'X' || letter == 'Y' || letter == 'Z' || letter == 'A')
        axes[letter] = number;
      else
        defect(base::message("unknown word {word}"_text, std::string(1, letter)));
    if (!axes.empty())
      move(axes, isMachine);
  }

  // Returns whether the line is in the machine's own coordinates.
  bool code(double number) {
    constexpr double kMachine = 53.0;
    if (number == 0.0 || number == 1.0)
      rapid_ = number == 0.0;
    else if (number == 54.0 || number == 55.0)
      system_ = static_cast<int>(number);
    else if (number != 21.0 && number != 90.0 && number != 94.0 && number != kMachine)
      defect(base::message("unknown word {word}"_text, "G" + std::to_string(std::lround(number))));
    return number == kMachine;
  }

  void function(double number) {
    if (number == 3.0)
      isTurning_ = true;
    else if (number == 5.0)
      isTurning_ = false;
    else if (number == 30.0)
      out_.complete = true;
    else
      defect(base::message("unknown word {word}"_text, "M" + std::to_string(std::lround(number))));
  }

  void move(const std::map<char, double>& axes, bool isMachine) {
    ReadMove m{.line = line_,
               .to = at_,
               .rapid = rapid_,
               .home = isMachine,
               .turned = isTurned_,
               .feedMmPerMin = feed_,
               .rpm = isTurning_ ? speed_ : 0.0};
    if (const auto turn = axes.find('A'); turn != axes.end()) {
      if (!isHome_)
        defect("the block turns while the cutter is not home"_text);
      if (turn->second != 0.0 && turn->second != 180.0)
        defect("the block is turned by neither 0 nor 180 degrees"_text);
      isTurned_ = turn->second == 180.0;
      return;
    }
    if (isMachine) {
      isHome_ = true;
      m.home = true;
      out_.moves.push_back(m);
      return;
    }
    if ((system_ == 55) != isTurned_ || system_ == 0)
      defect("coordinates of another side"_text);
    for (const auto& [letter, number] : axes)
      at_[letter - 'X'] = number;
    m.to = at_;
    isHome_ = false;
    out_.moves.push_back(m);
  }

  ReadMilling out_;
  std::size_t line_ = 0;
  Eigen::Vector3d at_ = Eigen::Vector3d::Zero();
  double feed_ = 0.0, speed_ = 0.0;
  int system_ = 0;
  bool rapid_ = true, isTurning_ = false, isTurned_ = false, isHome_ = false;
};

} // namespace

ReadMilling readMilling(std::string_view text) {
  return Reader().read(text);
}

} // namespace voluta::milling

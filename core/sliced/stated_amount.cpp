#include "sliced/stated_amount.h"

#include "program/common/program_text.h"
#include "program/gcode/gcode_line.h"
#include "sliced/gcode_command.h"

#include <algorithm>
#include <map>

namespace voluta::sliced {

namespace {

class Count {
public:
  explicit Count(const SlicedHeader& header) : header_(header), volumetric_(header.volumetric) {}

  void take(const GcodeCommand& command) {
    if (command.letter == 'T')
      tool_ = toolNumber(command.number).value_or(tool_);
    else if (command.letter == 'G')
      takeG(command);
    else if (command.letter == 'M')
      takeM(command);
  }
  double sum() const { return sum_; }

private:
  void takeG(const GcodeCommand& command) {
    const double g = command.number;
    if (g == 20.0 || g == 21.0)
      unit_ = g == 20.0 ? 25.4 : 1.0;
    else if (g == 90.0 || g == 91.0)
      relative_ = g == 91.0;
    program::GcodeWords words;
    const bool isMotion = g == 0.0 || g == 1.0 || g == 2.0 || g == 3.0;
    if ((!isMotion && g != 92.0) || !program::wordsOf(command.text, words))
      return;
    if (g == 92.0) {
      if (words['E'] || !words.any("XYZC"))
        at_ = unit_ * words['E'].value_or(0.0);
    } else if (words['E']) {
      const double value = unit_ * *words['E'];
      const double length = relative_ || relativeE_ ? value : value - at_;
      at_ += length;
      feed(length);
    }
  }

  void takeM(const GcodeCommand& command) {
    program::GcodeWords change;
    if (command.number == 6.0 && program::wordsOf(command.text, change) && change['T'])
      tool_ = toolNumber(*change['T']).value_or(tool_);
    if (command.number == 82.0 || command.number == 83.0) {
      relativeE_ = command.number == 83.0;
    } else if (command.number == 200.0 || command.number == 221.0) {
      program::GcodeWords words;
      if (!program::wordsOf(command.text, words))
        return;
      if (command.number == 200.0 && words['D'])
        volumetric_ = *words['D'] > 0.0;
      else if (command.number == 221.0 && words['S'] && *words['S'] > 0.0)
        flows_[words['T'] ? toolNumber(*words['T']).value_or(tool_) : tool_] = *words['S'] / 100.0;
    }
  }

  void feed(double length) {
    auto& [fed, maxFed] = nozzles_[header_.oneNozzle ? 0 : tool_];
    fed += length;
    const auto flow = flows_.find(tool_);
    sum_ += (flow == flows_.end() ? 1.0 : flow->second) * header_.amountShare(tool_, volumetric_) *
            std::max(0.0, fed - maxFed);
    maxFed = std::max(maxFed, fed);
  }

  const SlicedHeader& header_;
  bool volumetric_, relative_ = false, relativeE_ = false;
  double unit_ = 1.0, at_ = 0.0, sum_ = 0.0;
  int tool_ = 0;
  std::map<int, double> flows_;                      // of tools
  std::map<int, std::pair<double, double>> nozzles_; // fed in all, and the most of it so far
};
} // namespace

double statedAmount(std::string_view text, const SlicedHeader& header) {
  Count count(header);
  program::LineReader lines(text);
  std::string_view line;
  while (lines.next(line))
    for (GcodeCommand command = commandOf(line); !command.text.empty();
         command = commandOf(command.next))
      count.take(command);
  return count.sum();
}

} // namespace voluta::sliced

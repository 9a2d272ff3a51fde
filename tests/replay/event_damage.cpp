#include "replay/event_damage.h"

#include "program/common/program_text.h"
#include "program/dialect.h"
#include "program/own_lines.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <optional>
#include <regex>

namespace voluta::test {

namespace {

using Lines = std::vector<std::string>;

std::ptrdiff_t at(std::size_t line) {
  return static_cast<std::ptrdiff_t>(line);
}

// The step of a line that MELFA-BASIC numbers.
std::string stepOf(const std::string& line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  return digits > 0 && digits < line.size() && line[digits] == ' ' ? line.substr(0, digits + 1)
                                                                   : std::string();
}

class Damages {
public:
  Damages(const ProgramText& whole, const std::vector<EventBlock>& blocks,
          const std::vector<std::size_t>& motions)
      : whole_(whole), blocks_(blocks), motions_(motions),
        remark_(program::findDialect(whole.format).remark) {}

  std::vector<EventDamage> all() {
    for (const EventBlock& block : blocks_) {
      ofBlock(block);
      for (std::size_t l = block.first; l < block.end; ++l)
        if (!program::trimmed(bare(l)).empty())
          ofLine(l, block);
    }
    for (std::size_t b = 0; b + 1 < blocks_.size(); ++b)
      ofTwo(blocks_[b], blocks_[b + 1]);
    return std::move(found_);
  }

private:
  std::string bare(std::size_t l) const {
    return whole_.lines[l].substr(stepOf(whole_.lines[l]).size());
  }
  bool isRemark(std::size_t l) const { return program::trimmed(bare(l)).starts_with(remark_); }
  // Speeds, blends and the flow of the next motion, which are judged with that motion.
  bool isOfMotion(std::size_t l) const {
    static const std::regex kSettings(
        R"(analog_out|ANOUT|aoFlow|AIO_Out|M_Outw|\.AO\[|\$VEL|APO\.CDIS)"
        R"(|SpeedS|AccelS|Spd |Cnt |Speed [0-9]|JOvrd)");
    return std::regex_search(whole_.lines[l], kSettings);
  }
  bool isMark(std::size_t l) const {
    return whole_.lines[l].find(program::kOwnLineMark) != std::string::npos;
  }

  // Steps are numbered anew, as an editor does it.
  void add(const std::string& kind, std::size_t line, Lines lines) {
    if (lines == whole_.lines)
      return;
    std::size_t step = 0;
    for (std::string& one : lines)
      if (const std::string old = stepOf(one); !old.empty() && whole_.format == "melfa")
        one = std::to_string(++step) + " " + one.substr(old.size());
    found_.push_back({kind, {whole_.format, whole_.name, std::move(lines)}, whole_.lines[line]});
  }
  void replace(const std::string& kind, std::size_t l, const std::string& code) {
    Lines lines = whole_.lines;
    lines[l] = stepOf(lines[l]) + code;
    add(kind, l, std::move(lines));
  }
  void move(const std::string& kind, std::size_t first, std::size_t end, std::size_t to) {
    Lines lines = whole_.lines;
    const Lines moved(lines.begin() + at(first), lines.begin() + at(end));
    if (to >= end) {
      lines.insert(lines.begin() + at(to), moved.begin(), moved.end());
      lines.erase(lines.begin() + at(first), lines.begin() + at(end));
    } else {
      lines.erase(lines.begin() + at(first), lines.begin() + at(end));
      lines.insert(lines.begin() + at(to), moved.begin(), moved.end());
    }
    add(kind, first, std::move(lines));
  }
  // The line behind the motion that is `count` motions behind a line, or before it.
  std::optional<std::size_t> behindMotion(std::size_t line, std::ptrdiff_t count) const {
    const auto next = std::ranges::lower_bound(motions_, line) - motions_.begin() + count;
    if (next < 1 || next > static_cast<std::ptrdiff_t>(motions_.size()) - 1)
      return std::nullopt;
    return motions_[static_cast<std::size_t>(next - 1)] + 1;
  }

  void ofBlock(const EventBlock& block) {
    Lines lines = whole_.lines;
    lines.erase(lines.begin() + at(block.first), lines.begin() + at(block.end));
    add("stop deleted", block.first, lines);
    lines = whole_.lines;
    lines.insert(lines.begin() + at(block.end), whole_.lines.begin() + at(block.first),
                 whole_.lines.begin() + at(block.end));
    add("stop doubled", block.first, lines);
    lines = whole_.lines;
    std::reverse(lines.begin() + at(block.first), lines.begin() + at(block.end));
    add("stop in reverse order", block.first, lines);
    for (const int count : {1, 3})
      if (const auto to = behindMotion(block.end, count))
        move("stop " + std::to_string(count) + " later", block.first, block.end, *to);
    for (const int count : {-1, -3})
      if (const auto to = behindMotion(block.first, count))
        move("stop " + std::to_string(-count) + " earlier", block.first, block.end, *to);
  }

  void ofTwo(const EventBlock& a, const EventBlock& b) {
    const auto& w = whole_.lines;
    Lines lines(w.begin(), w.begin() + at(a.first));
    lines.insert(lines.end(), w.begin() + at(b.first), w.begin() + at(b.end));
    lines.insert(lines.end(), w.begin() + at(a.end), w.begin() + at(b.first));
    lines.insert(lines.end(), w.begin() + at(a.first), w.begin() + at(a.end));
    lines.insert(lines.end(), w.begin() + at(b.end), w.end());
    add("stops exchanged", a.first, std::move(lines));
    for (std::size_t l = a.first; l < a.end; ++l)
      for (std::size_t k = b.first; k < b.end; ++k)
        if (!isRemark(l) && !isRemark(k) && !isOfMotion(l) && !isOfMotion(k) &&
            bare(l) != bare(k)) {
          lines = whole_.lines;
          std::swap(lines[l], lines[k]);
          add("lines of two stops exchanged", l, std::move(lines));
        }
    for (std::size_t l = a.first; l < a.end; ++l)
      if (!isRemark(l) && !isOfMotion(l)) {
        lines = whole_.lines;
        lines.insert(lines.begin() + at(b.end), whole_.lines[l]);
        add("copied to another stop", l, std::move(lines));
      }
  }

  void ofLine(std::size_t l, const EventBlock& block) {
    if ((isRemark(l) && !isMark(l)) || isOfMotion(l))
      return;
    Lines lines = whole_.lines;
    lines.erase(lines.begin() + at(l));
    add(isMark(l) ? "mark deleted" : "deleted", l, lines);
    lines = whole_.lines;
    lines.insert(lines.begin() + at(l), lines[l]);
    add(isMark(l) ? "mark doubled" : "doubled", l, lines);
    const std::string code = bare(l);
    if (isMark(l)) {
      replace("mark changed", l, std::regex_replace(code, std::regex("asked"), "wished"));
      for (std::size_t k = block.first; k < block.end; ++k)
        if (k != l && k != l + 1 && !isRemark(k)) {
          lines = whole_.lines;
          lines.insert(lines.begin() + at(k), lines[l]);
          add("marked as the user's own", k, lines);
        }
      return;
    }
    replace("commented out", l, std::string(remark_) + " " + code);
    if (l + 1 < block.end && !isOfMotion(l + 1)) {
      lines = whole_.lines;
      std::swap(lines[l], lines[l + 1]);
      add("exchanged with the next line", l, lines);
    }
    for (const int count : {1, 2, 6})
      if (const auto to = behindMotion(l, count))
        move(std::to_string(count) + " motions later", l, l + 1, *to);
    for (const int count : {-1, -2, -6})
      if (const auto to = behindMotion(l, count))
        move(std::to_string(-count) + " motions earlier", l, l + 1, *to);
    move("to the first motion", l, l + 1, motions_.front() + 1);
    move("to the last motion", l, l + 1, motions_.back());
    for (std::size_t k = block.first; k < block.end; ++k)
      if (k != l && k != l + 1)
        move("within the stop", l, l + 1, k);
    numbers(l);
    words(l, code);
    texts(l, code);
  }

  void numbers(std::size_t l) {
    const std::string line = whole_.lines[l];
    const std::size_t step = stepOf(line).size();
    using Change = std::pair<const char*, std::function<double(double)>>;
    const Change changes[] = {
        {"greater number", [](double v) { return v + std::max(1.0, 0.25 * v); }},
        {"smaller number", [](double v) { return v - std::max(1.0, 0.25 * v); }},
        {"number doubled", [](double v) { return 2.0 * v; }},
        {"a tenth of the number", [](double v) { return 0.1 * v; }},
        {"number 0", [](double) { return 0.0; }},
        {"number negative", [](double v) { return -v; }}};
    for (const auto& where : numbersIn(line))
      if (where.first >= step)
        for (const auto& [kind, change] : changes) {
          const double old = std::strtod(line.c_str() + where.first, nullptr);
          if (change(old) == old)
            continue;
          std::string number = program::fixedText(change(old), 4);
          Lines lines = whole_.lines;
          lines[l].replace(where.first, where.second - where.first, number);
          add(kind, l, std::move(lines));
        }
  }

  void words(std::size_t l, const std::string& code) {
    const std::pair<const char*, const char*> states[] = {{"True", "False"}, {"TRUE", "FALSE"},
                                                          {",1;", ",0;"},    {"=1", "=0"},
                                                          {"S255", "S0"},    {"On ", "Off "}};
    for (const auto& [on, off] : states) {
      const auto exchange = [&](const char* from, const char* to) {
        if (const std::size_t found = code.find(from); found != std::string::npos) {
          std::string other = code;
          replace("on and off exchanged", l, other.replace(found, std::string(from).size(), to));
        }
      };
      exchange(on, off);
      exchange(off, on);
    }
    const std::size_t letter = static_cast<std::size_t>(
        std::ranges::find_if(code, [](unsigned char c) { return std::isalpha(c) != 0; }) -
        code.begin());
    if (letter >= code.size())
      return;
    std::string other = code;
    other.erase(letter, 1);
    replace("first letter lost", l, other);
    other = code;
    other[letter] = other[letter] == 'X' ? 'Y' : 'X';
    replace("another first letter", l, other);
    other = code;
    while (!other.empty() && std::isspace(static_cast<unsigned char>(other.back())) != 0)
      other.pop_back();
    other.pop_back();
    replace("last character lost", l, other);
    replace("half of the line lost", l, code.substr(0, letter + (code.size() - letter) / 2));
  }

  void texts(std::size_t l, const std::string& code) {
    const std::size_t from = code.find("Put in"), other = code.find("Turn the");
    const std::size_t text = std::min(from, other);
    if (text == std::string::npos)
      return;
    const auto with = [&](std::size_t count, std::string_view words) {
      std::string changed = code;
      return changed.replace(text, count, words);
    };
    replace("another letter in the text", l, with(1, "B"));
    replace("small letter in the text", l, with(1, from == text ? "p" : "t"));
    replace("word of the text lost", l, with(4, ""));
    replace("another text", l, with(6, "Take out"));
    replace("text begins with a blank", l, with(0, " "));
    replace("text begins with a word more", l, with(0, "Do not "));
    const std::size_t end = code.find('(', text);
    if (end != std::string::npos) {
      std::string changed = code;
      replace("layer of the text lost", l, changed.erase(end, code.find(')', end) - end + 1));
    }
    Lines lines = whole_.lines;
    lines.insert(lines.begin() + at(l), stepOf(lines[l]) + with(6, "Take out"));
    add("a second text before", l, std::move(lines));
  }

  const ProgramText& whole_;
  const std::vector<EventBlock>& blocks_;
  const std::vector<std::size_t>& motions_;
  std::string_view remark_;
  std::vector<EventDamage> found_;
};

} // namespace

std::vector<EventDamage> eventDamage(const ProgramText& whole,
                                     const std::vector<EventBlock>& blocks,
                                     const std::vector<std::size_t>& motions) {
  return Damages(whole, blocks, motions).all();
}

} // namespace voluta::test

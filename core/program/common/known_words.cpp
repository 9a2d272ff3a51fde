#include "program/common/known_words.h"

#include <algorithm>

namespace voluta::program {

const KnownWord* findWord(std::span<const KnownWord> table, std::string_view word) {
  const auto row = std::find_if(table.begin(), table.end(),
                                [&](const KnownWord& known) { return known.word == word; });
  return row == table.end() ? nullptr : &*row;
}

void WordPlaces::word(std::string_view word, std::uint8_t places, std::size_t file,
                      std::size_t line, bool extruderOn) {
  const std::uint8_t here = !moved_      ? kBeforeMotion
                            : extruderOn ? kDuringPrintOn
                            : deposited_ ? kDuringPrintOff
                                         : kBeforeMaterial;
  if ((places & here) != 0)
    return;
  if ((places & kAtEnd) != 0 && !extruderOn)
    waiting_.push_back({std::string(word), file, line});
  else
    refuse(word, file, line);
}

void WordPlaces::motion() {
  for (const Waiting& w : waiting_)
    refuse(w.word, w.file, w.line);
  waiting_.clear();
  moved_ = true;
}

void WordPlaces::material() {
  deposited_ = true;
}

void WordPlaces::refuse(std::string_view word, std::size_t file, std::size_t line) {
  defects_.add(
      file, line,
      base::message("'{word}' is not allowed here: it changes the machine during the print"_text,
                    word.substr(0, 40)));
}

} // namespace voluta::program

// One sheet to hand over, as data: what it says and shows, in reading order. Two writers lay it out
// alike on A4: HTML for a browser, PDF for a printer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voluta::page {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};
// "#rrggbb".
std::string hex(Colour colour);

enum class Mark : std::uint8_t { Passed, Failed, Note };

struct Picture {
  std::string png; // bytes
  std::string caption;
};

struct Fact {
  std::string label, value;
};

// One thing that was checked: the sentence with figure and limit, and where it is at its worst.
struct Check {
  Mark mark = Mark::Note;
  std::string sentence, place;
};

struct Swatch {
  Colour colour;
  std::string label;
};
// A picture of square cells, each with the colour of a swatch. Rows from the top.
struct CellMap {
  static constexpr int kNothing = -1;
  int width = 0, height = 0;
  std::vector<int> swatch; // index, or kNothing
  std::string caption;
};

struct HashedFile {
  std::string name, detail, sha256;
};

struct Sheet {
  std::string language = "en"; // BCP 47
  std::string title, issued;   // issued: by what program, when
  Mark verdictMark = Mark::Passed;
  std::string verdict, verdictDetail;
  std::vector<Picture> pictures;
  std::vector<Fact> facts;
  std::string checksTitle;
  std::vector<Check> checks;
  std::string mapsTitle;
  std::vector<CellMap> maps;
  std::vector<Swatch> legend;
  std::string filesTitle;
  std::vector<HashedFile> files;
  std::string footer;
};

// Stands alone: styles and pictures are inside.
std::string html(const Sheet& sheet);
// Files that do not fit on the first page go on on the next. Throws Error{CannotWrite}.
std::string pdf(const Sheet& sheet);

// What both writers share.
struct SheetColours {
  Colour ink{0x1c, 0x23, 0x2b}, quiet{0x5d, 0x67, 0x73}, rule{0xd4, 0xda, 0xe0};
  Colour passed{0x1b, 0x6b, 0x4a}, failed{0xa8, 0x2a, 0x2a}, note{0x5d, 0x67, 0x73};
  Colour passedBack{0xe7, 0xf3, 0xed}, failedBack{0xf9, 0xe8, 0xe8};

  Colour of(Mark mark) const {
    return mark == Mark::Passed ? passed : mark == Mark::Failed ? failed : note;
  }
};

} // namespace voluta::page

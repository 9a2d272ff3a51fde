// A one-page report as data, in reading order. Two writers lay it out alike on A4: HTML for a
// browser, PDF for a printer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace voluta::page {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};
// Returns "#rrggbb".
std::string hex(Colour colour);

enum class Mark : std::uint8_t { Passed, Caution, Failed, Note };
// Returns one character that stands for the mark, in UTF-8.
const char* signOf(Mark mark);

struct Picture {
  std::string png; // Bytes of a PNG file
  std::string caption;
};

struct Fact {
  std::string label, value;
};

// One check: its sentence with figure and limit, and its worst place.
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
  std::vector<int> swatch; // Index, or kNothing
  std::string caption;
};

struct HashedFile {
  std::string name, detail, sha256;
};

struct Sheet {
  std::string language = "en"; // BCP 47
  std::string title, issued;   // issued: program and date
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

// Returns a self-contained page, with styles and pictures embedded.
std::string html(const Sheet& sheet);
// Files that do not fit on the first page continue on the next. Throws Error{CannotWrite}.
std::string pdf(const Sheet& sheet);

// Shared by both writers.
struct SheetColours {
  Colour ink{0x1c, 0x23, 0x2b}, quiet{0x5d, 0x67, 0x73}, rule{0xd4, 0xda, 0xe0};
  Colour passed{0x1b, 0x6b, 0x4a}, caution{0x8a, 0x5a, 0x00}, failed{0xa8, 0x2a, 0x2a},
      note{0x5d, 0x67, 0x73};
  Colour passedBack{0xe7, 0xf3, 0xed}, cautionBack{0xfb, 0xf1, 0xdc}, failedBack{0xf9, 0xe8, 0xe8};

  Colour of(Mark mark) const {
    return mark == Mark::Passed    ? passed
           : mark == Mark::Caution ? caution
           : mark == Mark::Failed  ? failed
                                   : note;
  }
  Colour backOf(Mark mark) const {
    return mark == Mark::Failed ? failedBack : mark == Mark::Caution ? cautionBack : passedBack;
  }
};

} // namespace voluta::page

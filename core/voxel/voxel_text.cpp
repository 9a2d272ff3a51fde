#include "voxel/voxel_text.h"

#include "base/error.h"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace voluta::voxel {

namespace {
using base::Error;
using base::ErrorCode;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlank = " \t\r\v\f";

struct Row {
  std::string_view cells;
  std::size_t line = 0; // From 1
};
using Slice = std::vector<Row>;

base::Message place(const std::string& name, std::size_t line, std::size_t column) {
  return base::message("{file}, line {line}, column {column}"_text, name, std::to_string(line),
                       std::to_string(column + 1));
}

// Removes the next line from the text and returns it without trailing white space.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  const std::size_t last = line.find_last_not_of(kBlank);
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

base::Message quoted(char c) {
  if (c == ' ')
    return "a space"_text;
  const auto code = static_cast<unsigned char>(c);
  return code > 32 && code < 127 ? base::message("'{character}'"_text, std::string(1, c))
                                 : base::message("byte {code}"_text, fmt::format("{:#04x}", code));
}

void checkRow(const Row& row, const Row& first, const std::string& name) {
  const std::size_t invalid = row.cells.find_first_not_of("01-");
  if (invalid != std::string_view::npos)
    throw Error(ErrorCode::UnreadableFile,
                base::message("{found} is none of 0, 1 and -"_text, quoted(row.cells[invalid])),
                place(name, row.line, invalid),
                "write 1 for the part, 0 for air, - for the platform"_text);
  if (row.cells.size() != first.cells.size())
    throw Error(ErrorCode::UnreadableFile,
                base::message("the row has {cells} cells, the first one {first}"_text,
                              row.cells.size(), first.cells.size()),
                place(name, row.line, std::min(row.cells.size(), first.cells.size())),
                "make all rows equally long"_text);
}

std::vector<Slice> slicesOf(std::string_view text, const std::string& name) {
  if (text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  std::vector<Slice> slices;
  const auto checkSlice = [&](std::size_t line) {
    if (slices.size() > 1 && slices.back().size() != slices.front().size())
      throw Error(
          ErrorCode::UnreadableFile,
          base::message("slice {slice} ends after {rows} rows, the first one after {first}"_text,
                        slices.size(), slices.back().size(), slices.front().size()),
          place(name, line, 0), "give all slices the same number of rows"_text);
  };
  std::size_t line = 0, cells = 0;
  bool within = false;
  while (!text.empty()) {
    ++line;
    const Row row{takeLine(text), line};
    if (row.cells.empty()) {
      if (within)
        checkSlice(line - 1);
      within = false;
      continue;
    }
    if (!within)
      slices.emplace_back();
    within = true;
    slices.back().push_back(row);
    checkRow(row, slices.front().front(), name);
    cells += row.cells.size();
    constexpr auto kSide = static_cast<std::size_t>(kLargestSide);
    if (cells > kLargestObject || row.cells.size() > kSide || slices.size() > kSide ||
        slices.back().size() > kSide)
      throw Error(
          ErrorCode::UnusableInput, "the object is too large"_text,
          place(name, line, std::min(row.cells.size(), kSide)),
          base::message("use at most {side} cells a side and {millions} million in all"_text,
                        kLargestSide, kLargestObject / 1'000'000));
  }
  if (within)
    checkSlice(line);
  if (slices.empty())
    throw Error(ErrorCode::UnusableInput, "the file contains no cells"_text, name,
                "write rows of 0 and 1, and - for the platform"_text);
  return slices;
}

bool has(const Slice& slice, char c) {
  return std::any_of(slice.begin(), slice.end(),
                     [&](const Row& row) { return row.cells.find(c) != std::string_view::npos; });
}

// One interpretation of slices, rows and columns as x, y and levels from the top down.
struct Layout {
  const std::vector<Slice>& slices;
  bool flat;      // Slices are layers
  bool downwards; // flat: the first slice is the highest one

  int across() const { return static_cast<int>(slices[0][0].cells.size()); }
  int deep() const { return static_cast<int>(flat ? slices[0].size() : slices.size()); }
  int levels() const { return static_cast<int>(flat ? slices.size() : slices[0].size()); }
  // Returns the row of cells at y = j in the n-th level from above.
  const Row& row(int j, int n) const {
    const auto y = static_cast<std::size_t>(j), level = static_cast<std::size_t>(n);
    if (!flat)
      return slices[y][level];
    const Slice& slice = downwards ? slices[level] : slices[slices.size() - 1 - level];
    return slice[slice.size() - 1 - y];
  }
  template <typename Visit> void each(int level, char wanted, Visit&& visit) const {
    for (int j = 0; j < deep(); ++j) {
      const Row& r = row(j, level);
      for (std::size_t i = r.cells.find(wanted); i != std::string_view::npos;
           i = r.cells.find(wanted, i + 1))
        visit(static_cast<int>(i), j, r.line);
    }
  }
};

Layout layoutOf(const std::vector<Slice>& slices) {
  const auto platforms = static_cast<std::size_t>(std::count_if(
      slices.begin(), slices.end(), [](const Slice& slice) { return has(slice, '-'); }));
  const auto isPlatform = [&](const Slice& slice) { return has(slice, '-') && !has(slice, '1'); };
  const bool flat = slices.size() > 1 && platforms == 1 &&
                    (isPlatform(slices.front()) || isPlatform(slices.back()));
  return {slices, flat, flat && isPlatform(slices.back())};
}

} // namespace

VoxelObject readVoxelText(std::string_view text, const std::string& name) {
  const std::vector<Slice> slices = slicesOf(text, name);
  const Layout layout = layoutOf(slices);
  const auto any = [&](int level, char c) {
    bool found = false;
    layout.each(level, c, [&](int, int, std::size_t) { found = true; });
    return found;
  };
  const int levels = layout.levels();
  int top = 0;
  while (top < levels && !any(top, '-'))
    ++top;
  if (top == levels)
    throw Error(ErrorCode::UnusableInput, "there is no platform: no - in any row"_text,
                place(name, slices.back().back().line, 0),
                "add a row of - under the part, where it should be placed"_text);
  const int plate = any(top, '1') ? top + 1 : top; // The level below z = 0
  for (int level = plate; level < levels; ++level)
    layout.each(level, '1', [&](int i, int, std::size_t line) {
      throw Error(ErrorCode::UnusableInput, "the part reaches below the platform"_text,
                  place(name, line, static_cast<std::size_t>(i)),
                  "put - only under the part or beside its lowest row"_text);
    });

  VoxelObject object;
  object.size = {layout.across(), layout.deep(), plate};
  object.solid.assign(static_cast<std::size_t>(object.size.x()) *
                          static_cast<std::size_t>(object.size.y()) *
                          static_cast<std::size_t>(object.size.z()),
                      0);
  std::size_t count = 0;
  for (int level = 0; level < plate; ++level)
    layout.each(level, '1', [&](int i, int j, std::size_t) {
      object.solid[object.index(i, j, plate - 1 - level)] = 1;
      ++count;
    });
  std::size_t platformLine = 0;
  layout.each(top, '-', [&](int i, int j, std::size_t line) {
    object.platform.push_back({i, j});
    platformLine = line;
  });
  if (count == 0)
    throw Error(ErrorCode::UnusableInput, "no part: no 1 above the platform"_text, name,
                "write 1 where the part is"_text);
  if (!any(plate - 1, '1'))
    throw Error(ErrorCode::UnusableInput, "nothing is on the platform"_text,
                place(name, platformLine, static_cast<std::size_t>(object.platform.back()[0])),
                "put - directly under the part"_text);
  return object;
}

std::string writeVoxelText(const VoxelObject& object) {
  std::string text;
  for (int j = 0; j < object.size.y(); ++j) {
    if (j > 0)
      text += '\n';
    for (int k = object.size.z() - 1; k >= 0; --k) {
      for (int i = 0; i < object.size.x(); ++i)
        text += object.solid[object.index(i, j, k)] ? '1' : '0';
      text += '\n';
    }
    std::string ground(static_cast<std::size_t>(object.size.x()), '0');
    for (const auto& column : object.platform)
      if (column[1] == j)
        ground[static_cast<std::size_t>(column[0])] = '-';
    text += ground + '\n';
  }
  return text;
}

bool looksLikeVoxelText(std::string_view text) {
  if (text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  while (!text.empty())
    if (const std::string_view line = takeLine(text); !line.empty())
      return line.find_first_not_of("01-") == std::string_view::npos;
  return false;
}

} // namespace voluta::voxel

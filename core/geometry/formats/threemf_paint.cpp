#include "geometry/formats/threemf_paint.h"

#include <algorithm>
#include <array>

namespace voluta::geometry {

namespace {

struct PaintRow {
  std::string_view attribute;
  base::Text word;
  std::string_view setting = {};
};

// Attributes of PrusaSlicer, and of Bambu Studio and OrcaSlicer.
constexpr std::array<PaintRow, 8> kPaints{
    {{"custom_supports", "painted supports"_text, "paint_supports"},
     {"paint_supports", "painted supports"_text, "paint_supports"},
     {"custom_seam", "a painted seam"_text, "paint_seam"},
     {"paint_seam", "a painted seam"_text, "paint_seam"},
     {"mmu_segmentation", "painted colours"_text, "paint_color"},
     {"paint_color", "painted colours"_text, "paint_color"},
     {"fuzzy_skin", "a painted fuzzy skin"_text},
     {"paint_fuzzy_skin", "a painted fuzzy skin"_text}}};

const PaintRow* rowOf(std::string_view attribute) {
  const auto* row = std::ranges::find(kPaints, attribute, &PaintRow::attribute);
  return row == kPaints.end() ? nullptr : row;
}

std::optional<int> digitOf(char c) {
  if (c >= '0' && c <= '9')
    return c - '0';
  if (c >= 'A' && c <= 'F')
    return c - 'A' + 10;
  if (c >= 'a' && c <= 'f')
    return c - 'a' + 10;
  return std::nullopt;
}

class PaintReader {
public:
  explicit PaintReader(std::string_view code) : left_(code) {}

  std::optional<std::vector<PaintedFacet>> read(const Facet& facet) {
    if (!addPiece(facet, 0) || !left_.empty())
      return std::nullopt;
    return std::move(out_);
  }

private:
  std::optional<int> next() {
    if (left_.empty())
      return std::nullopt;
    const std::optional<int> digit = digitOf(left_.back());
    left_.remove_suffix(1);
    return digit;
  }

  // Returns false if the code is damaged.
  bool addPiece(const Facet& facet, int depth) {
    constexpr int kDeepest = 40;
    const std::optional<int> digit = next();
    if (!digit || depth > kDeepest)
      return false;
    const int sides = *digit & 3, high = *digit >> 2;
    return sides == 0 ? addLeaf(facet, high) : addDivided(facet, sides, high, depth);
  }

  bool addLeaf(const Facet& facet, int state) {
    constexpr int kMore = 3, kFull = 15, kMost = 1000;
    if (state == kMore) {
      std::optional<int> digit = next();
      for (; digit == kFull && state < kMost; digit = next())
        state += kFull;
      if (!digit || state >= kMost)
        return false;
      state += *digit;
    }
    if (state > 0)
      out_.push_back({state, facet});
    return true;
  }

  bool addDivided(const Facet& facet, int sides, int first, int depth) {
    if (sides == 3)
      first = 0;
    else if (first > 2)
      return false;
    const auto corner = [&](int k) -> const Eigen::Vector3d& {
      return facet[static_cast<std::size_t>((first + k) % 3)];
    };
    const Eigen::Vector3d &a = corner(0), &b = corner(1), &c = corner(2);
    const Eigen::Vector3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    std::vector<Facet> pieces;
    if (sides == 1)
      pieces = {{a, b, bc}, {bc, c, a}};
    else if (sides == 2)
      pieces = {{a, ab, ca}, {ab, b, ca}, {b, c, ca}};
    else
      pieces = {{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}};
    return std::all_of(pieces.rbegin(), pieces.rend(),
                       [&](const Facet& piece) { return addPiece(piece, depth + 1); });
  }

  std::string_view left_;
  std::vector<PaintedFacet> out_;
};

} // namespace

base::Text paintWord(std::string_view attribute) {
  const PaintRow* row = rowOf(attribute);
  return row ? row->word : base::Text();
}

std::string_view paintSetting(std::string_view attribute) {
  const PaintRow* row = rowOf(attribute);
  return row ? row->setting : std::string_view();
}

std::optional<std::vector<PaintedFacet>> paintedFacets(std::string_view code, const Facet& facet) {
  return PaintReader(code).read(facet);
}

} // namespace voluta::geometry

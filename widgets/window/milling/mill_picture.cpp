#include "window/milling/mill_picture.h"

#include "milling/block_mesh.h"

#include <QCoreApplication>

namespace voluta::window {

using Eigen::Vector3d;
using milling::MillSide;
using milling::MillStep;

namespace {

constexpr std::size_t kMaxColumns = 160000; // of the milled block

struct Row {
  const char* name; // source text of the context "MillPicture"
  int colour;       // categorical; -1: grey
};
const std::array<Row, kMillLines> kRows{{
    {QT_TRANSLATE_NOOP("MillPicture", "Block"), -1},
    {QT_TRANSLATE_NOOP("MillPicture", "Rapid moves"), -1},
    {QT_TRANSLATE_NOOP("MillPicture", "Side A, roughing"), 0},
    {QT_TRANSLATE_NOOP("MillPicture", "Side A, finishing"), 1},
    {QT_TRANSLATE_NOOP("MillPicture", "Side B, roughing"), 2},
    {QT_TRANSLATE_NOOP("MillPicture", "Side B, finishing"), 3},
    {QT_TRANSLATE_NOOP("MillPicture", "Contour"), 4},
}};
const Row& rowOf(MillLines which) {
  return kRows[static_cast<std::size_t>(which)];
}

MillLines groupOf(MillSide side, MillStep step) {
  if (step == MillStep::Rapid)
    return MillLines::Rapid;
  if (side == MillSide::Contour)
    return MillLines::Contour;
  const bool isRough = step == MillStep::Roughing;
  if (side == MillSide::A)
    return isRough ? MillLines::RoughA : MillLines::FineA;
  return isRough ? MillLines::RoughB : MillLines::FineB;
}

std::vector<std::vector<Vector3d>> edgesOf(const Eigen::AlignedBox3d& box) {
  const auto at = [&](int corner) {
    return Vector3d(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  };
  std::vector<std::vector<Vector3d>> edges;
  for (int corner = 0; corner < 8; ++corner)
    for (const int axis : {1, 2, 4})
      if ((corner & axis) == 0)
        edges.push_back({at(corner), at(corner | axis)});
  return edges;
}

} // namespace

QString millLinesName(MillLines which) {
  return QCoreApplication::translate("MillPicture", rowOf(which).name);
}

scene::Colour millLinesColour(MillLines which) {
  constexpr scene::Colour kGrey{0.55, 0.55, 0.55};
  const int colour = rowOf(which).colour;
  return colour < 0 ? kGrey : scene::categoricalColour(colour);
}

MillPicture pictureOf(const geometry::TriangleMesh& part) {
  MillPicture picture;
  picture.part = scene::drawPart(part);
  for (std::size_t i = 0; i < kMillLines; ++i)
    picture.lines[i].colour = millLinesColour(static_cast<MillLines>(i));
  return picture;
}

MillPicture pictureOf(const pipeline::MilledPart& milled) {
  MillPicture picture = pictureOf(milled.part);
  if (milled.verdict.rest)
    picture.milled = scene::drawWithoutEdges(milling::meshOf(*milled.verdict.rest, kMaxColumns));
  const auto group = [&](MillLines which) -> auto& {
    return picture.lines[static_cast<std::size_t>(which)].lines;
  };
  group(MillLines::Block) = edgesOf(milled.plan.block);
  for (const milling::MillPasses& passes : milled.plan.sides) {
    const auto inA = [&](const Vector3d& p) {
      return passes.side == MillSide::A ? p : Vector3d(p.x(), -p.y(), -p.z());
    };
    std::optional<MillLines> last;
    for (std::size_t i = 1; i < passes.moves.size(); ++i) {
      const MillLines which = groupOf(passes.side, passes.moves[i].step);
      if (which != last)
        group(which).push_back({inA(passes.moves[i - 1].to)});
      group(which).back().push_back(inA(passes.moves[i].to));
      last = which;
    }
  }
  return picture;
}

} // namespace voluta::window

#include "replay/depositor.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "process/bead_model.h"
#include "replay/line_walk.h"
#include "replay/shot_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace voluta::replay {

namespace {

constexpr std::size_t kBatch = 2048; // pieces per batch of footprints; two batches are in memory
constexpr std::size_t kGrain = 64;
// Width of the margin beyond the w x h rectangle on either side, as a share of the width.
constexpr double kMargin = 0.25;

// A piece's contribution to one cell, in cell volumes: `bead` is its material; `rectangle` and
// `margin` are the geometric shares of the cell within the displacement rectangles.
struct Share {
  std::uint32_t cell;
  float bead, rectangle, margin;
};

// Returns whether a bead continues from one piece into the other without a sharp bend.
bool continues(const BeadPiece& from, const BeadPiece& to) {
  constexpr double kSharp = 0.5; // cosine of 60 degrees
  constexpr double kSameMm = 1e-6;
  const Eigen::Vector3d a = from.to - from.from, b = to.to - to.from;
  const double lengths = a.norm() * b.norm();
  return from.run == to.run && lengths > 1e-12 && (from.to - to.from).norm() < kSameMm &&
         a.dot(b) > kSharp * lengths;
}

// Scratch memory of one thread for the cells around a piece.
class FootprintMaker {
public:
  FootprintMaker(const voxel::VoxelGrid& grid, const DepositOptions& options)
      : grid_(grid), options_(options) {}

  // `before`, `after`: the adjoining pieces of the same bead, if any. Appends the piece's shares in
  // cell order; returns the bead's volume outside the grid, in cell volumes.
  double make(const BeadPiece& piece, const BeadPiece* before, const BeadPiece* after,
              std::vector<Share>& out) {
    const Eigen::Vector3d along = piece.to - piece.from;
    const double length = along.norm();
    const BeadSection section = sectionOf(piece, options_.widthMaxMm);
    const double cellVolume = std::pow(grid_.pitch, 3);
    const double bead = piece.volumeMm3 / cellVolume;
    if (length < 1e-9 || section.heightMm <= 0.0)
      return bead;
    const double w = section.widthMm, h = section.heightMm;
    // A section lower than planned keeps its bottom at the planned position.
    const double filled = 2.0 * h / (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
    const double step = grid_.pitch / options_.samplesPerCell;
    const int nw = std::max(6, static_cast<int>(std::ceil((1 + 2 * kMargin) * w / step)));
    const int nh = std::max(4, static_cast<int>(std::ceil(h / step)));

    const Eigen::Vector3d side0 = sideAt(piece.fromDirection, before ? *before : piece, piece),
                          side1 = sideAt(piece.toDirection, piece, after ? *after : piece);
    box(piece, side0, side1, w);

    const double inBead = tally({piece, side0, side1, {nw, nh}, w, h, filled});
    const double perSample = inBead == 0.0 ? 0.0 : bead / inBead;
    const double geometric =
        length * (1 + 2 * kMargin) * w * h / cellVolume / (static_cast<double>(nw) * nh);
    double outside = inBead == 0.0 ? bead : 0.0;
    std::size_t at = 0;
    for (int k = 0; k < size_.z(); ++k)
      for (int j = 0; j < size_.y(); ++j)
        for (int i = 0; i < size_.x(); ++i, ++at) {
          const Tally& t = tallies_[at];
          if (t[kOfMargin] == 0.0f)
            continue;
          const Eigen::Vector3i c = low_ + Eigen::Vector3i(i, j, k);
          if (!grid_.contains(c.x(), c.y(), c.z())) {
            outside += static_cast<double>(t[kOfBead]) * perSample;
            continue;
          }
          out.push_back({static_cast<std::uint32_t>(grid_.index(c.x(), c.y(), c.z())),
                         static_cast<float>(static_cast<double>(t[kOfBead]) * perSample),
                         static_cast<float>(static_cast<double>(t[kOfRectangle]) * geometric),
                         static_cast<float>(static_cast<double>(t[kOfMargin]) * geometric)});
        }
    return outside;
  }

private:
  // Weighted line counts of bead, rectangle and margin; a line's weight is the length it
  // represents.
  using Tally = Eigen::Array4f;
  enum : Eigen::Index { kOfBead, kOfRectangle, kOfMargin };
  // The volume around a piece, divided into lines along it: `counts` of them across and down.
  struct Slab {
    const BeadPiece& piece;
    Eigen::Vector3d side0, side1;
    Eigen::Vector2i counts;
    double width, height;
    // ratio of the section's height to the planned height; the section fills the lower part
    double filled;
  };

  // Returns the direction across the joint of two pieces: at a bend, the miter at which both end;
  // for a single piece, its perpendicular.
  static Eigen::Vector3d sideAt(const Eigen::Vector3d& direction, const BeadPiece& before,
                                const BeadPiece& after) {
    const auto across = [&](const BeadPiece& piece) -> Eigen::Vector3d {
      const Eigen::Vector3d along = piece.to - piece.from, side = direction.cross(along);
      const double n = side.norm();
      return n > 1e-9 * along.norm() ? Eigen::Vector3d(side / n) : direction.unitOrthogonal();
    };
    const Eigen::Vector3d first = across(before), second = across(after);
    return (first + second) / (1.0 + std::max(0.0, first.dot(second)));
  }

  void box(const BeadPiece& piece, const Eigen::Vector3d& side0, const Eigen::Vector3d& side1,
           double width) {
    Eigen::Array3d low = piece.from.array(), high = low;
    const double reach = (0.5 + kMargin) * width;
    const auto take = [&](const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                          const Eigen::Vector3d& side, double height) {
      for (const double s : {-reach, reach})
        for (const double d : {0.0, height}) {
          const Eigen::Array3d p = (tip + s * side - d * direction).array();
          low = low.min(p);
          high = high.max(p);
        }
    };
    take(piece.from, piece.fromDirection, side0, piece.fromHeightMm);
    take(piece.to, piece.toDirection, side1, piece.toHeightMm);
    // Directions are interpolated along the piece and may bulge beyond the corners at its ends.
    const Eigen::Vector3d slack = Eigen::Vector3d::Constant(0.5 * grid_.pitch);
    low_ = grid_.cellOf(Eigen::Vector3d(low) - slack);
    const Eigen::Vector3i top = grid_.cellOf(Eigen::Vector3d(high) + slack);
    size_ = top - low_ + Eigen::Vector3i::Ones();
    corner_ = grid_.origin + grid_.pitch * low_.cast<double>();
    tallies_.assign(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                        static_cast<std::size_t>(size_.z()),
                    Tally(Tally::Zero()));
  }

  // Counts lines into tallies_; returns how many of them belong to the bead.
  double tally(const Slab& slab) {
    const int nw = slab.counts.x(), nh = slab.counts.y();
    const auto inCells = [&](const Eigen::Vector3d& v) {
      return Eigen::Vector3f((v / grid_.pitch).cast<float>());
    };
    const Eigen::Vector3f from = inCells(slab.piece.from - corner_),
                          to = inCells(slab.piece.to - corner_), side0 = inCells(slab.side0),
                          side1 = inCells(slab.side1),
                          down0 = inCells(slab.piece.fromHeightMm * slab.piece.fromDirection),
                          down1 = inCells(slab.piece.toHeightMm * slab.piece.toDirection);
    const auto across = static_cast<float>((1 + 2 * kMargin) * slab.width),
               filled = static_cast<float>(slab.filled),
               halfWidth = static_cast<float>(0.5 * slab.width),
               height = static_cast<float>(slab.height);
    const float half = 0.5f * height, flat = halfWidth - half;
    // On a bend the outside is longer than the inside.
    const Eigen::Vector3d span = slab.piece.to - slab.piece.from;
    const auto widens = static_cast<float>(span.dot(slab.side1 - slab.side0) / span.squaredNorm());
    // Lines are shifted against each other by fractions related to the golden ratio, so that no row
    // of them is in step with the cells.
    constexpr float kR1 = 0.7548776662466927f, kR2 = 0.5698402909980532f;
    const Floats none = {};
    // The four lanes are a quarter of the width apart and so fall into different cells: no addition
    // has to wait for another one.
    const int quarter = (nw + kLanes - 1) / kLanes;
    const Floats first = static_cast<float>(quarter) * Floats{0.0f, 1.0f, 2.0f, 3.0f};
    for (int c = 0; c < nh; ++c)
      for (int b = 0; b < quarter; ++b) {
        const Floats row = none + static_cast<float>(c), column = static_cast<float>(b) + first;
        const Floats x =
            ((column + base::fractionOf(kR1 * row + kR2)) / static_cast<float>(nw) - 0.5f) * across;
        // There are no lines beyond the last one.
        const Floats share =
            column < static_cast<float>(nw) ? base::max(none, 1.0f + x * widens) : none;
        const Floats depth =
            (row + base::fractionOf(kR1 * column + kR2 * row)) / static_cast<float>(nh);
        const Floats below = 1.0f - filled + depth * filled; // from the tip, in heights
        const Floats off = depth * height - half, end = base::max(none, base::absOf(x) - flat);
        const Floats rectangle = base::absOf(x) <= halfWidth ? share : none;
        const Floats bead = end * end + off * off <= half * half ? share : none;
        Lines lines;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto axis = static_cast<Eigen::Index>(k);
          lines.from[k] = from[axis] + x * side0[axis] - below * down0[axis];
          lines.to[k] = to[axis] + x * side1[axis] - below * down1[axis];
        }
        std::array<Tally, kLanes> shares;
        for (int l = 0; l < kLanes; ++l)
          shares[static_cast<std::size_t>(l)] = Tally(bead[l], rectangle[l], share[l], 0.0f);
        alongLines(lines, size_, [&](Ints cell, Floats part) {
          for (int l = 0; l < kLanes; ++l)
            tallies_[static_cast<std::size_t>(cell[l])] +=
                part[l] * shares[static_cast<std::size_t>(l)];
        });
      }
    double inBead = 0.0;
    for (const Tally& t : tallies_)
      inBead += static_cast<double>(t[kOfBead]);
    return inBead;
  }

  const voxel::VoxelGrid& grid_;
  const DepositOptions& options_;
  Eigen::Vector3i low_ = Eigen::Vector3i::Zero(), size_ = Eigen::Vector3i::Zero();
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero(); // of low_
  std::vector<Tally> tallies_;
};

// Deposits pieces one after the other.
class Layer {
public:
  explicit Layer(BeadGrid& result) : result_(result) {}

  // Returns the volume that found no room, in cell volumes.
  double lay(const Share* shares, std::size_t count, std::uint32_t piece, bool ofPart) {
    placed_.assign(count, 0.0f);
    double left = 0.0;
    for (std::size_t s = 0; s < count; ++s)
      left += shares[s].bead - put(shares[s].cell, shares[s].bead, placed_[s]);
    left = displace(shares, count, left, &Share::rectangle);
    left = displace(shares, count, left, &Share::margin);
    for (std::size_t s = 0; s < count; ++s) {
      const std::uint32_t cell = shares[s].cell;
      if (ofPart)
        widenRectangle(cell, shares[s].rectangle);
      if (placed_[s] <= 0.0f)
        continue;
      if (!ofPart)
        result_.otherFill[cell] += placed_[s];
      if (result_.fill[cell] > 0.5f && result_.filler[cell] == 0)
        result_.filler[cell] = piece + 1;
    }
    return left;
  }

private:
  // Only the difference that the float actually changes by counts as deposited: nothing is lost to
  // rounding.
  double put(std::uint32_t cell, double amount, float& placed) {
    float& fill = result_.fill[cell];
    const float before = fill;
    fill = static_cast<float>(std::min(1.0, static_cast<double>(before) + amount));
    const double difference = static_cast<double>(fill) - static_cast<double>(before);
    placed += static_cast<float>(difference);
    return difference;
  }

  void widenRectangle(std::uint32_t cell, float by) {
    std::uint8_t& share = result_.rectangle[cell];
    share =
        static_cast<std::uint8_t>(std::min(255.0f, static_cast<float>(share) + 255.0f * by + 0.5f));
  }

  double displace(const Share* shares, std::size_t count, double left, float Share::*within) {
    if (left <= 1e-9)
      return left;
    room_.resize(count);
    double total = 0.0;
    for (std::size_t s = 0; s < count; ++s) {
      const double free = 1.0 - static_cast<double>(result_.fill[shares[s].cell]);
      room_[s] = std::clamp(static_cast<double>(shares[s].*within) - placed_[s], 0.0, free);
      total += room_[s];
    }
    if (total <= 0.0)
      return left;
    const double part = std::min(1.0, left / total);
    for (std::size_t s = 0; s < count; ++s)
      if (room_[s] > 0.0)
        left -= put(shares[s].cell, part * room_[s], placed_[s]);
    return left;
  }

  BeadGrid& result_;
  std::vector<float> placed_;
  std::vector<double> room_;
};

// Footprints of consecutive pieces.
struct Chunk {
  std::vector<Share> shares;
  std::vector<std::size_t> end; // of each piece's shares
  std::vector<double> outside;  // per piece, in cell volumes
};
using Batch = std::array<Chunk, kBatch / kGrain>;

// Computes the footprints of kGrain pieces from `begin` on.
void makeFootprints(Chunk& chunk, const std::vector<BeadPiece>& pieces, std::size_t begin,
                    const voxel::VoxelGrid& grid, const DepositOptions& options) {
  chunk.shares.clear();
  chunk.end.clear();
  chunk.outside.clear();
  FootprintMaker maker(grid, options);
  for (std::size_t i = begin; i < std::min(pieces.size(), begin + kGrain); ++i) {
    if (pieces[i].shot) { // depends on earlier material
      chunk.outside.push_back(0.0);
      chunk.end.push_back(chunk.shares.size());
      continue;
    }
    const BeadPiece* before =
        i > 0 && continues(pieces[i - 1], pieces[i]) ? &pieces[i - 1] : nullptr;
    const BeadPiece* after =
        i + 1 < pieces.size() && continues(pieces[i], pieces[i + 1]) ? &pieces[i + 1] : nullptr;
    chunk.outside.push_back(maker.make(pieces[i], before, after, chunk.shares));
    chunk.end.push_back(chunk.shares.size());
  }
}

// Deposits kBatch pieces from `first` on.
void layBatch(const Batch& batch, const std::vector<BeadPiece>& pieces, std::size_t first,
              Layer& layer, BeadGrid& result) {
  const double cellVolume = std::pow(result.grid.pitch, 3);
  for (std::size_t p = 0; first + p < std::min(pieces.size(), first + kBatch); ++p) {
    const Chunk& chunk = batch[p / kGrain];
    const std::size_t in = p % kGrain, begin = in == 0 ? 0 : chunk.end[in - 1];
    const BeadPiece& piece = pieces[first + p];
    const auto index = static_cast<std::uint32_t>(first + p);
    const double left =
        piece.shot ? fillFromTip(result, piece, index)
                   : chunk.outside[in] + layer.lay(chunk.shares.data() + begin,
                                                   chunk.end[in] - begin, index, piece.ofPart);
    result.pieceExcessMm3[first + p] = static_cast<float>(left * cellVolume);
    result.excessMm3 += left * cellVolume;
    result.depositedMm3 += piece.volumeMm3;
  }
}

} // namespace

BeadSection sectionOf(const BeadPiece& piece, double widthMaxMm) {
  const double height = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
  const double length = (piece.to - piece.from).norm();
  if (length < 1e-9 || piece.volumeMm3 <= 0.0f || height <= 0.0)
    return {0.0, 0.0};
  const double area = piece.volumeMm3 / length;
  if (area < base::kPi / 4.0 * height * height) {
    const double diameter = std::sqrt(4.0 * area / base::kPi);
    return {diameter, diameter};
  }
  return {std::min(process::widthOfArea(area, height), std::max(widthMaxMm, height)), height};
}

double widestOf(const BeadPiece& piece) {
  constexpr double kWidestMm = 10.0, kWidestHeights = 8.0;
  return std::max(kWidestMm, kWidestHeights * std::max(static_cast<double>(piece.fromHeightMm),
                                                       static_cast<double>(piece.toHeightMm)));
}

BeadGrid depositBeads(const voxel::VoxelGrid& grid, const std::vector<BeadPiece>& pieces,
                      const DepositOptions& options, const base::RunContext& ctx) {
  base::require(grid.cellCount() < kNeverFilled, "depositBeads: fewer than 2^32 - 1 cells");
  base::require(options.samplesPerCell >= 1, "depositBeads: samplesPerCell >= 1");
  BeadGrid result;
  result.grid = grid;
  result.fill = base::ZeroedArray<float>(grid.cellCount());
  result.filler = base::ZeroedArray<std::uint32_t>(grid.cellCount());
  result.rectangle = base::ZeroedArray<std::uint8_t>(grid.cellCount());
  result.pieceExcessMm3.assign(pieces.size(), 0.0f);
  if (std::any_of(pieces.begin(), pieces.end(), [](const BeadPiece& p) { return !p.ofPart; }))
    result.otherFill = base::ZeroedArray<float>(grid.cellCount());
  // Footprints do not depend on earlier material: the footprints of a batch are computed in
  // parallel while the preceding batch is deposited piece by piece.
  Layer layer(result);
  Batch making, laying;
  for (std::size_t first = 0; first < pieces.size() + kBatch; first += kBatch) {
    ctx.report(std::min(1.0, static_cast<double>(first) / static_cast<double>(pieces.size())),
               "depositing beads"_text);
    const std::size_t left = pieces.size() - std::min(first, pieces.size());
    const std::size_t chunks = (std::min(kBatch, left) + kGrain - 1) / kGrain;
    base::parallelChunks(ctx, chunks + 1, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        if (c > 0)
          makeFootprints(making[c - 1], pieces, first + (c - 1) * kGrain, grid, options);
        else if (first > 0)
          layBatch(laying, pieces, first - kBatch, layer, result);
    });
    std::swap(making, laying);
  }
  return result;
}

voxel::VoxelGrid gridOver(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double pitchMm,
                          std::size_t maxCells) {
  base::require(pitchMm > 0.0 && (high - low).minCoeff() >= 0.0, "gridOver: a box and a pitch");
  voxel::VoxelGrid grid;
  grid.pitch = pitchMm;
  for (;;) {
    grid.origin = low;
    grid.size = ((high - low) / grid.pitch).array().ceil().matrix().cast<int>().cwiseMax(1);
    if (grid.cellCount() <= maxCells)
      return grid;
    grid.pitch *= 1.1;
  }
}

} // namespace voluta::replay

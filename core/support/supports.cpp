#include "support/supports.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "curved/flood.h"
#include "curved/reverse_growth.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>

namespace voluta::support {

namespace {

constexpr std::size_t kMaxListed = 20;
constexpr int kSlowRounds = 4; // for schemes that do not peel
constexpr std::int32_t kUnreached = std::numeric_limits<std::int32_t>::max();

struct Group {
  std::vector<std::size_t> cells;  // of the part, connected
  std::int32_t order = kUnreached; // the first of them that a flood from the platform reaches
};

base::Message voxels(std::size_t count) {
  return base::message("{count} voxel|{count} voxels"_plural, count);
}

class Supporter {
public:
  Supporter(const voxel::SolidVoxels& part, const std::vector<Eigen::Vector2d>& platform,
            const SupportOptions& options, const base::RunContext& ctx)
      : part_(part), platform_(platform), options_(options), ctx_(ctx),
        peels_(options.growth.row().peels) {
    out_.solid = part;
  }

  Supports run() {
    const curved::VoxelGraph plain = graphOf(out_.solid.solid);
    belowPlate_ = part_.count - plain.size();
    curved::Growth first = grown(plain, ctx_.sub(0.0, 0.3));
    out_.missedBefore = out_.missedAfter = missedOf(plain, first.rank);
    const std::vector<std::size_t> wanted = alwaysCarried();
    if (out_.missedBefore == 0 && wanted.empty()) {
      out_.growth = std::make_shared<curved::Growth>(std::move(first));
      return std::move(out_);
    }
    const std::vector<std::int32_t> reached = curved::flood(plain, {}, ctx_).order;
    out_.unreachedBefore =
        belowPlate_ + static_cast<std::size_t>(std::count_if(reached.begin(), reached.end(),
                                                             [](auto o) { return o < 0; }));
    markPlate(plain);
    carryAlways(plain, wanted);
    kept_ = out_.columns.size();
    addColumns(plain, first.rank);
    thin();
    const curved::VoxelGraph graph = graphOf(out_.solid.solid);
    out_.growth = std::make_shared<curved::Growth>(grown(graph, ctx_.sub(0.9, 1.0)));
    out_.missedAfter = missedOf(graph, out_.growth->rank);
    out_.support.assign(part_.solid.size(), 0);
    for (const Column& column : out_.columns)
      for (const std::size_t c : column.cells)
        out_.support[c] = 1;
    out_.voxels = out_.solid.count - part_.count;
    report();
    return std::move(out_);
  }

private:
  const process::HeadShape* head() const {
    return options_.head.sections.empty() ? nullptr : &options_.head;
  }

  curved::VoxelGraph graphOf(const std::vector<std::uint8_t>& solid) const {
    return curved::voxelGraph(part_.grid, solid, part_.plateLayer(), platform_);
  }
  bool ofPart(std::size_t cell) const { return part_.solid[cell] != 0; }
  bool has(std::size_t cell, layers::SupportRule rule) const {
    return options_.rules.empty() ? rule == layers::SupportRule::Auto
                                  : options_.rules[cell] == rule;
  }

  bool wantsColumn(std::size_t cell) const {
    return options_.rules.empty() || layers::wantsColumns(options_.rules[cell]);
  }

  // Returns the part's cells below which the rules want a column: those above empty ones, in their
  // order, each at least bridgeMm from those before it in its layer.
  std::vector<std::size_t> alwaysCarried() const {
    std::vector<std::size_t> chosen;
    if (options_.rules.empty())
      return chosen;
    for (std::size_t c = 0; c < part_.solid.size(); ++c) {
      const Eigen::Vector3i at = part_.grid.cell(c);
      if (!ofPart(c) || !has(c, layers::SupportRule::Always) || at.z() <= part_.plateLayer() ||
          ofPart(part_.grid.index(at.x(), at.y(), at.z() - 1)))
        continue;
      const bool isCarried = std::ranges::any_of(chosen, [&](std::size_t other) {
        const Eigen::Vector3i apart = part_.grid.cell(other) - at;
        return apart.z() == 0 && apart.cast<double>().norm() * part_.grid.pitch < options_.bridgeMm;
      });
      if (!isCarried)
        chosen.push_back(c);
    }
    return chosen;
  }

  // Puts a column below each of these cells, where there is a path for one.
  void carryAlways(const curved::VoxelGraph& plain, const std::vector<std::size_t>& wanted) {
    if (wanted.empty())
      return;
    const std::vector<std::int32_t> order = curved::flood(plain, {}, ctx_).order;
    std::map<std::size_t, std::int32_t> orderOf;
    for (std::size_t v = 0; v < plain.size(); ++v)
      orderOf[plain.cellOf(v)] = order[v];
    for (const std::size_t cell : wanted) {
      ctx_.checkpoint();
      const auto own = orderOf.find(cell);
      const bool isReached = own != orderOf.end() && own->second >= 0;
      carry({{cell}, isReached ? own->second : kUnreached}, plain, order);
    }
  }

  curved::Growth grown(const curved::VoxelGraph& graph, const base::RunContext& ctx) {
    ++out_.growths;
    return curved::grow(graph, options_.growth, options_.forward, ctx, head());
  }

  // Returns the number of the part's voxels without a rank.
  std::size_t missedOf(const curved::VoxelGraph& graph,
                       const std::vector<std::int32_t>& rank) const {
    std::size_t missed = belowPlate_;
    for (std::size_t v = 0; v < graph.size(); ++v)
      missed += rank[v] <= 0 && ofPart(graph.cellOf(v));
    return missed;
  }

  // Returns the ranks of the first pass of reverse growth, in which abandoned voxels are separate
  // from those they carried; for other schemes the scheme's own ranks. `at`: progress of the
  // search.
  std::vector<std::int32_t> quickRanks(const curved::VoxelGraph& graph, double at) {
    ctx_.report(at, "supports"_text);
    if (!peels_)
      return grown(graph, ctx_.sub(at, at)).rank;
    ++out_.growths;
    curved::PeelOptions peeling;
    peeling.head = head();
    return curved::peel(graph, {}, peeling, ctx_.quiet()).rank;
  }

  // Marks every empty cell above the platform in the plate's layer, and every closed one beyond it.
  void markPlate(const curved::VoxelGraph& plain) {
    cells_.assign(part_.solid.size(), Cell::Empty);
    std::vector<std::uint8_t> plate(part_.solid.size(), 0);
    const int k = part_.plateLayer();
    const Eigen::Vector3i& n = part_.grid.size;
    if (k >= 0 && k < n.z())
      for (int j = 0; j < n.y(); ++j)
        for (int i = 0; i < n.x(); ++i)
          plate[part_.grid.index(i, j, k)] = 1;
    const curved::VoxelGraph layer = graphOf(plate);
    for (std::size_t v = 0; v < layer.size(); ++v)
      cells_[layer.cellOf(v)] = layer.onPlatform[v] ? Cell::Plate : Cell::Closed;
    for (int below = 0; below < std::min(k, n.z()); ++below)
      for (int j = 0; j < n.y(); ++j)
        for (int i = 0; i < n.x(); ++i)
          cells_[part_.grid.index(i, j, below)] = Cell::Closed;
    for (std::size_t c = 0; c < options_.closed.size(); ++c)
      if (options_.closed[c])
        cells_[c] = Cell::Closed;
    for (std::size_t v = 0; v < plain.size(); ++v)
      cells_[plain.cellOf(v)] = Cell::Part;
  }

  std::vector<Group> missedGroups(const curved::VoxelGraph& graph,
                                  const std::vector<std::int32_t>& rank,
                                  const std::vector<std::int32_t>& order) const {
    std::vector<Group> groups;
    std::vector<std::uint8_t> seen(graph.size(), 0);
    std::vector<std::size_t> members;
    for (std::size_t first = 0; first < graph.size(); ++first) {
      if (seen[first] || rank[first] > 0)
        continue;
      members.assign(1, first);
      seen[first] = 1;
      Group group;
      for (std::size_t i = 0; i < members.size(); ++i) {
        const std::size_t v = members[i];
        if (order[v] >= 0)
          group.order = std::min(group.order, order[v]);
        if (ofPart(graph.cellOf(v)) && wantsColumn(graph.cellOf(v)))
          group.cells.push_back(graph.cellOf(v));
        for (const std::int32_t w : graph.neighbour[v])
          if (w >= 0 && !seen[static_cast<std::size_t>(w)] &&
              rank[static_cast<std::size_t>(w)] <= 0) {
            seen[static_cast<std::size_t>(w)] = 1;
            members.push_back(static_cast<std::size_t>(w));
          }
      }
      if (!group.cells.empty())
        groups.push_back(std::move(group));
    }
    return groups;
  }

  void addColumns(const curved::VoxelGraph& plain, const std::vector<std::int32_t>& plainRank) {
    // A scheme that does not peel has computed its first ranks already.
    std::vector<std::int32_t> rank = peels_ ? quickRanks(plain, 0.3) : plainRank;
    curved::VoxelGraph graph = plain;
    if (kept_ > 0) {
      graph = graphOf(out_.solid.solid);
      rank = quickRanks(graph, 0.3);
      missedWithAll_ = missedOf(graph, rank);
    }
    const int rounds = peels_ ? options_.rounds : std::min(options_.rounds, kSlowRounds);
    for (int round = 0; round < rounds; ++round) {
      const std::vector<std::int32_t> order = curved::flood(graph, {}, ctx_).order;
      stranded_.clear();
      const std::size_t before = out_.columns.size();
      for (const Group& group : missedGroups(graph, rank, order))
        if (!carry(group, graph, order))
          stranded_.push_back(group);
      if (out_.columns.size() == before)
        return;
      graph = graphOf(out_.solid.solid);
      rank = quickRanks(graph, 0.3 + 0.4 * (round + 1) / rounds);
      missedWithAll_ = missedOf(graph, rank);
      if (missedWithAll_ == belowPlate_) {
        stranded_.clear();
        return;
      }
    }
  }

  // Puts a column below the group; returns false if there is no path for one.
  bool carry(const Group& group, const curved::VoxelGraph& graph,
             const std::vector<std::int32_t>& order) {
    // Its footing must not depend on the group itself.
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (const std::size_t c = graph.cellOf(v); ofPart(c))
        cells_[c] = order[v] >= 0 && order[v] < group.order ? Cell::Footing : Cell::Part;
    for (const std::size_t c : group.cells)
      cells_[c] = Cell::Part;
    const int maxLateralSteps =
        std::max(1, static_cast<int>(0.5 * options_.bridgeMm / part_.grid.pitch + 1e-9));
    std::optional<Column> column =
        cheapestColumn(part_.grid, cells_, group.cells, maxLateralSteps, ctx_);
    if (!column)
      return false;
    for (const std::size_t c : column->cells) {
      cells_[c] = Cell::Support;
      out_.solid.solid[c] = 1;
    }
    out_.solid.count += column->cells.size();
    out_.columns.push_back(std::move(*column));
    carried_.push_back(group.cells.size());
    return true;
  }

  std::vector<std::uint8_t> solidWith(const std::vector<std::uint8_t>& keep) const {
    std::vector<std::uint8_t> solid = part_.solid;
    for (std::size_t n = 0; n < out_.columns.size(); ++n)
      if (keep[n])
        for (const std::size_t c : out_.columns[n].cells)
          solid[c] = 1;
    return solid;
  }

  // Returns whether another kept column is based on or joined to column n.
  bool isJoined(std::size_t n, const std::vector<std::uint8_t>& keep) const {
    for (std::size_t other = n + 1; other < out_.columns.size(); ++other) {
      if (!keep[other] || out_.columns[other].standsOn != Column::Foot::Support)
        continue;
      const Eigen::Vector3i under = out_.columns[other].foot - Eigen::Vector3i::UnitZ();
      const std::size_t c = part_.grid.index(under.x(), under.y(), under.z());
      const auto& cells = out_.columns[n].cells;
      if (std::find(cells.begin(), cells.end(), c) != cells.end())
        return true;
    }
    return false;
  }

  // Removes columns, longest first, as long as nothing more is missed without them.
  void thin() {
    std::vector<std::uint8_t> keep(out_.columns.size(), 1);
    int trials = 0;
    const auto missedWith = [&] {
      const curved::VoxelGraph graph = graphOf(solidWith(keep));
      return missedOf(graph, quickRanks(graph, 0.7 + 0.2 * trials / (options_.trials + 1)));
    };
    const std::size_t allowed = missedWithAll_;
    // A single column that solves everything is needed.
    if (peels_ && !keep.empty() && (keep.size() > 1 || allowed > belowPlate_)) {
      std::vector<std::size_t> order(out_.columns.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return out_.columns[a].cells.size() > out_.columns[b].cells.size();
      });
      for (const std::size_t n : order) {
        if (trials == options_.trials)
          break;
        if (n < kept_ || isJoined(n, keep))
          continue;
        ++trials;
        keep[n] = 0;
        if (missedWith() > allowed)
          keep[n] = 1;
      }
    }
    out_.solid.solid = solidWith(keep);
    std::vector<Column> columns;
    std::vector<std::size_t> carried;
    for (std::size_t n = 0; n < keep.size(); ++n)
      if (keep[n]) {
        columns.push_back(std::move(out_.columns[n]));
        carried.push_back(carried_[n]);
      }
    out_.columns = std::move(columns);
    carried_ = std::move(carried);
    out_.solid.count = static_cast<std::size_t>(
        std::count_if(out_.solid.solid.begin(), out_.solid.solid.end(), [](auto s) { return s; }));
  }

  void report() {
    for (std::size_t n = 0; n < std::min(kMaxListed, out_.columns.size()); ++n) {
      const Column& column = out_.columns[n];
      const base::Text foot = column.standsOn == Column::Foot::Platform ? "the platform"_text
                              : column.standsOn == Column::Foot::Part   ? "the part below"_text
                                                                        : "another column"_text;
      std::vector<plan::NamedValue> values{{"voxels", voxels(column.cells.size())},
                                           {"foot", foot},
                                           {"carried", voxels(carried_[n])}};
      if (column.sideFaces > 0)
        values.push_back({"faces", column.sideFaces});
      out_.findings.push_back(plan::makeFinding(
          column.sideFaces > 0 ? plan::FindingKind::SupportColumnTouching
                               : plan::FindingKind::SupportColumn,
          std::move(values), part_.grid.centre(column.top.x(), column.top.y(), column.top.z()),
          column.cells.size()));
    }
    if (out_.columns.size() > kMaxListed) {
      const std::size_t rest = out_.columns.size() - kMaxListed;
      out_.findings.push_back(plan::makeFinding(plan::FindingKind::SupportColumns,
                                                {{"columns", rest}}, std::nullopt, rest));
    }
    if (out_.missedAfter == 0)
      return;
    for (std::size_t n = 0; n < std::min(kMaxListed, stranded_.size()); ++n) {
      const Eigen::Vector3i c = part_.grid.cell(stranded_[n].cells.front());
      const std::size_t count = stranded_[n].cells.size();
      out_.findings.push_back(plan::makeFinding(plan::FindingKind::NoSupport, {{"voxels", count}},
                                                part_.grid.centre(c.x(), c.y(), c.z()), count));
    }
  }

  const voxel::SolidVoxels& part_;
  const std::vector<Eigen::Vector2d>& platform_;
  const SupportOptions& options_;
  const base::RunContext& ctx_;
  const bool peels_;
  std::size_t belowPlate_ = 0; // voxels of the part
  std::vector<Cell> cells_;
  std::vector<std::size_t> carried_; // per column
  std::size_t kept_ = 0;             // columns that the rules ask for, the first ones
  std::size_t missedWithAll_ = 0;    // with all columns
  std::vector<Group> stranded_;
  Supports out_;
};

} // namespace

base::ParameterTable supportParameters() {
  return base::ParameterTable({
      base::ofRegion(base::choiceParameter(
          "supports", "none",
          {{"none", "none"_text}, {"auto", "auto"_text}, {"always", "under all overhangs"_text}},
          "Layers"_text, "Supports"_text,
          "Break-away columns below overhangs beyond the overhang angle, in mode curved below "
          "voxels that growth would miss. A region without them blocks them."_text,
          true)),
  });
}

layers::SupportRule supportRule(const base::ParameterValues& values) {
  const std::string text = values.text("supports");
  return text == "none"   ? layers::SupportRule::None
         : text == "auto" ? layers::SupportRule::Auto
                          : layers::SupportRule::Always;
}

bool supportsWanted(const base::ParameterValues& values) {
  return supportRule(values) != layers::SupportRule::None;
}

Supports supportsFor(const voxel::SolidVoxels& part, const std::vector<Eigen::Vector2d>& platform,
                     const SupportOptions& options, const base::RunContext& ctx) {
  base::require(options.rounds >= 1 && options.trials >= 0,
                "supportsFor: rounds >= 1, trials >= 0");
  base::Stopwatch watch;
  Supports out = Supporter(part, platform, options, ctx).run();
  out.seconds = watch.seconds();
  ctx.report(1.0, "supports"_text);
  return out;
}

} // namespace voluta::support

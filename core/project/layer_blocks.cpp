#include "project/block_portions.h"
#include "project/job_blocks.h"

#include <algorithm>

namespace voluta::project {

namespace {
// Number of columns per row.
constexpr std::size_t kPatchColumns = 4, kPocketColumns = 11;

// Value in the column of periods for a patch without a chart.
constexpr double kNoChart = -1.0;

// A row of kPocketColumns numbers per pocket.
std::vector<double> pocketRows(const std::vector<layers::Pocket>& pockets) {
  std::vector<double> rows;
  for (const layers::Pocket& p : pockets)
    rows.insert(rows.end(), {p.top.x(), p.top.y(), p.top.z(), p.direction.x(), p.direction.y(),
                             p.direction.z(), p.volumeMm3, p.depthMm, p.openingMm,
                             static_cast<double>(p.layer), static_cast<double>(p.tool)});
  return rows;
}

std::vector<layers::Pocket> pocketsOf(const std::vector<double>& rows) {
  std::vector<layers::Pocket> pockets;
  for (std::size_t i = 0; i + kPocketColumns <= rows.size(); i += kPocketColumns) {
    const double* row = &rows[i];
    layers::Pocket pocket;
    pocket.top = {row[0], row[1], row[2]};
    pocket.direction = {row[3], row[4], row[5]};
    pocket.volumeMm3 = row[6];
    pocket.depthMm = row[7];
    pocket.openingMm = row[8];
    pocket.layer = static_cast<int>(row[9]);
    pocket.tool = static_cast<int>(row[10]);
    pockets.push_back(pocket);
  }
  return pockets;
}
} // namespace

void addLayers(BlockWriter& out, const layers::LayerStack& stack) {
  std::vector<std::int64_t> rows{stack.layerCount};
  for (const layers::Patch& patch : stack.patches)
    rows.insert(rows.end(), {static_cast<std::int64_t>(patch.surface.vertices.size()),
                             static_cast<std::int64_t>(patch.surface.triangles.size()), patch.layer,
                             patch.group});
  out.addOwned("layers.patches", rows);
  // Layers of one tool without regions need no block.
  std::vector<std::int32_t> owners;
  for (const layers::Patch& patch : stack.patches)
    owners.insert(owners.end(), {patch.tool, patch.region});
  if (std::ranges::any_of(owners, [](std::int32_t owner) { return owner != 0; }))
    out.addOwned("layers.owners", owners);
  const auto column = [&](const char* name, std::size_t item, const auto& arrayOf) {
    out.begin(name, item);
    for (const layers::Patch& patch : stack.patches)
      out.append(arrayOf(patch));
  };
  using layers::Patch;
  column(
      "layers.vertices", sizeof(Eigen::Vector3d),
      [](const Patch& p) -> const auto& { return p.surface.vertices; });
  column(
      "layers.triangles", sizeof(std::array<int, 3>),
      [](const Patch& p) -> const auto& { return p.surface.triangles; });
  column(
      "layers.thickness", sizeof(double),
      [](const Patch& p) -> const auto& { return p.thicknessMm; });
  column(
      "layers.direction", sizeof(Eigen::Vector3d),
      [](const Patch& p) -> const auto& { return p.direction; });
  column(
      "layers.clearDirection", sizeof(Eigen::Vector3d),
      [](const Patch& p) -> const auto& { return p.clearDirection; });
  std::vector<std::uint8_t> rims;
  for (const Patch& patch : stack.patches) {
    rims.insert(rims.end(), patch.innerRim.begin(), patch.innerRim.end());
    if (patch.innerRim.empty())
      rims.insert(rims.end(), patch.surface.vertices.size(), 0);
  }
  out.addOwned("layers.innerRim", rims);
  if (!stack.pockets.empty())
    out.addOwned("layers.pockets", pocketRows(stack.pockets));
  if (std::ranges::all_of(stack.patches, [](const Patch& p) { return p.chart.empty(); }))
    return;
  column(
      "layers.chart", sizeof(Eigen::Vector2d),
      [](const Patch& p) -> const auto& { return p.chart.at; });
  std::vector<double> periods;
  for (const Patch& patch : stack.patches)
    periods.push_back(patch.chart.empty() ? kNoChart : patch.chart.periodMm);
  out.addOwned("layers.chartPeriod", periods);
}

layers::LayerStack getLayers(const BlockReader& in) {
  const auto rows = in.get<std::int64_t>("layers.patches");
  if (rows.size() % kPatchColumns != 1)
    contradiction("size of the table of patches"_text);
  Portions vertices(in.get<Eigen::Vector3d>("layers.vertices"));
  Portions triangles(in.get<std::array<int, 3>>("layers.triangles"));
  Portions thickness(in.get<double>("layers.thickness"));
  Portions direction(in.get<Eigen::Vector3d>("layers.direction"));
  Portions clearDirection(in.get<Eigen::Vector3d>("layers.clearDirection"));
  // Older projects lack these.
  const bool hasRims = in.has("layers.innerRim");
  Portions innerRim(hasRims ? in.get<std::uint8_t>("layers.innerRim")
                            : std::vector<std::uint8_t>{});
  const bool hasCharts = in.has("layers.chart");
  Portions chart(hasCharts ? in.get<Eigen::Vector2d>("layers.chart")
                           : std::vector<Eigen::Vector2d>{});
  Portions chartPeriod(hasCharts ? in.get<double>("layers.chartPeriod") : std::vector<double>{});
  const std::size_t count = (rows.size() - 1) / kPatchColumns;
  Portions owners(in.has("layers.owners") ? in.get<std::int32_t>("layers.owners")
                                          : std::vector<std::int32_t>(2 * count, 0));
  layers::LayerStack stack;
  stack.layerCount = static_cast<int>(rows[0]);
  for (std::size_t i = 1; i < rows.size(); i += kPatchColumns) {
    layers::Patch patch;
    patch.surface.vertices = vertices.next(rows[i]);
    patch.surface.triangles = triangles.next(rows[i + 1]);
    patch.thicknessMm = thickness.next(rows[i]);
    patch.direction = direction.next(rows[i]);
    patch.clearDirection = clearDirection.next(rows[i]);
    if (hasRims)
      patch.innerRim = innerRim.next(rows[i]);
    if (const double period = hasCharts ? chartPeriod.next(1).front() : kNoChart; period >= 0.0)
      patch.chart = {chart.next(rows[i]), period};
    const std::vector<std::int32_t> owner = owners.next(2);
    patch.tool = owner[0];
    patch.region = owner[1];
    patch.layer = static_cast<int>(rows[i + 2]);
    patch.group = static_cast<int>(rows[i + 3]);
    stack.patches.push_back(std::move(patch));
  }
  if (in.has("layers.pockets"))
    stack.pockets = pocketsOf(in.get<double>("layers.pockets"));
  return stack;
}

} // namespace voluta::project

#include "elastic/deposited.h"

#include "base/error.h"
#include "base/units.h"
#include "elastic/bead_stiffness.h"
#include "elastic/elastic_solve.h"
#include "geometry/symmetric_axes.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace voluta::elastic {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

constexpr double kAlignedDeg = 30.0;
constexpr double kStepShare = 0.4; // of a cell's width, between places in a bead
constexpr double kEmpty = 1e-3;    // of the beads around a cell: it has none of its own
constexpr double kFull = 0.9;      // the rest is rounding of beads into cells
constexpr double kSoft = 1e-3;     // of the matrix, where no bead is: no corner is loose
constexpr double kExceeded = 0.01; // of the volume, by the tensions that are reported
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool countsFor(const plan::ToolPath& path, int item) {
  return path.item == item && !plan::isWaste(path.kind) && path.kind != PathKind::Support &&
         path.kind != PathKind::Shot;
}

// Calls visit(path, i) for each segment from waypoint i - 1 to i of an item's beads and tapes.
template <typename Visit> void eachSegment(const plan::ToolPlan& plan, int item, Visit visit) {
  for (const plan::ToolPath& path : plan.paths)
    if (countsFor(path, item))
      for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
        if ((plan.position[i] - plan.position[i - 1]).squaredNorm() > 0.0)
          visit(path, i);
}

// Returns the angle in degrees between a direction and the strongest of the dyads; nullopt if there
// is none.
std::optional<double> angleTo(const Eigen::Matrix3d& dyads, const Vector3d& along) {
  const auto [values, axes] = geometry::symmetricAxes(dyads);
  if (values[2] <= 0.0)
    return std::nullopt;
  return base::radiansToDegrees(std::acos(std::min(1.0, std::abs(axes.col(2).dot(along)))));
}

// Returns the mean of a sum over a length; unknown without any length.
double meanOver(double lengthMm, double sum) {
  return lengthMm > 0.0 ? sum / lengthMm : kUnknown;
}

// Adds the alignment of all beads under stress. Returns whether there are any.
bool addAngles(const plan::ToolPlan& plan, int item, const PrincipalStress& principal,
               plan::LoadStatistics& figures) {
  double length = 0.0, inside = 0.0, angles = 0.0, alignedMm = 0.0, alignedInside = 0.0;
  eachSegment(plan, item, [&](const plan::ToolPath& path, std::size_t i) {
    const Vector3d step = plan.position[i] - plan.position[i - 1];
    const Vector3d middle = 0.5 * (plan.position[i] + plan.position[i - 1]);
    const std::optional<double> angle = angleTo(principal.dyadsAt(middle), step.normalized());
    if (!angle)
      return;
    const double aligned = *angle <= kAlignedDeg ? step.norm() : 0.0;
    length += step.norm();
    angles += step.norm() * *angle;
    alignedMm += aligned;
    if (path.kind != PathKind::Wall) {
      inside += step.norm();
      alignedInside += aligned;
    }
  });
  figures.angleMeanDeg = meanOver(length, angles);
  figures.alignedFraction = meanOver(length, alignedMm);
  figures.infillAlignedFraction = meanOver(inside, alignedInside);
  return length > 0.0;
}

// What the beads within a cell are.
struct CellBeads {
  double mm3 = 0.0;
  Stiffness6 stiffness = Stiffness6::Zero();       // times volume
  Vector3d up = Vector3d::Zero();                  // normal of the layers
  Eigen::Matrix3d along = Eigen::Matrix3d::Zero(); // dyads
};

class DepositedCells {
public:
  DepositedCells(const LoadCase& load, const process::Tooling& tooling)
      : load_(load), tooling_(tooling), cells_(load.share.size()) {}

  // Returns the first process whose beads have an unknown elasticity; null if there is none.
  const process::Process* add(const plan::ToolPlan& plan, int item) {
    const process::Process* unknown = nullptr;
    eachSegment(plan, item, [&](const plan::ToolPath& path, std::size_t i) {
      if (unknown)
        return;
      if (const std::optional<process::Elasticity> elasticity = elasticityOf(path))
        addSegment(plan, i, *elasticity);
      else
        unknown = &tooling_.of(path).process;
    });
    return unknown;
  }

  // Returns the stiffness of what fills a cell's part: that of the beads in it and around it, so
  // that the rounding of beads into cells does not matter, times the share that they fill.
  Stiffness6 stiffnessOf(std::size_t c) const {
    double beadMm3 = 0.0, partMm3 = 0.0;
    Stiffness6 stiffness = Stiffness6::Zero();
    const Eigen::Vector3i cell = load_.grid.cell(c);
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i at = cell + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (!load_.grid.contains(at.x(), at.y(), at.z()))
        continue;
      const std::size_t other = load_.grid.index(at.x(), at.y(), at.z());
      partMm3 += static_cast<double>(load_.share[other]) * std::pow(load_.grid.pitch, 3);
      beadMm3 += cells_[other].mm3;
      stiffness += cells_[other].stiffness;
    }
    if (cells_[c].mm3 > kEmpty * beadMm3)
      stiffness = cells_[c].stiffness * (beadMm3 / cells_[c].mm3);
    if (beadMm3 <= 0.0)
      return Stiffness6::Zero();
    const double fill = beadMm3 / partMm3;
    return stiffness / beadMm3 * (fill >= kFull ? 1.0 : fill);
  }

  const std::vector<CellBeads>& cells() const { return cells_; }

private:
  std::optional<process::Elasticity> elasticityOf(const plan::ToolPath& path) const {
    const process::Process& process = tooling_.of(path).process;
    if (!process.tape)
      return process.material.elasticity;
    const std::optional<process::Elasticity>& matrix = tooling_.first().process.material.elasticity;
    return matrix ? tapeElasticity(process, *matrix) : std::nullopt;
  }

  void addSegment(const plan::ToolPlan& plan, std::size_t i,
                  const process::Elasticity& elasticity) {
    const Vector3d from = plan.position[i - 1], step = plan.position[i] - from;
    const Vector3d along = step.normalized();
    const Vector3d up = (plan.direction[i] - plan.direction[i].dot(along) * along).normalized();
    const Vector3d across = up.cross(along);
    const auto width = static_cast<double>(plan.widthMm[i]),
               height = static_cast<double>(plan.heightMm[i]);
    const double mm3 = process::beadArea(width, height) * step.norm();
    const Stiffness6 stiffness = beadStiffness(elasticity, along);
    const auto places = [&](double mm) {
      return static_cast<int>(std::max(1.0, std::ceil(mm / (kStepShare * load_.grid.pitch))));
    };
    const int steps = places(step.norm()), lanes = places(width), levels = places(height);
    const double each = mm3 / (steps * lanes * levels);
    for (int k = 0; k < steps; ++k)
      for (int a = 0; a < lanes; ++a)
        for (int h = 0; h < levels; ++h) {
          const Vector3d place = from + (k + 0.5) / steps * step +
                                 ((a + 0.5) / lanes - 0.5) * width * across -
                                 (h + 0.5) / levels * height * up;
          const Eigen::Vector3i cell = load_.grid.cellOf(place);
          if (!load_.grid.contains(cell.x(), cell.y(), cell.z()))
            continue;
          CellBeads& beads = cells_[load_.grid.index(cell.x(), cell.y(), cell.z())];
          beads.mm3 += each;
          beads.stiffness += each * stiffness;
          beads.up += each * up;
          beads.along += each * along * along.transpose();
        }
  }

  const LoadCase& load_;
  const process::Tooling& tooling_;
  std::vector<CellBeads> cells_;
};

// Returns the value that a share of the weights exceeds.
double exceededBy(std::vector<std::pair<double, double>> values, double share) {
  std::ranges::sort(values, std::greater());
  double weight = 0.0;
  for (const auto& [value, w] : values)
    weight += w;
  double above = 0.0;
  for (const auto& [value, w] : values) {
    above += w;
    if (above >= share * weight)
      return std::max(0.0, value);
  }
  return 0.0;
}

void addTensions(const LoadCase& load, const std::vector<CellBeads>& cells,
                 const ElasticState& state, plan::LoadStatistics& figures) {
  std::vector<std::pair<double, double>> beads, layers; // tension and volume
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!load.isSolid(c) || cells[c].mm3 <= 0.0 || std::ranges::binary_search(load.held, c))
      continue;
    const Eigen::Matrix3d stress = stressMatrix(state.stress[c]);
    const Vector3d up = cells[c].up.normalized();
    const double volume = static_cast<double>(load.share[c]);
    layers.emplace_back(up.dot(stress * up), volume);
    // Across the beads: the mean over their directions.
    const Eigen::Matrix3d within = Eigen::Matrix3d::Identity() - up * up.transpose();
    const Eigen::Matrix3d across = within - cells[c].along / cells[c].mm3;
    beads.emplace_back((across * stress).trace(), volume);
  }
  figures.acrossBeadsMPa = exceededBy(std::move(beads), kExceeded);
  figures.acrossLayersMPa = exceededBy(std::move(layers), kExceeded);
}

double forceOf(const LoadCase& load) {
  return std::accumulate(
      load.forces.begin(), load.forces.end(), 0.0,
      [](double sum, const CellForce& force) { return sum + force.newton.norm(); });
}

plan::Finding unknownFigures(base::Message figures, base::Message reason, base::Message help) {
  return plan::makeFinding(
      plan::FindingKind::LoadFiguresUnknown,
      {{"figures", std::move(figures)}, {"reason", std::move(reason)}, {"help", std::move(help)}});
}

plan::Finding unknownElasticity(const process::Process& process) {
  return process.tape
             ? unknownFigures("stiffness and tensions"_text,
                              base::message("tape {process} or the plastic around it states no "
                                            "elasticity"_text,
                                            process.id),
                              "give the modulus and the share of its fibres, and the elasticity "
                              "of the plastic"_text)
             : unknownFigures("stiffness and tensions"_text,
                              base::message("material {material} states no elasticity"_text,
                                            process.material.label),
                              "give the material its elasticity"_text);
}
} // namespace

LoadFigures loadFigures(const plan::ToolPlan& plan, int item, const process::Tooling& tooling,
                        const LoadCase& load, const PrincipalStress& principal,
                        const base::RunContext& ctx) {
  LoadFigures judged{{.forceN = forceOf(load)}, {}};
  plan::LoadStatistics& figures = judged.figures;
  figures.stiffnessNPerMm = figures.acrossBeadsMPa = figures.acrossLayersMPa = kUnknown;
  if (!addAngles(plan, item, principal, figures)) {
    judged.unknown = unknownFigures("figures"_text, "no bead is under stress"_text,
                                    "give forces that do not cancel each other"_text);
    return judged;
  }
  ctx.checkpoint();
  DepositedCells deposited(load, tooling);
  if (const process::Process* const process = deposited.add(plan, item)) {
    judged.unknown = unknownElasticity(*process);
    return judged;
  }
  const process::Elasticity matrix =
      tooling.first().process.material.elasticity.value_or(process::Elasticity{});
  const Stiffness6 soft = isotropicStiffness(kSoft * matrix.acrossMPa, matrix.poisson);
  const auto state = foundEquilibrium(
      load, [&](std::size_t c) { return Stiffness6(deposited.stiffnessOf(c) + soft); }, ctx);
  if (!state) {
    judged.unknown =
        unknownFigures("stiffness and tensions"_text, "found no equilibrium of the beads"_text,
                       "hold the part in more places"_text);
    return judged;
  }
  if (state->workNmm > 0.0)
    figures.stiffnessNPerMm = figures.forceN * figures.forceN / state->workNmm;
  addTensions(load, deposited.cells(), *state, figures);
  return judged;
}

} // namespace voluta::elastic

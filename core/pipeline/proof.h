// What was checked of a program, for whoever has to answer for running it.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "pipeline/outputs.h"
#include "pipeline/road.h"
#include "pipeline/stages.h"

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace voluta::collision {
class GrowingPart;
}

namespace voluta::pipeline {

// A value at its worst, and where in the program that is.
struct ProofValue {
  double value = 0.0;
  std::string file; // empty: in none
  std::size_t line = 0;
  double atS = 0.0; // from the program's start
};

// Of cubes `cellMm` wide: what share of the part in them is filled with beads; below 0: no part.
struct FillMap {
  double cellMm = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); // work frame
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  std::vector<double> filled; // x runs fastest
};

struct Proof {
  std::string part, format, printed; // printed: file of the mesh
  bool foreign = false;
  struct File {
    std::string name, sha256;
    std::size_t bytes = 0;
  };
  std::vector<File> files;
  project::ReplayReport verdict;
  double plannedS = 0.0, programS = 0.0; // how long: by the plan, and as the program is run
  double materialMm3 = 0.0;
  ProofValue clearance; // of arm, plate and part, mm; the head's to plate and part left out
  struct Joint {
    std::string name;
    bool slides = false; // then mm, else degrees
    ProofValue margin;   // to the nearer limit
  };
  std::vector<Joint> joints;
  ProofValue isotropy; // motion/margins.h; 0: singular
  FillMap fill;
};

// Of what of the part lies in each cube, by the cells of `growing`; cubes are a fortieth of the
// part's longest side wide, or a cell. Throws Cancelled.
FillMap fillMap(const geometry::TriangleMesh& part, const collision::GrowingPart& growing,
                const base::RunContext& ctx);

// NAME of a program's first file.
std::string proofName(const CheckedProgram& program);
std::string proofJson(const Proof& proof);
// A page that stands alone, in English.
std::string proofPage(const Proof& proof);

// NAME.proof.html and NAME.proof.json for each of the programs that passed, and PART.printed.stl.
// `meanwhile` is called as well, side by side with what takes longest. Throws Error{CannotWrite};
// Cancelled.
void writeProofs(
    const PlanResult& result, const Programs& programs, const std::filesystem::path& folder,
    const base::RunContext& ctx, const std::function<void()>& meanwhile = [] {});
std::vector<std::string> proofNames(const PlanResult& result, const Programs& programs);

} // namespace voluta::pipeline

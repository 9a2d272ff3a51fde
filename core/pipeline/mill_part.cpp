#include "pipeline/mill_part.h"

#include "base/stopwatch.h"
#include "milling/mill_program.h"
#include "program/gcode/gcode_milling.h"

#include <utility>

namespace voluta::pipeline {

MilledPart millPart(geometry::TriangleMesh part, const MillOrder& order,
                    const base::RunContext& ctx) {
  MilledPart out;
  base::Stopwatch loading;
  if (order.layDown) {
    ctx.report(0.0, "laying the part down"_text);
    out.orientation = placement::millingOrientation(part);
    for (Eigen::Vector3d& v : part.vertices)
      v = out.orientation.rotation * v;
  }
  out.part = std::move(part);
  out.timings.load = loading.seconds();
  base::Stopwatch planning;
  out.plan = milling::planMilling(out.part, order.rule, ctx.sub(0.1, 0.6));
  out.program = milling::writeMilling(out.plan, order.rule, order.name);
  out.timings.toolpath = planning.seconds();
  base::Stopwatch judging;
  const plan::ReadProgram read = program::readMillingGcode(out.program);
  out.motions = read.motions.size();
  out.verdict = milling::judgeCuts(read, out.plan, order.rule, ctx.sub(0.6, 1.0));
  out.timings.replay = judging.seconds();
  return out;
}

} // namespace voluta::pipeline

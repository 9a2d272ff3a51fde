#include "pipeline/mill_part.h"

#include "milling/mill_program.h"
#include "milling/mill_reader.h"

#include <utility>

namespace voluta::pipeline {

MilledPart millPart(geometry::TriangleMesh part, const MillOrder& order,
                    const base::RunContext& ctx) {
  MilledPart out;
  if (order.layDown) {
    ctx.report(0.0, "laying the part down"_text);
    out.laid = placement::laidDown(part);
    for (Eigen::Vector3d& v : part.vertices)
      v = out.laid.turn * v;
  }
  out.part = std::move(part);
  out.plan = milling::planMilling(out.part, order.rule, ctx.sub(0.1, 0.6));
  out.program = milling::writeMilling(out.plan, order.rule, order.name);
  const milling::ReadMilling read = milling::readMilling(out.program);
  out.motions = read.moves.size();
  out.verdict = milling::replayMilling(read, out.plan, order.rule, ctx.sub(0.6, 1.0));
  return out;
}

} // namespace voluta::pipeline

#include "program/stream/joint_rows_writer.h"

#include "base/error.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/common/straight_pieces.h"
#include "program/common/tcp_motions.h"
#include "program/common/walk.h"

#include <algorithm>

namespace voluta::program {

namespace {

constexpr double kMinS = 1e-6; // resolution of the rows

class RowsWriter : private ProgramEmitter {
public:
  RowsWriter(const ProgramInput& input, std::string_view format, std::span<const std::string> head,
             double (*written)(double share), const base::RunContext& ctx)
      : in_(input), format_(format), head_(head), written_(written), ctx_(ctx),
        targets_(motionTargets(input, ctx)), motions_(in_, targets_, written) {
    base::require(input.trajectory.dof == static_cast<int>(kRowJoints),
                  "rows of joints are of an arm without external axes");
  }

  WrittenRows write() {
    walkTrajectory(in_, {format_, cutsOf(in_, 0), &motions_}, *this, ctx_);
    return std::move(out_);
  }

private:
  void beginFile(std::size_t) override {
    out_.text.reserve(in_.trajectory.pointCount() * 90 + 1024);
    for (const std::string& line : head_)
      remark(line);
    out_.text += joined({kRowHeader, "\n"});
  }
  void endFile(std::size_t) override {
    row_.on = false;
    put(RowKind::End, 0.0);
  }

  void remark(std::string_view text) override { out_.text += joined({"# ", text, "\n"}); }
  void flow(std::string_view share) override {
    parseNumber(share, share_);
    share_ = written_(share_);
  }
  void extruder(bool on) override { row_.on = on; }
  void wait(double seconds) override { put(RowKind::Wait, seconds); }
  void jointMotion(std::size_t i) override { go(i); }
  void straightMotion(std::size_t i, bool) override {
    const std::vector<robot::JointVector> pieces = straightPieces(in_, i, kBlendToleranceMm);
    const double parts = static_cast<double>(pieces.size() + 1);
    for (const robot::JointVector& q : pieces)
      move(q.data(), motions_.seconds(i) / parts);
    move(in_.trajectory.at(i), motions_.seconds(i) / parts);
  }

  void go(std::size_t i) {
    if (i > 0) {
      move(in_.trajectory.at(i), motions_.seconds(i));
      return;
    }
    std::copy_n(in_.trajectory.at(i), kRowJoints, row_.joints.begin());
    put(RowKind::Start, 0.0);
  }
  void move(const double* joints, double seconds) {
    std::copy_n(joints, kRowJoints, row_.joints.begin());
    put(RowKind::Move, std::max(kMinS, seconds));
  }
  void put(RowKind kind, double seconds) {
    row_.kind = kind;
    row_.seconds = seconds;
    row_.flow = row_.on ? share_ : 0.0;
    row_ = asWritten(row_);
    appendRow(out_.text, row_);
    out_.rows.push_back(row_);
  }

  const ProgramInput& in_;
  std::string_view format_;
  std::span<const std::string> head_;
  double (*written_)(double share);
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  TcpMotions motions_;
  WrittenRows out_;
  JointRow row_;
  double share_ = 0.0;
};

} // namespace

WrittenRows writeRows(const ProgramInput& input, std::string_view format,
                      std::span<const std::string> head, double (*written)(double share),
                      const base::RunContext& ctx) {
  checkInput(input);
  return RowsWriter(input, format, head, written, ctx).write();
}

} // namespace voluta::program

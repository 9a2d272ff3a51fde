#include "program/stream/link_writer.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/common/walk.h"

#include <cmath>
#include <utility>

namespace voluta::program {

namespace {

class LinkWriter : private ProgramEmitter {
public:
  LinkWriter(const ProgramInput& input, const LinkForm& form, const LinkMotions& motions,
             const LinkHead& head, const base::RunContext& ctx)
      : in_(input), form_(form), motions_(motions), head_(head), ctx_(ctx), link_(head.frames) {}

  LinkText write() {
    walkTrajectory(in_, {head_.format, cutsOf(in_, 0), &motions_.tcp()}, *this, ctx_);
    return {std::move(out_), link_};
  }

private:
  void beginFile(std::size_t) override {
    constexpr std::size_t kLine = 80, kHead = 2048;
    out_.reserve(in_.trajectory.pointCount() * kLine + kHead);
    for (const std::string& text : head_.remarks)
      remark(text);
    out_ += joined({form_.header, "\n"});
    appendLinkFrame(out_, kLinkTool, link_.tool, form_);
    for (const auto& [name, frame] : {std::pair{kLinkNozzle, &link_.nozzle},
                                      {kLinkBase, &link_.base},
                                      {kLinkLoad, &link_.load}})
      if (*frame)
        appendLinkFrame(out_, name, **frame, form_);
  }
  void endFile(std::size_t) override {
    row_.speed = row_.rotation = row_.flow = 0.0;
    appendLinkRow(out_, row_, form_);
  }

  void remark(std::string_view text) override { out_ += joined({"# ", text, "\n"}); }
  void flow(std::string_view share) override {
    parseNumber(share, share_);
    share_ *= form_.fullFlow;
    if (form_.wholeFlow)
      share_ = std::round(share_);
  }
  void extruder(bool on) override { on_ = on; }
  void wait(double seconds) override {
    row_.speed = -seconds;
    row_.rotation = 0.0;
    put();
  }

  void jointMotion(std::size_t i) override {
    pose(i);
    row_.blend = kLinkByJointsToPose;
    if (!in_.foreign) {
      row_.blend = kLinkByJoints;
      for (std::size_t k = 0; k < row_.target.size(); ++k)
        row_.target[k] =
            roundedTo(base::radiansToDegrees(in_.trajectory.at(i)[k]), form_.frameDecimals);
    }
    row_.speed = motions_.jointPercent(i);
    row_.rotation = 0.0;
    const std::size_t line = out_.size();
    put();
    if (i == 0) // rounded as written
      parseLinkRow(std::string_view(out_).substr(line, out_.size() - line - 1), form_, link_.start);
  }
  void straightMotion(std::size_t i, bool stops) override {
    pose(i);
    row_.speed = motions_.mmPerS(i);
    row_.rotation = form_.turns ? motions_.degPerS(i) : 0.0;
    row_.blend = stops ? 0.0 : motions_.blendMm(i);
    put();
  }

  void pose(std::size_t i) {
    const Eigen::Vector3d mm = motions_.mm(i), degrees = motions_.degrees(i);
    for (int k = 0; k < 3; ++k) {
      row_.target[static_cast<std::size_t>(k)] = mm[k];
      row_.target[static_cast<std::size_t>(k) + 3] = degrees[k];
    }
  }
  void put() {
    row_.flow = on_ ? share_ : 0.0;
    appendLinkRow(out_, row_, form_);
  }

  const ProgramInput& in_;
  const LinkForm& form_;
  const LinkMotions& motions_;
  const LinkHead& head_;
  const base::RunContext& ctx_;
  std::string out_;
  Link link_;
  LinkRow row_;
  double share_ = 0.0; // of the full flow
  bool on_ = false;
};

} // namespace

LinkText writeLinkRows(const ProgramInput& input, const LinkForm& form, const LinkMotions& motions,
                       const LinkHead& head, const base::RunContext& ctx) {
  return LinkWriter(input, form, motions, head, ctx).write();
}

} // namespace voluta::program

// Writes the lines of a data link (program/stream/link_rows.h).
#pragma once

#include "base/run_context.h"
#include "program/common/tcp_motions.h"
#include "program/program_input.h"
#include "program/stream/link_rows.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// A trajectory's motions as the controller executes them, rounded as written. Points are indices;
// motion i ends at point i.
class LinkMotions {
public:
  virtual ~LinkMotions() = default;
  virtual const TcpMotions& tcp() const = 0;
  // The target, in the frame of the form's poses.
  virtual Eigen::Vector3d mm(std::size_t i) const = 0;
  virtual Eigen::Vector3d degrees(std::size_t i) const = 0;
  // For straight motions.
  virtual double mmPerS(std::size_t i) const = 0;
  virtual double degPerS(std::size_t i) const = 0; // for a form that turns
  // 0: the arm stops after it. Precondition: i > 0.
  virtual double blendMm(std::size_t i) const = 0;
  // For joint motions.
  virtual double jointPercent(std::size_t i) const = 0;
};

// Data written before the first line.
struct LinkHead {
  std::string_view format;
  std::vector<std::string> remarks; // without their mark
  Link frames;                      // its start is set by the writer
};
struct LinkText {
  std::string text;
  Link link;
};
// Throws Cancelled.
LinkText writeLinkRows(const ProgramInput& input, const LinkForm& form, const LinkMotions& motions,
                       const LinkHead& head, const base::RunContext& ctx);

} // namespace voluta::program

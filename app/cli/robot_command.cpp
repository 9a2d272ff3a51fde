#include "cli/commands.h"
#include "robot/cell/robot_json_output.h"
#include "robot/robot_model.h"

#include <charconv>
#include <fmt/format.h>

namespace voluta::cli {

namespace {
std::vector<double> numbers(std::string_view text, std::size_t count, const char* what) {
  const auto wrong = [&] {
    return base::Error(
        base::ErrorCode::Usage,
        base::message("'{text}' must be {count} comma-separated numbers"_text, text, count),
        std::string(what));
  };
  std::vector<double> values;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view field = text.substr(0, comma);
    double value = 0.0;
    const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (status != std::errc{} || end != field.data() + field.size())
      throw wrong();
    values.push_back(value);
    if (comma == std::string_view::npos)
      break;
    text.remove_prefix(comma + 1);
  }
  if (values.size() != count)
    throw wrong();
  return values;
}
} // namespace

ExitCode robotCommand(const RobotOptions& options) {
  const robot::RobotModel model = robot::loadRobot(options.id);
  if (!options.forward.empty())
    fmt::print("{}\n",
               robot::forwardJson(
                   model, numbers(options.forward, static_cast<std::size_t>(model.dof()), "--fk")));
  else
    fmt::print("{}\n", robot::inverseJson(model, numbers(options.inverse, 7, "--ik")));
  return kDone;
}

} // namespace voluta::cli

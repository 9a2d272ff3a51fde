#include "base/error.h"
#include "cli/commands.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>

namespace voluta::cli {

void requireFiniteNumbers(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    if (option->get_type_name().starts_with("FLOAT"))
      for (const std::string& value : option->results())
        if (!std::isfinite(std::strtod(value.c_str(), nullptr)))
          throw base::Error(base::ErrorCode::Usage,
                            base::message("'{value}' is no number"_text, value.substr(0, 60)),
                            option->get_name(), {});
  for (const CLI::App* command : app.get_subcommands())
    requireFiniteNumbers(*command);
}

} // namespace voluta::cli

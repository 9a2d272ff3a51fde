// Parameters for the choices of a test, as text.
#pragma once

#include "pipeline/stage_options.h"
#include "project/choices.h"

#include <map>
#include <string>

namespace voluta::test {

// Stores a value where parameters of its scope are stored, without a check of the value.
inline void giveParameter(project::Choices& choices, const std::string& key,
                          const std::string& text) {
  const base::ParameterTable table = pipeline::allParameters();
  const base::ParameterSpec* spec = table.find(base::currentKey(key));
  pipeline::parametersOf(choices, spec ? spec->scope : base::ParameterScope::Item)[key] = text;
}

// Replaces all parameters of the job and of its first item.
inline void giveParameters(project::Choices& choices,
                           const std::map<std::string, std::string>& parameters) {
  choices.parameters.clear();
  choices.item().parameters.clear();
  for (const auto& [key, text] : parameters)
    giveParameter(choices, key, text);
}

} // namespace voluta::test

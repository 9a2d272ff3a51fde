// What a mode does not take has no say in what it makes: the form leaves it out.
#include "modes/file_parameters.h"
#include "modes/mode_table.h"
#include "pipeline/choices.h"
#include "process/process.h"
#include "project/choices.h"

#include <gtest/gtest.h>

namespace voluta::modes {
namespace {

// Another value than the default.
std::string otherText(const base::ParameterSpec& spec) {
  switch (spec.type) {
  case base::ParameterType::Number:
  case base::ParameterType::Integer:
    return base::formatParameter(spec.type == base::ParameterType::Number
                                     ? base::ParameterValue(spec.maximum)
                                     : base::ParameterValue(static_cast<long long>(spec.maximum)));
  case base::ParameterType::Boolean:
    return std::get<bool>(spec.defaultValue) ? "false" : "true";
  case base::ParameterType::Choice:
    for (const auto& choice : spec.choices)
      if (choice.id != std::get<std::string>(spec.defaultValue))
        return choice.id;
    break;
  case base::ParameterType::Text:
    return "1,2,3";
  }
  return {};
}

std::string keyOf(const Mode& mode, const project::Choices& choices) {
  const base::ParameterValues values = pipeline::parameterValues(choices);
  const process::Process process = pipeline::chosenProcess(choices, values);
  const ModeChoices in{choices, values, process};
  return mode.decompose.key(in) + mode.layers.key(in) + mode.place.key(in);
}

TEST(ModeParameters, WhatAModeDoesNotTakeHasNoSayInIt) {
  const base::ParameterTable all = modeParameters();
  for (const Mode& mode : modeTable()) {
    project::Choices choices;
    choices.item().mode = mode.id;
    choices.cell = mode.usual.cell;
    choices.tool().process = mode.usual.process;
    choices.item().platform = mode.usual.platform;
    const std::string usual = keyOf(mode, choices);
    for (const base::ParameterSpec& spec : all.specs()) {
      if (takesParameter(mode, spec.key))
        continue;
      project::Choices other = choices;
      other.item().parameters[spec.key] = otherText(spec);
      EXPECT_EQ(keyOf(mode, other), usual) << mode.id << " " << spec.key;
    }
  }
}

TEST(ModeParameters, EveryModeNamesParametersThatThereAre) {
  const base::ParameterTable all = modeParameters();
  for (const Mode& mode : modeTable())
    for (const std::string& key : mode.parameters)
      EXPECT_NE(all.find(key), nullptr) << mode.id << " " << key;
}

TEST(ModeParameters, FilesAreForTextsThatThereAre) {
  const base::ParameterTable all = modeParameters();
  for (const FileParameter& file : fileParameters()) {
    const base::ParameterSpec* spec = all.find(file.key);
    ASSERT_NE(spec, nullptr) << file.key;
    EXPECT_EQ(spec->type, base::ParameterType::Text) << file.key;
  }
}

} // namespace
} // namespace voluta::modes

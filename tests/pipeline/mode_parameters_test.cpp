// Parameters that a mode does not take have no effect on its results: the form hides them.
#include "helpers/given_parameters.h"
#include "helpers/other_text.h"
#include "modes/mode_table.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "project/choices.h"

#include <gtest/gtest.h>

namespace voluta::modes {
namespace {

std::string keyOf(const Mode& mode, const project::Choices& choices) {
  const base::ParameterValues values = pipeline::parameterValues(choices);
  const process::Process process = pipeline::chosenProcess(choices, values);
  const ModeChoices in{choices, values, process};
  return mode.decompose.key(in) + mode.layers.key(in) + mode.place.key(in);
}

TEST(ModeParameters, ParametersThatAModeDoesNotTakeHaveNoEffect) {
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
      test::giveParameter(other, spec.key, test::otherText(spec));
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

} // namespace
} // namespace voluta::modes

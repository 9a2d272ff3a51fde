// Typed input: parameters, the platform, the scale.
#include "fuzz_target.h"

#include "helpers/given_parameters.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <cmath>

using namespace voluta;

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> texts{"fit", "fit:2.5", "disc:40", "rect:30x20", "0.5", "urscript,csv"};
  const base::ParameterTable table = pipeline::allParameters();
  for (const base::ParameterSpec& spec : table.specs())
    texts.push_back(spec.key + "=" + base::formatParameter(spec.defaultValue));
  return texts;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  const std::string value = text.substr(text.find('=') + 1);
  const base::ParameterTable table = pipeline::allParameters();
  for (const base::ParameterSpec& spec : table.specs())
    fuzz::takenOrRefused([&] {
      const base::ParameterValue taken = base::parseParameter(spec, value);
      fuzz::expect(base::parseParameter(spec, base::formatParameter(taken)) == taken,
                   "a value comes back from its text");
    });
  fuzz::takenOrRefused([&] {
    const project::Platform platform(text);
    fuzz::expect(project::Platform(platform.text()) == platform,
                 "a platform comes back from its text");
  });
  fuzz::takenOrRefused(
      [&] { fuzz::expect(std::isfinite(project::parsedScale(text)), "a scale is a number"); });
  fuzz::takenOrRefused([&] { curved::GrowthScheme{text}; });
  fuzz::takenOrRefused([&] {
    project::Choices choices;
    choices.cell = choices.item().mode = text;
    test::giveParameter(choices, text.substr(0, text.find('=')), value);
    pipeline::checkChoices(choices);
    pipeline::parameterValues(choices);
  });
  return 0;
}

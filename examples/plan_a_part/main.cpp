// plan_a_part PART FOLDER: plans a part in flat layers and writes programs, report and project.
#include <base/error.h>
#include <filesystem>
#include <iostream>
#include <pipeline/outputs.h>
#include <pipeline/road.h>
#include <pipeline/stage_options.h>

int main(int argc, char** argv) {
  using namespace voluta;
  if (argc != 3)
    return 1;
  try {
    const base::RunContext run(base::CancelToken(), 2); // two threads
    pipeline::PlanRequest request;
    request.item().part = argv[1];
    project::ItemChoices& choices = request.choices.item();
    choices.mode = "flat";
    choices.scale = "0.3";
    choices.platform = pipeline::usualPlatform(request.choices);
    pipeline::PlanResult result = pipeline::planPart(request, run);
    std::filesystem::create_directories(argv[2]);
    pipeline::writeOutputs(result, argv[2], run);
    std::cout << result.job.report.item().layers.count << " layers\n";
    return pipeline::nothingBlocks(result.job.report) ? 0 : 2;
  } catch (const base::Error& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}

// Descriptions of robots, cells, processes and presets in JSON.
#include "fuzz_target.h"

#include "base/files.h"
#include "pipeline/presets/print_preset.h"
#include "process/process.h"
#include "process/process_text.h"
#include "robot/cell.h"
#include "robot/cell_draft.h"

#include <filesystem>

using namespace voluta;

namespace {

const std::filesystem::path kResources = VOLUTA_SOURCE_DIR "/resources";

// Files are to be named after their contents.
void read(const char* name, const std::string& text, void (*readIt)(const std::filesystem::path&)) {
  fuzz::write(name, text);
  fuzz::takenOrRefused([&] { readIt(name); });
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  ::setenv("VOLUTA_RESOURCES", kResources.c_str(), 1);
  return {base::readFile(kResources / "robots" / "ur5.json"),
          base::readFile(kResources / "robots" / "irb1200.json"),
          base::readFile(kResources / "cells" / "ur5-fixed.json"),
          base::readFile(kResources / "cells" / "lathe.json"),
          base::readFile(kResources / "processes" / "fdm-1.0.json"),
          base::readFile(kResources / "presets" / "draft.json")};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  for (const char* name : {"ur5.json", "irb1200.json"})
    read(name, text, [](const std::filesystem::path& file) {
      const robot::RobotModel robot = robot::readRobot(file);
      fuzz::expect(robot.dof() > 0 && robot.limits.size() == static_cast<std::size_t>(robot.dof()),
                   "every joint has its limits");
    });
  for (const char* name : {"ur5-fixed.json", "lathe.json"})
    read(name, text, [](const std::filesystem::path& file) {
      const robot::Cell cell =
          robot::Cell::read(file, process::loadProcess("fdm-1.0"), {{-9, -9}, {9, -9}, {0, 9}});
      fuzz::expect(cell.home().size() == static_cast<Eigen::Index>(cell.dof()),
                   "the arm has a home for every joint");
      fuzz::expect(cell.externalAxes().size() == (cell.rod() ? 1U : 0U), "a rod has its axis");
      std::vector<Eigen::Isometry3d> frames;
      cell.framePoses(cell.home(), frames);
      fuzz::expect(static_cast<int>(frames.size()) ==
                       cell.armDof() + 4 + static_cast<int>(cell.externalAxes().size()),
                   "every frame has a pose");
    });
  fuzz::takenOrRefused([&] {
    const robot::CellDraft draft(text);
    fuzz::expect(robot::CellDraft(draft.text()) == draft, "a draft comes back from its text");
    for (const robot::DraftBody& body : draft.bodies())
      robot::CellDraft(draft.withPose(body, body.pose).text());
  });
  read("fdm-1.0.json", text, [](const std::filesystem::path& file) {
    const process::Process process = process::readProcess(file);
    fuzz::expect(process.head.sections.size() >= 2, "a head has a shape");
    const std::string written = process::processText(process);
    fuzz::expect(process::sameProcess(process::readProcessText(written, "written"), process),
                 "a process comes back from its text");
  });
  fuzz::takenOrRefused([&] {
    const pipeline::PrintPreset preset = pipeline::readPreset(text, "draft.json");
    fuzz::expect(pipeline::readPreset(pipeline::presetText(preset), "written") == preset,
                 "a preset comes back from its text");
  });
  return 0;
}

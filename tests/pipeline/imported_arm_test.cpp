// From an arm's URDF to a program that passed its replay.
#include "base/files.h"
#include "box_request.h"
#include "cells/arm_import.h"
#include "helpers/temporary_folder.h"
#include "robot/urdf_arms.h"
#include "robot/urdf_text.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

class ImportedArm : public testing::TestWithParam<std::pair<const char*, std::string>> {};

TEST_P(ImportedArm, PrintsABox) {
  const test::TemporaryFolder folder;
  const std::filesystem::path data = folder / std::filesystem::path("data"),
                              urdf = folder / std::filesystem::path("arm.urdf");
  setenv("VOLUTA_DATA", data.c_str(), 1);
  base::writeFile(urdf, GetParam().second);
  const cells::ArmImport import =
      cells::importArm(urdf, {.tip = {}, .base = {}, .id = GetParam().first}, robot::Mount::Flange,
                       process::loadProcess("fdm-1.0"), base::RunContext());
  cells::writeImport(import, data);
  pipeline::PlanRequest request = test::boxRequest();
  request.item().loaded = test::loadedBox({-6, -6, 0}, {6, 6, 4});
  request.choices.item().mode = "flat";
  request.choices.cell = import.layout.cell.id;
  request.choices.formats = {"csv", "krl"};
  const pipeline::PlanResult planned = pipeline::planPart(request, base::RunContext());
  EXPECT_EQ(planned.job.report.motion.unreachable, 0u);
  EXPECT_EQ(planned.job.report.motion.collisions, 0u);
  EXPECT_TRUE(planned.job.report.replay.passed);
  unsetenv("VOLUTA_DATA");
}

INSTANTIATE_TEST_SUITE_P(Urdf, ImportedArm,
                         testing::Values(std::pair("parallel", test::ur5Urdf()),
                                         std::pair("wrist", test::urdfOf(test::irb1200())),
                                         std::pair("numeric", test::urdfOf(test::oddArm()))),
                         [](const auto& one) { return one.param.first; });

} // namespace

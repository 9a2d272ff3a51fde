// Programs of a box whose trajectory has events, in every dialect that has words for them.
#pragma once

#include "process/tooling.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::replay {

class EventPrograms : public ::testing::Test {
protected:
  static std::vector<std::string_view> formatsWith(plan::EventKind kind) {
    std::vector<std::string_view> ids;
    for (const program::Dialect& dialect : test::dialectsFor("urscript"))
      if (dialect.tiltsNozzle && std::ranges::find(dialect.events, kind) != dialect.events.end())
        ids.push_back(dialect.id);
    return ids;
  }
  plan::Program programFor(std::string_view format) const {
    return program::writeProgram(format,
                                 {scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"});
  }
  plan::ReadProgram read(const test::ProgramText& text) const { return test::read(text, tooling_); }
  Verification verify(plan::ReadProgram program) const {
    return replayProgram({std::move(program), scene_.plan, scene_.trajectory, scene_.cell, tooling_,
                          scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  }

  test::Scene scene_ = test::boxScene();
  process::Tooling tooling_{scene_.process};
};

} // namespace voluta::replay

#include "window/page_state.h"

#include "document/document.h"
#include "window/flow_bar.h"

#include <algorithm>

namespace voluta::window {

namespace {
using document::StageState;

PageState worthOf(StageState state) {
  switch (state) {
  case StageState::Nothing:
    return PageState::Nothing;
  case StageState::Running:
    return PageState::Running;
  case StageState::Done:
    return PageState::Done;
  case StageState::OutOfDate:
    return PageState::OutOfDate;
  case StageState::Differs:
    return PageState::Differs;
  case StageState::Blocked:
  case StageState::Failed:
    break;
  }
  return PageState::Blocked;
}
} // namespace

QString stateName(PageState state) {
  switch (state) {
  case PageState::Nothing:
    return FlowBar::tr("nothing yet");
  case PageState::Running:
    return FlowBar::tr("running");
  case PageState::Done:
    return FlowBar::tr("done");
  case PageState::OutOfDate:
    return FlowBar::tr("out of date");
  case PageState::Differs:
    return FlowBar::tr("not as asked or not checked: see the findings");
  default:
    return FlowBar::tr("blocked: see the findings");
  }
}

PageState worstState(const document::Document& document,
                     const std::vector<project::Stage>& stages) {
  PageState worst = PageState::Nothing;
  for (const project::Stage stage : stages)
    worst = std::max(worst, worthOf(document.state(stage)));
  return worst;
}

} // namespace voluta::window

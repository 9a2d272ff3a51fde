#include "window/pages/page_table.h"

#include "window/pages/compare_page.h"
#include "window/pages/export_page.h"
#include "window/pages/layers_page.h"
#include "window/pages/prepare_page.h"
#include "window/pages/simulate_page.h"

namespace voluta::window {

namespace {
template <typename... Pages> std::vector<std::unique_ptr<Page>> made(const Workspace& workspace) {
  std::vector<std::unique_ptr<Page>> pages;
  (pages.push_back(std::make_unique<Pages>(workspace)), ...);
  return pages;
}
} // namespace

// Pages beside the flow come last.
std::vector<std::unique_ptr<Page>> makePages(const Workspace& workspace) {
  return made<PreparePage, LayersPage, SimulatePage, ExportPage, ComparePage>(workspace);
}

} // namespace voluta::window

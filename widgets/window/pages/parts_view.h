// The list of parts on the Prepare page, and the commands on parts.
#pragma once

#include "jobs/job_runner.h"
#include "panels/part_list.h"
#include "window/pages/page.h"

#include <optional>
#include <vector>

namespace voluta::pipeline {
struct PlanRequest;
}

namespace voluta::window {

class PartsView : public QObject {
  Q_OBJECT

public:
  // `page`: with the list; only there the key that removes a part has an effect. All of `workspace`
  // must outlive this.
  PartsView(const Workspace& workspace, Page& page);

  // Created here, to be placed by the caller; visible from two parts on.
  panels::PartList* list() { return list_; }
  std::vector<Command> commands();
  void show();

private:
  void arrange();
  void editName();
  void chooseCopies();
  void makeCopies(std::optional<std::size_t> count); // none: as many as there is room for
  void takeCopies(const pipeline::PlanRequest& made);
  // All parts that are selected in the list, at least the active one.
  std::vector<std::size_t> selected() const;

  Workspace work_;
  const Page& page_;
  panels::PartList* list_;
  jobs::JobRunner runner_;
};

} // namespace voluta::window

// Comparison of ways of building the document's part, planned in turn in the background.
#pragma once

#include "jobs/job_runner.h"
#include "pipeline/compare_figures.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::document {

class Document;

// Ways to compare; an empty list stands for the document's own value.
struct ComparedWays {
  std::vector<std::string> modes;
  std::vector<curved::GrowthScheme> growths;
  std::vector<project::Platform> platforms;
  project::Stage until = project::Stage::Replay;
  std::vector<std::string> cells = {}; // ids
};

// Makes a picture of a planned job; called on the thread of the run. Null: no pictures.
using PictureMaker = std::function<QImage(const project::Job&)>;

class Comparing : public QObject {
  Q_OBJECT

public:
  // `document` has to outlive the object.
  explicit Comparing(Document& document, QObject* parent = nullptr);
  ~Comparing() override;

  void setPictures(PictureMaker pictures) { pictures_ = std::move(pictures); }

  // Precondition: the document has a part that is ready. Drops the rows of the last comparison.
  void run(const ComparedWays& ways);
  // Keeps completed rows.
  void cancel();
  bool running() const { return runner_.running(); }
  const jobs::Progress& progress() const { return runner_.progress(); }

  struct Row {
    pipeline::Combination combination;
    std::optional<pipeline::CompareRow> compared; // nullopt: not planned yet, or never
    QImage picture;
    // Its plan, to continue from; kept for the best few only.
    std::shared_ptr<const pipeline::PlanResult> result;
  };
  const std::vector<Row>& rows() const { return rows_; }
  std::optional<std::size_t> current() const { return current_; } // row that is being planned
  project::Stage until() const { return until_; }
  // Which of several cells suits the part, and why; empty until the comparison has ended, and for
  // one cell.
  const base::Message& advice() const { return advice_; }
  // Returns whether the part and all other choices are those with which the rows were planned.
  bool upToDate() const;

  const pipeline::Weights& weights() const { return weights_; }
  void setWeights(const pipeline::Weights& weights);
  // Ranking of the completed rows; `scores` and the row numbers refer to rows(), which is in order
  // of planning.
  const pipeline::Ranking& ranking() const { return ranking_; }

signals:
  void started();
  void progressed(const voluta::jobs::Progress& progress);
  void rowsChanged();                  // the set of rows
  void rowChanged(int row);            // its planning begins or is done
  void rankingChanged();               // scores, the best
  void ended();                        // also after a cancel
  void failed(const QString& message); // the part or a choice is unusable; before ended()

private:
  std::string keyOf(const pipeline::PlanRequest& request) const;
  bool sameAsPlanned() const;
  void take(std::size_t row, const pipeline::CompareRow& compared, const QImage& picture,
            std::shared_ptr<const pipeline::PlanResult> result);
  void rankAgain();

  Document& document_;
  jobs::JobRunner runner_;
  PictureMaker pictures_;
  std::vector<Row> rows_;
  std::optional<std::size_t> current_;
  pipeline::Weights weights_ = pipeline::defaultWeights();
  pipeline::Ranking ranking_;
  project::Stage until_ = project::Stage::Replay;
  std::string key_;
  base::Message advice_;
  mutable std::optional<bool>
      upToDate_; // valid until the next edit: queried far more often than it changes
};

} // namespace voluta::document

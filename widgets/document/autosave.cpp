#include "document/autosave.h"

#include "base/files.h"
#include "document/document.h"
#include "language/words.h"
#include "project/job.h"

#include <QDir>
#include <QFile>
#include <QTimer>
#include <QUuid>
#include <filesystem>
#include <utility>

namespace voluta::document {

namespace {
std::filesystem::path pathOf(const QString& file) {
  return file.toStdString();
}

QString newCopy(const QString& folder) {
  return QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) +
                               QStringLiteral(".voluta"));
}
} // namespace

Autosave::Autosave(Document& document, AutosaveOptions options, QObject* parent)
    : QObject(parent), document_(document), options_(std::move(options)), pause_(new QTimer(this)),
      atLatest_(new QTimer(this)) {
  file_ = newCopy(options_.folder);
  pause_->setSingleShot(true);
  pause_->setInterval(options_.pauseMs);
  atLatest_->setSingleShot(true);
  atLatest_->setInterval(options_.atLatestMs);
  connect(pause_, &QTimer::timeout, this, &Autosave::write);
  connect(atLatest_, &QTimer::timeout, this, &Autosave::write);
  connect(&document_, &Document::edited, this, &Autosave::noteChange);
  connect(&document_, &Document::resultChanged, this, &Autosave::noteChange);
  connect(&document_, &Document::settled, this, &Autosave::remove);
  connect(&document_, &Document::dirtyChanged, this, [this](bool dirty) {
    if (!dirty)
      remove();
  });
}

Autosave::~Autosave() {
  remove();
}

void Autosave::adopt(const Recovered& recovered) {
  adopted_ = recovered;
  noteChange();
}

void Autosave::noteChange() {
  if (!document_.source())
    return;
  pause_->start();
  if (!atLatest_->isActive())
    atLatest_->start();
}

void Autosave::write() {
  pause_->stop();
  atLatest_->stop();
  if (!document_.source())
    return;
  if (runner_.running()) {
    again_ = true;
    return;
  }
  again_ = false;
  unwanted_ = std::make_shared<std::atomic<bool>>(false);
  runner_.run(
      [copy = file_, folder = options_.folder, unwanted = unwanted_, job = document_.snapshot(),
       owner = ownerBytes(document_.name(), document_.projectFile())](const base::RunContext&) {
        std::error_code status;
        std::filesystem::create_directories(pathOf(folder), status);
        // Write the owner first: a copy without an owner would look like one left behind by a
        // crash.
        base::writeFile(pathOf(ownerFileOf(copy)),
                        {owner.constData(), static_cast<std::size_t>(owner.size())});
        if (!unwanted->load())
          project::writeJob(pathOf(copy), job);
        if (unwanted->load())
          discardRecovered({copy, {}, {}, {}});
        return true;
      },
      [this](const base::Outcome<bool>& outcome) { writeEnded(outcome); }, 1);
}

void Autosave::writeEnded(const base::Outcome<bool>& outcome) {
  if (const auto* error = std::get_if<base::Error>(&outcome)) {
    if (!std::exchange(reported_, true))
      emit failed(language::words(error->whole()));
  } else if (std::holds_alternative<bool>(outcome)) {
    reported_ = false;
    if (adopted_)
      discardRecovered(*std::exchange(adopted_, std::nullopt));
    emit written();
  }
  if (again_)
    write();
}

// A pending write cleans up after itself, so the next copy uses another file.
void Autosave::remove() {
  pause_->stop();
  atLatest_->stop();
  again_ = false;
  if (unwanted_)
    unwanted_->store(true);
  runner_.cancel();
  discardRecovered({file_, {}, {}, {}});
  file_ = newCopy(options_.folder);
  if (adopted_)
    discardRecovered(*std::exchange(adopted_, std::nullopt));
}

} // namespace voluta::document

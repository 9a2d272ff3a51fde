#include "window/manual/manual_pages.h"

#include "base/parameters.h"
#include "language/parameter_texts.h"
#include "language/translated.h"
#include "language/words.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"

#include <QCoreApplication>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <QWidget>

namespace voluta::window {

namespace {

QUrl pageOf(const QString& folder, const QString& name) {
  return QUrl("qrc:/docs/" + folder + "/" + name + ".md");
}
QUrl manualPage(const QString& name) {
  return pageOf("manual", name);
}
const QString kContents = "README";

QUrl settingsUrl() {
  return manualPage("all_settings");
}
QUrl findingsUrl() {
  return manualPage("all_findings");
}

QString compiledText(const QUrl& url) {
  QFile file(":" + url.path());
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// Returns the pages that a table of contents links to.
std::vector<ManualPage> linkedPages(const QUrl& contents) {
  static const QRegularExpression kLink(R"(\[([^\]]+)\]\(([A-Za-z0-9_./]+\.md)\))");
  std::vector<ManualPage> pages;
  const QString text = compiledText(contents);
  for (auto links = kLink.globalMatch(text); links.hasNext();) {
    const QRegularExpressionMatch link = links.next();
    const QUrl url = contents.resolved(QUrl(link.captured(2)));
    const bool isKnown = std::any_of(pages.begin(), pages.end(),
                                     [&](const ManualPage& page) { return page.url == url; });
    if (!isKnown && url.adjusted(QUrl::RemoveFilename) == contents.adjusted(QUrl::RemoveFilename))
      pages.push_back({link.captured(1), url});
  }
  return pages;
}

// Within a cell of a table.
QString cell(QString text) {
  return text.replace('|', "\\|").replace('\n', ' ').replace('<', "&lt;").replace('*', "\\*");
}

QString rangeOf(const base::ParameterSpec& spec) {
  using language::valueText;
  switch (spec.type) {
  case base::ParameterType::Number:
    return QCoreApplication::translate("Manual", "%1 to %2")
        .arg(valueText(spec, spec.minimum), valueText(spec, spec.maximum));
  case base::ParameterType::Integer:
    return QCoreApplication::translate("Manual", "%1 to %2")
        .arg(valueText(spec, static_cast<long long>(spec.minimum)),
             valueText(spec, static_cast<long long>(spec.maximum)));
  case base::ParameterType::Choice: {
    QStringList labels;
    for (const base::Choice& choice : spec.choices)
      labels << language::heading(choice.label);
    return labels.join(", ");
  }
  default:
    return {};
  }
}

QString settingsText() {
  QStringList groups;
  QHash<QString, QStringList> rows;
  const base::ParameterTable table = pipeline::allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    const QString group = language::heading(spec.group);
    if (!rows.contains(group))
      groups << group;
    rows[group] << QStringLiteral("| %1 | %2 | %3 | %4 | `%5` |")
                       .arg(cell(language::heading(spec.label)),
                            cell(language::translatedHeading(spec.help)), cell(rangeOf(spec)),
                            cell(language::valueText(spec, spec.defaultValue)),
                            QString::fromStdString(spec.key));
  }
  QStringList text{QStringLiteral("# ") + QCoreApplication::translate("Manual", "All settings"),
                   QString()};
  for (const QString& group : groups)
    text << QStringLiteral("## ") + group << QString()
         << QStringLiteral("| %1 | %2 | %3 | %4 | %5 |")
                .arg(QCoreApplication::translate("Manual", "setting"),
                     QCoreApplication::translate("Manual", "meaning"),
                     QCoreApplication::translate("Manual", "range"),
                     QCoreApplication::translate("Manual", "default"),
                     QCoreApplication::translate("Manual", "key"))
         << "|---|---|---|---|---|" << rows[group] << QString();
  return text.join('\n');
}

// Returns a reason without its values.
QString withoutValues(QString sentence) {
  static const QRegularExpression kValue(R"(\{[^}]*\})");
  return sentence.replace(kValue, "…");
}

QString findingsText() {
  QStringList text{QStringLiteral("# ") + QCoreApplication::translate("Manual", "All findings"),
                   QString(),
                   QStringLiteral("| %1 | %2 |")
                       .arg(QCoreApplication::translate("Manual", "finding"),
                            QCoreApplication::translate("Manual", "what would help")),
                   "|---|---|"};
  for (const plan::FindingRow& row : plan::findingRows()) {
    const QString reason = withoutValues(language::heading(row.reason));
    if (reason != "…") // the words of somebody else, such as a reader's
      text << QStringLiteral("| %1 | %2 |")
                  .arg(cell(reason), cell(withoutValues(language::heading(row.remedy))));
  }
  return text.join('\n') + "\n";
}

} // namespace

std::vector<ManualChapter> manualChapters() {
  ManualChapter manual{{}, linkedPages(manualPage(kContents))};
  manual.pages.insert(manual.pages.begin(),
                      {QCoreApplication::translate("Manual", "Contents"), manualPage(kContents)});
  manual.pages.push_back({QCoreApplication::translate("Manual", "All settings"), settingsUrl()});
  manual.pages.push_back({QCoreApplication::translate("Manual", "All findings"), findingsUrl()});
  return {std::move(manual),
          {QCoreApplication::translate("Manual", "Algorithms"),
           linkedPages(pageOf("algorithms", kContents))}};
}

QString madePage(const QUrl& url) {
  return url == settingsUrl() ? settingsText() : url == findingsUrl() ? findingsText() : QString();
}

QString manualText(const QUrl& url) {
  const QString made = madePage(url);
  return made.isEmpty() ? compiledText(url) : made;
}

QUrl manualPageFor(const QWidget* widget, const QString& pageId) {
  // By the object names of dialogs and panels, and by the ids of pages.
  static const QHash<QString, QString> kPages{
      {"prepare", "prepare"},      {"layers", "layers"},         {"simulate", "simulate"},
      {"export", "export"},        {"compare", "compare"},       {"findingsPanel", "findings"},
      {"cellEditor", "cell"},      {"touchDialog", "substrate"}, {"measureDialog", "cell"},
      {"armImportDialog", "cell"}, {"library", "process"},       {"compareItems", "process"},
      {"headNumbers", "process"},  {"sizes", "process"},         {"togetherDialog", "machines"},
      {"millDialog", "milling"},   {"verifyDialog", "export"},   {"runDialog", "export"},
      {"copiesDialog", "prepare"}};
  const auto page = [&](const QString& name) { return manualPage(kPages.value(name, kContents)); };
  for (const QWidget* w = widget; w; w = w->parentWidget())
    if (kPages.contains(w->objectName()))
      return page(w->objectName());
  return page(pageId);
}

} // namespace voluta::window

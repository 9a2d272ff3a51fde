// Texts of core, as the window shows them.
#include "language/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

// Italian as the file of translations would have it, of two sentences.
class Italian : public QTranslator {
public:
  QString translate(const char* context, const char* text, const char*, int n) const override {
    if (QLatin1String(context) != QLatin1String("Core"))
      return {};
    const QLatin1String source(text);
    if (source == QLatin1String("{area:.3g} lean over by more than {angle}"))
      return QStringLiteral("oltre {angle} si inclinano {area:.3g}");
    if (source == QLatin1String("{voxels} voxels lie below the plate"))
      return n == 1 ? QStringLiteral("{voxels} voxel sta sotto la piastra")
                    : QStringLiteral("{voxels} voxel stanno sotto la piastra");
    return {};
  }
  bool isEmpty() const override { return false; }
};

class Words : public testing::Test {
protected:
  ~Words() override {
    QCoreApplication::removeTranslator(&italian_);
    QLocale::setDefault(before_);
  }
  void speakItalian() {
    QCoreApplication::installTranslator(&italian_);
    QLocale::setDefault(QLocale(QLocale::Italian, QLocale::Italy));
  }

private:
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  int count_ = 1;
  QCoreApplication application_{count_, arguments_};
  Italian italian_;
  QLocale before_;
};

base::Message leaning(double area) {
  return base::message("{area:.3g} lean over by more than {angle}"_text, base::mm2(area),
                       base::degrees(45.0));
}
base::Message below(int voxels) {
  return base::message(
      "{voxels} voxel lies below the plate|{voxels} voxels lie below the plate"_plural, voxels);
}

TEST_F(Words, EnglishHasSignsOfUnitsAndItsForms) {
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  EXPECT_EQ(language::words(leaning(7.031)).toStdString(), "7.03 mm² lean over by more than 45°");
  EXPECT_EQ(language::words(below(1)).toStdString(), "1 voxel lies below the plate");
  EXPECT_EQ(language::words(below(12345)).toStdString(), "12,345 voxels lie below the plate");
  EXPECT_EQ(language::heading("fewest missed voxels"_text).toStdString(), "Fewest missed voxels");
}

TEST_F(Words, ItalianHasItsOrderNumbersAndForms) {
  speakItalian();
  EXPECT_EQ(language::words(leaning(7.031)).toStdString(), "oltre 45° si inclinano 7,03 mm²");
  EXPECT_EQ(language::words(below(1)).toStdString(), "1 voxel sta sotto la piastra");
  EXPECT_EQ(language::words(below(12345)).toStdString(), "12.345 voxel stanno sotto la piastra");
  EXPECT_EQ(language::words(base::message("{what} ({remedy})"_text, leaning(0.5), "?"_name))
                .toStdString(),
            "oltre 45° si inclinano 0,5 mm² (?)");
}

} // namespace

// A sheet as HTML and as PDF: nothing of it is markup by accident, and the map has the legend's
// colours.
#include "page/sheet.h"

#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <string>

using namespace voluta::page;

namespace {

Sheet sample() {
  Sheet sheet;
  sheet.title = "a<b>.stl: proof";
  sheet.issued = "Voluta, today";
  sheet.verdict = "Passed: all is well.";
  sheet.verdictDetail = "In detail.";
  sheet.facts = {{"Part", "a & b"}, {"Mass", "12 g"}};
  sheet.checksTitle = "Checks";
  sheet.checks = {{Mark::Passed, "Fill: 99 %.", "layer 3"}, {Mark::Note, "Half-carried: 1 %.", ""}};
  sheet.mapsTitle = "Map";
  sheet.legend = {{{1, 2, 3}, "full"}, {{200, 100, 0}, "half"}, {{9, 9, 9}, "unused"}};
  sheet.maps = {{3, 2, {0, 0, 1, CellMap::kNothing, 1, 0}, "front"}};
  sheet.filesTitle = "Files";
  sheet.files = {{"a.script", "12 bytes", std::string(64, 'a')}};
  return sheet;
}

// Fills of rectangles of the part of the text.
std::set<std::string> fillsOf(const std::string& text) {
  const std::regex fill("fill=\"(#[0-9a-f]{6})\"");
  std::set<std::string> fills;
  for (std::sregex_iterator at(text.begin(), text.end(), fill), end; at != end; ++at)
    fills.insert((*at)[1]);
  return fills;
}

TEST(Sheet, TheMapIsDrawnInTheLegendsColours) {
  const std::string page = html(sample());
  const std::size_t legend = page.find("<ul class=\"legend\">");
  ASSERT_NE(legend, std::string::npos);
  EXPECT_EQ(fillsOf(page.substr(0, legend)), (std::set<std::string>{"#010203", "#c86400"}));
  EXPECT_EQ(fillsOf(page.substr(legend)), (std::set<std::string>{"#010203", "#c86400", "#090909"}));
}

TEST(Sheet, TextIsNoMarkup) {
  const std::string page = html(sample());
  EXPECT_NE(page.find("a&lt;b&gt;.stl"), std::string::npos);
  EXPECT_NE(page.find("a &amp; b"), std::string::npos);
  EXPECT_EQ(page.find("<b>.stl"), std::string::npos);
}

// A file of an old system is named in Latin-1.
TEST(Sheet, BytesThatAreNoTextDoNotStopIt) {
  Sheet sheet = sample();
  sheet.title = "Zahnr\344d.stl: proof";
  sheet.facts[0].value = "Zahnr\344d.stl";
  sheet.files[0].name = "Zahnr\344d.script";
  EXPECT_EQ(pdf(sheet).substr(0, 5), "%PDF-");
  const std::string page = html(sheet);
  EXPECT_NE(page.find("<h1>Zahnr\xef\xbf\xbd"
                      "d.stl: proof</h1>"),
            std::string::npos);
  EXPECT_EQ(page.find('\344'), std::string::npos);
}

// Nothing is fetched from elsewhere.
TEST(Sheet, PageIsSelfContained) {
  Sheet sheet = sample();
  sheet.pictures = {{"no PNG, only bytes", "a picture"}};
  const std::string page = html(sheet);
  EXPECT_NE(page.find("src=\"data:image/png;base64,bm8gUE5HLCBvbmx5IGJ5dGVz\""), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST(Sheet, ManyFilesContinueOnTheNextPage) {
  const auto pagesOf = [](const Sheet& sheet) {
    const std::string bytes = pdf(sheet);
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    const std::regex count("/Count ([0-9]+)");
    std::smatch found;
    return std::regex_search(bytes, found, count) ? std::stoi(found[1]) : 0;
  };
  Sheet sheet = sample();
  EXPECT_EQ(pagesOf(sheet), 1);
  sheet.files.assign(60, sheet.files.front());
  EXPECT_EQ(pagesOf(sheet), 2);
}

} // namespace

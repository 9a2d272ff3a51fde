// Events of slicers as events of layers, and as ranges of heights with a tool.
#include "project/file_events.h"

#include "project/choices.h"
#include "project/file_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::project {
namespace {

using geometry::EventOfFile, geometry::EventOfFileKind;
using ::testing::ElementsAre, ::testing::HasSubstr;

struct Made {
  FileEvents events;
  std::vector<std::string> notes;
};
Made madeFrom(const std::vector<EventOfFile>& events, double topMm = 20.0) {
  std::vector<base::Message> notes;
  FileEvents made = eventsOfFile(events, topMm, notes);
  return {std::move(made), base::english(notes)};
}

TEST(FileEvents, PausesAndColoursAreEventsOfLayers) {
  const Made made = madeFrom({{EventOfFileKind::Pause, 0.0, 1, {}},
                              {EventOfFileKind::Colour, 3.25, 1, "#FF8000"},
                              {EventOfFileKind::Colour, 4.0, 1, {}},
                              {EventOfFileKind::Pause, 6.0, 1, "Put in the nut"},
                              {EventOfFileKind::Pause, 20.0, 1, "late"}});
  EXPECT_EQ(made.events.layerEvents,
            "1 pause; z3.25 filament Change to colour #FF8000; z4 filament Change the colour; "
            "z6 pause Put in the nut");
  EXPECT_TRUE(made.events.tools.empty());
  EXPECT_THAT(made.notes,
              ElementsAre("from the file: a pause at a height of 0 mm",
                          "from the file: a change of colour at a height of 3.25 mm",
                          "from the file: a change of colour at a height of 4 mm",
                          "from the file: a pause at a height of 6 mm",
                          "not used: a pause at a height of 20 mm in the file: the part ends at 20 "
                          "mm"));
}

TEST(FileEvents, TextsAreThoseOfControllers) {
  const auto textOf = [](const std::string& text) {
    return madeFrom({{EventOfFileKind::Pause, 5.0, 1, text}}).events.layerEvents;
  };
  EXPECT_EQ(textOf("a; 12 pause\n\"b\" \\"), "z5 pause a, 12 pause 'b' /");
  EXPECT_EQ(textOf("Gr\xc3\xbc\xc3\x9f"), "z5 pause Gruess");
  EXPECT_EQ(textOf(std::string(100, 'x')), "z5 pause " + std::string(44, 'x'));
}

TEST(FileEvents, ToolsAreRangesOfHeights) {
  const Made made = madeFrom({{EventOfFileKind::Tool, 4.0, 2, {}},
                              {EventOfFileKind::Pause, 5.0, 1, {}},
                              {EventOfFileKind::Tool, 9.5, 1, {}}});
  ASSERT_EQ(made.events.tools.size(), 2u);
  EXPECT_EQ(made.events.tools[0].shape, "height:4,9.5");
  EXPECT_EQ(made.events.tools[0].parameters, (std::map<std::string, std::string>{{"tool", "2"}}));
  EXPECT_EQ(made.events.tools[1].shape, "height:9.5,100000");
  EXPECT_EQ(made.events.layerEvents, "z5 pause");
}

TEST(FileEvents, AnItemKeepsItsOwnEvents) {
  LoadedPart part;
  part.layerEvents = "z5 pause";
  part.regions = {{.shape = "height:4,9.5"}};
  ItemChoices item;
  takeFromFile(item, part);
  EXPECT_EQ(item.parameters.at("layerEvents"), "z5 pause");
  EXPECT_EQ(item.regions.size(), 1u);
  item.parameters["layerEvents"] = "3 pause";
  takeFromFile(item, part);
  EXPECT_EQ(item.parameters.at("layerEvents"), "3 pause");
}

} // namespace
} // namespace voluta::project

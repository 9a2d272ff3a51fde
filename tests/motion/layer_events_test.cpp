// Events of layers: their texts, their places in the tool-paths, and the trajectory with them.
#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/change_place.h"
#include "motion/layer_event_text.h"
#include "motion/layer_events.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"
#include "motion/sample_plans.h"
#include "plan/waypoints.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace voluta {
namespace {

using motion::layerEventsOf;
using plan::EventKind, plan::LayerEvent, plan::LayerEventKind;

TEST(LayerEvents, APauseWithoutATextStandsBetweenOthers) {
  const auto events = layerEventsOf("3 output 3 on; 3 pause; 4 output 3 off");
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[1].kind, LayerEventKind::Pause);
  EXPECT_TRUE(events[1].text.empty());
}

TEST(LayerEvents, AreReadFromTheirText) {
  const auto events = layerEventsOf(
      "12 pause; 20 pause Put in the nut ;z5.5 wait 60; 30 output 3 on;31 output 3 off"
      "; 40 tool 2; 50 statement rapid TPWrite \"a; b\";; 60 statement krl X=1");
  ASSERT_EQ(events.size(), 8u);
  EXPECT_EQ(events[0].layer, 12);
  EXPECT_EQ(events[0].kind, LayerEventKind::Pause);
  EXPECT_TRUE(events[0].text.empty());
  EXPECT_EQ(events[1].text, "Put in the nut");
  EXPECT_EQ(events[2].layer, 0);
  EXPECT_DOUBLE_EQ(events[2].heightMm, 5.5);
  EXPECT_DOUBLE_EQ(events[2].seconds, 60.0);
  EXPECT_EQ(events[3].number, 3);
  EXPECT_TRUE(events[3].on);
  EXPECT_FALSE(events[4].on);
  EXPECT_EQ(events[5].kind, LayerEventKind::Tool);
  EXPECT_EQ(events[5].number, 2);
  EXPECT_EQ(events[6].format, "rapid");
  EXPECT_EQ(events[6].text, "TPWrite \"a; b\";");
  EXPECT_EQ(events[7].text, "X=1");
  EXPECT_TRUE(layerEventsOf(" ; ").empty());
  for (const char* wrong :
       {"pause", "12", "0 pause", "z0 pause", "z pause", "12 stop", "12 wait", "12 wait -1",
        "12 wait nan", "12 output 3", "12 output on", "12 output 3 maybe", "12 tool 0",
        "12 statement", "12 statement urscript", "12 pause; 13 wait",
        "12 pause a text that is longer than a pendant has room for"})
    EXPECT_THROW(layerEventsOf(wrong), base::Error) << wrong;
}

TEST(LayerEvents, AChangeOfFilamentIsAPauseWithAPurge) {
  const auto events = layerEventsOf("3 filament Change to red; z5 filament; 6 pause");
  ASSERT_EQ(events.size(), 3u);
  for (const auto& event : events)
    EXPECT_EQ(event.kind, LayerEventKind::Pause);
  EXPECT_EQ(events[0].text, "Change to red");
  EXPECT_TRUE(events[0].changesFilament);
  EXPECT_TRUE(events[1].changesFilament);
  EXPECT_FALSE(events[2].changesFilament);
}

TEST(LayerEvents, TextsThatControllersCannotShowAreRefused) {
  const auto reasonOf = [](const std::string& text) {
    try {
      layerEventsOf(text);
    } catch (const base::Error& error) {
      return base::english(error.whole());
    }
    return std::string();
  };
  EXPECT_NE(reasonOf("12 pause " + std::string(45, 'a')).find("at most 44 characters"),
            std::string::npos);
  EXPECT_EQ(reasonOf("12 pause " + std::string(44, 'a')), "");
  for (const char* text : {"12 pause Mutter für das Gehäuse", "12 pause the \"nut\"",
                           "12 statement krl ; Gehäuse", "12 statement krl a\tb"})
    EXPECT_NE(reasonOf(text).find("controllers do not know"), std::string::npos) << text;
  EXPECT_EQ(reasonOf("12 statement rapid TPWrite \"nut\\0A\""), "");
}

TEST(LayerEvents, ARemovedToolLeavesItsLayersToTheFirst) {
  const char* const text = "12 pause tool 2 ; 20 tool 2; z5.5 tool 3;30 tool 1; 40 tool 4;";
  EXPECT_EQ(motion::eventsWithoutTool(text, 2),
            "12 pause tool 2 ; 20 tool 1; z5.5 tool 2;30 tool 1; 40 tool 3;");
  EXPECT_EQ(motion::eventsWithoutTool("tool 2", 2), "tool 2");
  EXPECT_EQ(motion::eventsWithoutTool("", 2), "");
}

// Two parts, each with its own layers, one after the other.
plan::ToolPlan twoParts() {
  plan::ToolPlan plan = test::cylinder(15, 8);
  for (plan::ToolPath& path : plan.paths)
    path.item = path.layer < 4 ? 0 : 1;
  return plan;
}

TEST(LayerEvents, CountTheLayersOfTheirPart) {
  const plan::ToolPlan plan = twoParts();
  ASSERT_EQ(plan.paths.size(), 8u);
  EXPECT_EQ(motion::layersOfItem(plan, 0), 4);
  EXPECT_EQ(motion::layersOfItem(plan, 1), 4);
  const auto places = motion::eventPlaces(
      plan, {{.item = 1, .layer = 3}, {.item = 0, .layer = 3}, {.item = 0, .layer = 5}});
  ASSERT_EQ(places.size(), 2u) << "the first part has no fifth layer";
  EXPECT_EQ(places[0].event, 1u);
  EXPECT_EQ(places[0].path, 2u);
  EXPECT_EQ(places[1].event, 0u);
  EXPECT_EQ(places[1].path, 6u);
  EXPECT_EQ(places[1].layer, 3);
  EXPECT_EQ(places[1].layers, 4);
  motion::EventPlace place = places[1];
  place.event = 0;
  const auto pause = motion::trajectoryEvents(plan, {{.item = 1, .layer = 3}}, place).front();
  EXPECT_NE(pause.text.find("layer 3 of 4 of part 2"), std::string::npos) << pause.text;
}

TEST(LayerEvents, TheLayersOfThePrintAreThoseOfItsParts) {
  const plan::ToolPlan plan = twoParts();
  const auto first = motion::layerOfItem(plan, 3), second = motion::layerOfItem(plan, 4);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->item, 0);
  EXPECT_EQ(first->layer, 4);
  EXPECT_EQ(second->item, 1);
  EXPECT_EQ(second->layer, 1);
  EXPECT_FALSE(motion::layerOfItem(plan, 8));
}

TEST(LayerEvents, SeveralPartsHaveBeadsInALayer) {
  plan::ToolPlan plan = test::cylinder(15, 8);
  for (std::size_t p = 0; p < plan.paths.size(); ++p) {
    plan.paths[p].item = static_cast<int>(p % 2);
    plan.paths[p].layer = static_cast<int>(p / 2);
  }
  const auto items = motion::itemsInLayer(plan, 2);
  ASSERT_EQ(items.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(items[i].item, static_cast<int>(i));
    EXPECT_EQ(items[i].layer, 3);
  }
  EXPECT_TRUE(motion::itemsInLayer(plan, 8).empty());
}

TEST(LayerEvents, ComeAtHeightsAndBeforeBeads) {
  const plan::ToolPlan plan = test::cylinder(15, 4);
  const double second = plan.position[plan.paths[1].first].z();
  const auto places = motion::eventPlaces(
      plan, {{.heightMm = second - 0.01}, {.heightMm = second + 0.01}, {.bead = 4}});
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].path, 1u) << "the layer that ends above the height";
  EXPECT_EQ(places[1].path, 2u);
  EXPECT_EQ(places[2].path, 3u);
}

TEST(LayerEvents, APrimeInTheAirIsNoHeightOfThePart) {
  plan::ToolPlan plan = test::cylinder(15, 4);
  plan.paths[0].kind = plan::PathKind::Prime;
  for (std::size_t i = 0; i < plan.paths[0].count; ++i)
    plan.position[i].z() = 100.0;
  EXPECT_TRUE(motion::eventPlaces(plan, {{.heightMm = 50.0}}).empty());
}

TEST(LayerEvents, ThePauseNamesItsLayerAndItsText) {
  const plan::ToolPlan plan = test::cylinder(15, 4);
  const motion::EventPlace place{.path = 2, .layer = 3, .layers = 4, .heightMm = 5.5};
  EXPECT_EQ(motion::trajectoryEvents(plan, {{.layer = 3}}, place).front().text,
            "Paused before layer 3 of 4 (z 5.50 mm)");
  EXPECT_EQ(
      motion::trajectoryEvents(plan, {{.layer = 3, .text = "Put in the nut"}}, place).front().text,
      "Put in the nut (layer 3 of 4, z 5.50 mm)");
}

// The operator answers one question where several stops fall together, with each text once.
TEST(LayerEvents, StopsAtOnePlaceAreOneQuestion) {
  const plan::ToolPlan plan = test::cylinder(15, 4);
  const auto stop = [](const std::string& text) { return LayerEvent{.layer = 3, .text = text}; };
  const LayerEvent output{.layer = 3, .kind = LayerEventKind::Output, .number = 3, .on = true};
  const auto textsOf = [&](const std::vector<LayerEvent>& events) {
    std::vector<std::string> texts;
    for (const motion::EventPlace& place : motion::eventPlaces(plan, events))
      for (const plan::TrajectoryEvent& event : motion::trajectoryEvents(plan, events, place))
        texts.push_back(event.kind == EventKind::Pause ? event.text : "output");
    return texts;
  };
  std::vector<std::string> texts = textsOf({{.layer = 3, .isListed = true},
                                            stop("Put in the nut"),
                                            stop("Turn the plate"),
                                            stop("Put in the nut")});
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(texts[0].starts_with("Put in the nut / Turn the plate (layer 3 of 4, z "))
      << texts[0];
  // What lies between them stays between them.
  texts = textsOf({stop("Put in the nut"), output, stop("Turn the plate")});
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_EQ(texts[1], "output");
  // Texts for which there is no room are a stop of their own.
  const std::string longest(motion::kOwnTextLength, 'x');
  texts = textsOf({stop(longest), stop("Turn the plate")});
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_TRUE(texts[1].starts_with("Turn the plate (")) << texts[1];
}

TEST(LayerEvents, APhotoIsAPulseAtRest) {
  const plan::ToolPlan plan = test::cylinder(15, 4);
  const std::vector<LayerEvent> events = layerEventsOf("3 photo 4; 4 photo 5 1.5");
  ASSERT_EQ(events.size(), 2u);
  EXPECT_TRUE(motion::waitsAside(events[0].kind));
  EXPECT_DOUBLE_EQ(events[0].seconds, 0.5);
  const auto places = motion::eventPlaces(plan, events);
  ASSERT_EQ(places.size(), 2u);
  const auto pulse = motion::trajectoryEvents(plan, events, places[1]);
  ASSERT_EQ(pulse.size(), 3u);
  EXPECT_EQ(pulse[0].kind, EventKind::Output);
  EXPECT_EQ(pulse[0].tool, 5);
  EXPECT_TRUE(pulse[0].on);
  EXPECT_EQ(pulse[1].kind, EventKind::Wait);
  EXPECT_DOUBLE_EQ(pulse[1].seconds, 1.5);
  EXPECT_EQ(pulse[2].tool, 5);
  EXPECT_FALSE(pulse[2].on);
  for (const char* wrong : {"3 photo", "3 photo x", "3 photo 4 0.05", "3 photo 4 100"})
    EXPECT_THROW(layerEventsOf(wrong), base::Error) << wrong;
}

class LayerEventMotion : public ::testing::Test {
protected:
  motion::MotionResult planned(std::vector<LayerEvent> events, const std::string& cellText = {}) {
    cell_.emplace(
        robot::loadCell(cellText.empty() ? "ur5-moving" : cellText, process_, test::disc(20)));
    motion::MotionOptions options;
    options.layerEvents = std::move(events);
    options.purge.primesBeside = true;
    const collision::GrowingPart part(plan_, 0.45, {});
    return motion::MotionPlanner(plan_, *cell_, tooling_, part, options).plan({});
  }
  static std::vector<EventKind> kindsOf(const plan::Trajectory& t) {
    std::vector<EventKind> kinds;
    for (const plan::TrajectoryEvent& event : t.events)
      kinds.push_back(event.kind);
    return kinds;
  }
  bool dripsOnPart(const plan::Trajectory& t, std::size_t point) {
    motion::MotionOptions options;
    const collision::GrowingPart part(plan_, 0.45, {});
    const collision::CellCollision collision(*cell_, process_);
    const motion::MotionScene scene{plan_, *cell_, collision, part, options, {}};
    return motion::dropsOnPart(scene, Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof));
  }

  plan::ToolPlan plan_ = test::cylinder(15, 4);
  process::Process process_ = process::loadProcess("fdm-1.0");
  process::Tooling tooling_{process_};
  std::optional<robot::Cell> cell_;
};

TEST_F(LayerEventMotion, WaitsBesideThePartAndPrimesAgain) {
  for (const LayerEventKind kind : {LayerEventKind::Pause, LayerEventKind::Wait}) {
    const auto result = planned({{.layer = 3, .kind = kind, .seconds = 60.0}});
    EXPECT_TRUE(result.skipped.empty());
    EXPECT_EQ(result.statistics.collisions, 0u);
    const plan::Trajectory& t = result.trajectory;
    const bool isPause = kind == LayerEventKind::Pause;
    const auto event = std::ranges::find(t.events, isPause ? EventKind::Pause : EventKind::Wait,
                                         &plan::TrajectoryEvent::kind);
    ASSERT_NE(event, t.events.end());
    EXPECT_EQ(plan::waypointAhead(t, event->point), plan_.paths[2].first);
    EXPECT_FALSE(dripsOnPart(t, event->point - 1));
    ASSERT_NE(event + 1, t.events.end());
    EXPECT_EQ((event + 1)->kind, EventKind::Purge);
    EXPECT_EQ((event + 1)->point, event->point) << "where it waited";
    EXPECT_DOUBLE_EQ((event + 1)->volumeMm3, motion::primeMm3(process_));
    if (!isPause) {
      EXPECT_DOUBLE_EQ(event->seconds, 60.0);
    }
  }
}

TEST_F(LayerEventMotion, ANewFilamentIsPurged) {
  const auto result =
      planned({{.bead = 3, .changesFilament = true, .text = "Change the filament"}});
  const auto& events = result.trajectory.events;
  const auto pause = std::ranges::find(events, EventKind::Pause, &plan::TrajectoryEvent::kind);
  ASSERT_NE(pause, events.end());
  ASSERT_NE(pause + 1, events.end());
  EXPECT_DOUBLE_EQ((pause + 1)->volumeMm3, motion::MotionOptions{}.purge.changeMm3);
}

TEST_F(LayerEventMotion, OutputsAndStatementsComeBehindTheLift) {
  const auto without = planned({}).trajectory;
  const auto t =
      planned(
          {{.layer = 2, .kind = LayerEventKind::Output, .number = 3, .on = true},
           {.layer = 4, .kind = LayerEventKind::Statement, .text = "foo()", .format = "urscript"}})
          .trajectory;
  EXPECT_EQ(t.joints, without.joints) << "the arm takes the same way";
  std::vector<plan::TrajectoryEvent> own;
  std::ranges::copy_if(t.events, std::back_inserter(own), [](const plan::TrajectoryEvent& event) {
    return event.kind == EventKind::Output || event.kind == EventKind::Statement;
  });
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(own[0].tool, 3);
  EXPECT_TRUE(own[0].on);
  EXPECT_EQ(plan::waypointAhead(t, own[0].point), plan_.paths[1].first);
  EXPECT_EQ(own[1].text, "foo()");
  EXPECT_EQ(own[1].format, "urscript");
  EXPECT_EQ(plan::waypointAhead(t, own[1].point), plan_.paths[3].first);
  for (const plan::TrajectoryEvent& event : own) {
    EXPECT_NE(t.move[event.point], plan::MoveKind::Print);
    EXPECT_NE(t.move[event.point - 1], plan::MoveKind::Print) << "the nozzle has left the bead";
  }
}

// A feeder changes the tool while the arm stays where it is: the pause comes before the change, and
// is none for it.
TEST_F(LayerEventMotion, APauseComesBeforeAFeedersChange) {
  tooling_ = process::Tooling({{process_}, {process_}});
  plan_.paths[2].tool = plan_.paths[3].tool = 1;
  std::string text = base::readFile(base::resourceFolder() / "cells/ur5-moving.json");
  text.insert(text.find('{') + 1, R"("toolChange": {"by": "feeder"},)");
  const auto result = planned({{.layer = 3}}, text);
  const plan::Trajectory& t = result.trajectory;
  std::vector<EventKind> kinds = kindsOf(t);
  std::erase_if(kinds, [](EventKind kind) { return kind == EventKind::Purge; });
  EXPECT_EQ(kinds, (std::vector{EventKind::Pause, EventKind::ToolChange}));
  const auto pause = std::ranges::find(t.events, EventKind::Pause, &plan::TrajectoryEvent::kind);
  EXPECT_EQ(t.changeAfter(*pause), nullptr);
}

// The operator is there anyway; a text of its own is shown all the same.
TEST_F(LayerEventMotion, AChangeByHandStandsForAPauseWithoutText) {
  tooling_ = process::Tooling({{process_}, {process_}});
  plan_.paths[2].tool = plan_.paths[3].tool = 1;
  const auto pauses = [&](std::vector<LayerEvent> events) {
    const plan::Trajectory t = planned(std::move(events)).trajectory;
    return std::ranges::count(t.events, EventKind::Pause, &plan::TrajectoryEvent::kind);
  };
  EXPECT_EQ(pauses({}), 1);
  EXPECT_EQ(pauses({{.layer = 3}}), 1);
  EXPECT_EQ(pauses({{.layer = 3, .text = "Put in the nut"}}), 2);
  EXPECT_EQ(pauses({{.layer = 2}}), 2);
}

} // namespace
} // namespace voluta

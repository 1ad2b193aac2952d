#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/replay/replay.h"
#include "game/simulation/run_header.h"
#include "tests/study/level_study.h"
#include "tests/study/text.h"

namespace study {

namespace fs = std::filesystem;

/// A folder of the test, with a copy of a level and a replay without inputs.
class LevelStudy : public testing::Test {
 protected:
  LevelStudy() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    home = testing::TempDir() + "study_" + info->name();
    fs::remove_all(home);
    fs::create_directories(home);
    level_path = home + "/swing.tmj";
    change_level(TEST_ASSETS "/levels/first_swing.tmj", [](Json& cord) {
      Json& properties = cord["properties"];
      std::erase_if(properties.get_ref<Json::array_t&>(),
                    [](const Json& p) { return p["name"] == "tension_only" || p["name"] == "at_rest"; });
    });
    replay_path = home + "/swing.replay";
    record(replay_path, 20);
  }
  ~LevelStudy() override { fs::remove_all(home); }

  using Json = nlohmann::ordered_json;

  /// Writes the test's level: that of a file, with changed cords.
  void change_level(const std::string& from, const std::function<void(Json& cord)>& change) const {
    Json json = Json::parse(read_file(from));
    for (Json& layer : json["layers"]) {
      for (Json& object : layer["objects"]) {
        if (object.contains("polyline")) change(object);
      }
    }
    std::ofstream(level_path) << json.dump();
  }

  /// Leaves one cord, which is free and 20 cm above the ground, at `x` pixels.
  void leave_a_loose_cord(int x = 120) const {
    auto json = Json::parse(read_file(level_path));
    for (auto& layer : json["layers"]) {
      auto objects = Json::array();
      int cords = 0;
      for (auto& object : layer["objects"]) {
        if (object.contains("polyline") && cords++ > 0) continue;
        if (object.contains("polyline")) {
          object["polyline"] = {{{"x", 0}, {"y", 0}}, {{"x", 60}, {"y", 0}}};
          object["x"] = x;
          object["y"] = 410;  // 20 cm above it
          for (auto& property : object["properties"]) {
            if (property["name"] == "pin_first") property["value"] = false;
            if (property["name"] == "columns") property["value"] = 9;
          }
        }
        objects.push_back(object);
      }
      layer["objects"] = objects;
    }
    std::ofstream(level_path) << json.dump();
  }

  void record(const std::string& path, int ticks) const {
    const game::Level level = game::load_level(level_path);
    engine::ReplayWriter writer(path, game::replay_header(level));
    game::Simulation simulation(level);
    for (int k = 0; k < ticks; ++k) {
      simulation.tick({});
      writer.write({}, simulation.hash());
    }
    writer.finish();
  }

  StudyOptions options() const {
    StudyOptions options;
    options.quick = true;
    options.repeats = 1;
    options.folder = home + "/report";
    return options;
  }

  std::string home, level_path, replay_path;
};

}  // namespace study

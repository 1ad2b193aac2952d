#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

#include "engine/scene/scene.h"
#include "tests/support/refusal.h"

// The weather of a map.

namespace engine {
namespace {

/// A map with a cord of 2 m that hangs from (5, 9) and feels the weather.
TiledMap map() {
  TiledMap made;
  made.file = "test.tmj";
  made.size = {10.0, 10.0};
  made.properties = Properties("test.tmj");
  MapObject cord;
  cord.id = 1;
  cord.kind = "cord";
  cord.shape = MapShape::polyline;
  cord.position = {5.0, 9.0};
  cord.points = {{5.0, 9.0}, {5.0, 7.0}};
  cord.properties = Properties("test.tmj: object 1");
  cord.properties.insert("columns", std::int64_t{21});
  cord.properties.insert("mass", 0.4);
  cord.properties.insert("pin_first", true);
  cord.properties.insert("drag_across", 1.2);
  cord.properties.insert("drag_along", 0.01);
  cord.properties.insert("displaced_area", 3e-4);
  made.objects.push_back(cord);
  return made;
}

TEST(SceneWeather, IsReadFromTheMap) {
  TiledMap windy = map();
  for (const auto& [name, value] : {std::pair{"wind_x", 4.0},
                                    {"wind_y", 0.5},
                                    {"air_density", 1.3},
                                    {"gusts", 0.25},
                                    {"gust_time", 3.0},
                                    {"gust_length", 12.0},
                                    {"water_level", 7.5},
                                    {"water_density", 990.0},
                                    {"current_x", -1.0},
                                    {"current_y", 0.1}}) {
    windy.properties.insert(name, value);
  }
  Scene scene(windy);
  ASSERT_TRUE(scene.weather());
  ribbon::WeatherDef def;
  def.wind = {4.0, 0.5};
  def.air_density = 1.3;
  def.gusts = 0.25;
  def.gust_time = 3.0;
  def.gust_length = 12.0;
  def.water_level = 7.5;
  def.water_density = 990.0;
  def.current = {-1.0, 0.1};
  EXPECT_EQ(scene.weather()->def(), def);
  const ribbon::CordDef& cord = scene.coupling().cord(0).direct().def();
  EXPECT_EQ(cord.drag_across, 1.2);
  EXPECT_EQ(cord.drag_along, 0.01);
  EXPECT_EQ(cord.displaced_area, 3e-4);
  for (int k = 0; k < 60; ++k) scene.tick(1.0 / 60.0);
  EXPECT_LT(scene.coupling().cord(0).positions()[20].x, 4.99) << "in the river";
  EXPECT_GT(scene.coupling().last_step().medium_time(), 0.99);
  TiledMap dry = map();
  dry.properties.insert("wind_x", 4.0);
  Scene blown(dry);
  for (int k = 0; k < 60; ++k) blown.tick(1.0 / 60.0);
  EXPECT_GT(blown.coupling().cord(0).positions()[20].x, 5.01) << "in the wind";
}

TEST(SceneWeather, IsNoneWithoutItsProperties) {
  Scene scene(map());
  EXPECT_FALSE(scene.weather());
  for (int k = 0; k < 10; ++k) scene.tick(1.0 / 60.0);
  EXPECT_EQ(scene.coupling().last_step().medium_time(), 0.0);
}

TEST(SceneWeather, RefusesWhatIsOutOfRange) {
  for (const auto& [name, value] : {std::pair{"wind_x", 1e4},
                                    {"wind_y", -1e4},
                                    {"air_density", -1.0},
                                    {"gusts", 1.5},
                                    {"gust_time", 0.0},
                                    {"gust_length", -1.0},
                                    {"water_level", 1e7},
                                    {"water_density", -1.0},
                                    {"current_x", 1e4},
                                    {"current_y", 1e4}}) {
    TiledMap bad = map();
    bad.properties.insert(name, value);
    const std::string message = test_support::refusal<MapError>([&] { const Scene scene(bad); });
    EXPECT_TRUE(test_support::says(message, std::string("\"") + name + "\""));
  }
  TiledMap bad = map();
  bad.properties.insert("wind", 3.0);
  EXPECT_TRUE(test_support::says(test_support::refusal<MapError>([&] { const Scene scene(bad); }), "water_level"));
}

TEST(SceneWeather, IsRefusedByTheThesisSolver) {
  for (const char* name : {"drag_across", "drag_along", "displaced_area"}) {
    TiledMap bad = map();
    MapObject& cord = bad.objects[0];
    cord.properties = Properties("test.tmj: object 1");
    cord.properties.insert("solver", std::string("thesis"));
    cord.properties.insert("columns", std::int64_t{21});
    cord.properties.insert("mass", 0.4);
    cord.properties.insert("spring_stiffness", 100.0);
    cord.properties.insert(name, 1.0);
    EXPECT_TRUE(test_support::says(test_support::refusal<MapError>([&] { const Scene scene(bad); }), name));
  }
}

}  // namespace
}  // namespace engine

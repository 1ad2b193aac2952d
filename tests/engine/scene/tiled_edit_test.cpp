#include "engine/scene/tiled_edit.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

#include "engine/scene/tiled_map.h"
#include "tests/support/files.h"

namespace {

using engine::map_itself;
using engine::parse_tiled_map;
using engine::with_property;
using engine::without_property;
using test_support::bytes_of;

const std::string& first_swing() {
  static const std::string text = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  return text;
}

/// A map with objects in groups, names with quotes and brackets, and a layout that no program writes.
std::string odd_map() {
  return R"({ "width":20 ,"height":20,"tilewidth":64,"tileheight":64,"infinite":false,"orientation":"orthogonal",
    "type":"map","unknown":[1,{"id":3,"properties":"no"}],"layers":[
     {"type":"group","name":"]}\"","layers":[{"type":"objectgroup","objects":[
       {"id":3,"name":"a \"}{][ b","x":1,"y":2,"point":true,"width":0,"height":0,"rotation":0,"type":"player",
        "properties":[ {"type":"float" , "name":"mass","value":50.5} ]}]}]},
     {"type":"objectgroup","objects":[{"id":4,"x":0,"y":0,"point":true,"name":"","rotation":0,"type":"x","properties":[]},
       {"id":5,"x":0,"y":0,"point":true,"name":"","rotation":0,"type":"x"}]}]})";
}

int first_cord() {
  for (const auto& object : parse_tiled_map(first_swing(), "a").objects) {
    if (object.kind == "cord") return object.id;
  }
  return -1;
}

/// Returns the number of bytes from the first to the last difference.
std::size_t changed_bytes(const std::string& a, const std::string& b) {
  std::size_t front = 0;
  while (front < std::min(a.size(), b.size()) && a[front] == b[front]) ++front;
  std::size_t back = 0;
  while (back < std::min(a.size(), b.size()) - front && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  return std::max(a.size(), b.size()) - front - back;
}

TEST(TiledEdit, ChangesAValueAndNothingElse) {
  const std::string changed = with_property(first_swing(), first_cord(), "mass", 7.25);
  EXPECT_EQ(parse_tiled_map(changed, "a").find(first_cord())->properties.number("mass"), 7.25);
  EXPECT_LE(changed_bytes(changed, first_swing()), 4U);
}

TEST(TiledEdit, ANewPropertyIsFormattedLikeTheOthersAndCanBeRemoved) {
  const std::string changed = with_property(first_swing(), first_cord(), "restitution", 0.25);
  EXPECT_EQ(parse_tiled_map(changed, "a").find(first_cord())->properties.number("restitution"), 0.25);
  EXPECT_NE(
      changed.find("\n       \"name\": \"restitution\",\n       \"type\": \"float\",\n       \"value\": 0.25\n      }"),
      std::string::npos);
  EXPECT_EQ(without_property(changed, first_cord(), "restitution"), first_swing());
}

TEST(TiledEdit, EveryPropertyOfALevelCanBeRemovedAndAddedAgain) {
  const auto map = parse_tiled_map(first_swing(), "a");
  const std::string without = without_property(first_swing(), first_cord(), "columns");
  EXPECT_FALSE(parse_tiled_map(without, "a").find(first_cord())->properties.has("columns"));
  const std::string back =
      with_property(without, first_cord(), "columns", map.find(first_cord())->properties.integer("columns"));
  EXPECT_EQ(back.size(), first_swing().size()) << "in another order";
}

TEST(TiledEdit, UnusualLayoutsAndNamesAreParsed) {
  const std::string text = odd_map();
  const std::string changed = with_property(text, 3, "mass", 60.0);
  EXPECT_EQ(parse_tiled_map(changed, "a").find(3)->properties.number("mass"), 60.0);
  EXPECT_LE(changed_bytes(changed, text), 4U);
  EXPECT_EQ(
      parse_tiled_map(with_property(text, 3, "mass", std::string("a \"b\"")), "a").find(3)->properties.text("mass"),
      "a \"b\"");
  EXPECT_EQ(parse_tiled_map(with_property(text, 4, "on", true), "a").find(4)->properties.boolean("on"), true);
  EXPECT_EQ(parse_tiled_map(with_property(text, 5, "n", std::int64_t{12}), "a").find(5)->properties.integer("n"), 12);
  EXPECT_EQ(parse_tiled_map(with_property(text, map_itself, "gravity_y", -1.5), "a").properties.number("gravity_y"),
            -1.5);
}

TEST(TiledEdit, TheOnlyPropertyCanBeRemoved) {
  const std::string without = without_property(odd_map(), 3, "mass");
  EXPECT_FALSE(parse_tiled_map(without, "a").find(3)->properties.has("mass"));
  EXPECT_EQ(without_property(odd_map(), 5, "mass"), odd_map());
}

TEST(TiledEdit, AnIntegerValueOfAFloatLeavesItAFloat) {
  const std::string changed = with_property(odd_map(), 3, "mass", std::int64_t{60});
  EXPECT_NE(changed.find("{\"type\":\"float\" , \"name\":\"mass\",\"value\":60}"), std::string::npos);
}

TEST(TiledEdit, RefusesUnknownObjectsAndInvalidValues) {
  EXPECT_THROW(with_property(odd_map(), 77, "mass", 1.0), engine::MapError);
  EXPECT_THROW(with_property(odd_map(), 3, "mass", std::numeric_limits<double>::infinity()), engine::MapError);
}

TEST(TiledEdit, AFileIsReplacedWholeOrNotAtAll) {
  const std::string path = testing::TempDir() + "replaced.tmj";
  engine::replace_file(path, "old");
  engine::replace_file(path, "new");
  EXPECT_EQ(bytes_of(path), "new");
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
  std::filesystem::remove(path);
  EXPECT_THROW(engine::replace_file("/no/such/folder/a.tmj", "text"), std::runtime_error);
  const std::string folder = testing::TempDir() + "a_folder.tmj";
  std::filesystem::create_directories(folder + "/in_it");
  EXPECT_THROW(engine::replace_file(folder, "text"), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder + ".new"));
  std::filesystem::remove_all(folder);
}

}  // namespace

#include "engine/scene/tiled_map.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/engine/scene/map_json.h"
#include "tests/support/refusal.h"

// Properties of the objects of a map.

namespace engine {
namespace {

using test_support::says;

TEST(Properties, AreReadByType) {
  const Properties p =
      load_object(point(list(property("stiffness", "float", 1.5), property("whole", "float", 2),
                             property("count", "int", 7), property("loose", "bool", true),
                             property("material", "string", "hemp"), property("tint", "color", "#ff0000"),
                             property("anchor", "object", 4), json::object({{"name", "untyped"}, {"value", "x"}}))))
          .properties;
  EXPECT_EQ(p.number("stiffness"), 1.5);
  EXPECT_EQ(p.number("whole"), 2.0);
  EXPECT_EQ(p.number("count"), 7.0);
  EXPECT_EQ(p.integer("count"), 7);
  EXPECT_EQ(p.integer("anchor"), 4);
  EXPECT_TRUE(p.boolean("loose"));
  EXPECT_EQ(p.text("material", {"hemp", "wire"}), "hemp");
  EXPECT_EQ(p.text("tint"), "#ff0000");
  EXPECT_EQ(p.text("untyped"), "x");
  EXPECT_TRUE(p.has("count"));
  EXPECT_FALSE(p.has("weight"));
}

TEST(Properties, AnAbsentPropertyHasADefaultOnlyIfOneIsGiven) {
  const Properties p = load_object(point()).properties;
  EXPECT_EQ(p.number_or("a", 2.5, {0, 1}), 2.5);
  EXPECT_EQ(p.integer_or("a", -3), -3);
  EXPECT_TRUE(p.boolean_or("a", true));
  EXPECT_EQ(p.text_or("a", "hemp", {"wire"}), "hemp");
  const std::string missing = file + ": object 12 \"rope\": property \"a\" is missing, accepted is ";
  EXPECT_EQ(error_of([&] { p.number("a", {0.5, 20}); }), missing + "a number from 0.5 to 20");
  EXPECT_EQ(error_of([&] { p.number("a"); }), missing + "a number");
  EXPECT_EQ(error_of([&] { p.integer("a", {.min = 1}); }), missing + "a whole number, 1 or more");
  EXPECT_EQ(error_of([&] { p.boolean("a"); }), missing + "true or false");
  EXPECT_EQ(error_of([&] { p.text("a", {"hemp", "wire"}); }), missing + "one of hemp, wire");
}

TEST(Properties, ErrorsNameFileObjectPropertyValueAndWhatIsAccepted) {
  const Properties p = load_object(point(list(property("length", "float", 99.5), property("count", "int", 9),
                                              property("loose", "bool", true), property("material", "string", "silk"))))
                           .properties;
  const std::string owner = file + ": object 12 \"rope\": property ";
  EXPECT_EQ(error_of([&] {
              p.number("length", {0.1, 20});
            }),
            owner + "\"length\" is 99.5, accepted is a number from 0.1 to 20");
  EXPECT_EQ(error_of([&] { p.number_or("length", 1, {.max = 20}); }),
            owner + "\"length\" is 99.5, accepted is a number, 20 or less");
  EXPECT_EQ(error_of([&] { p.number("material"); }), owner + "\"material\" is \"silk\", accepted is a number");
  EXPECT_EQ(error_of([&] {
              p.integer("count", {1, 8});
            }),
            owner + "\"count\" is 9, accepted is a whole number from 1 to 8");
  EXPECT_EQ(error_of([&] { p.integer_or("length", 1); }), owner + "\"length\" is 99.5, accepted is a whole number");
  EXPECT_EQ(error_of([&] { p.boolean_or("count", true); }), owner + "\"count\" is 9, accepted is true or false");
  EXPECT_EQ(error_of([&] { p.text("loose"); }), owner + "\"loose\" is true, accepted is a text");
  EXPECT_EQ(error_of([&] {
              p.text_or("material", "hemp", {"hemp", "wire"});
            }),
            owner + "\"material\" is \"silk\", accepted is one of hemp, wire");
}

TEST(Properties, UnknownPropertiesAreRefusedWithAListOfTheKnownOnes) {
  const Properties p =
      load_object(point(list(property("length", "float", 1), property("lenght", "float", 2)))).properties;
  EXPECT_NO_THROW(p.check_known_properties({"lenght", "length", "material"}));
  EXPECT_EQ(error_of([&] {
              p.check_known_properties({"length", "material"});
            }),
            file + ": object 12 \"rope\": property \"lenght\" is unknown, accepted are: length, material");
  EXPECT_TRUE(says(error_of([&] { p.check_known_properties({}); }), "accepted are: none"));
}

TEST(Properties, OfANamelessObjectAreNamedByItsId) {
  json nameless = point();
  nameless.erase("name");
  const MapObject object = load_object(nameless);
  EXPECT_STREQ(object.error("is too short").what(), (file + ": object 12: is too short").c_str());
}

}  // namespace
}  // namespace engine

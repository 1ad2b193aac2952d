#pragma once

#include <string>

#include "engine/scene/tiled_map.h"

namespace engine {

/// A map of 10 × 10 m with these objects, 10 pixels per metre.
inline TiledMap map_with(const std::string& objects) {
  return parse_tiled_map(
      R"({"type":"map","version":"1.8","orientation":"orthogonal","renderorder":"right-down","infinite":false,)"
      R"("width":10,"height":10,"tilewidth":10,"tileheight":10,"tilesets":[],)"
      R"("properties":[{"name":"pixels_per_metre","type":"float","value":10}],)"
      R"("layers":[{"type":"objectgroup","id":1,"name":"level","visible":true,"x":0,"y":0,"objects":[)" +
          objects + "]}]}",
      "test.tmj");
}

inline std::string object(const std::string& kind, const std::string& shape, const std::string& properties = "") {
  return R"({"id":7,"name":"thing","type":")" + kind + R"(","x":20,"y":30,"rotation":0,"visible":true,)" + shape +
         R"(,"properties":[)" + properties + "]}";
}

inline std::string number(const std::string& name, const std::string& value) {
  return R"({"name":")" + name + R"(","type":"float","value":)" + value + "}";
}

inline std::string whole(const std::string& name, const std::string& value) {
  return R"({"name":")" + name + R"(","type":"int","value":)" + value + "}";
}

inline std::string text(const std::string& name, const std::string& value) {
  return R"({"name":")" + name + R"(","type":"string","value":")" + value + "\"}";
}

inline std::string yes(const std::string& name) { return R"({"name":")" + name + R"(","type":"bool","value":true})"; }

const std::string line = R"("width":0,"height":0,"polyline":[{"x":0,"y":0},{"x":0,"y":40}])";
const std::string disc = R"("width":10,"height":10,"ellipse":true)";
const std::string box = R"("width":40,"height":10)";
const std::string either_cord = whole("columns", "9") + "," + number("mass", "1.8");
const std::string cord_properties =
    text("solver", "thesis") + "," + either_cord + "," + number("spring_stiffness", "1000");
const std::string direct_properties = text("solver", "direct") + "," + either_cord;

}  // namespace engine

#include "engine/scene/tiled_map.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "engine/files/json_object.h"
#include "engine/files/ranges.h"
#include "engine/files/regular_file.h"
#include "engine/scene/tiled_object.h"
#include "ribbon/box2d/state_hash.h"

namespace engine {
namespace {

using nlohmann::json;

constexpr std::size_t max_file_bytes = std::size_t{4} << 20;
constexpr int max_json_depth = 64;
constexpr int max_group_depth = 16;
constexpr IntegerRange accepted_tiles{1, 100'000};
constexpr NumberRange accepted_pixels_per_metre{0.001, 100'000.0};

/// What a layer inherits from the group layers around it.
struct LayerFrame {
  ribbon::Vec2 offset_px;
  bool hidden = false;
  int depth = 0;
};

class MapLoader {
 public:
  MapLoader(std::string_view text, const std::string& file)
      : root_(parse_json(text, file, max_json_depth)), map_(root_, file + ": map") {
    result_.file = file;
    result_.content_hash = ribbon::box2d::hash_bytes(text);
  }

  TiledMap load() {
    check_kind();
    result_.properties = parse_properties(map_);
    result_.pixels_per_metre = result_.properties.number_or("pixels_per_metre", 64.0, accepted_pixels_per_metre);
    const double width_px = pixels("width", "tilewidth");
    frame_ = {.height_px = pixels("height", "tileheight"), .pixels_per_metre = result_.pixels_per_metre};
    result_.size = {width_px / frame_.pixels_per_metre, frame_.height_px / frame_.pixels_per_metre};
    if (map_.has("backgroundcolor")) result_.background = colour();
    load_layers(map_, {});
    return std::move(result_);
  }

 private:
  double pixels(const char* tiles, const char* tile_size) const {
    return static_cast<double>(map_.integer(tiles, accepted_tiles)) *
           static_cast<double>(map_.integer(tile_size, accepted_tiles));
  }

  void check_kind() const;
  MapColour colour() const;
  void load_layers(const JsonObject& parent, const LayerFrame& around);
  void load_layer(const JsonObject& layer, const LayerFrame& around);
  void load_objects(const JsonObject& layer, ribbon::Vec2 offset_px);

  json root_;
  JsonObject map_;
  TiledFrame frame_;
  TiledMap result_;
  std::set<int> ids_;
};

void MapLoader::check_kind() const {
  if (map_.text("type") != "map") map_.refuse("type", "\"map\"");
  if (map_.text("orientation") != "orthogonal") map_.refuse("orientation", "\"orthogonal\"");
  if (map_.boolean_or("infinite", false)) map_.refuse("infinite", "false");
}

MapColour MapLoader::colour() const {
  constexpr std::string_view hexadecimal = "0123456789abcdefABCDEF";
  const std::string text = map_.text("backgroundcolor");
  const bool well_formed = (text.size() == 7 || text.size() == 9) && text[0] == '#' &&
                           text.find_first_not_of(hexadecimal, 1) == std::string::npos;
  if (!well_formed) map_.refuse("backgroundcolor", "#rrggbb or #aarrggbb");
  const unsigned long argb = std::stoul(text.substr(1), nullptr, 16);
  const auto channel = [&](int shift) { return static_cast<std::uint8_t>(argb >> shift & 0xFFU); };
  return {channel(16), channel(8), channel(0), text.size() == 9 ? channel(24) : std::uint8_t{255}};
}

void MapLoader::load_layers(const JsonObject& parent, const LayerFrame& around) {
  if (around.depth > max_group_depth) {
    parent.fail("group layers nest more than the " + std::to_string(max_group_depth) + " deep accepted");
  }
  std::size_t number = 0;
  for (const json& value : parent.array("layers")) {
    JsonObject layer(value, parent.where() + ": layer " + std::to_string(++number));
    layer.rename(result_.file + ": layer " + in_quotes(layer.text_or("name", "")));
    load_layer(layer, around);
  }
}

void MapLoader::load_layer(const JsonObject& layer, const LayerFrame& around) {
  const LayerFrame inside{around.offset_px + ribbon::Vec2{layer.number_or("offsetx", 0.0, tiled_coordinate),
                                                          layer.number_or("offsety", 0.0, tiled_coordinate)},
                          around.hidden || !layer.boolean_or("visible", true), around.depth + 1};
  const std::string type = layer.text("type");
  if (type == "objectgroup") return load_objects(layer, inside.offset_px);
  if (type == "group") return load_layers(layer, inside);
  // Hidden tile and image layers are templates for the editor. Visible ones are refused, since the game does not draw
  // them.
  if (inside.hidden && (type == "tilelayer" || type == "imagelayer")) return;
  layer.refuse("type", "objectgroup or group (tilelayer and imagelayer if hidden)");
}

void MapLoader::load_objects(const JsonObject& layer, ribbon::Vec2 offset_px) {
  std::size_t number = 0;
  for (const json& value : layer.array("objects")) {
    JsonObject object(value, layer.where() + ": object number " + std::to_string(++number));
    MapObject loaded = parse_object(object, result_.file, offset_px, frame_);
    if (!ids_.insert(loaded.id).second) throw loaded.error("the id is taken by another object, ids must be unique");
    result_.objects.push_back(std::move(loaded));
  }
}

std::string read_file(const std::string& path) {
  std::ifstream in;
  try {
    in = open_regular_file(path);
  } catch (const std::runtime_error& error) {
    throw MapError(error.what());
  }
  // Reads one byte more than accepted, whatever size the file reports.
  std::string text(max_file_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw MapError(path + ": reading failed");
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

}  // namespace

const MapObject* TiledMap::find(int id) const {
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const MapObject& o) { return o.id == id; });
  return found == objects.end() ? nullptr : &*found;
}

TiledMap load_tiled_map(const std::string& path) { return parse_tiled_map(read_file(path), path); }

TiledMap parse_tiled_map(std::string_view text, const std::string& file) {
  if (text.size() > max_file_bytes) {
    throw MapError(file + ": the file is longer than the " + std::to_string(max_file_bytes) + " bytes accepted");
  }
  try {
    return MapLoader(text, file).load();
  } catch (const JsonError& error) {
    throw MapError(error.what());
  }
}

}  // namespace engine

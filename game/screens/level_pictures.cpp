#include "game/screens/level_pictures.h"

#include <exception>

#include "engine/window/sdl_canvas.h"
#include "game/simulation/simulation.h"
#include "game/view/view.h"

namespace game {
namespace {

engine::Image image_of(const engine::Raster& raster) {
  std::vector<engine::Color> pixels;
  for (const std::uint32_t rgb : raster.pixels()) {
    pixels.push_back({static_cast<std::uint8_t>(rgb >> 16U & 0xffU), static_cast<std::uint8_t>(rgb >> 8U & 0xffU),
                      static_cast<std::uint8_t>(rgb & 0xffU)});
  }
  return {raster.width(), raster.height(), pixels};
}

}  // namespace

const engine::Image* LevelPictures::of(const Level& level, bool colour_safe) const {
  const auto found = images_.find(key_of(level, colour_safe));
  return found == images_.end() || !found->second ? nullptr : &*found->second;
}

void LevelPictures::make(const Level& level, const std::vector<std::string>& signs, bool colour_safe) {
  auto& image = images_[key_of(level, colour_safe)];
  if (image) return;
  try {
    const Simulation simulation(level);
    engine::HeadlessCanvas canvas(width, height);
    ViewOptions options;
    options.hud = false;
    options.signs = signs;
    options.colour_safe = colour_safe;
    View(simulation).draw(canvas, 1.0, options);
    image = image_of(canvas.raster());
  } catch (const std::exception&) {  // the card has no picture
    image = std::nullopt;
  }
}

}  // namespace game

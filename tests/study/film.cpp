#include "tests/study/film.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ribbon/box2d/convert.h"
#include "tests/study/errors.h"

namespace study {
namespace {

using ribbon::Vec2;

constexpr std::size_t max_ticks = 1800;
constexpr int points_of_a_cord = 17;  // every second station

std::string base64_of(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      three = three << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += k + j > bytes.size() ? '=' : digits[three >> (18U - 6U * static_cast<unsigned>(j)) & 63U];
    }
  }
  return text;
}

/// Little-endian 16-bit numbers.
class Numbers {
 public:
  explicit Numbers(const Stage& stage) : stage_(&stage) {}
  void add(int value) {
    const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(std::clamp(value, -32767, 32767)));
    bytes_ += static_cast<char>(bits & 255U);
    bytes_ += static_cast<char>(bits >> 8U);
  }
  void add(Vec2 place) {
    for (const double value : {place.x - stage_->origin.x, place.y - stage_->origin.y}) {
      add(std::isfinite(value) ? static_cast<int>(std::lround(std::clamp(value / stage_->unit, -4e4, 4e4))) : 32767);
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  const Stage* stage_;
  std::string bytes_;
};

std::vector<Vec2> outline_of(const b2Fixture& fixture) {
  constexpr int corners = 24;
  std::vector<Vec2> outline;
  const auto add = [&](b2Vec2 local) {
    outline.push_back(ribbon::box2d::to_double(fixture.GetBody()->GetWorldPoint(local)));
  };
  if (fixture.GetType() == b2Shape::e_polygon) {
    const auto& polygon = static_cast<const b2PolygonShape&>(*fixture.GetShape());
    for (int k = 0; k < polygon.m_count; ++k) add(polygon.m_vertices[k]);
  } else if (fixture.GetType() == b2Shape::e_circle) {
    const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
    for (int k = 0; k < corners; ++k) {
      const b2Rot turn(2.0F * b2_pi * static_cast<float>(k) / corners);
      add(circle.m_p + circle.m_radius * turn.GetXAxis());
    }
  }
  return outline;
}

void note(GreatestError& greatest, std::size_t tick, Vec2 place, Vec2 reference) {
  const double metres = length(place - reference);
  if (metres > greatest.metres) greatest = {tick + 1, metres, place, reference};
}

}  // namespace

Stage stage_of(const game::Level& level, const Trace& converged) {
  constexpr double margin = 3.0;  // m
  Stage stage;
  Vec2 low = converged.player.front();
  Vec2 high = low;
  const auto add = [&](const std::vector<Vec2>& places) {
    for (const Vec2 p : places) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  };
  add(converged.player);
  for (const auto& places : converged.places) add(places);
  for (const auto& bodies : converged.bodies) add(bodies);
  stage.origin = 0.5 * (low + high);
  stage.unit = (0.5 * std::max(high.x - low.x, high.y - low.y) + margin) / 32000.0;
  const auto scene = level.make_scene();
  for (const engine::SceneBody& made : scene->bodies()) {
    if (made.body->GetType() == b2_dynamicBody) continue;
    for (const b2Fixture* f = made.body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
      if (std::vector<Vec2> outline = outline_of(*f); !outline.empty()) stage.scenery.push_back(std::move(outline));
    }
  }
  return stage;
}

std::string frames_of(const Trace& trace, const Stage& stage) {
  Numbers numbers(stage);
  const std::size_t ticks = std::min(trace.player.size(), max_ticks);
  for (std::size_t k = 0; k < ticks; k += stage.ticks_per_frame) {
    numbers.add(static_cast<int>(trace.cords[k].size()));
    for (std::size_t c = 0; c < trace.cords[k].size(); ++c) {
      numbers.add(points_of_a_cord);
      for (std::size_t s = 0; s < Trace::stations; s += 2) numbers.add(trace.places[k][c * Trace::stations + s]);
    }
    numbers.add(1 + static_cast<int>(trace.bodies[k].size()));
    numbers.add(trace.player[k]);
    for (const Vec2 body : trace.bodies[k]) numbers.add(body);
  }
  return base64_of(numbers.bytes());
}

/// Of the ticks that a film shows.
GreatestError greatest_error(const Trace& run, const Trace& reference, std::size_t ticks) {
  GreatestError greatest;
  const std::size_t shown = std::min({ticks, max_ticks, run.player.size(), reference.player.size()});
  for (std::size_t k = 0; k < shown; k += Stage{}.ticks_per_frame) {
    note(greatest, k, run.player[k], reference.player[k]);
    for (std::size_t b = 0; b < std::min(run.bodies[k].size(), reference.bodies[k].size()); ++b) {
      note(greatest, k, run.bodies[k][b], reference.bodies[k][b]);
    }
    for_each_common_cord(run, reference, k, [&](std::size_t i, std::size_t j, std::size_t) {
      for (std::size_t s = 0; s < Trace::stations; ++s) {
        note(greatest, k, run.places[k][i * Trace::stations + s], reference.places[k][j * Trace::stations + s]);
      }
    });
  }
  return greatest;
}

}  // namespace study

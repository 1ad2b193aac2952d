#include "game/sound/music.h"

#include <algorithm>

#include "engine/window/sdl_window.h"

namespace game {
namespace {

// Of the time between two frames, a part renders the wanted piece; in a menu a smaller one then renders a later piece.
// At 60 frames a second these are 4 ms and 2 ms. A slow machine, with fewer frames, gets as much in a second.
constexpr std::int64_t budget_part = 4;
constexpr std::int64_t later_part = 8;
constexpr std::int64_t max_budget_ns = 25'000'000;

std::int64_t part_of(std::int64_t elapsed_ns, std::int64_t part) { return std::min(elapsed_ns / part, max_budget_ns); }

}  // namespace

const char* tune_name(Tune tune) {
  switch (tune) {
    case Tune::menu: return "menu";
    case Tune::calm: return "calm";
    case Tune::tense: return "tense";
    case Tune::none: break;
  }
  return "none";
}

Tune tune_of(const Level& level) {
  const auto breaks = [](const engine::MapObject& object) { return object.properties.has("breaking_force"); };
  const bool has_gusts = level.map.properties.has("gusts");
  const bool can_break = std::any_of(level.map.objects.begin(), level.map.objects.end(), breaks);
  return has_gusts || can_break ? Tune::tense : Tune::calm;
}

void Fades::advance(std::int64_t elapsed_ns, Tune wanted, bool is_ready) {
  const auto share = [elapsed_ns](std::int64_t of) {
    return static_cast<double>(elapsed_ns) / static_cast<double>(of);
  };
  if (sounding_ != wanted && volume_ > 0.0) {
    volume_ = std::max(0.0, volume_ - share(out_ns));
    silent_ns_ = 0;
    return;
  }
  silent_ns_ += elapsed_ns;
  if (wanted == Tune::none || !is_ready) return;
  if (sounding_ != wanted && silent_ns_ < gap_ns) return;
  sounding_ = wanted;
  volume_ = std::min(1.0, volume_ + share(in_ns));
}

Music::Music(engine::Audio& audio) : audio_(&audio) {
  for (const Tune tune : {Tune::menu, Tune::calm, Tune::tense}) {
    try {
      engine::Score score = engine::load_score(assets_folder() + "/music/" + tune_name(tune) + ".score");
      pieces_[static_cast<std::size_t>(tune)].renderer = std::make_unique<engine::ScoreRenderer>(std::move(score));
    } catch (const engine::SoundError& error) {
      if (load_error_.empty()) load_error_ = error.what();
    }
  }
}

/// Renders parts of the piece while there is time, and starts its loop, silent, when it is complete.
void Music::render_some(Piece& piece, std::int64_t budget_ns) {
  if (!piece.renderer) return;
  const std::int64_t end = engine::now_ns() + budget_ns;
  while (piece.renderer->step()) {
    if (engine::now_ns() >= end) return;
  }
  piece.loop = audio_->start_loop(audio_->add(piece.renderer->finish()));
  piece.renderer.reset();
}

void Music::frame(std::int64_t elapsed_ns, Tune wanted, double volume) {
  if (wanted != Tune::none && volume > 0.0 && audio_->has_device()) {
    render_some(pieces_[static_cast<std::size_t>(wanted)], part_of(elapsed_ns, budget_part));
    const auto later =
        std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.renderer != nullptr; });
    if (is_ready(Tune::menu) && wanted == Tune::menu && later != pieces_.end())
      render_some(*later, part_of(elapsed_ns, later_part));
  }
  fades_.advance(elapsed_ns, wanted, is_ready(wanted));
  for (std::size_t k = 0; k < tune_count; ++k) {
    if (pieces_[k].loop < 0) continue;
    audio_->set_loop(pieces_[k].loop, {volume * fades_.volume(static_cast<Tune>(k)), 0.0, 1.0});
  }
}

}  // namespace game

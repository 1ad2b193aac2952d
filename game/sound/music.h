#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/sound/score_renderer.h"
#include "engine/window/sdl_audio.h"
#include "game/simulation/level.h"

namespace game {

/// The pieces of music; `none` is silence, for a pause.
enum class Tune : unsigned char { menu, calm, tense, none };
inline constexpr std::size_t tune_count = static_cast<std::size_t>(Tune::none);

/// Returns the name of a piece: its score is assets/music/NAME.score.
const char* tune_name(Tune tune);
/// Returns the piece of a level: tense if a gust blows in it or something in it can break, else calm.
Tune tune_of(const Level& level);

/// The volumes of the pieces while one fades out and the next one in.
class Fades {
 public:
  static constexpr std::int64_t out_ns = 700'000'000;
  static constexpr std::int64_t gap_ns = 300'000'000;  ///< silence between two pieces
  static constexpr std::int64_t in_ns = 1'200'000'000;

  /// Moves on by the time since the last frame, towards the wanted piece, which begins only when it `is_ready`.
  void advance(std::int64_t elapsed_ns, Tune wanted, bool is_ready);
  /// The volume of a piece, 0 … 1.
  double volume(Tune tune) const { return tune == sounding_ ? volume_ : 0.0; }

 private:
  Tune sounding_ = Tune::none;
  double volume_ = 0.0;
  std::int64_t silent_ns_ = gap_ns;  // since the last piece ended
};

/// Plays the music. A piece is rendered from its score when it is first wanted, a part in each frame.
class Music {
 public:
  /// Reads the scores from assets/music. A piece whose score cannot be read is silent.
  explicit Music(engine::Audio& audio);

  /// The message of the first score that could not be read; empty if there is none.
  const std::string& load_error() const { return load_error_; }
  /// Call it in each frame. `volume`: 0 … 1. Until the wanted piece is rendered it takes a quarter
  /// of the time between frames, in a menu then an eighth until the others are.
  void frame(std::int64_t elapsed_ns, Tune wanted, double volume);
  bool is_ready(Tune tune) const { return tune != Tune::none && pieces_[static_cast<std::size_t>(tune)].loop >= 0; }

 private:
  struct Piece {
    std::unique_ptr<engine::ScoreRenderer> renderer;  // null: rendered, or without a score
    engine::LoopId loop = -1;
  };

  void render_some(Piece& piece, std::int64_t budget_ns);

  engine::Audio* audio_;
  std::string load_error_;
  std::array<Piece, tune_count> pieces_;
  Fades fades_;
};

}  // namespace game

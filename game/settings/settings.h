#pragma once

#include "game/settings/bindings.h"
#include "game/simulation/assists.h"

namespace game {

struct SoundSettings {
  int volume = 70;  ///< of the sounds, 0 … 100
  int music = 50;   ///< the volume of the music, 0 … 100
  bool muted = false;

  bool operator==(const SoundSettings&) const = default;
};

/// The options of a player, which are saved.
struct Settings {
  static constexpr int min_speed = 50;  // %

  Bindings bindings = Bindings::defaults();
  Bindings second_bindings = Bindings::second_defaults();  ///< of the second player; see bindings_of
  bool toggle_grab = false;                                ///< a press grabs, the next one releases
  int speed = 100;                                         ///< % of real time, `min_speed` … 100
  bool long_reach = false;                                 ///< a larger grab range
  bool no_fall = false;                                    ///< after a fall the player returns to its last foothold
  bool reduced_motion = false;                             ///< less shake and motion of the picture
  bool colour_safe = false;                                ///< colours that also differ in brightness
  bool strain_tint = false;                                ///< cords are coloured by their strain
  bool ghost = true;                                       ///< the best run is shown beside the current one
  bool help = false;                                       ///< the list of keys is shown
  bool fullscreen = false;
  SoundSettings sound;

  /// Returns the assists for new runs.
  Assists assists() const { return {long_reach ? std::optional(Assists::long_grab_range) : std::nullopt, no_fall}; }

  bool operator==(const Settings&) const = default;
};

}  // namespace game

#pragma once

#include "game/settings/bindings.h"
#include "game/simulation/assists.h"

namespace game {

struct SoundSettings {
  int volume = 70;  ///< 0 … 100
  bool muted = false;

  bool operator==(const SoundSettings&) const = default;
};

/// What a player can choose, and what is remembered.
struct Settings {
  static constexpr int slowest = 50;  // %

  Bindings bindings = Bindings::defaults();
  bool toggle_grab = false;     ///< one press holds on, the next lets go
  int speed = 100;              ///< % of real time, `slowest` … 100
  bool long_reach = false;      ///< the hand catches cords from further away
  bool no_fall = false;         ///< who falls goes on where he last stood
  bool reduced_motion = false;  ///< less shake and movement of the picture
  bool colour_safe = false;     ///< colours that differ in brightness too
  bool strain_tint = false;     ///< cords are tinted by how much they are stretched
  bool ghost = true;            ///< the best run is shown beside the present one
  bool help = true;             ///< the keys are shown
  bool fullscreen = false;
  SoundSettings sound;

  /// Of runs that begin from now on.
  Assists assists() const { return {long_reach ? std::optional(Assists::long_grab_range) : std::nullopt, no_fall}; }

  bool operator==(const Settings&) const = default;
};

}  // namespace game

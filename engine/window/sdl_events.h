#pragma once

#include <map>
#include <memory>

#include "engine/window/window_input.h"

union SDL_Event;
struct _SDL_GameController;

namespace engine {

/// Turns SDL's events into what an InputState gathers, and opens every gamepad that is plugged in.
class EventReader {
 public:
  EventReader();
  EventReader(const EventReader&) = delete;
  EventReader& operator=(const EventReader&) = delete;
  ~EventReader();

  /// `pixels_per_unit` is the canvas's pixels a desktop unit, x and y.
  void read(const SDL_Event& event, ribbon::Vec2 pixels_per_unit, InputState& input);

 private:
  struct Close {
    void operator()(_SDL_GameController* pad) const;
  };

  void open_pad(int device, InputState& input);
  void read_pad(const SDL_Event& event, InputState& input);

  std::map<int, std::unique_ptr<_SDL_GameController, Close>> pads_;  // by SDL's instance number
  bool started_ = false;
};

}  // namespace engine

#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include "engine/window/window_input.h"

union SDL_Event;
struct _SDL_GameController;

namespace engine {

/// Passes SDL's events to an InputState and opens all gamepads that are connected.
class EventReader {
 public:
  EventReader();
  EventReader(const EventReader&) = delete;
  EventReader& operator=(const EventReader&) = delete;
  ~EventReader();

  /// `pixels_per_unit`: pixels of the canvas per desktop unit, x and y.
  void read(const SDL_Event& event, ribbon::Vec2 pixels_per_unit, InputState& input);

 private:
  struct Close {
    void operator()(_SDL_GameController* pad) const;
  };

  struct Pad {
    std::unique_ptr<_SDL_GameController, Close> device;
    std::size_t number;  // the lowest that was free when it was connected
  };

  void open_pad(int device, InputState& input);
  void read_pad(const SDL_Event& event, InputState& input);
  std::size_t number_of(int instance) const;

  std::map<int, Pad> pads_;  // by SDL's instance id
  bool started_ = false;
};

}  // namespace engine

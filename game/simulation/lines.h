#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "game/simulation/line.h"
#include "game/simulation/target.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// The lines of a player, one a hand.
class Lines {
 public:
  static constexpr std::size_t most = 2;
  static constexpr std::size_t most_knots = 8;  ///< lines that hang things together, and pieces of cut ones; a further
                                                ///< one takes away the first that the other player does not hold

  /// The buttons of a tick that act on lines.
  struct Command {
    std::array<bool, most> throws{};  ///< the button of this hand was pressed
    bool ties = false;                ///< the button of knots was pressed
    int reel = 0;                     ///< −1 in, 1 out, 0 not
  };

  /// `count`: 1 … most. A single line takes the throws of both hands.
  Lines(const LineTuning& tuning, std::size_t count);

  std::span<const Line> all() const { return std::span(lines_).first(count_); }
  const Line& first() const { return lines_.front(); }
  /// Returns the line that was thrown last, if one is held: the player hangs on it.
  const Line* held() const;

  /// Throws, or releases what is thrown or held; makes a knot. Call it first in each tick.
  void use(const Command& command, const Targets& targets, ribbon::Vec2 hand, ribbon::box2d::Coupling& coupling,
           double dt);
  /// Returns whether a flying line arrives in this tick.
  bool arrive() const;
  /// Advances flying lines, which `body` then holds at `hand` (m, in its frame), and reels the held ones.
  void move(const Command& command, ribbon::box2d::Coupling& coupling, b2Body& body, ribbon::Vec2 hand, double dt);
  /// Lets go of the lines that were cut since the last call, and keeps their pieces. Call it after each tick.
  void follow_cuts(ribbon::box2d::Coupling& coupling);
  /// Releases all lines. A line that the other player holds stays as it is for it, and is no longer one of these.
  /// Returns false if there is none.
  bool release(ribbon::box2d::Coupling& coupling);

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  /// A line that the player has left where it is. Its end moves from the hand to the place where it is tied.
  struct Knot {
    ribbon::box2d::CordId cord = 0;
    ribbon::Vec2 end;                             // m, in the frame of the body if one holds it
    ribbon::Vec2 place;                           // m, likewise
    std::optional<ribbon::box2d::GripId> grip{};  // of that body
    bool is_tied = true;
  };

  bool release(Line& line, ribbon::box2d::Coupling& coupling);
  void hand_over(Line& line, ribbon::box2d::Coupling& coupling);
  bool is_shared(const Line& line) const { return line.cord() && line.cord() == shared_; }
  void tie(const std::optional<Target>& target, ribbon::Vec2 hand, ribbon::box2d::Coupling& coupling);
  void tighten(Knot& knot, ribbon::box2d::Coupling& coupling, double dt) const;
  void add_knot(const Knot& knot, ribbon::box2d::Coupling& coupling);
  bool forget(ribbon::box2d::CordId cut, ribbon::box2d::Coupling& coupling);

  std::array<Line, most> lines_;
  std::size_t count_;
  std::size_t last_thrown_ = 0;
  std::array<Knot, most_knots> knots_{};  // oldest first
  std::size_t knot_count_ = 0;
  std::optional<ribbon::box2d::CordId> shared_{};  // as Targets::shared in the last tick
};

}  // namespace game

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace game::lab {

/// What the sliders of the lab change. Each scene has some of them.
enum class Knob : std::uint8_t {
  load_ratio,      ///< mass of the load / mass of the cord
  weight_ratio,    ///< mass of the heavy weight / mass of the light one
  start_angle,     ///< degrees between the cord and the vertical at the start
  turns,           ///< whole turns around the post, in addition to half a one
  count,           ///< number of cords
  load_share,      ///< load / the load at which the column buckles
  may_sleep,       ///< 0 or 1: what is at rest falls asleep
  chain_substeps,  ///< steps of Box2D's world per tick
  preset,          ///< 0 … 2: fast, balanced, accurate
  substeps,        ///< per tick
  tolerance,       ///< m
  stretch,         ///< EA, N
  bending,         ///< EI, N·m²
  friction,        ///< of cords and bodies
  spring_share,    ///< k of the thesis: the share of a link's error that a substep corrects
  iterations,      ///< N of the thesis: substeps per tick
  bar_damping,     ///< β of the thesis: damping of its bars, in point masses per substep
  area,            ///< of the thesis: the share of a triangle's missing area that a substep restores
  self_collision,  ///< 0 or 1: of the thesis
  air_drag,        ///< 1/s
};
inline constexpr std::size_t knob_count = static_cast<std::size_t>(Knob::air_drag) + 1;

/// The range of a knob in a scene.
struct KnobRange {
  /// How a slider moves through the range.
  enum class Scale : std::uint8_t { linear, logarithmic, whole, choice };

  Knob knob;
  double min, max, initial;
  Scale scale = Scale::linear;
  bool min_is_zero = false;      ///< of a logarithmic scale: its left end means 0
  bool max_is_infinite = false;  ///< of a logarithmic scale: its right end means infinity
  bool rebuilds = false;         ///< a change starts the scene anew; else it acts on what is there

  /// Returns the place of a value on the slider, 0 … 1.
  double position_of(double value) const;
  /// Returns the value at a place of the slider, 0 … 1: on a logarithmic scale with two significant digits, whole for
  /// whole scales and choices.
  double value_at(double position) const;
  /// Returns the value after `steps` presses of an arrow key; negative: to the left. A choice wraps around.
  double stepped(double value, int steps) const;
};

/// The values of all knobs; those that a scene does not have are 0.
class KnobValues {
 public:
  double operator[](Knob knob) const { return values_[static_cast<std::size_t>(knob)]; }
  double& operator[](Knob knob) { return values_[static_cast<std::size_t>(knob)]; }
  bool is_on(Knob knob) const { return (*this)[knob] != 0.0; }
  int whole(Knob knob) const { return static_cast<int>((*this)[knob]); }
  bool operator==(const KnobValues&) const = default;

 private:
  std::array<double, knob_count> values_{};
};

}  // namespace game::lab

#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/thesis/thesis_cord.h"

namespace extremes {

/// The steppers: the direct solver's presets and the thesis's.
enum class Method : unsigned char { fast, balanced, accurate, thesis };
constexpr std::array<Method, 4> all_methods = {Method::fast, Method::balanced, Method::accurate, Method::thesis};
std::string_view name(Method method);
/// Of the direct solver's.
ribbon::Accuracy accuracy_of(Method method);

/// What the steps of either solver report, summed up.
struct Counts {
  long steps = 0;
  ribbon::CordReport direct;
  ribbon::StepReport thesis;

  Counts& operator+=(const Counts& other);
};

/// A cord of any method, made of one definition.
class Subject {
 public:
  /// With the thesis's method a rope is a strip of two rows, EA becomes that of its springs along it (none stiffer than
  /// give back half of a link's error in a substep of a step of dt, which stands for infinity too), and attached masses
  /// are bodies that hold its points. Otherwise `dt` is not looked at.
  Subject(Method method, ribbon::CordDef def, double dt);

  /// Attaches kg to the last column, each row its share of the width. Once.
  void attach_load(double mass);
  void operate(int point, ribbon::Vec2 target);
  void release(int point);
  void set_velocity(int point, ribbon::Vec2 velocity);
  void stop();  ///< takes all velocity from everything
  void step(double dt, ribbon::Vec2 gravity, const ribbon::Surroundings& surroundings = {});

  Method method() const { return method_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int index(int i, int j) const { return i * rows_ + j; }
  std::span<const ribbon::Vec2> positions() const;
  std::span<const ribbon::Vec2> velocities() const;
  double mass(int point) const;               ///< kg, without a thesis's load
  double total_mass() const;                  ///< kg, with the load
  double energy(ribbon::Vec2 gravity) const;  ///< J
  bool is_finite() const;
  double fastest() const;  ///< m/s
  double length() const;   ///< m, from the middle of the first column to that of the last, straight
  /// How far a link, or a side or diagonal of a cell, is off its rest length, relative; if it `may_be_slack`, longer
  /// only.
  double worst_strain(bool may_be_slack = false) const;
  /// What its shape has become, if it is not as it was made: "inside out", "collapsed" or "stretched", whichever is
  /// worst.
  std::string_view shape() const;
  int inverted() const;  ///< corners of cells, or triangles, that are turned inside out
  const Counts& counts() const { return counts_; }
  /// Of the direct solver only.
  ribbon::Cord& direct() { return *direct_; }

 private:
  struct Load {
    ribbon::RigidBody body;
    int point;
  };
  struct Lengths {
    double shortest = 1.0;
    double longest = 1.0;
  };
  Lengths lengths() const;
  void step_thesis(double dt, ribbon::Vec2 gravity, const ribbon::Surroundings& surroundings);

  Method method_;
  int columns_;
  int rows_;
  ribbon::Vec2 cell_;  // m, at rest
  std::optional<ribbon::Cord> direct_;
  std::optional<ribbon::ThesisCord> thesis_;
  std::vector<Load> loads_;  // of the thesis's
  std::vector<ribbon::RigidBody> bodies_;
  std::vector<ribbon::Grip> grips_;
  Counts counts_;
};

}  // namespace extremes

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

/// The solvers: the direct solver's presets and the thesis's method.
enum class Method : unsigned char { fast, balanced, accurate, thesis };
constexpr std::array<Method, 4> all_methods = {Method::fast, Method::balanced, Method::accurate, Method::thesis};
std::string_view name(Method method);
/// Returns the accuracy of a preset of the direct solver.
ribbon::Accuracy accuracy_of(Method method);

/// The sum of what the steps of either solver report.
struct Counts {
  long steps = 0;
  ribbon::IslandReport direct;
  ribbon::StepReport thesis;

  Counts& operator+=(const Counts& other);
};

/// A cord of any method, built from one definition.
class TestedCord {
 public:
  /// With the thesis's method a rope is a strip of two rows; EA becomes the stiffness of its springs along it, limited
  /// (also for infinity) to one that corrects half of a link's error in a substep of a step of dt; attached masses are
  /// bodies that hold its points. The other methods ignore `dt`.
  TestedCord(Method method, ribbon::CordDef def, double dt);

  /// Attaches a mass [kg] to the last column; each row carries its share of the width. Call it once.
  void attach_load(double mass);
  void operate(int point, ribbon::Vec2 target);
  void release(int point);
  void set_velocity(int point, ribbon::Vec2 velocity);
  void stop();  ///< sets all velocities to zero
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
  double length() const;   ///< m, the straight distance from the middle of the first column to that of the last
  /// Returns the greatest relative length error of a link, or of a cell's side or diagonal. If it `may_be_slack`, only
  /// elongation counts.
  double worst_strain(bool may_be_slack = false) const;
  /// Returns the worst change of shape: "inside out", "collapsed" or "stretched"; empty if the shape is as built.
  std::string_view shape() const;
  int inverted() const;  ///< number of inverted corners of cells, or of inverted triangles
  const Counts& counts() const { return counts_; }
  /// The direct solver's cord; not for the thesis's method.
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
  std::vector<Load> loads_;  // of the thesis's method
  std::vector<ribbon::RigidBody> bodies_;
  std::vector<ribbon::Grip> grips_;
  Counts counts_;
};

}  // namespace extremes

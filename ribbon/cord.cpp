#include "ribbon/cord.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "ribbon/elastic/chain.h"
#include "ribbon/elastic/lattice.h"
#include "ribbon/island/island.h"

namespace ribbon {
namespace {

constexpr std::size_t usual_grips = 4;

const CordDef& checked(const CordDef& def) {
  check(def);
  return def;
}

std::unique_ptr<Elasticity> make_elasticity(const CordDef& def) {
  if (def.rows == 1 && def.bending_stiffness == 0.0) return std::make_unique<Chain>(def);
  return std::make_unique<Lattice>(def);
}

std::vector<Vec2> start_positions(const CordDef& def) {
  if (!def.positions.empty()) return def.positions;
  std::vector<Vec2> straight;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      const double across = def.rows > 1 ? def.width * j / (def.rows - 1) : 0.0;
      straight.push_back({def.length * i / (def.points - 1), across});
    }
  }
  return straight;
}

/// A rope from end to end, a ribbon around, below from its start to its end and back above.
std::vector<int> outline_of(const CordDef& def) {
  std::vector<int> outline;
  const int n = def.points;
  const int rows = def.rows;
  for (int i = 0; i < n; ++i) outline.push_back(i * rows);
  if (rows == 1) return outline;
  for (int j = 1; j < rows; ++j) outline.push_back((n - 1) * rows + j);
  for (int i = n - 2; i >= 0; --i) outline.push_back(i * rows + rows - 1);
  for (int j = rows - 2; j > 0; --j) outline.push_back(j);
  return outline;
}

}  // namespace

CordReport& CordReport::operator+=(const CordReport& other) {
  stages += other.stages;
  iterations += other.iterations;
  searches += other.searches;
  fallbacks += other.fallbacks;
  energy_gains += other.energy_gains;
  halvings += other.halvings;
  impacts += other.impacts;
  posed += other.posed;
  cuts += other.cuts;
  unlocked += other.unlocked;
  unconverged += other.unconverged;
  work += other.work;
  position_error = std::max(position_error, other.position_error);
  force_error = std::max(force_error, other.force_error);
  return *this;
}

Cord::Cord(const CordDef& def)
    : def_(checked(def)),
      elasticity_(make_elasticity(def)),
      positions_(start_positions(def)),
      velocities_(positions_.size()),
      accelerations_(positions_.size()),
      targets_(positions_),
      kinds_(positions_.size(), PointKind::free),
      tensions_(elasticity_->tension_count()),
      rest_(slot(def.points) - 1, def.length / (def.points - 1)),
      outline_(outline_of(def)),
      alone_(std::make_unique<Island>()) {
  for (std::size_t p = 0; p < positions_.size(); ++p) own_masses_.push_back(own_mass(p));
  masses_ = own_masses_;
  for (const int pin : def_.pins) kinds_[slot(pin)] = PointKind::constrained;
  elasticity_->set_rest_lengths(rest_);
  elasticity_->find_tensions(positions_, tensions_);
  reserve(usual_grips);
}

Cord::Cord(Cord&& other) noexcept = default;
Cord& Cord::operator=(Cord&& other) noexcept = default;
Cord::~Cord() = default;

CordReport Cord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_met(surroundings, surroundings.bodies.size(), size(), def_.rows);
  const IslandCord alone{this, surroundings};
  return alone_->step({&alone, 1}, surroundings.bodies, dt, gravity);
}

/// An equal share of each link or cell around the point.
double Cord::own_mass(std::size_t point) const {
  const auto rows = slot(def_.rows);
  const auto share = [](std::size_t k, std::size_t n) { return k == 0 || k == n - 1 ? 0.5 : 1.0; };
  const double link = def_.mass_per_length * def_.length / (def_.points - 1);
  if (rows == 1) return link * share(point, slot(def_.points));
  return link * share(point / rows, slot(def_.points)) * share(point % rows, rows) / static_cast<double>(rows - 1);
}

Cord::Energy Cord::energy(Vec2 gravity) const {
  Energy sum;
  const Motion at{positions(), damping_apart_ ? std::span<const Vec2>{} : velocities()};
  sum.elastic = elasticity_->energy(at, tensions_);
  for (std::size_t p = 0; p < count(); ++p) {
    sum.kinetic += 0.5 * masses_[p] * dot(velocities_[p], velocities_[p]);
    sum.potential -= masses_[p] * dot(gravity, positions_[p]);
  }
  for (std::size_t p = 0; p < loads_.size(); ++p) sum.potential -= dot(loads_[p], positions_[p]);
  return sum;
}

Cord::Sweep Cord::find_sweep() const {
  Sweep sweep{
      {positions_[0], positions_[0]}, 0.0, asleep_ ? 0.0 : elasticity_->energy({positions_, velocities_}, tensions_)};
  const auto take = [&box = sweep.box](Vec2 x) {
    box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y)};
    box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y)};
  };
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    take(positions_[p]);
    if (kinds_[p] != PointKind::free) take(targets_[p]);
    sweep.speed2 = std::max(sweep.speed2, dot(velocities_[p], velocities_[p]));
  }
  return sweep;
}

/// A tension is elastic and damping together, and the damping one jumps with a velocity that is set from outside: the
/// elastic one does not.
void Cord::set_damping_apart() {
  if (def_.damping == 0.0 || damping_apart_) return;
  elasticity_->add_damping({positions(), velocities()}, -1.0, tensions_);
  damping_apart_ = true;
}

void Cord::put_damping_back() {
  if (!damping_apart_) return;
  elasticity_->add_damping({positions(), velocities()}, 1.0, tensions_);
  damping_apart_ = false;
}

void Cord::check_point(int point) const { check_range("point", point, 0, size() - 1); }

/// What changes a cord from outside has it begin anew.
void Cord::disturb() {
  restart_ = true;
  sweep_.reset();
  wake();
}

void Cord::wake() {
  if (asleep_) sweep_.reset();
  rested_ = 0.0;
  asleep_ = false;
}

/// What is left of its motion is taken.
void Cord::fall_asleep() {
  if (asleep_) return;
  asleep_ = true;
  sweep_.reset();
  set_damping_apart();
  std::fill(velocities_.begin(), velocities_.end(), Vec2{});
  std::fill(accelerations_.begin(), accelerations_.end(), Vec2{});
  restart_ = true;
}

void Cord::attach_mass(int point, double mass) {
  check_point(point);
  check_range("attached mass", mass, 0.0, 1e12);
  masses_[slot(point)] = own_masses_[slot(point)] + mass;
  disturb();
}

void Cord::set_load(int point, Vec2 force) {
  check_point(point);
  check_coordinates("load", force);
  loads_.resize(count());
  loads_[slot(point)] = force;
  disturb();
}

void Cord::drive(int point, Vec2 target, PointKind kind) {
  check_point(point);
  check_coordinates("target", target);
  targets_[slot(point)] = target;
  kinds_[slot(point)] = kind;
  disturb();
}

void Cord::constrain(int point, Vec2 target) { drive(point, target, PointKind::constrained); }

void Cord::operate(int point, Vec2 target) { drive(point, target, PointKind::operated); }

void Cord::release(int point) {
  check_point(point);
  kinds_[slot(point)] = PointKind::free;
  disturb();
}

void Cord::set_velocity(int point, Vec2 velocity) {
  check_point(point);
  check_coordinates("velocity", velocity);
  set_damping_apart();
  velocities_[slot(point)] = velocity;
  disturb();
}

void Cord::set_accuracy(const Accuracy& accuracy) {
  check(accuracy);
  if (accuracy.integrator != def_.accuracy.integrator) restart_ = true;  // implicit Euler's are those of another order
  def_.accuracy = accuracy;
}

void Cord::reel(int first, int last, double length, double speed) {
  check_range("first", first, 0, def_.points - 2);
  check_range("last", last, first + 1, def_.points - 1);
  const double made = def_.length * (last - first) / (def_.points - 1);
  check_range("length", length, 1e-3 * made, 1e3 * made);
  if (!(speed > 0.0)) refuse("speed", speed, "above 0, up to 1e+06");
  check_range("speed", speed, 0.0, 1e6);

  double now = 0.0;
  for (std::size_t e = slot(first); e < slot(last); ++e) now += rest_[e];
  const double link = def_.length / (def_.points - 1);
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    // A millionth more, for sums that round.
    check_range("length of a reeled link", rest_[e] * (length / now), 0.999999e-3 * link, 1.000001e3 * link);
  }
  if (rest_targets_.empty()) {
    rest_targets_ = rest_;
    rest_start_ = rest_;
    rest_end_ = rest_;
    rest_speeds_.resize(rest_.size());
  }
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    rest_targets_[e] = rest_[e] * (length / now);
    rest_speeds_[e] = speed * (rest_[e] / now);
  }
  disturb();
}

void Cord::reserve(std::size_t grips) {
  holders_.reserve(grips);
  alone_->reserve(*this, grips);
}

Cord::State Cord::save() const {
  State state;
  save(state);
  return state;
}

void Cord::save(State& state) const {
  const std::span<const char> unlocked = elasticity_->unlocked();
  state.positions = positions_;
  state.velocities = velocities_;
  state.accelerations = accelerations_;
  state.targets = targets_;
  state.kinds = kinds_;
  state.masses = masses_;
  state.loads = loads_;
  state.tensions = tensions_;
  state.rest = rest_;
  state.rest_targets = rest_targets_;
  state.rest_speeds = rest_speeds_;
  state.unlocked.assign(unlocked.begin(), unlocked.end());
  state.holders = holders_;
  state.touches.reserve(touches_.capacity());
  state.touches = touches_;
  state.touch_changed = touch_changed_;
  state.ledger = ledger_;
  state.balance = balance_;
  state.damping_apart = damping_apart_;
  state.restart = restart_;
  state.rested = rested_;
  state.asleep = asleep_;
  state.still_among = still_among_;
}

void Cord::check_state(const State& state) const {
  const std::size_t n = count();
  const auto is_optional = [](std::size_t size, std::size_t wanted) { return size == wanted || size == 0; };
  if (state.positions.size() != n || state.velocities.size() != n || state.accelerations.size() != n ||
      state.targets.size() != n || state.kinds.size() != n || state.masses.size() != n ||
      !is_optional(state.loads.size(), n) || state.tensions.size() != tensions_.size() ||
      state.rest.size() != rest_.size() || !is_optional(state.rest_targets.size(), rest_.size()) ||
      state.rest_speeds.size() != state.rest_targets.size() ||
      state.unlocked.size() != elasticity_->unlocked().size()) {
    throw DefinitionError("state is of another cord; accepted is one of " + std::to_string(def_.points) + " x " +
                          std::to_string(def_.rows) + " points with the same terms");
  }
  constexpr double anything = std::numeric_limits<double>::max();
  constexpr double something = std::numeric_limits<double>::min();
  const auto check_all = [](const char* field, std::span<const double> values, double low, double high) {
    for (const double value : values) check_range(field, value, low, high);
  };
  const auto check_vectors = [](const char* field, std::span<const Vec2> values) {
    for (const Vec2 value : values) {
      check_range(field, value.x, -anything, anything);
      check_range(field, value.y, -anything, anything);
    }
  };
  check_vectors("state.positions", state.positions);
  check_vectors("state.velocities", state.velocities);
  check_vectors("state.accelerations", state.accelerations);
  check_vectors("state.targets", state.targets);
  check_vectors("state.loads", state.loads);
  check_all("state.masses", state.masses, something, anything);
  check_all("state.tensions", state.tensions, -anything, anything);
  check_all("state.rest", state.rest, something, anything);
  check_all("state.rest_targets", state.rest_targets, something, anything);
  check_all("state.rest_speeds", state.rest_speeds, 0.0, anything);
  check_range("state.ledger", state.ledger, -anything, anything);
  check_range("state.balance", state.balance, -anything, anything);
  check_range("state.rested", state.rested, state.asleep ? time_to_sleep : 0.0, def_.allow_sleep ? time_to_sleep : 0.0);
  for (const PointKind kind : state.kinds) check_range("state.kinds", static_cast<int>(kind), 0, 2);
  for (const Holder& holder : state.holders) {
    check_range("state.holders.point", holder.point, 0, size() - 1);
    check_vectors("state.holders", std::array{holder.velocity, holder.acceleration, holder.pull});
    check_all("state.holders", std::array{holder.turning, holder.angular_acceleration, holder.slid}, -anything,
              anything);
  }
  for (const Touch& touch : state.touches) {
    check_vectors("state.touches", std::array{touch.point, touch.normal});
    check_all("state.touches", std::array{touch.force, touch.stuck, touch.impulse}, -anything, anything);
  }
}

void Cord::restore(const State& state) {
  check_state(state);
  sweep_.reset();
  positions_ = state.positions;
  velocities_ = state.velocities;
  accelerations_ = state.accelerations;
  targets_ = state.targets;
  kinds_ = state.kinds;
  masses_ = state.masses;
  loads_ = state.loads;
  tensions_ = state.tensions;
  rest_ = state.rest;
  rest_targets_ = state.rest_targets;
  rest_start_ = state.rest_targets;
  rest_end_ = state.rest_targets;
  rest_speeds_ = state.rest_speeds;
  std::copy(state.unlocked.begin(), state.unlocked.end(), elasticity_->unlocked().begin());
  holders_ = state.holders;
  touches_ = state.touches;
  touch_changed_ = state.touch_changed;
  ledger_ = state.ledger;
  balance_ = state.balance;
  damping_apart_ = state.damping_apart;
  restart_ = state.restart;
  rested_ = state.rested;
  asleep_ = state.asleep;
  still_among_ = state.still_among;
  elasticity_->set_rest_lengths(rest_);
}

}  // namespace ribbon

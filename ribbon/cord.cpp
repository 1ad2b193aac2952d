#include "ribbon/cord.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/chain.h"
#include "ribbon/elastic/lattice.h"
#include "ribbon/island/island.h"

namespace ribbon {
namespace {

constexpr std::size_t initial_grips = 4;

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

/// Returns the points of the contact outline: of a rope from its start to its end, of a ribbon counter-clockwise around
/// it in its default layout.
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
      rest_lengths_(slot(def.points) - 1, def.length / (def.points - 1)),
      outline_(outline_of(def)),
      own_island_(std::make_unique<Island>()) {
  for (std::size_t p = 0; p < positions_.size(); ++p) own_masses_.push_back(own_mass(p));
  masses_ = own_masses_;
  for (const int pin : def_.pins) kinds_[slot(pin)] = PointKind::constrained;
  elasticity_->set_rest_lengths(rest_lengths_);
  elasticity_->find_tensions(positions_, tensions_);
  reserve(initial_grips);
}

Cord::Cord(Cord&& other) noexcept = default;
Cord& Cord::operator=(Cord&& other) noexcept = default;
Cord::~Cord() = default;

CordReport Cord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  check_step(dt, gravity);
  check_bodies(surroundings.bodies);
  check_met(surroundings, surroundings.bodies.size(), size(), def_.rows);
  const IslandCord alone{this, surroundings};
  return own_island_->step({&alone, 1}, surroundings.bodies, dt, gravity);
}

/// Returns the mass of a point [kg]: an equal share of each link or cell around it.
double Cord::own_mass(std::size_t point) const {
  const auto rows = slot(def_.rows);
  const auto share = [](std::size_t k, std::size_t n) { return k == 0 || k == n - 1 ? 0.5 : 1.0; };
  const double link = def_.mass_per_length * def_.length / (def_.points - 1);
  if (rows == 1) return link * share(point, slot(def_.points));
  return link * share(point / rows, slot(def_.points)) * share(point % rows, rows) / static_cast<double>(rows - 1);
}

Cord::Energy Cord::energy(Vec2 gravity) const {
  Energy sum;
  const Motion at{positions(), damping_excluded_ ? std::span<const Vec2>{} : velocities()};
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
  const auto enclose = [&box = sweep.box](Vec2 x) {
    box.low = {std::min(box.low.x, x.x), std::min(box.low.y, x.y)};
    box.high = {std::max(box.high.x, x.x), std::max(box.high.y, x.y)};
  };
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    enclose(positions_[p]);
    if (kinds_[p] != PointKind::free) enclose(targets_[p]);
    sweep.speed2 = std::max(sweep.speed2, dot(velocities_[p], velocities_[p]));
  }
  return sweep;
}

/// The damping part jumps with a velocity that is set from outside; the elastic part does not.
void Cord::exclude_damping() {
  if (def_.damping == 0.0 || damping_excluded_) return;
  elasticity_->add_damping({positions(), velocities()}, -1.0, tensions_);
  damping_excluded_ = true;
}

void Cord::include_damping() {
  if (!damping_excluded_) return;
  elasticity_->add_damping({positions(), velocities()}, 1.0, tensions_);
  damping_excluded_ = false;
}

void Cord::check_point(int point) const { check_range("point", point, 0, size() - 1); }

void Cord::disturb() {
  restart_ = true;
  sweep_.reset();
  wake();
}

void Cord::wake() {
  if (asleep_) sweep_.reset();
  rest_time_ = 0.0;
  asleep_ = false;
}

void Cord::fall_asleep() {
  if (asleep_) return;
  asleep_ = true;
  sweep_.reset();
  exclude_damping();
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
  exclude_damping();
  velocities_[slot(point)] = velocity;
  disturb();
}

void Cord::set_accuracy(const Accuracy& accuracy) {
  check(accuracy);
  if (accuracy.integrator != def_.accuracy.integrator) restart_ = true;  // its accelerations have another order
  def_.accuracy = accuracy;
}

void Cord::reel(int first, int last, double length, double speed) {
  check_range("first", first, 0, def_.points - 2);
  check_range("last", last, first + 1, def_.points - 1);
  const double initial = def_.length * (last - first) / (def_.points - 1);
  check_range("length", length, 1e-3 * initial, 1e3 * initial);
  if (!(speed > 0.0)) refuse("speed", speed, "above 0, up to 1e+06");
  check_range("speed", speed, 0.0, 1e6);

  double current = 0.0;
  for (std::size_t e = slot(first); e < slot(last); ++e) current += rest_lengths_[e];
  const double link = def_.length / (def_.points - 1);
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    // The range is a millionth wider, because the sum is rounded.
    check_range("length of a reeled link", rest_lengths_[e] * (length / current), 0.999999e-3 * link,
                1.000001e3 * link);
  }
  if (reel_targets_.empty()) {
    reel_targets_ = rest_lengths_;
    reel_start_ = rest_lengths_;
    reel_end_ = rest_lengths_;
    reel_speeds_.resize(rest_lengths_.size());
  }
  for (std::size_t e = slot(first); e < slot(last); ++e) {
    reel_targets_[e] = rest_lengths_[e] * (length / current);
    reel_speeds_[e] = speed * (rest_lengths_[e] / current);
  }
  disturb();
}

void Cord::reserve(std::size_t grips) {
  holders_.reserve(grips);
  own_island_->reserve(*this, grips);
}

}  // namespace ribbon

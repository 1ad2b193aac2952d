// Calls ribbon::box2d::Coupling in any order with any numbers, on cords of both solvers, and adds and removes bodies.
// Each call succeeds, or throws and changes nothing; cords and bodies stay finite.

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/cord_queries.h"
#include "ribbon/weather.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/fuzz/arbitrary_body.h"
#include "tests/fuzz/arbitrary_cord.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

namespace {

using fuzz::Bytes;
using fuzz::require;
using ribbon::Vec2;
using ribbon::box2d::Coupling;

constexpr int max_calls = 10;
constexpr std::size_t max_bodies = 6;

/// The state that a refused call must not change.
struct Observed {
  std::vector<std::variant<ribbon::ThesisCord::State, ribbon::Cord::State>> cords;
  std::vector<int> holds;    // cord and point by body
  std::vector<double> arcs;  // by grip
  bool operator==(const Observed&) const = default;
};

/// Refuses some contacts and sensors, makes belts, and looks at what it is told.
struct Listener : ribbon::box2d::ContactListener {
  bool pre_solve(ribbon::box2d::CordId cord, const b2Fixture& fixture, ribbon::box2d::Surface& surface) override {
    require(!fixture.IsSensor(), "sensors do not collide");
    surface.tangent_speed = speed;
    return cord != refused;
  }
  bool wants_impulses() const override { return wanted; }
  void post_solve(ribbon::box2d::CordId /*cord*/, const b2Fixture& /*fixture*/,
                  std::span<const ribbon::box2d::TouchImpulse> touches) override {
    require(wanted && !touches.empty(), "impulses are wanted");
    for (const ribbon::box2d::TouchImpulse& touch : touches) require(is_finite(touch.impulse), "impulses are finite");
  }
  bool should_meet_sensor(ribbon::box2d::CordId cord, const b2Fixture& sensor) override {
    require(sensor.IsSensor(), "only sensors are asked about");
    return cord != refused;
  }
  void sensor_event(const ribbon::box2d::SensorEvent& event) override {
    require(!event.begins || (event.fixture != nullptr && event.cord != refused), "what begins exists");
  }
  double speed = 0.0;
  ribbon::box2d::CordId refused = -1;
  bool wanted = false;
};

class Fuzzed {
 public:
  explicit Fuzzed(Bytes& bytes) : bytes_(bytes) {
    coupling_.set_medium(&weather_);  // some cords feel it
    for (int k = 1 + bytes_.below(2); k > 0; --k) add_cord();
    for (int k = 1 + bytes_.below(3); k > 0; --k) bodies_.push_back(&fuzz::add_arbitrary_body(world_, bytes_));
  }

  void call();

 private:
  void add_cord();
  void tick();
  void change_a_grip();
  void change_bodies();
  void query();
  void drive_a_cord();
  void cut();
  void tie();
  void reeve();
  void save_or_restore();
  void listen();
  void look_at_sensors() const;
  Observed observe() const;
  bool box2d_keeps_bodies_finite() const;
  template <typename Do>
  bool accepts(Do&& what);

  ribbon::box2d::CordId cord() { return bytes_.integer(0, 7); }  // an id of a former, present or unknown cord
  int point() { return bytes_.integer(0, 15); }
  ribbon::box2d::GripId grip() { return bytes_.integer(0, 8); }
  b2Body* body() { return bodies_.empty() ? nullptr : bodies_[bytes_.byte() % bodies_.size()]; }

  Bytes& bytes_;
  b2World world_{{0.0F, -9.81F}};
  ribbon::Weather weather_{ribbon::WeatherDef{.wind = {20.0, 3.0}, .gusts = 0.5, .water_level = 0.0}};
  Coupling coupling_;
  std::vector<b2Body*> bodies_;
  bool gathered_ = false;
  std::optional<Coupling::State> saved_;
  ribbon::box2d::CordQueries queries_;
  Listener listener_;
};

void Fuzzed::add_cord() {
  const bool direct = bytes_.below(4) != 0;
  try {
    if (direct) {
      coupling_.add(
          ribbon::Cord(bytes_.below(4) == 0 ? fuzz::arbitrary_cord(bytes_) : fuzz::arbitrary_mild_cord(bytes_)));
    } else {
      coupling_.add(ribbon::ThesisCord(fuzz::arbitrary_thesis_cord(bytes_)));
    }
  } catch (const ribbon::DefinitionError&) {
    ribbon::CordDef def;
    def.points = 5;
    def.length = 2.0;
    def.pins = {0};
    coupling_.add(ribbon::Cord(def));
  }
}

Observed Fuzzed::observe() const {
  Observed observed;
  for (const ribbon::box2d::CordId c : coupling_.cords()) {
    if (coupling_.cord(c).solver() == ribbon::box2d::Solver::direct) {
      observed.cords.emplace_back(coupling_.cord(c).direct().save());
    } else {
      observed.cords.emplace_back(coupling_.cord(c).thesis().save());
    }
  }
  for (const b2Body* body : bodies_) {
    const auto held = coupling_.body(*body).held_place();
    observed.holds.push_back(held ? 1000 * held->cord + held->point : -1);
  }
  for (ribbon::box2d::GripId grip = 0; grip < 9; ++grip) {
    const auto held = coupling_.grip(grip);
    observed.arcs.push_back(held.is_valid() ? held.state().arc : -1.0);
  }
  return observed;
}

template <typename Do>
bool Fuzzed::accepts(Do&& what) {
  const Observed before = observe();
  const auto refused = [&](const std::logic_error& error) {
    require(std::string_view(error.what()).find("accepted") != std::string_view::npos,
            "the message says what is accepted", error.what());
    require(observe() == before, "a refused call changes nothing", error.what());
    return false;
  };
  try {
    what();
    return true;
  } catch (const ribbon::DefinitionError& error) {
    return refused(error);
  } catch (const ribbon::CallError& error) {
    return refused(error);
  }
}

void Fuzzed::call() {
  switch (bytes_.below(15)) {
    case 0:
    case 1: change_a_grip(); break;
    case 2: drive_a_cord(); break;
    case 3: change_bodies(); break;
    case 4: query(); break;
    case 5: gathered_ = accepts([&] { coupling_.gather(world_, bytes_.number(1e-3, 0.1)); }) || gathered_; break;
    case 7:
    case 8: cut(); break;
    case 9: save_or_restore(); break;
    case 10: tie(); break;
    case 11: listen(); break;
    case 12: reeve(); break;
    case 6: require(!accepts([&] { coupling_.apply(); }), "apply without step is refused"); break;
    default: tick();
  }
}

void Fuzzed::tick() {
  const double dt = bytes_.number(1e-3, 0.1);
  if (!gathered_ && !accepts([&] { coupling_.gather(world_, dt); })) return;
  if (bytes_.below(8) == 0) change_a_grip();
  coupling_.step();
  look_at_sensors();
  if (bytes_.below(8) == 0) change_a_grip();
  coupling_.apply();
  gathered_ = false;
  world_.Step(1.0F / 60.0F, 8, 3);
  for (const ribbon::box2d::CordId c : coupling_.cords()) {
    for (const Vec2 x : coupling_.cord(c).positions()) require(is_finite(x), "positions of cords are finite");
  }
  for (const b2Body* body : bodies_) {
    if (!box2d_keeps_bodies_finite()) break;
    require(body->GetPosition().IsValid() && body->GetLinearVelocity().IsValid(),
            "positions and velocities of bodies are finite");
  }
}

/// Bodies of Box2D that collide with infinite restitution or friction get NaN positions, with and without cords.
bool Fuzzed::box2d_keeps_bodies_finite() const {
  for (const b2Body* body : bodies_) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (!std::isfinite(fixture->GetFriction()) || !std::isfinite(fixture->GetRestitution())) return false;
    }
  }
  return true;
}

void Fuzzed::change_a_grip() {
  b2Body* const holder = body();
  if (holder == nullptr) return;
  switch (bytes_.below(6)) {
    case 0: {
      const b2Vec2 hand = fuzz::arbitrary_anchor(bytes_);
      accepts([&] { coupling_.hold(cord(), point(), *holder, hand); });
      break;
    }
    case 1: coupling_.body(*holder).release(); break;
    case 2: accepts([&] { coupling_.grip(grip()).climb(bytes_.number(0.0, 2.0), bytes_.number(0.1, 10.0)); }); break;
    case 3: coupling_.grip(grip()).release(); break;
    default: {
      ribbon::box2d::GripDef def;
      def.cord = cord();
      def.arc = bytes_.number(0.0, 2.0);
      def.row = bytes_.integer(0, 2);
      def.local_anchor = fuzz::arbitrary_anchor(bytes_);
      if (bytes_.boolean()) def.strength = bytes_.number(0.1, 1e4);
      def.lets_go = bytes_.boolean();
      if (bytes_.below(4) == 0) def.point = point();
      accepts([&] { coupling_.hold(*holder, def); });
    }
  }
}

void Fuzzed::drive_a_cord() {
  const ribbon::box2d::CordId c = cord();
  const int p = point();
  switch (bytes_.below(6)) {
    case 0: accepts([&] { coupling_.cord(cord()).drag(p, bytes_.vector(-2.0, 2.0)); }); break;
    case 1: accepts([&] { coupling_.cord(cord()).free(p); }); break;
    case 2: accepts([&] { coupling_.cord(cord()).set_enabled(bytes_.boolean()); }); break;
    case 3:
      if (bytes_.boolean()) {
        accepts([&] { coupling_.remove(cord()); });
      } else if (coupling_.size() < 3) {
        add_cord();
      }
      break;
    default: {
      if (!coupling_.cord(c).is_valid() || coupling_.cord(c).solver() != ribbon::box2d::Solver::direct) return;
      ribbon::Cord& direct = coupling_.cord(c).direct();
      if (bytes_.boolean()) {
        accepts([&] { direct.reel(bytes_.integer(0, 3), bytes_.integer(1, 4), bytes_.number(0.01, 10.0), 1.0); });
      } else {
        accepts([&] { direct.attach_mass(p, bytes_.number(1e-3, 1e3)); });
      }
    }
  }
}

void Fuzzed::cut() {
  const ribbon::box2d::CordId c = cord();
  switch (bytes_.below(5)) {
    case 3: accepts([&] { coupling_.cord(c).cut_along(bytes_.integer(-1, 4)); }); break;
    case 4: accepts([&] { coupling_.reserve(bytes_.integer(-1, 4), bytes_.integer(1, 20)); }); break;
    case 0: accepts([&] { coupling_.cord(c).cut(bytes_.number(0.0, 2.0)); }); break;
    case 1: accepts([&] { coupling_.cut(bytes_.vector(-2.0, 2.0), bytes_.vector(-2.0, 2.0)); }); break;
    default:
      if (!coupling_.cord(c).is_valid() || coupling_.cord(c).solver() != ribbon::box2d::Solver::direct) return;
      accepts([&] { coupling_.cord(c).direct().set_breaking_force(bytes_.integer(0, 8), bytes_.number(0.0, 100.0)); });
  }
  for (const ribbon::box2d::CutEvent& event : coupling_.last_step().cut_events()) {
    require(!event.first || event.first != event.second, "the pieces of a cord have ids of their own");
  }
}

void Fuzzed::tie() {
  if (bytes_.boolean()) {
    accepts([&] { coupling_.tie(static_cast<ribbon::box2d::TieId>(bytes_.integer(0, 6))).untie(); });
    return;
  }
  const ribbon::box2d::TieDef def{cord(), bytes_.integer(-1, 12), cord(), bytes_.integer(-1, 12),
                                  bytes_.number(0.0, 1e3)};
  ribbon::box2d::TieId made = 0;
  if (!accepts([&] { made = coupling_.tie(def); })) return;
  require(coupling_.tie(made).state().other_point == def.other_point, "a tie is where it was made");
}

/// Lays a cord around a wheel, changes its motor, or takes it off.
void Fuzzed::reeve() {
  const auto id = static_cast<ribbon::box2d::PulleyId>(bytes_.integer(0, 4));
  switch (bytes_.below(4)) {
    case 0: accepts([&] { coupling_.pulley(id).remove(); }); return;
    case 1:
      accepts([&] { coupling_.pulley(id).set_motor(bytes_.number(-100.0, 100.0), bytes_.number(-1.0, 1e3)); });
      return;
    default: break;
  }
  ribbon::PulleyDef def;
  def.center = bytes_.vector(-2.0, 2.0);
  def.radius = bytes_.number(0.0, 1.0);
  def.counterclockwise = bytes_.boolean();
  def.before = bytes_.integer(-1, 8);
  def.after = bytes_.integer(0, 12);
  def.inertia = bytes_.number(0.0, 10.0);
  if (bytes_.boolean()) def.friction = bytes_.number(0.0, 2.0);
  def.motor_torque = bytes_.number(0.0, 10.0);
  b2Body* const carrier = world_.GetBodyList();
  if (carrier == nullptr) return;
  ribbon::box2d::PulleyId made = 0;
  if (!accepts([&] { made = coupling_.add_pulley(cord(), *carrier, def); })) return;
  require(std::isfinite(coupling_.pulley(made).state().arc), "the arc of a pulley is finite");
}

/// A state is restored although cords were cut, added and removed since, unless bodies were.
void Fuzzed::save_or_restore() {
  if (!saved_ || bytes_.boolean()) {
    if (!gathered_) saved_ = coupling_.save(world_);
    return;
  }
  if (accepts([&] { coupling_.restore(*saved_, world_); })) gathered_ = false;
}

void Fuzzed::listen() {
  listener_.speed = bytes_.number(-10.0, 10.0);
  listener_.refused = bytes_.integer(-1, 3);
  listener_.wanted = bytes_.boolean();
  coupling_.listen(bytes_.below(4) == 0 ? nullptr : &listener_);
}

/// An event agrees with the overlaps that there are.
void Fuzzed::look_at_sensors() const {
  for (const ribbon::box2d::SensorEvent& event : coupling_.last_step().sensor_events()) {
    const auto cord = coupling_.cord(event.cord);
    if (!cord.is_valid() || event.number == 0) continue;
    const auto inside = cord.sensors();
    require(std::binary_search(inside.begin(), inside.end(), event.number) == event.begins,
            "what began overlaps, and what ended does not");
  }
}

void Fuzzed::change_bodies() {
  if (bytes_.boolean() && bodies_.size() < max_bodies) {
    bodies_.push_back(&fuzz::add_arbitrary_body(world_, bytes_));
    return;
  }
  if (bodies_.empty()) return;
  const std::size_t k = bytes_.byte() % bodies_.size();
  if (bytes_.boolean()) {
    fuzz::disturb(*bodies_[k], bytes_);
    return;
  }
  coupling_.destroy(world_, *bodies_[k]);
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(k));
}

void Fuzzed::query() {
  const auto nearest = coupling_.nearest_point(bytes_.vector(-2.0, 2.0), bytes_.number(0.0, 2.0));
  require(!nearest || (coupling_.cord(nearest->cord).is_valid() && nearest->distance >= 0.0),
          "the nearest point is of a valid cord");
  require(!nearest || coupling_.cord(nearest->cord).is_enabled(), "the nearest point is of an enabled cord");
  queries_.update(coupling_);
  const Vec2 from = bytes_.vector(-2.0, 2.0);
  const Vec2 to = bytes_.vector(-2.0, 2.0);
  accepts([&] {
    const auto hit = queries_.ray_cast(from, to);
    require(!hit || (hit->fraction >= 0.0 && hit->fraction <= 1.0 && is_finite(hit->normal)), "a hit is on the ray");
  });
  if (bytes_.boolean()) coupling_.estimate_errors(bytes_.boolean());
  for (const ribbon::box2d::TouchEvent& touch : coupling_.last_step().touch_events()) {
    require(is_finite(touch.point) && is_finite(touch.normal), "contact points and normals are finite");
  }
  if (!box2d_keeps_bodies_finite()) return;
  for (const b2Body* body : bodies_)
    require(is_finite(coupling_.body(*body).velocity()), "velocities of bodies are finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Fuzzed coupling(bytes);
  for (int k = 0; k < max_calls && !bytes.empty(); ++k) coupling.call();
  return 0;
}

// Calls ribbon::Cord in any order with any numbers. Each call succeeds, or throws and changes nothing. After every step
// the cord is finite, has gained no energy without a cause, and equals a restored copy after the same step.

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/weather.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "tests/fuzz/arbitrary_cord.h"
#include "tests/fuzz/arbitrary_surroundings.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/refusals.h"
#include "tests/fuzz/require.h"

namespace {

using fuzz::accepts;
using fuzz::Bytes;
using fuzz::require;
using ribbon::Cord;
using ribbon::Vec2;

constexpr int max_calls = 8;

Cord built(Bytes& bytes) {
  try {
    return Cord(fuzz::arbitrary_cord(bytes));
  } catch (const ribbon::DefinitionError&) {
    ribbon::CordDef def;
    def.points = 6;
    def.pins = {0};
    return Cord(def);
  }
}

/// Returns whether the initial energy is unknown: an inextensible cord is stretched, or the cord overlaps itself.
bool initial_energy_is_unknown(const ribbon::CordDef& def) {
  return !def.positions.empty() && (std::isinf(def.stretch_stiffness) || def.self_contact);
}

class Fuzzed {
 public:
  explicit Fuzzed(Bytes& bytes)
      : bytes_(bytes), cord_(built(bytes)), saved_(cord_.save()), driven_(initial_energy_is_unknown(cord_.def())) {}

  void call();

 private:
  void step(const ribbon::Surroundings& surroundings);
  void restore();
  void corrupt(Cord::State& state);
  int point() { return bytes_.integer(0, cord_.size() - 1); }
  void require_no_gain(double before, double after, const ribbon::CordEnergy& then) const;

  Bytes& bytes_;
  Cord cord_;
  Cord::State saved_;
  bool driven_;  // since its construction
  ribbon::Weather weather_{ribbon::WeatherDef{.wind = {20.0, 3.0}, .gusts = 0.5, .water_level = 0.0}};
};

void Fuzzed::call() {
  const int p = point();
  switch (bytes_.below(14)) {
    case 0: accepts(cord_, [&] { cord_.attach_mass(p, bytes_.number(1e-3, 1e3)); }); break;
    case 1: accepts(cord_, [&] { cord_.set_load(p, bytes_.vector(-100.0, 100.0)); }); break;
    case 2: driven_ |= accepts(cord_, [&] { cord_.constrain(p, bytes_.vector(-1.0, 1.0)); }); break;
    case 3: driven_ |= accepts(cord_, [&] { cord_.operate(p, bytes_.vector(-1.0, 1.0)); }); break;
    case 4: accepts(cord_, [&] { cord_.release(p); }); break;
    case 5: accepts(cord_, [&] { cord_.set_velocity(p, bytes_.vector(-10.0, 10.0)); }); break;
    case 6: accepts(cord_, [&] { cord_.set_accuracy(fuzz::arbitrary_accuracy(bytes_)); }); break;
    case 7: {
      const int last = bytes_.integer(1, cord_.def().points - 1);
      driven_ |= accepts(cord_, [&] { cord_.reel(p, last, bytes_.number(1e-3, 1e3), bytes_.number(0.1, 10.0)); });
      break;
    }
    case 8: saved_ = cord_.save(); break;
    case 9: restore(); break;
    case 10: {
      fuzz::ArbitrarySurroundings surroundings(bytes_, cord_.size());
      driven_ = true;
      step(surroundings.view());
      for (const ribbon::RigidBody& body : surroundings.bodies)
        require(is_finite(body.impulse), "impulses on bodies are finite");
      break;
    }
    default: {
      ribbon::Surroundings surroundings;
      if (feels_medium(cord_.def())) {
        surroundings.medium = &weather_;
        driven_ = true;
      }
      step(surroundings);
      break;
    }
  }
}

void Fuzzed::step(const ribbon::Surroundings& surroundings) {
  const double dt = bytes_.number(1e-4, 0.1);
  const Vec2 gravity = bytes_.boolean() ? Vec2{0.0, -9.81} : bytes_.vector(-100.0, 100.0);
  std::optional<Cord> copy;
  if (surroundings.bodies.empty() && bytes_.below(4) == 0) {
    copy.emplace(cord_.def());
    copy->restore(cord_.save());
  }
  const ribbon::CordEnergy before = energy_of(cord_, gravity);
  ribbon::IslandReport report;
  if (!accepts(cord_, [&] { report = cord_.step(dt, gravity, surroundings); })) return;
  fuzz::require_finite(cord_);
  require(report.stages > 0 && report.iterations >= 0 && report.unconverged >= 0, "the report has valid counts");
  if (!surroundings.bodies.empty()) return;
  require(!copy || (copy->step(dt, gravity, surroundings) == report && copy->save() == cord_.save()),
          "a restored cord continues with the same bits");
  const ribbon::CordEnergy after = energy_of(cord_, gravity);
  if (!driven_ && report.unlocked == 0 && report.unconverged == 0)
    require_no_gain(before.total(), after.total(), after);
}

/// Allows 5 % of the energy's scale, for the energy guard, and the rounding error of positions far from the origin.
void Fuzzed::require_no_gain(double before, double after, const ribbon::CordEnergy& then) const {
  double mass = 0.0;
  for (int p = 0; p < cord_.size(); ++p) mass += cord_.mass(p);
  const double scale = mass * 100.0 * cord_.def().length + then.kinetic + then.elastic;
  const double rounding = 1e-9 * (std::abs(before) + std::abs(then.potential));
  require(after - before <= 0.05 * scale + rounding, "energy does not rise without a cause",
          std::to_string(before) + " J, then " + std::to_string(after) + " J");
}

void Fuzzed::restore() {
  Cord::State state = saved_;
  if (bytes_.boolean()) corrupt(state);
  if (accepts(cord_, [&] { cord_.restore(state); })) {
    require(cord_.save() == state, "the restored state equals the saved state");
    driven_ = true;
  }
}

void Fuzzed::corrupt(Cord::State& state) {
  const auto k = static_cast<std::size_t>(bytes_.below(cord_.size()));
  switch (bytes_.below(12)) {
    case 0: state.positions[k] = bytes_.vector(-1.0, 1.0); break;
    case 1: state.velocities[k] = bytes_.vector(-1.0, 1.0); break;
    case 2: state.accelerations[k] = bytes_.vector(-1.0, 1.0); break;
    case 3: state.targets[k] = bytes_.vector(-1.0, 1.0); break;
    case 4: state.masses[k] = bytes_.number(1e-3, 1.0); break;
    case 5: state.tensions.front() = bytes_.number(-1.0, 1.0); break;
    case 6: state.rest.front() = bytes_.number(0.1, 1.0); break;
    case 7: state.regainable_energy = bytes_.number(-1.0, 1.0); break;
    case 8: state.positions.pop_back(); break;
    case 9: state.kinds[k] = static_cast<ribbon::PointKind>(bytes_.byte()); break;
    case 10: {
      Cord::Holder holder;
      holder.point = bytes_.integer(0, cord_.size() - 1);
      holder.acceleration = bytes_.vector(-1.0, 1.0);
      state.holders.push_back(holder);
      break;
    }
    default: {
      ribbon::Touch touch;
      touch.other = bytes_.byte();
      touch.feature = bytes_.integer(0, 2 * cord_.size());
      touch.force = bytes_.number(0.0, 1.0);
      touch.normal = bytes_.vector(-1.0, 1.0);
      touch.push = bytes_.vector(-1.0, 1.0);
      state.touches.push_back(touch);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Fuzzed cord(bytes);
  for (int k = 0; k < max_calls && !bytes.empty(); ++k) cord.call();
  return 0;
}

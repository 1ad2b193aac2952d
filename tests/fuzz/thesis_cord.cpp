// Calls ribbon::ThesisCord in any order with any numbers. Each call succeeds, or throws and changes nothing. After
// every step the cord is finite, and equals a restored copy after the same step.

#include "ribbon/thesis/thesis_cord.h"

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/arbitrary_cord.h"
#include "tests/fuzz/arbitrary_surroundings.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/refusals.h"
#include "tests/fuzz/require.h"

namespace {

using fuzz::Bytes;
using fuzz::require;
using ribbon::ThesisCord;
using ribbon::Vec2;

constexpr int max_calls = 10;

ThesisCord built(Bytes& bytes) {
  try {
    return ThesisCord(fuzz::arbitrary_thesis_cord(bytes));
  } catch (const ribbon::DefinitionError&) {
    ribbon::ThesisDef def;
    def.w = 5;
    def.substeps = 2;
    return ThesisCord(def);
  }
}

void step(ThesisCord& cord, Bytes& bytes, const ribbon::Surroundings& surroundings) {
  const double dt = bytes.number(1e-4, 0.1);
  const Vec2 gravity = bytes.boolean() ? Vec2{0.0, -9.81} : bytes.vector(-100.0, 100.0);
  ThesisCord copy(cord.def());
  const bool copied =
      surroundings.bodies.empty() && bytes.below(4) == 0 && fuzz::accepts(copy, [&] { copy.restore(cord.save()); });
  ribbon::StepReport report;
  if (!fuzz::accepts(cord, [&] { report = cord.step(dt, gravity, surroundings); })) return;
  fuzz::require_finite(cord);
  if (!copied) return;
  require(copy.step(dt, gravity) == report && copy.save() == cord.save(),
          "a restored cord continues with the same bits");
}

void restore(ThesisCord& cord, Bytes& bytes, ThesisCord::State state) {
  const auto k = static_cast<std::size_t>(bytes.below(cord.mesh().size()));
  switch (bytes.below(6)) {
    case 0: state.positions[k] = bytes.vector(-1.0, 1.0); break;
    case 1: state.velocities[k] = bytes.vector(-1.0, 1.0); break;
    case 2: state.targets[k] = bytes.vector(-1.0, 1.0); break;
    case 3: state.kinds[k] = static_cast<ribbon::PointKind>(bytes.byte()); break;
    case 4: state.targets.pop_back(); break;
    default: break;
  }
  if (fuzz::accepts(cord, [&] { cord.restore(state); }))
    require(cord.save() == state, "the restored state equals the saved state");
}

void call(ThesisCord& cord, Bytes& bytes, ThesisCord::State& saved) {
  const int p = bytes.integer(0, cord.mesh().size() - 1);
  switch (bytes.below(10)) {
    case 0: fuzz::accepts(cord, [&] { cord.constrain(p, bytes.vector(-1.0, 1.0)); }); break;
    case 1: fuzz::accepts(cord, [&] { cord.operate(p, bytes.vector(-1.0, 1.0)); }); break;
    case 2: fuzz::accepts(cord, [&] { cord.release(p); }); break;
    case 3: fuzz::accepts(cord, [&] { cord.set_velocity(p, bytes.vector(-10.0, 10.0)); }); break;
    case 4: fuzz::accepts(cord, [&] { cord.add_momentum(bytes.vector(-1.0, 1.0)); }); break;
    case 5: saved = cord.save(); break;
    case 6: restore(cord, bytes, saved); break;
    case 7: {
      fuzz::ArbitrarySurroundings surroundings(bytes, cord.mesh().size());
      step(cord, bytes, surroundings.view());
      for (const ribbon::RigidBody& body : surroundings.bodies)
        require(is_finite(body.impulse), "impulses on bodies are finite");
      break;
    }
    default: step(cord, bytes, {}); break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  ThesisCord cord = built(bytes);
  ThesisCord::State saved = cord.save();
  for (int k = 0; k < max_calls && !bytes.empty(); ++k) call(cord, bytes, saved);
  return 0;
}

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ribbon/box2d/state_hash.h"
#include "tests/bits/bit_scenes.h"
#include "tests/bits/golden_replays.h"

// Save, step, restore, step again. The state of a Box2D world cannot be saved, so there are two kinds of tests: with an
// equal world at the same tick, whose coupling was changed before; and with the same world, whose bodies are set to
// their recorded state.

namespace bits {
namespace {

constexpr int together = 4;  // ticks that are compared after a restore

struct Velocity {
  b2Vec2 linear;
  float angular;
};

std::vector<Velocity> velocities_of(b2World& world) {
  std::vector<Velocity> velocities;
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    velocities.push_back({body->GetLinearVelocity(), body->GetAngularVelocity()});
  }
  return velocities;
}

/// Sets only velocities that differ, because setting a velocity keeps a body awake.
void set_velocities(b2World& world, const std::vector<Velocity>& velocities) {
  auto before = velocities.begin();
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++before) {
    if (!(body->GetLinearVelocity() == before->linear)) body->SetLinearVelocity(before->linear);
    if (body->GetAngularVelocity() != before->angular) body->SetAngularVelocity(before->angular);
  }
}

/// Changes all of a coupling but not the world: restores a much older state, then runs some ticks in which nothing else
/// moves.
void spoil(ribbon::box2d::Coupling& coupling, b2World& world, const ribbon::box2d::Coupling::State& long_before) {
  const std::vector<Velocity> velocities = velocities_of(world);
  coupling.restore(long_before, world);
  for (int k = 0; k < 2; ++k) {
    coupling.gather(world, dt);
    coupling.step();
    coupling.restore(coupling.save(world), world);  // in place of apply
  }
  set_velocities(world, velocities);
}

class Restored : public testing::TestWithParam<BitScene> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Restored, testing::ValuesIn(bit_scenes().begin(), bit_scenes().end()),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST_P(Restored, ReturnsTheSavedState) {
  BitWorld world;
  GetParam().build(world);
  const ribbon::box2d::Coupling::State start = world.coupling.save(world.world);
  for (int k = 0; k < GetParam().ticks / 2; ++k) tick(GetParam(), world, k);
  const ribbon::box2d::Coupling::State state = world.coupling.save(world.world);
  EXPECT_FALSE(start == state);
  world.coupling.restore(start, world.world);
  EXPECT_TRUE(world.coupling.save(world.world) == start);
  world.coupling.restore(state, world.world);
  EXPECT_TRUE(world.coupling.save(world.world) == state);
}

/// Two equal worlds. They are changed and restored alternately, so that every tick follows a restore.
TEST_P(Restored, InAnEqualWorldContinuesWithTheSameBitsFromEveryTick) {
  const BitScene& scene = GetParam();
  BitWorld world;
  scene.build(world);
  std::vector<std::unique_ptr<BitWorld>> twins;
  for (int k = 0; k < together; ++k) {
    twins.push_back(std::make_unique<BitWorld>());
    scene.build(*twins.back());
  }
  const ribbon::box2d::Coupling::State start = world.coupling.save(world.world);
  for (int k = 0; k < scene.ticks; ++k) {
    BitWorld& twin = *twins[static_cast<std::size_t>(k % together)];
    spoil(twin.coupling, twin.world, start);
    twin.coupling.restore(world.coupling.save(world.world), twin.world);
    tick(scene, world, k);
    const std::uint64_t hash = hash_of(world.coupling, world.world);
    for (const auto& each : twins) {
      tick(scene, *each, k);
      ASSERT_EQ(ribbon::box2d::to_hex(hash_of(each->coupling, each->world)), ribbon::box2d::to_hex(hash))
          << "tick " << k;
    }
  }
}

class RestoredReplay : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Golden, RestoredReplay, testing::ValuesIn(golden_replays()), name_of_replay);

TEST_P(RestoredReplay, InAnEqualWorldContinuesWithTheSameBitsFromEveryTick) {
  const GoldenRun run(GetParam());
  game::Simulation simulation(run.level);
  std::vector<std::unique_ptr<game::Simulation>> twins;
  for (int k = 0; k < together; ++k) twins.push_back(std::make_unique<game::Simulation>(run.level));
  ribbon::box2d::Coupling::State long_before = simulation.scene().coupling().save(simulation.scene().world());
  for (std::size_t k = 0; k < run.replay.ticks.size(); ++k) {
    const ribbon::box2d::Coupling::State state = simulation.scene().coupling().save(simulation.scene().world());
    // A state can only be restored with the same cords: after a cord is added or removed, older states are useless.
    if (state.cords.size() != long_before.cords.size()) long_before = state;
    engine::Scene& twin = twins[k % together]->scene();
    spoil(twin.coupling(), twin.world(), long_before);
    twin.coupling().restore(state, twin.world());
    simulation.tick(run.replay.ticks[k].input);
    const std::uint64_t hash = hash_of(simulation.scene().coupling(), simulation.scene().world());
    ASSERT_EQ(simulation.hash(), run.replay.ticks[k].state) << "tick " << k;
    for (const auto& each : twins) {
      each->tick(run.replay.ticks[k].input);
      ASSERT_EQ(ribbon::box2d::to_hex(hash_of(each->scene().coupling(), each->scene().world())),
                ribbon::box2d::to_hex(hash))
          << "tick " << k;
      ASSERT_EQ(each->hash(), simulation.hash()) << "tick " << k;
    }
  }
}

/// The recorded surroundings of a coupling in a tick, which replace a running world.
struct Frame {
  struct Body {
    b2Vec2 position;
    float angle;
    Velocity velocity;
  };
  std::vector<Body> bodies;
  std::optional<ribbon::box2d::CordPoint> held;
  b2Vec2 hand;
};

std::vector<Frame> record(const GoldenRun& run) {
  game::Simulation simulation(run.level);
  std::vector<Frame> frames;
  for (const engine::RecordedTick& recorded : run.replay.ticks) {
    Frame frame;
    for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
      frame.bodies.push_back(
          {body->GetPosition(), body->GetAngle(), {body->GetLinearVelocity(), body->GetAngularVelocity()}});
    }
    simulation.tick(recorded.input);
    frame.held = simulation.scene().coupling().body(simulation.player().body()).held_place();
    frame.hand = ribbon::box2d::to_float(simulation.player().grip());
    frames.push_back(std::move(frame));
  }
  return frames;
}

/// The level's cords in a world whose bodies, and the player's grip, are set in every tick.
class Stand {
 public:
  explicit Stand(const game::Level& level) : scene_(level.make_scene()), player_(scene_->world(), level.player_start) {}

  std::uint64_t tick(const Frame& frame) {
    auto set = frame.bodies.begin();
    for (b2Body* body = scene_->world().GetBodyList(); body != nullptr; body = body->GetNext(), ++set) {
      body->SetTransform(set->position, set->angle);
      body->SetLinearVelocity(set->velocity.linear);
      body->SetAngularVelocity(set->velocity.angular);
    }
    follow_hand(frame);
    coupling().gather(scene_->world(), dt);
    coupling().step();
    coupling().apply();
    return hash_of(coupling(), scene_->world());
  }
  ribbon::box2d::Coupling& coupling() { return scene_->coupling(); }
  b2World& world() { return scene_->world(); }

 private:
  void follow_hand(const Frame& frame) {
    const auto grip = coupling().body(player_.body()).first_grip();
    const auto held = coupling().body(player_.body()).held_place();
    if (frame.held && held && held->cord == frame.held->cord && held->point == frame.held->point) {
      return coupling().grip(*grip).move_anchor(frame.hand);
    }
    coupling().body(player_.body()).release();
    if (frame.held) coupling().hold(frame.held->cord, frame.held->point, player_.body(), frame.hand);
  }

  std::unique_ptr<engine::Scene> scene_;
  game::Player player_;
};

/// This test holds cords only at points, so that it can follow runs with little climbing and few contacts.
TEST(RestoredRun, InItsOwnWorldRepeatsEveryTickWithTheSameBits) {
  const GoldenRun run(game::assets_folder() + "/replays/first_swing.replay");
  const std::vector<Frame> frames = record(run);
  Stand stand(run.level);
  std::size_t held = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const ribbon::box2d::Coupling::State state = stand.coupling().save(stand.world());
    const std::size_t end = std::min(frames.size(), k + together);
    std::vector<std::uint64_t> first;
    for (std::size_t t = k; t < end; ++t) first.push_back(stand.tick(frames[t]));
    stand.coupling().restore(state, stand.world());
    for (std::size_t t = k; t < end; ++t) ASSERT_EQ(stand.tick(frames[t]), first[t - k]) << "from " << k << " to " << t;
    stand.coupling().restore(state, stand.world());
    ASSERT_EQ(stand.tick(frames[k]), first[0]);
    held += stand.coupling().body(*stand.world().GetBodyList()).held_place().has_value() ? 1U : 0U;
  }
  EXPECT_GT(held, 60U) << "of little worth where the player holds nothing";
}

}  // namespace
}  // namespace bits

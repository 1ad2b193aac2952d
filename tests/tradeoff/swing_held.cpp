#include "tests/tradeoff/swing_held.h"

#include <optional>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/exact_chain.h"
#include "tests/support/heavy_swing.h"

namespace tradeoff {
namespace {

namespace heavy = test_support::heavy;
using ribbon::Vec2;
using ribbon::box2d::to_double;

using constants::infinity;

class HeldSwing final : public Swing {
 public:
  explicit HeldSwing(std::optional<ribbon::Accuracy> accuracy) : accuracy_(accuracy) { reset(); }

  void reset() override {
    scene_.emplace();
    if (accuracy_) {
      ribbon::Cord cord = test_support::heavy_swing(infinity, *accuracy_);
      cord.attach_mass(heavy::links, 0.0);
      scene_->coupling.add(std::move(cord));
      scene_->coupling.hold(0, heavy::links, *scene_->load, {0.0F, 0.0F});
    }
    unconverged_ = 0;
  }

  void tick() override {
    if (accuracy_) {
      scene_->coupling.gather(scene_->world, heavy::tick);
      scene_->coupling.step();
      scene_->coupling.apply();
      unconverged_ += scene_->coupling.cord(0).island_report().unconverged;
    }
    scene_->world.Step(static_cast<float>(heavy::tick), 8, 3);
  }

  std::vector<Vec2> path() const override {
    std::vector<Vec2> points{{}};
    if (accuracy_) {
      const auto positions = scene_->coupling.cord(0).positions();
      points.assign(positions.begin(), positions.end());
    }
    points.back() = to_double(scene_->load->GetPosition());
    return points;
  }

  double energy() override {
    const Vec2 position = to_double(scene_->load->GetPosition());
    const double load = energy_of(heavy::load_mass, position, scene_->coupling.body(*scene_->load).velocity());
    return load + (accuracy_ ? energy_of(scene_->coupling.cord(0).direct(), {0.0, -heavy::gravity}).total() : 0.0);
  }

  std::optional<int> unconverged() const override { return unconverged_; }
  std::optional<std::int64_t> work() const override { return scene_->coupling.last_step().report().work; }

 private:
  struct Scene {
    Scene() {
      b2BodyDef definition;
      definition.type = b2_dynamicBody;
      definition.position = ribbon::box2d::to_float({heavy::length, 0.0});
      definition.allowSleep = false;
      load = world.CreateBody(&definition);
      b2MassData data;
      data.mass = static_cast<float>(heavy::load_mass);
      data.center.SetZero();
      data.I = 7.0F;
      load->SetMassData(&data);
    }
    b2World world{{0.0F, static_cast<float>(-heavy::gravity)}};
    ribbon::box2d::Coupling coupling;
    b2Body* load = nullptr;
  };

  std::optional<ribbon::Accuracy> accuracy_;
  std::optional<Scene> scene_;
  int unconverged_ = 0;
};

}  // namespace

std::unique_ptr<Swing> held_swing(const ribbon::Accuracy& accuracy) { return std::make_unique<HeldSwing>(accuracy); }

std::unique_ptr<Swing> falling_body() { return std::make_unique<HeldSwing>(std::nullopt); }

}  // namespace tradeoff

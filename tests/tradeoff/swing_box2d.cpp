#include "tests/tradeoff/swing_box2d.h"

#include <optional>

#include "ribbon/box2d/convert.h"
#include "tests/support/exact_chain.h"

namespace tradeoff {
namespace {

namespace heavy = test_support::heavy;
using ribbon::Vec2;
using ribbon::box2d::to_double;
using test_support::Box2dChain;
using test_support::Box2dRope;

constexpr auto tick_seconds = static_cast<float>(heavy::tick);
constexpr auto half_link = static_cast<float>(0.5 * heavy::length / heavy::links);

class ChainSwing final : public Swing {
 public:
  ChainSwing(Box2dChain::Limit limit, Box2dSetting setting) : limit_(limit), setting_(setting) { reset(); }

  void reset() override { chain_.emplace(limit_); }

  void tick() override {
    for (int k = 0; k < setting_.substeps; ++k) {
      chain_->step(tick_seconds / static_cast<float>(setting_.substeps), setting_.velocity_iterations,
                   setting_.position_iterations);
    }
  }

  /// The path joins the rear ends of the links, so that gaps of joints count as stretch.
  std::vector<Vec2> path() const override {
    std::vector<Vec2> points = {Vec2{}};
    for (const b2Body* link : chain_->links()) points.push_back(to_double(link->GetWorldPoint({half_link, 0.0F})));
    points.push_back(to_double(chain_->load().GetPosition()));
    return points;
  }

  double energy() override {
    const b2Body& load = chain_->load();
    double sum = energy_of(heavy::load_mass, to_double(load.GetPosition()), to_double(load.GetLinearVelocity()));
    for (const b2Body* link : chain_->links()) {
      for (const b2Vec2 end : {b2Vec2{-half_link, 0.0F}, b2Vec2{half_link, 0.0F}}) {
        sum += energy_of(0.5 * heavy::rope_mass / heavy::links, to_double(link->GetWorldPoint(end)),
                         to_double(link->GetLinearVelocityFromLocalPoint(end)));
      }
    }
    return sum;
  }

 private:
  Box2dChain::Limit limit_;
  Box2dSetting setting_;
  std::optional<Box2dChain> chain_;
};

class RopeSwing final : public Swing {
 public:
  RopeSwing(const b2RopeTuning& tuning, int substeps, int iterations)
      : tuning_(tuning), substeps_(substeps), iterations_(iterations) {
    reset();
  }

  void reset() override { rope_.emplace(tuning_); }

  void tick() override {
    for (int k = 0; k < substeps_; ++k) rope_->step(substep(), iterations_);
  }

  std::vector<Vec2> path() const override {
    std::vector<Vec2> points;
    for (const b2Vec2 p : rope_->positions()) points.push_back(to_double(p));
    return points;
  }

  /// The velocities are not accessible, so they are measured as the motion of the points in one more substep.
  double energy() override {
    const std::vector<Vec2> before = path();
    rope_->step(substep(), iterations_);
    const std::vector<Vec2> after = path();
    const double mass = heavy::rope_mass / heavy::links;
    double sum = 0.0;
    for (std::size_t p = 1; p < after.size(); ++p) {
      const Vec2 velocity = (1.0 / static_cast<double>(substep())) * (after[p] - before[p]);
      sum += energy_of(p + 1 < after.size() ? mass : 0.5 * mass + heavy::load_mass, after[p], velocity);
    }
    return sum;
  }

 private:
  float substep() const { return tick_seconds / static_cast<float>(substeps_); }

  b2RopeTuning tuning_;
  int substeps_;
  int iterations_;
  std::optional<Box2dRope> rope_;
};

}  // namespace

std::unique_ptr<Swing> box2d_chain(Box2dChain::Limit limit, Box2dSetting setting) {
  return std::make_unique<ChainSwing>(limit, setting);
}

std::unique_ptr<Swing> box2d_rope(const b2RopeTuning& tuning, int substeps, int iterations) {
  return std::make_unique<RopeSwing>(tuning, substeps, iterations);
}

}  // namespace tradeoff

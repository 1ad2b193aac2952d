#include "tests/tradeoff/swing_cords.h"

#include <optional>

#include "ribbon/cord_forces.h"
#include "ribbon/thesis/thesis_cord.h"
#include "tests/support/exact_chain.h"
#include "tests/support/heavy_swing.h"

namespace tradeoff {
namespace {

namespace heavy = test_support::heavy;
using ribbon::Vec2;

constexpr Vec2 gravity{0.0, -heavy::gravity};

class CordSwing final : public Swing {
 public:
  CordSwing(double stiffness, const ribbon::Accuracy& accuracy)
      : cord_(test_support::heavy_swing(stiffness, accuracy)), start_(cord_.save()) {}

  void reset() override {
    cord_.restore(start_);
    unconverged_ = 0;
  }

  void tick() override {
    const ribbon::IslandReport report = cord_.step(heavy::tick, gravity);
    unconverged_ += report.unconverged;
    work_ = report.work;
  }

  std::vector<Vec2> path() const override { return {cord_.positions().begin(), cord_.positions().end()}; }
  double energy() override { return energy_of(cord_, gravity).total(); }
  std::optional<int> unconverged() const override { return unconverged_; }
  std::optional<std::int64_t> work() const override { return work_; }

 private:
  ribbon::Cord cord_;
  ribbon::Cord::State start_;
  int unconverged_ = 0;
  std::int64_t work_ = 0;
};

ribbon::ThesisDef thesis_def(int substeps) {
  ribbon::ThesisDef def;
  def.w = heavy::links + 1;
  def.h = 2;
  def.spacing = heavy::length / heavy::links;
  def.point_mass = heavy::rope_mass / (def.w * def.h);
  def.spring_stiffness = 1e12;
  def.bar_damping = def.point_mass * substeps / heavy::tick;
  def.area_stiffness = 0.0;
  def.substeps = substeps;
  def.pins = {0};
  return def;
}

class ThesisSwing final : public Swing {
 public:
  explicit ThesisSwing(int substeps) : cord_(thesis_def(substeps)), start_(cord_.save()) { reset(); }

  void reset() override {
    cord_.restore(start_);
    load_ = {};
    load_.position = {heavy::length, 0.0};
    load_.inverse_mass = 1.0 / heavy::load_mass;
    load_.acceleration = gravity;
    skipped_ = 0;
  }

  void tick() override {
    const ribbon::Grip grip{2 * heavy::links, 0, {}};
    skipped_ += cord_.step(heavy::tick, gravity, {{&load_, 1}, {}, {&grip, 1}}).fem_skipped;
    load_.velocity += heavy::tick * gravity + load_.inverse_mass * load_.impulse;
    load_.position += load_.moved;
    load_.impulse = {};
  }

  std::vector<Vec2> path() const override {
    std::vector<Vec2> points;
    for (std::size_t p = 0; p < cord_.positions().size(); p += 2) points.push_back(cord_.positions()[p]);
    points.back() = load_.position;
    return points;
  }

  /// Omits the energy of the springs, which is negligible for this stiffness. Heights are relative to the start.
  double energy() override {
    double sum = energy_of(heavy::load_mass, load_.position, load_.velocity);
    for (std::size_t p = 0; p < cord_.positions().size(); ++p) {
      sum += energy_of(cord_.def().point_mass, cord_.positions()[p] - start_.positions[p], cord_.velocities()[p]);
    }
    return sum;
  }

  /// Counts substeps without a positive definite matrix, which only the springs solved.
  std::optional<int> unconverged() const override { return skipped_; }

 private:
  ribbon::ThesisCord cord_;
  ribbon::ThesisCord::State start_;
  ribbon::RigidBody load_;
  int skipped_ = 0;
};

}  // namespace

std::unique_ptr<Swing> cord_swing(double stiffness, const ribbon::Accuracy& accuracy) {
  return std::make_unique<CordSwing>(stiffness, accuracy);
}

std::unique_ptr<Swing> thesis_swing(int substeps) { return std::make_unique<ThesisSwing>(substeps); }

}  // namespace tradeoff

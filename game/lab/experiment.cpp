#include "game/lab/experiment.h"

#include <algorithm>
#include <limits>
#include <string>

#include "game/lab/figures.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/definition.h"

namespace game::lab {
namespace {

bool is_within(const KnobRange& range, double value) {
  if (range.min_is_zero && value == 0.0) return true;
  if (range.max_is_infinite && value == std::numeric_limits<double>::infinity()) return true;
  return value >= range.min && value <= range.max;
}

}  // namespace

Experiment::Experiment(const Scene& scene) : scene_(&scene), values_(initial_values(scene)) { build(); }

void Experiment::build() {
  benches_.clear();
  first_energies_.clear();
  ticks_ = 0;
  const auto add = [this](Method method, ribbon::Vec2 origin) {
    benches_.push_back(std::make_unique<Bench>(method, scene_->gravity));
    scene_->build(*benches_.back(), values_, origin);
    benches_.back()->set_chain_substeps(std::max(values_.whole(Knob::chain_substeps), 1));
    benches_.back()->coupling().use(parallel_for_);
    first_energies_.push_back(energy(*benches_.back()));
  };
  add(Method::cords, {});
  if (scene_->chains_at) add(Method::chains, *scene_->chains_at);
}

void Experiment::restart() { build(); }

void Experiment::set(Knob knob, double value) {
  const KnobRange* range = range_of(*scene_, knob);
  if (range == nullptr) {
    throw ribbon::CallError("the scene " + std::string(scene_->name) + " does not have this knob");
  }
  if (!is_within(*range, value)) {
    throw ribbon::DefinitionError("the value of a knob is " + std::to_string(value) + "; accepted is " +
                                  std::to_string(range->min) + " to " + std::to_string(range->max));
  }
  if (values_[knob] == value) return;
  values_[knob] = value;
  if (range->rebuilds) return build();
  apply(knob);
}

void Experiment::apply(Knob knob) {
  if (knob == Knob::preset) follow_preset(values_);
  for (const std::unique_ptr<Bench>& bench : benches_) {
    switch (knob) {
      case Knob::preset:
      case Knob::substeps:
      case Knob::tolerance: bench->set_accuracy(accuracy_of(values_)); break;
      case Knob::chain_substeps: bench->set_chain_substeps(values_.whole(knob)); break;
      case Knob::friction: bench->set_friction(values_[knob]); break;
      case Knob::stretch:
        bench->change_cords([this](ribbon::CordDef& def) { def.stretch_stiffness = values_[Knob::stretch]; });
        break;
      case Knob::bending:
        bench->change_cords([this](ribbon::CordDef& def) { def.bending_stiffness = values_[Knob::bending]; });
        if (scene_->tune) scene_->tune(*bench, values_);  // the load of a column follows it
        break;
      default:
        if (scene_->tune) scene_->tune(*bench, values_);
    }
  }
}

void Experiment::tick(const engine::TickInput& input, BenchWatch* watch) {
  for (std::size_t k = 0; k < benches_.size(); ++k) {
    if (watch != nullptr) watch->begins(k);
    benches_[k]->tick(input);
    if (watch != nullptr) watch->ends(k);
  }
  ++ticks_;
}

void Experiment::let_go() {
  for (const std::unique_ptr<Bench>& bench : benches_) bench->let_go();
}

void Experiment::use(const ribbon::ParallelFor& parallel_for) {
  parallel_for_ = parallel_for;
  for (const std::unique_ptr<Bench>& bench : benches_) bench->coupling().use(parallel_for_);
}

std::uint64_t Experiment::hash() const {
  ribbon::box2d::Hasher hasher;
  for (const std::unique_ptr<Bench>& bench : benches_) hasher.add(state_hash(*bench));
  return hasher.value();
}

}  // namespace game::lab

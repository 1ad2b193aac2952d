#include "game/lab/history.h"

#include "game/lab/figures.h"

namespace game::lab {

void History::add(const Experiment& experiment) {
  if (experiment.ticks() <= last_tick_) forget();
  last_tick_ = experiment.ticks();
  for (std::size_t k = 0; k < experiment.benches().size(); ++k) {
    const Bench& bench = *experiment.benches()[k];
    samples_[k][count_ % length] = {energy(bench) - experiment.first_energy(k), greatest_stretch(bench)};
  }
  ++count_;
}

}  // namespace game::lab

#include "game/lab_view/picture.h"

#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

Vec2 between(Vec2 from, Vec2 to, double alpha) { return from + alpha * (to - from); }

void take(Picture::Bench& shown, const Bench& bench) {
  take_snapshot(shown.snapshot, bench.world(), bench.coupling());
  shown.chains.resize(bench.chains().size());
  for (std::size_t c = 0; c < shown.chains.size(); ++c) {
    const JointChain& chain = bench.chains()[c];
    shown.chains[c].clear();
    for (int box = 0; box + 1 < chain.points(); ++box) {
      const auto [front, rear] = chain.ends(box);
      shown.chains[c].emplace_back(to_double(front), to_double(rear));
    }
  }
}

}  // namespace

void take_picture(Picture& picture, const Experiment& experiment) {
  const auto benches = experiment.benches();
  picture.benches.resize(benches.size());
  for (std::size_t k = 0; k < benches.size(); ++k) take(picture.benches[k], *benches[k]);
  picture.forces.clear();
  if (experiment.scene().forces) picture.forces = experiment.scene().forces(*benches.front(), experiment.values());
}

Picture between(const Picture& from, const Picture& to, double alpha) {
  Picture shown = to;
  for (std::size_t k = 0; k < to.benches.size(); ++k) {
    const Picture::Bench& a = from.benches[k];
    Picture::Bench& b = shown.benches[k];
    b.snapshot = interpolate(a.snapshot, to.benches[k].snapshot, alpha);
    for (std::size_t c = 0; c < b.chains.size(); ++c) {
      for (std::size_t link = 0; link < b.chains[c].size(); ++link) {
        b.chains[c][link].first = between(a.chains[c][link].first, b.chains[c][link].first, alpha);
        b.chains[c][link].second = between(a.chains[c][link].second, b.chains[c][link].second, alpha);
      }
    }
  }
  for (std::size_t k = 0; k < shown.forces.size(); ++k) {
    ShownForce& force = shown.forces[k];
    force.tip = between(from.forces[k].tip, force.tip, alpha);
    force.arrow = between(from.forces[k].arrow, force.arrow, alpha);
    force.number_at = between(from.forces[k].number_at, force.number_at, alpha);
  }
  return shown;
}

std::size_t number_of(const b2Body& body) {
  std::size_t number = 0;  // the list of a world begins with the last body
  for (const b2Body* each = body.GetNext(); each != nullptr; each = each->GetNext()) ++number;
  return number;
}

}  // namespace game::lab

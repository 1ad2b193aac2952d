#include "tests/extremes/any_scene/shrink.h"

#include <algorithm>
#include <cmath>

#include "tests/extremes/any_scene/edit.h"
#include "tests/extremes/any_scene/figures.h"
#include "tests/extremes/any_scene/oracles.h"
#include "tests/support/slot.h"

namespace any_scene {
namespace {

constexpr double touching = 1e-4;   // m, the overlap or separation allowed for rounding
constexpr double stretched = 1e-4;  // the relative length error of links allowed for rounding

using test_support::slot;

double ends(const Summary& run) { return run.end == End::crashed || run.end == End::broken ? 1.0 : 0.0; }

/// Holds a scene and makes it smaller as long as it fails.
class Shrinker {
 public:
  Shrinker(const Scene& scene, const Fails& fails) : scene_(scene), fails_(fails) {}

  const Scene& scene() const { return scene_; }

  /// Accepts the edited scene if it differs and also fails.
  bool take(const Scene& edited) {
    if (edited == scene_ || !fails_(edited)) return false;
    scene_ = edited;
    return true;
  }

  template <typename Edit>
  bool attempt(Edit&& edit) {
    Scene edited = scene_;
    edit(edited);
    return take(edited);
  }

  void end_sooner();
  bool drop_parts();
  bool drop_terms();
  bool thin_out();
  bool round_numbers();

 private:
  template <typename Edit>
  bool attempt_each(std::size_t (*count)(const Scene&), Edit&& edit) {
    bool any = false;
    for (std::size_t k = count(scene_); k-- > 0;) {
      any = attempt([&](Scene& edited) { edit(edited, static_cast<int>(k)); }) || any;
    }
    return any;
  }

  Scene scene_;
  const Fails& fails_;
};

/// Finds the least number of ticks by bisection. Assumes that a scene that fails after n ticks also fails after more.
void Shrinker::end_sooner() {
  int passes = 0;
  int fails = scene_.ticks;
  while (fails - passes > 1) {
    const int middle = passes + (fails - passes) / 2;
    if (attempt([&](Scene& edited) { edited.ticks = middle; })) {
      fails = middle;
    } else {
      passes = middle;
    }
  }
}

bool Shrinker::drop_parts() {
  bool any = attempt_each([](const Scene& s) { return s.drags.size(); },
                          [](Scene& s, int k) { s.drags.erase(s.drags.begin() + k); });
  any = attempt_each([](const Scene& s) { return s.reels.size(); },
                     [](Scene& s, int k) { s.reels.erase(s.reels.begin() + k); }) ||
        any;
  any = attempt_each([](const Scene& s) { return s.cuts.size(); },
                     [](Scene& s, int k) { s.cuts.erase(s.cuts.begin() + k); }) ||
        any;
  any = attempt_each([](const Scene& s) { return s.knots.size(); },
                     [](Scene& s, int k) { s.knots.erase(s.knots.begin() + k); }) ||
        any;
  any = attempt_each([](const Scene& s) { return s.wheels.size(); },
                     [](Scene& s, int k) { s.wheels.erase(s.wheels.begin() + k); }) ||
        any;
  any = attempt_each([](const Scene& s) { return s.holds.size(); },
                     [](Scene& s, int k) { s.holds.erase(s.holds.begin() + k); }) ||
        any;
  any = attempt_each([](const Scene& s) { return s.solids.size(); }, remove_solid) || any;
  any = attempt_each([](const Scene& s) { return s.cords.size(); },
                     [](Scene& s, int k) {
                       if (s.cords.size() > 1) remove_cord(s, k);
                     }) ||
        any;
  return any;
}

bool Shrinker::drop_terms() {
  bool any = attempt([](Scene& s) { s.sleeping = false; });
  for (int k = 0; k < static_cast<int>(scene_.cords.size()); ++k) {
    for (const CordEdit edit : term_edits()) {
      const auto edited = [&](Scene& s) {
        edit(s.cords[slot(k)]);
        hold_again(s);
        drop_misfits(s);
      };
      any = attempt(edited) || any;
    }
  }
  for (int k = 0; k < static_cast<int>(scene_.solids.size()); ++k) {
    for (const SolidEdit edit : solid_edits()) {
      any = attempt([&](Scene& s) { edit(s.solids[slot(k)]); }) || any;
    }
  }
  for (int k = 0; k < static_cast<int>(scene_.holds.size()); ++k) {
    for (const HoldEdit edit : hold_edits()) {
      any = attempt([&](Scene& s) { edit(s.holds[slot(k)]); }) || any;
    }
  }
  for (int k = 0; k < static_cast<int>(scene_.wheels.size()); ++k) {
    for (const WheelEdit edit : wheel_edits()) {
      any = attempt([&](Scene& s) { edit(s.wheels[slot(k)]); }) || any;
    }
  }
  return any;
}

bool Shrinker::thin_out() {
  bool any = false;
  for (int k = 0; k < static_cast<int>(scene_.cords.size()); ++k) {
    for (const bool front : {false, true}) {
      for (int columns = scene_.cords[slot(k)].def.points / 2; columns >= 1;) {
        if (attempt([&](Scene& s) { cut_cord(s, k, columns, front); })) {
          any = true;
          columns = std::min(columns, scene_.cords[slot(k)].def.points / 2);
        } else {
          columns /= 2;
        }
      }
    }
    while (attempt([&](Scene& s) { halve_points(s, k); })) any = true;
  }
  return any;
}

/// Rounds to fewer and fewer decimals: first all numbers of a kind, then one at a time.
bool Shrinker::round_numbers() {
  bool any = false;
  for (int k = 0; k < static_cast<int>(scene_.cords.size() + scene_.solids.size() + scene_.wheels.size()); ++k) {
    for (const double parts : {10.0, 100.0, 1e3, 1e4, 1e6}) {
      const auto edit = [&](Scene& s) {
        const std::size_t cords = s.cords.size();
        if (slot(k) < cords) {
          round_cord(s.cords[slot(k)], parts);
        } else if (slot(k) < cords + s.solids.size()) {
          round_solid(s.solids[slot(k) - cords], parts);
        } else {
          round_wheel(s.wheels[slot(k) - cords - s.solids.size()], parts);
        }
        hold_again(s);
        drop_misfits(s);
      };
      if (!attempt(edit)) continue;
      any = true;
      break;
    }
  }
  return any;
}

}  // namespace

const std::vector<Limit>& limits() {
  static const std::vector<Limit> all = {
      {"end", 0.0, ends},
      {"crossings", 0.0, [](const Summary& run) { return static_cast<double>(all_crossings(run)); }},
      {"inverted", 0.0, [](const Summary& run) { return static_cast<double>(run.inverted); }},
      {"unconverged", 0.0, [](const Summary& run) { return static_cast<double>(run.unconverged); }},
      {"stretch", 0.01, [](const Summary& run) { return run.stretch; }},
      {"late stretch", 0.01, [](const Summary& run) { return run.late_stretch; }},
      {"hanging", 10.0, [](const Summary& run) { return static_cast<double>(run.hanging); }},
      {"gap", 0.01, [](const Summary& run) { return run.gap; }},
      {"rise", 0.02, [](const Summary& run) { return run.rise; }},
      {"work", 100.0, [](const Summary& run) { return static_cast<double>(run.max_work); }},
      {"depth", 1.0, [](const Summary& run) { return run.penetration; }},
  };
  return all;
}

const Limit* first_exceeded(const Summary& run) {
  const auto found = std::find_if(limits().begin(), limits().end(),
                                  [&](const Limit& limit) { return !(limit.value(run) <= limit.most); });
  return found == limits().end() ? nullptr : &*found;
}

bool starts_clear(const Scene& scene) {
  try {
    const World world(scene);
    return Oracles(scene).overlap(world.snapshot()) <= touching && world.grip_gaps().free <= touching &&
           lengths(world).stretch <= stretched;
  } catch (const ribbon::DefinitionError&) {
    return false;
  }
}

Scene shrink(const Scene& scene, const Fails& fails) {
  Shrinker shrinker(scene, fails);
  constexpr int most_rounds = 6;
  for (int round = 0; round < most_rounds; ++round) {
    shrinker.end_sooner();
    bool any = shrinker.drop_parts();
    any = shrinker.drop_terms() || any;
    any = shrinker.thin_out() || any;
    any = shrinker.round_numbers() || any;
    if (!any) break;
  }
  return shrinker.scene();
}

}  // namespace any_scene

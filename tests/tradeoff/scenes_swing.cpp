#include <array>
#include <cmath>
#include <map>

#include "tests/study/figures.h"
#include "tests/support/constants.h"
#include "tests/support/exact_chain.h"
#include "tests/support/heavy_swing.h"
#include "tests/tradeoff/scene_lists.h"
#include "tests/tradeoff/swing_box2d.h"
#include "tests/tradeoff/swing_cords.h"
#include "tests/tradeoff/swing_held.h"

namespace tradeoff {
namespace {

using constants::infinity;
using ribbon::Accuracy;
using ribbon::Integrator;
using ribbon::Vec2;
using study::unavailable;
using test_support::Box2dChain;
constexpr int swing_points = test_support::heavy::links + 1;

const std::vector<Vec2>& exact_load() {
  static const std::vector<Vec2> path = test_support::exact_heavy_load();
  return path;
}

/// Returns the path of the load: of an elastic cord with 512 substeps, converged to 0.1 mm; of an inextensible cord by
/// the exact chain.
const std::vector<Vec2>& converged_load(double stiffness) {
  if (stiffness == infinity) return exact_load();
  static std::map<double, std::vector<Vec2>> known;
  const auto found = known.find(stiffness);
  if (found != known.end()) return found->second;
  return known[stiffness] = test_support::run_heavy_swing(stiffness, {Integrator::tr_bdf2, 512, 8, 1e-9}).load;
}

/// The results by the scene's columns. Every baseline converges to the inextensible chain (apart from single
/// precision), so the error relative to the own converged motion is given only for our elastic cords.
std::vector<double> figures_of(Swing& swing, double own_stiffness) {
  const SwingFigures run_figures = run(swing);
  const double own = std::isnan(own_stiffness)
                         ? unavailable
                         : test_support::rms_distance(run_figures.load, converged_load(own_stiffness));
  return {test_support::rms_distance(run_figures.load, exact_load()), 100.0 * run_figures.max_stretch,
          100.0 * run_figures.energy_drift, run_figures.unconverged ? *run_figures.unconverged : unavailable, own};
}

Variant variant(const char* method, std::string setting, std::shared_ptr<Swing> swing, int point_count = swing_points,
                double own_stiffness = unavailable) {
  std::function<std::int64_t()> work;
  if (swing->work()) work = [swing] { return *swing->work(); };
  return {method,
          std::move(setting),
          point_count,
          [swing] { swing->reset(); },
          [swing] { swing->tick(); },
          [swing, own_stiffness] { return figures_of(*swing, own_stiffness); },
          {},
          {},
          work};
}

std::string setting_of(double stiffness, const Accuracy& accuracy) {
  return std::string(accuracy.integrator == Integrator::tr_bdf2 ? "tr_bdf2" : "implicit_euler") +
         " EA=" + number(stiffness) + " substeps=" + std::to_string(accuracy.substeps) +
         " tolerance=" + number(accuracy.tolerance);
}

Variant cord(const std::string& name, double stiffness, const Accuracy& accuracy) {
  return variant("cord", name.empty() ? setting_of(stiffness, accuracy) : name, cord_swing(stiffness, accuracy),
                 swing_points, stiffness);
}

void add_presets(std::vector<Variant>& list) {
  list.push_back(cord("fast", infinity, Accuracy::fast()));
  list.push_back(cord("balanced", infinity, Accuracy::balanced()));
  list.push_back(cord("accurate", infinity, Accuracy::accurate()));
}

/// `balanced` with one parameter changed at a time, and substeps for every stiffness. The row without a change shows
/// the repeatability of times.
void add_parameter_sweep(std::vector<Variant>& list) {
  for (const double stiffness : {infinity, 1e8, 1e7}) {
    for (const int substeps : {1, 2, 4, 8}) {
      Accuracy accuracy = Accuracy::balanced();
      accuracy.substeps = substeps;
      list.push_back(cord("", stiffness, accuracy));
    }
  }
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
    Accuracy accuracy = Accuracy::balanced();
    accuracy.tolerance = tolerance;
    list.push_back(cord("", infinity, accuracy));
  }
  for (const int substeps : {1, 4, 16, 64}) {
    Accuracy accuracy = Accuracy::balanced();
    accuracy.integrator = Integrator::implicit_euler;
    accuracy.substeps = substeps;
    list.push_back(cord("", infinity, accuracy));
  }
}

void add_chain(std::vector<Variant>& list, const char* method, Box2dChain::Limit limit, const Box2dSetting& setting) {
  list.push_back(variant(method,
                         "substeps=" + std::to_string(setting.substeps) +
                             " iterations=" + std::to_string(setting.velocity_iterations) + "/" +
                             std::to_string(setting.position_iterations),
                         box2d_chain(limit, setting)));
}

/// More iterations in Box2D's ratio of 8 to 3.
void add_chains(std::vector<Variant>& list) {
  for (const int substeps : {1, 4, 16, 64}) add_chain(list, "box2d_chain", Box2dChain::Limit::none, {substeps, 8, 3});
  for (const int substeps : {1, 4}) add_chain(list, "box2d_chain", Box2dChain::Limit::none, {substeps, 128, 48});
  add_chain(list, "box2d_chain", Box2dChain::Limit::none, {64, 32, 12});
  for (const int substeps : {1, 4, 16, 64}) {
    add_chain(list, "box2d_max_distance", Box2dChain::Limit::max_distance, {substeps, 8, 3});
  }
}

struct RopeSetting {
  b2StretchingModel model;
  float hertz;  // of XPBD alone
  int substeps;
  int iterations;
};

/// The best settings at each cost. XPBD is best at 1 to 2 kHz; damping, or the load as the first point, has no
/// advantage. With more substeps all are worse, because single precision rounds away the motion of a point in a
/// substep.
constexpr std::array<RopeSetting, 13> rope_settings = {{
    {b2_pbdStretchingModel, 0.0F, 1, 50},
    {b2_pbdStretchingModel, 0.0F, 16, 1},
    {b2_pbdStretchingModel, 0.0F, 16, 8},
    {b2_pbdStretchingModel, 0.0F, 50, 1},
    {b2_pbdStretchingModel, 0.0F, 64, 1},
    {b2_xpbdStretchingModel, 1000.0F, 1, 50},
    {b2_xpbdStretchingModel, 1000.0F, 16, 8},
    {b2_xpbdStretchingModel, 1000.0F, 16, 50},
    {b2_xpbdStretchingModel, 1000.0F, 50, 1},
    {b2_xpbdStretchingModel, 1000.0F, 64, 1},
    {b2_xpbdStretchingModel, 2000.0F, 16, 8},
    {b2_xpbdStretchingModel, 2000.0F, 50, 1},
    {b2_xpbdStretchingModel, 2000.0F, 64, 1},
}};

void add_ropes(std::vector<Variant>& list) {
  for (const RopeSetting& setting : rope_settings) {
    const bool xpbd = setting.model == b2_xpbdStretchingModel;
    list.push_back(variant(
        xpbd ? "b2rope_xpbd" : "b2rope_pbd",
        "substeps=" + std::to_string(setting.substeps) + " iterations=" + std::to_string(setting.iterations) +
            (xpbd ? " hertz=" + number(static_cast<double>(setting.hertz)) : ""),
        box2d_rope(test_support::without_bending(setting.model, setting.hertz), setting.substeps, setting.iterations)));
  }
}

void add_thesis(std::vector<Variant>& list) {
  for (const int substeps : {8, 32, 128}) {
    list.push_back(variant("thesis", "substeps=" + std::to_string(substeps), thesis_swing(substeps), 2 * swing_points));
  }
}

std::vector<Variant> heavy_swing() {
  std::vector<Variant> list;
  add_presets(list);
  add_parameter_sweep(list);
  add_chains(list);
  add_ropes(list);
  add_thesis(list);
  return list;
}

/// The load is a body of Box2D that holds the cord; beside the same cord with a point mass, and the world alone, which
/// has no path to compare. The load of the chains and of the thesis's cord is always a body.
std::vector<Variant> held_swings() {
  std::vector<Variant> list;
  const std::shared_ptr<Swing> alone = falling_body();
  for (const auto& [name, accuracy] :
       {std::pair{"fast", Accuracy::fast()}, {"balanced", Accuracy::balanced()}, {"accurate", Accuracy::accurate()}}) {
    list.push_back(cord(name, infinity, accuracy));
    list.push_back(variant("held", name, held_swing(accuracy)));
  }
  list.push_back({"b2world_step", "one body", 1, [alone] { alone->reset(); }, [alone] { alone->tick(); },
                  [] { return std::vector<double>(4, unavailable); }});
  add_chains(list);
  add_thesis(list);
  return list;
}

}  // namespace

std::vector<Scene> swing_scenes() {
  const std::vector<Column> columns = {us_per_tick(),
                                       p99_us(),
                                       figure("rms_error_m", 0),
                                       figure("max_stretch_pct", 1),
                                       figure("energy_drift_pct", 2),
                                       figure("unconverged", 3)};
  std::vector<Column> with_own = columns;
  with_own.push_back(figure("own_error_m", 4));
  return {
      {"heavy_swing",
       "51 points of 1 kg and a load of 70 kg, released from the horizontal: cords, Box2D's, the thesis's",
       test_support::heavy::ticks, heavy_swing, with_own, "balanced"},
      {"held_swing",
       "the same with the load a body of Box2D's that the cord carries, and the cost of b2World::Step alone",
       test_support::heavy::ticks,
       held_swings,
       columns,
       "balanced",
       {"`cord` carries a point mass in place of the body. The load of Box2D's chains and of the thesis's cord is a "
        "body in any case: they are those of heavy_swing. b2Rope holds no body, and is not included."}}};
}

}  // namespace tradeoff

#include "tests/peers/variants.h"

#include <algorithm>

#include "ribbon/box2d/coupling.h"
#include "ribbon/version.h"
#include "tests/study/text.h"

namespace peers {
namespace {

using test_support::CordMethod;

constexpr const char* box2d_name = "Box2D 2.4";
constexpr const char* chipmunk_name = "Chipmunk";

std::string words_of(const Parameters& parameters) {
  std::string words;
  for (const Parameter& parameter : parameters) {
    if (parameter.name == "joints") continue;  // part of the engine's name
    words += (words.empty() ? "" : " ") + parameter.name + "=" + study::significant(parameter.value, 6);
  }
  return words;
}

constexpr int many_points = 4000;
constexpr double highest_of_many = 4.0;

bool is_affordable(const Parameters& parameters, const Plan& plan) {
  return points_of(plan) < many_points ||
         std::all_of(parameters.begin(), parameters.end(), [](const Parameter& parameter) {
           return parameter.value <= highest_of_many || parameter.name == "hertz";
         });
}

struct NodeEngine {
  const char* name;
  const char* module;  ///< in tests/peers/run_plan.mjs
  const char* kind;
  std::vector<Parameters> settings;
  bool runs_ropes = true;
  bool runs_ribbons = false;
};

Parameters with(Parameters parameters, const std::string& name, double value) {
  parameters.push_back({name, value});
  return parameters;
}

/// Returns settings with several numbers of substeps, and with more iterations at the last.
std::vector<Parameters> by_substeps(const Parameters& always, double more_iterations) {
  std::vector<Parameters> list;
  for (const double substeps : {1.0, 4.0, 16.0, 64.0}) list.push_back(with(always, "substeps", substeps));
  if (more_iterations > 0.0) list.push_back(with(list.back(), "iterations", more_iterations));
  return list;
}

std::vector<Parameters> by_iterations(const Parameters& always) {
  std::vector<Parameters> list;
  for (const double iterations : {4.0, 16.0, 64.0}) list.push_back(with(always, "iterations", iterations));
  list.push_back(with(with(always, "substeps", 16.0), "iterations", 4.0));
  return list;
}

const std::vector<NodeEngine>& node_engines() {
  static const std::vector<Parameters> soft_ropes = [] {
    std::vector<Parameters> list;
    for (const double substeps : {1.0, 4.0, 16.0}) {
      for (const double hertz : {60.0, 1000.0}) {
        list.push_back(with({{"joints", 0.0}, {"substeps", substeps}}, "hertz", hertz));
      }
    }
    return list;
  }();
  static const std::vector<Parameters> multibodies = {{{"joints", 2.0}, {"iterations", 4.0}},
                                                      {{"joints", 2.0}, {"iterations", 16.0}}};
  static const std::vector<Parameters> box2d3 = {
      {{"substeps", 4.0}}, {{"substeps", 16.0}}, {{"substeps", 64.0}}, {{"substeps", 256.0}}};
  static const std::vector<NodeEngine> list = {
      {"Box2D 3", "box2d3", "WebAssembly", box2d3},
      {"Rapier impulse joints", "rapier", "WebAssembly", by_iterations({{"joints", 1.0}})},
      {"Rapier multibody", "rapier", "WebAssembly", multibodies},
      {"Rapier soft rope", "rapier", "WebAssembly", soft_ropes},
      {"Rapier soft ribbon", "rapier", "WebAssembly", by_substeps({{"joints", 0.0}}, 0.0), false, true},
      {"Rapier SIMD impulse joints", "rapier_simd", "WebAssembly", by_iterations({{"joints", 1.0}})},
      {"Rapier SIMD multibody", "rapier_simd", "WebAssembly", multibodies},
      {"Planck", "planck", "JavaScript", by_substeps({}, 32.0)},
      {"Matter.js", "matter", "JavaScript", by_substeps({}, 32.0)},
  };
  return list;
}

std::vector<Variant> ours(bool ribbons) {
  std::vector<Variant> list;
  const auto add = [&](const char* setting, const ribbon::Accuracy& accuracy) {
    CordMethod how;
    how.accuracy = accuracy;
    list.push_back({our_name, setting,
                    [how](const Scene& scene, const Plan& plan) { return run_coupled(scene.set_up, plan, how); }});
  };
  add("balanced", ribbon::Accuracy::balanced());
  add("fast", ribbon::Accuracy::fast());
  if (!ribbons) add("accurate", ribbon::Accuracy::accurate());
  return list;
}

std::vector<Variant> box2d_chains(const Plan& plan) {
  std::vector<Variant> list;
  for (const int substeps : {1, 4, 16, 64}) {
    const Parameters parameters = {{"substeps", static_cast<double>(substeps)}};
    if (!is_affordable(parameters, plan)) continue;
    CordMethod how;
    how.chain = true;
    how.substeps = substeps;
    list.push_back({box2d_name, words_of(parameters),
                    [how](const Scene& scene, const Plan& known) { return run_coupled(scene.set_up, known, how); }});
  }
  return list;
}

}  // namespace

std::vector<Engine> engines(const NodeRunner& node) {
  const b2Version box2d = b2_version;
  std::vector<Engine> list = {
      {our_name, RIBBON_VERSION, "native"},
      {box2d_name,
       std::to_string(box2d.major) + "." + std::to_string(box2d.minor) + "." + std::to_string(box2d.revision),
       "native"},
      {chipmunk_name, chipmunk_version(), "native"}};
  for (const NodeEngine& engine : node_engines()) {
    list.push_back({engine.name, node.version(engine.module), engine.kind});
  }
  return list;
}

std::vector<Variant> variants(const Scene& scene, const NodeRunner& node, bool quick) {
  const Plan plan = plan_of(scene.set_up, 0, 0);
  const bool ribbons = plan.cords.front().def.rows > 1;
  std::vector<Variant> list = ours(ribbons);
  const auto add = [&](std::vector<Variant> more) {
    if (quick) more.resize(std::min<std::size_t>(more.size(), 1));
    list.insert(list.end(), more.begin(), more.end());
  };
  if (quick) list.resize(1);
  if (!ribbons) {
    add(box2d_chains(plan));
    std::vector<Variant> chipmunk;
    for (const Parameters& parameters : by_substeps({}, 40.0)) {
      if (!is_affordable(parameters, plan)) continue;
      chipmunk.push_back({chipmunk_name, words_of(parameters),
                          [parameters](const Scene&, const Plan& known) { return run_chipmunk(known, parameters); }});
    }
    add(chipmunk);
  }
  for (const NodeEngine& engine : node_engines()) {
    if (!(ribbons ? engine.runs_ribbons : engine.runs_ropes)) continue;
    std::vector<Variant> settings;
    for (const Parameters& parameters : engine.settings) {
      if (!is_affordable(parameters, plan)) continue;
      settings.push_back(
          {engine.name, words_of(parameters), [&node, &engine, parameters](const Scene&, const Plan& known) {
             return node.run(engine.module, known, parameters);
           }});
    }
    add(settings);
  }
  return list;
}

}  // namespace peers

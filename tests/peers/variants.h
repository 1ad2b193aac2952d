#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/peers/runners.h"
#include "tests/peers/scenes.h"

namespace peers {

/// An engine with a setting.
struct Variant {
  std::string engine;   ///< ours, Box2D 2.4, Rapier
  std::string setting;  ///< balanced, substeps=16
  std::function<Recording(const Scene&, const Plan&)> run;
};

/// The description of an engine, for the page.
struct Engine {
  std::string name;
  std::string version;
  std::string kind;  ///< native, WebAssembly, JavaScript
};

/// Returns all engines, with the versions of their packages.
std::vector<Engine> engines(const NodeRunner& node);

/// Returns all engines that can run a scene; ours first. `quick` leaves one setting of each engine. A large scene has
/// no settings with parameters above 4, which would take minutes each.
std::vector<Variant> variants(const Scene& scene, const NodeRunner& node, bool quick);

/// The engine whose cost is the reference.
inline constexpr const char* our_name = "ours";
inline constexpr const char* compared_setting = "balanced";

}  // namespace peers

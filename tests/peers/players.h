#pragma once

#include <string>
#include <vector>

#include "tests/peers/plan.h"
#include "tests/peers/recording.h"
#include "tests/support/coupled_world.h"

// The engines. Each one plays a scene and records it.

namespace peers {

/// A parameter of an engine by name, such as substeps=4; the engine's player knows the names.
struct Parameter {
  std::string name;
  double value = 0.0;
};
using Parameters = std::vector<Parameter>;
/// Returns the parameter with that name, or `fallback`.
double parameter_or(const Parameters& parameters, const std::string& name, double fallback);

/// Plays with our cords, or with Box2D 2.4's joints.
Recording play_coupled(const SetUp& set_up, const Plan& plan, const test_support::CordMethod& method);

/// Plays with Chipmunk's pivot joints between segments. Parameters: substeps (1) and iterations (10).
Recording play_chipmunk(const Plan& plan, const Parameters& parameters);
/// Returns "7.0.3" or the like.
std::string chipmunk_version();

/// Runs another program, tests/peers/play.mjs, which reads a plan and writes a recording.
class NodePlayer {
 public:
  /// `folder` exists and receives scratch files.
  NodePlayer(std::string script, std::string folder) : script_(std::move(script)), folder_(std::move(folder)) {}

  /// Throws std::runtime_error with the program's error message if it fails or takes more than ten minutes.
  Recording play(const std::string& engine, const Plan& plan, const Parameters& parameters) const;
  std::string version(const std::string& engine) const;

 private:
  void run(const std::string& arguments) const;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  std::string script_;
  std::string folder_;
};

}  // namespace peers

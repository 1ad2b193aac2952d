#pragma once

#include <string>
#include <vector>

#include "tests/peers/plan.h"
#include "tests/peers/recording.h"
#include "tests/support/coupled_world.h"

// The engines. Each one runs a scene and records it.

namespace peers {

/// A parameter of an engine by name, such as substeps=4; the names are those of its runner.
struct Parameter {
  std::string name;
  double value = 0.0;
};
using Parameters = std::vector<Parameter>;
/// Returns the parameter with that name, or `fallback`.
double parameter_or(const Parameters& parameters, const std::string& name, double fallback);

/// Runs with our cords, or with Box2D 2.4's joints.
Recording run_coupled(const SetUp& set_up, const Plan& plan, const test_support::CordMethod& method);

/// Runs with Chipmunk's pivot joints between segments. Parameters: substeps (1) and iterations (10).
Recording run_chipmunk(const Plan& plan, const Parameters& parameters);
/// Returns "7.0.3" or the like.
std::string chipmunk_version();

/// Runs another program, tests/peers/run_plan.mjs, which reads a plan and writes a recording.
class NodeRunner {
 public:
  /// `folder` exists and receives scratch files.
  NodeRunner(std::string script, std::string folder) : script_(std::move(script)), folder_(std::move(folder)) {}

  /// Throws std::runtime_error with the program's error message if it fails or takes more than ten minutes.
  Recording run(const std::string& engine, const Plan& plan, const Parameters& parameters) const;
  std::string version(const std::string& engine) const;

 private:
  void start_node(const std::string& arguments) const;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  std::string script_;
  std::string folder_;
};

}  // namespace peers

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/peers/runners.h"
#include "tests/study/text.h"

namespace peers {
namespace {

/// Returns the error message of Node: the first line that contains "Error", or else the last line.
std::string fault_of(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("Error") != std::string::npos) return line;
    if (!line.empty()) last = line;
  }
  return last;
}

std::string without_newline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

void NodeRunner::start_node(const std::string& arguments) const {
  const std::string log = path("node.log");
  const std::string command = "timeout 600 node '" + script_ + "' " + arguments + " > '" + log + "' 2>&1";
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error(fault_of(study::read_file(log)));
  }
}

Recording NodeRunner::run(const std::string& engine, const Plan& plan, const Parameters& parameters) const {
  std::ofstream(path("plan.json")) << to_json(plan);
  std::filesystem::remove(path("recording"));
  std::string settings;
  for (const Parameter& parameter : parameters)
    settings += " " + parameter.name + "=" + study::significant(parameter.value, 6);
  start_node(engine + " '" + path("plan.json") + "' '" + path("recording") + "'" + settings);
  return read_recording(path("recording"), plan);
}

std::string NodeRunner::version(const std::string& engine) const {
  start_node(engine + " --version");
  return without_newline(study::read_file(path("node.log")));
}

}  // namespace peers

#include "tests/study/results.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ribbon/box2d/state_hash.h"
#include "tests/study/text.h"
#include "tests/study/trace_file.h"

namespace study {
namespace {

using Json = nlohmann::ordered_json;

unsigned long long hash_of(const std::string& path) { return ribbon::box2d::hash_bytes(read_file(path)); }

Json json_of(const Errors& e) {
  return Json::array({e.position_m, e.position_relative, e.player_m, e.stretch, e.tension, e.penetration, e.energy,
                      e.momentum, e.body_m});
}

/// JSON writes null for NaN.
double number_or_unavailable(const Json& j) { return j.is_null() ? unavailable : j.get<double>(); }

Errors errors_of(const Json& j) {
  const auto at = [&j](std::size_t k) { return number_or_unavailable(j.at(k)); };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8)};
}

Json json_of(const Measured& m) {
  return {{"solver", m.setting.solver},
          {"integrator", m.setting.integrator},
          {"substeps", m.setting.substeps},
          {"tolerance", m.setting.tolerance},
          {"points", m.setting.points},
          {"max_iterations", m.setting.iterations},
          {"rows", m.setting.rows},
          {"max_work", m.setting.max_work},
          {"error", json_of(m.error)},
          {"mesh", json_of(m.mesh)},
          {"chaotic", m.chaotic.values},
          {"windows", {m.windows.position_m, m.windows.player_m, m.windows.body_m, m.windows_resolution_m}},
          {"tick_work", {m.tick_work.mean, m.tick_work.p99, m.tick_work.most}},
          {"others", {m.others.error_m, m.others.work.mean, m.others.work.p99, m.others.work.most}},
          {"others_failure", m.others.failure},
          {"spends_budget", {m.windows.spends_budget, m.others.spends_budget}},
          {"resolution", m.resolution_m},
          {"contacts", m.contacts},
          {"work", m.work.work},
          {"iterations", m.work.iterations},
          {"stages", m.work.stages},
          {"fallbacks", m.work.fallbacks},
          {"halvings", m.work.halvings},
          {"posed", m.work.posed},
          {"unconverged_ticks", m.unconverged_ticks},
          {"failure", m.failure}};
}

Measured measured_of(const Json& j) {
  Measured m;
  m.setting = {j.at("solver"), j.at("integrator"),     j.at("substeps"), j.at("tolerance"),
               j.at("points"), j.at("max_iterations"), j.at("rows"),     j.at("max_work")};
  m.error = errors_of(j.at("error"));
  m.mesh = errors_of(j.at("mesh"));
  for (std::size_t k = 0; k < Statistics::count; ++k)
    m.chaotic.values[k] = number_or_unavailable(j.at("chaotic").at(k));
  const auto windows = [&j](std::size_t k) { return number_or_unavailable(j.at("windows").at(k)); };
  m.windows = {windows(0), windows(1), windows(2), {}, j.at("spends_budget").at(0)};
  m.windows_resolution_m = windows(3);
  const auto work = [&j](std::size_t k) { return number_or_unavailable(j.at("tick_work").at(k)); };
  m.tick_work = {work(0), work(1), work(2)};
  const auto others = [&j](std::size_t k) { return number_or_unavailable(j.at("others").at(k)); };
  m.others = {others(0), {others(1), others(2), others(3)}, j.at("others_failure"), j.at("spends_budget").at(1)};
  m.resolution_m = j.at("resolution");
  m.contacts = j.at("contacts");
  m.work.work = j.at("work");
  m.work.iterations = j.at("iterations");
  m.work.stages = j.at("stages");
  m.work.fallbacks = j.at("fallbacks");
  m.work.halvings = j.at("halvings");
  m.work.posed = j.at("posed");
  m.unconverged_ticks = j.at("unconverged_ticks");
  m.failure = j.at("failure");
  return m;
}

[[noreturn]] void refuse(const std::string& path) {
  throw std::runtime_error("cannot write to " + path +
                           "; accepted is a folder that can be written, with space (--out)");
}

}  // namespace

Results::Results(const std::string& folder, std::uint64_t level_hash, const std::string& replay_path, bool quick)
    : folder_(folder) {
  if (folder.empty()) return;
  std::array<char, 64> key{};
  std::snprintf(key.data(), key.size(), "%016llx-%016llx-%016llx", static_cast<unsigned long long>(level_hash),
                hash_of(replay_path), hash_of("/proc/self/exe"));
  key_ = key.data();
  level_ = key_.substr(0, key_.rfind('-'));
  key_ += quick ? "-quick" : "";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string path = folder + "/results.jsonl";
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const Json json = Json::parse(line, nullptr, false);  // the last line may be incomplete
    if (json.is_object() && json.value("key", "") == key_) known_.push_back(measured_of(json.at("measured")));
  }
  out_.open(path, std::ios::app);
  if (!out_) refuse(path);
}

const Measured* Results::find(const Setting& setting) const {
  const auto found =
      std::find_if(known_.begin(), known_.end(), [&](const Measured& m) { return m.setting == setting; });
  return found == known_.end() ? nullptr : &*found;
}

void Results::add(const Measured& measured) {
  if (!out_.is_open()) return;
  out_ << Json{{"key", key_}, {"measured", json_of(measured)}}.dump() << std::endl;
  if (!out_) refuse(folder_ + "/results.jsonl");
}

std::string Results::path_of_run(const std::string& name) const {
  std::string file = name;
  std::replace(file.begin(), file.end(), ' ', '_');
  std::replace(file.begin(), file.end(), '/', '_');
  return folder_ + "/" + level_ + "_" + file + ".run";
}

std::optional<Trace> Results::run(const std::string& name) const {
  if (folder_.empty()) return {};
  return load_trace(key_ + " " + name, path_of_run(name));
}

void Results::add_run(const std::string& name, const Trace& trace) {
  if (folder_.empty()) return;
  const std::string path = path_of_run(name);
  if (!save_trace(trace, key_ + " " + name, path)) refuse(path);
}

}  // namespace study

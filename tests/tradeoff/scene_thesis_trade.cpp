#include <array>
#include <cmath>
#include <memory>
#include <span>

#include "ribbon/cord.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::ThesisCord;
using ribbon::ThesisDef;
using ribbon::Vec2;
using test_support::earth_gravity;
using test_support::frame_dt;
using test_support::ThesisCondition;

constexpr int trade_ticks = 120;
constexpr int converged_substeps = 1024;

using Path = std::vector<std::vector<Vec2>>;  // by tick and point

/// A cord that is held by its first column and released from the horizontal.
ThesisDef thesis_swing(const ThesisCondition& condition, int substeps) {
  ThesisDef def = test_support::thesis_def(condition);
  def.substeps = substeps;
  def.self_collision = false;
  for (int j = 0; j < def.h; ++j) def.pins.push_back(j);
  return def;
}

/// The same ribbon of the direct solver, with the same mass and the springs' stiffness along its rows.
CordDef cord_swing(const ThesisCondition& condition, const Accuracy& accuracy) {
  const ThesisDef thesis = thesis_swing(condition, condition.substeps);
  CordDef def;
  def.points = thesis.w;
  def.rows = thesis.h;
  def.length = thesis.spacing * (thesis.w - 1);
  def.width = thesis.spacing * (thesis.h - 1);
  def.mass_per_length = thesis.point_mass * thesis.w * thesis.h / def.length;
  def.stretch_stiffness = thesis.spring_stiffness * thesis.spacing * thesis.h;
  def.bending_stiffness = def.stretch_stiffness * def.width * def.width / 12.0;
  def.drag = thesis.drag;
  def.accuracy = accuracy;
  for (int j = 0; j < def.rows; ++j) def.pins.push_back(j);
  return def;
}

template <typename Method>
Path path_of(Method& method) {
  Path path;
  for (int k = 0; k < trade_ticks; ++k) {
    method.step(frame_dt, earth_gravity);
    path.emplace_back(method.positions().begin(), method.positions().end());
  }
  return path;
}

double rms(const Path& a, const Path& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t p = 0; p < a[k].size(); ++p) sum += dot(a[k][p] - b[k][p], a[k][p] - b[k][p]);
  }
  return std::sqrt(sum / static_cast<double>(a.size() * a[0].size()));
}

/// Returns the motion of a method's finest setting; computed in the first call.
using Converged = std::function<const Path&()>;

template <typename Method>
Converged converged(Method finest) {
  const auto fine = std::make_shared<Method>(std::move(finest));
  const auto path = std::make_shared<Path>();
  return [fine, path]() -> const Path& {
    if (path->empty()) *path = path_of(*fine);
    return *path;
  };
}

template <typename Method>
Variant variant(const char* name, const std::string& setting, const ThesisCondition& condition,
                const std::shared_ptr<Method>& method, const Converged& converged) {
  const auto start = std::make_shared<typename Method::State>(method->save());
  return {name,
          setting,
          static_cast<int>(method->positions().size()),
          [method, start] { method->restore(*start); },
          [method] { method->step(frame_dt, earth_gravity); },
          [method, start, converged] {
            method->restore(*start);
            return std::vector<double>{rms(path_of(*method), converged())};
          },
          {},
          std::string(condition.name)};
}

Variant cord_variant(const std::string& setting, const ThesisCondition& condition, const Accuracy& accuracy,
                     const Converged& converged) {
  const auto cord = std::make_shared<Cord>(cord_swing(condition, accuracy));
  const auto work = std::make_shared<std::int64_t>();
  Variant out = variant("cord", setting, condition, cord, converged);
  out.tick = [cord, work] { *work = cord->step(frame_dt, earth_gravity).work; };
  out.work = [work] { return *work; };
  return out;
}

void add_thesis(std::vector<Variant>& list, const ThesisCondition& condition) {
  const Converged fine = converged(ThesisCord(thesis_swing(condition, converged_substeps)));
  for (const int substeps : {1, 2, 4, 8, 16, 32, 64}) {
    list.push_back(variant("thesis", "iterations=" + std::to_string(substeps), condition,
                           std::make_shared<ThesisCord>(thesis_swing(condition, substeps)), fine));
  }
}

void add_cord(std::vector<Variant>& list, const ThesisCondition& condition) {
  Accuracy accuracy;
  accuracy.tolerance = 1e-8;
  accuracy.substeps = 256;
  const Converged fine = converged(Cord(cord_swing(condition, accuracy)));
  for (const auto& [setting, preset] :
       {std::pair{"fast", Accuracy::fast()}, {"balanced", Accuracy::balanced()}, {"accurate", Accuracy::accurate()}}) {
    list.push_back(cord_variant(setting, condition, preset, fine));
  }
}

/// D is C with another number of iterations.
std::vector<Variant> thesis_trade_variants() {
  std::vector<Variant> list;
  for (const ThesisCondition& condition : std::span(test_support::thesis_conditions).first(3)) {
    add_thesis(list, condition);
    add_cord(list, condition);
  }
  return list;
}

}  // namespace

Scene thesis_trade_scene() {
  return {"thesis_trade",
          "the thesis's conditions A to C (D is C) let go from the horizontal, 1 to 64 iterations, and cords as heavy "
          "and stiff; each against its own converged motion",
          trade_ticks,
          thesis_trade_variants,
          {us_per_tick(), p99_us(), frames_per_second(), figure("rms_error_m", 0)}};
}

}  // namespace tradeoff

#include "game/tuning/tuning_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/window/sdl_canvas.h"
#include "game/tuning/parameters.h"
#include "game/tuning/tables.h"
#include "game/words/panel_words.h"
#include "game/words/words.h"

namespace game {
namespace {

/// Adds a slider. Returns true when it was moved.
bool slide(const char* label, double& value, double min, double max, bool logarithmic) {
  const ImGuiSliderFlags flags = logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &min, &max, "%.4g", flags);
}

std::string title_of(const engine::Scene& scene, const Level& level, ribbon::box2d::CordId cord) {
  const engine::MapObject* object = level.map.find(scene.cord_object(cord));
  const std::string name = object == nullptr || object->name.empty() ? "" : ": " + object->name;
  return words::filled(words::panel::cord,
                       {{"number", std::to_string(cord)},
                        {"name", name},
                        {"solver", ribbon::box2d::solver_name(scene.coupling().cord(cord).solver())}});
}

}  // namespace

TuningPanel::TuningPanel() : panel_(engine::HeadlessCanvas::default_font()) {}

bool TuningPanel::takes_restart() { return std::exchange(wants_restart_, false); }

const Preset* TuningPanel::takes_comparison() { return std::exchange(compared_, nullptr); }

engine::WindowInput TuningPanel::update(const engine::WindowInput& input, const engine::Canvas& canvas, double scale,
                                        double seconds, RecordedRun& run, const Meter& meter, const FrameTimes& times) {
  if (!is_shown_) return input;
  panel_.begin(input, canvas.width(), canvas.height(), scale, seconds);
  show(run, meter, times, scale);
  panel_.end();
  apply_change(run);
  return without_captured(panel_, input);
}

void TuningPanel::draw(engine::Canvas& canvas) const {
  if (is_shown_) panel_.draw(canvas);
}

void TuningPanel::show(const RecordedRun& run, const Meter& meter, const FrameTimes& times, double scale) {
  const auto unit = static_cast<float>(scale);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x - 12.0F * unit, 12.0F * unit}, ImGuiCond_FirstUseEver, {1.0F, 0.0F});
  ImGui::SetNextWindowSize({430.0F * unit, std::max(200.0F * unit, screen.y - 24.0F * unit)}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin(words::panel::title, &is_shown_)) {
    show_tables(run.simulation(), meter, times);
    show_last_seconds(run);
    ImGui::Separator();
    ImGui::PushItemWidth(-13.0F * ImGui::GetFontSize());  // space for the names
    if (run.has_replay()) {
      ImGui::TextWrapped(words::panel::replay);
    } else {
      show_file(run);
      show_world(run);
      show_player(run);
      const engine::Scene& scene = run.simulation().scene();
      for (const ribbon::box2d::CordId cord : scene.coupling().cords()) {
        const std::string title = title_of(scene, run.level(), cord);
        ImGui::PushID(cord);
        if (ImGui::CollapsingHeader(title.c_str())) show_cord(scene, cord);
        ImGui::PopID();
      }
    }
    ImGui::PopItemWidth();
  }
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  place_ = {{static_cast<double>(corner.x), static_cast<double>(corner.y)},
            {static_cast<double>(size.x), static_cast<double>(size.y)}};
  ImGui::End();
}

void TuningPanel::show_last_seconds(const RecordedRun& run) {
  ImGui::TextUnformatted(words::panel::last_seconds);
  ImGui::BeginDisabled(!run.can_be_repeated());
  for (const Preset& preset : presets()) {
    ImGui::SameLine();
    if (ImGui::SmallButton(preset.name)) compared_ = &preset;
  }
  ImGui::EndDisabled();
  if (!run.can_be_repeated()) ImGui::TextWrapped(words::panel::not_repeated);
}

void TuningPanel::show_file(const RecordedRun& run) {
  if (run.is_tuned()) ImGui::TextColored({1.0F, 0.83F, 0.36F, 1.0F}, words::panel::changed);
  if (ImGui::Button(words::panel::restart)) wants_restart_ = true;
  const bool is_changed = tuned_ && tuned_->is_changed();
  ImGui::BeginDisabled(!is_changed);
  ImGui::SameLine();
  if (ImGui::Button(words::panel::reset)) wants_file_ = true;
  ImGui::SameLine();
  if (ImGui::Button(words::panel::write)) ImGui::OpenPopup(words::panel::ask_overwrite);
  ImGui::EndDisabled();
  if (ImGui::BeginPopupModal(words::panel::ask_overwrite, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::Text(words::panel::will_overwrite, run.level().map.file.c_str());
    if (ImGui::Button(words::panel::overwrite)) {
      write();
      ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button(words::panel::cancel)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  if (!message_.empty()) ImGui::TextWrapped("%s", message_.c_str());
}

void TuningPanel::show_world(const RecordedRun& run) {
  if (!ImGui::CollapsingHeader(words::panel::world)) return;
  const b2Vec2 gravity = run.simulation().scene().world().GetGravity();
  double value = std::round(1e4 * static_cast<double>(gravity.y)) / 1e4;  // removes the digits of single precision
  if (slide(words::panel::gravity, value, -30.0, 5.0, false)) change_ = Change{engine::map_itself, "gravity_y", value};
}

void TuningPanel::show_player(const RecordedRun& run) {
  if (!ImGui::CollapsingHeader(words::panel::player)) return;
  PlayerTuning tuning = run.simulation().player().tuning();
  bool moved = slide(words::panel::run_speed, tuning.run_speed, 1.0, 20.0, false);
  moved |= slide(words::panel::ground_gain, tuning.ground_acceleration, 1.0, 100.0, false);
  moved |= slide(words::panel::air_gain, tuning.air_acceleration, 0.0, 40.0, false);
  moved |= slide(words::panel::jump_speed, tuning.jump_speed, 1.0, 20.0, false);
  moved |= slide(words::panel::pump, tuning.pump_acceleration, 0.0, 20.0, false);
  moved |= slide(words::panel::reach, tuning.grab_range, 0.3, 3.0, false);
  moved |= slide(words::panel::climb_speed, tuning.climb_speed, 0.1, 10.0, false);
  moved |= slide(words::panel::hop_speed, tuning.hop_speed, 0.0, 10.0, false);
  if (moved) player_ = tuning;
}

void TuningPanel::show_cord(const engine::Scene& scene, ribbon::box2d::CordId cord) {
  const int object = scene.cord_object(cord);
  if (object == 0) {
    ImGui::TextWrapped(words::panel::own_line);
    return;
  }
  if (is_placed(object)) {
    ImGui::TextWrapped(words::panel::placed);
    return;
  }
  for (const Switch& option : switches_of(scene.coupling(), cord)) {
    bool on = option.value(scene.coupling(), cord);
    if (ImGui::Checkbox(option.property, &on)) change_ = Change{object, option.property, on};
  }
  if (scene.coupling().cord(cord).solver() == ribbon::box2d::Solver::direct) {
    constexpr std::array names = {"tr_bdf2", "implicit_euler"};
    int chosen = static_cast<int>(scene.coupling().cord(cord).direct().def().accuracy.integrator);
    if (ImGui::Combo(words::panel::integrator, &chosen, names.data(), static_cast<int>(names.size()))) {
      change_ = Change{object, "integrator", std::string(names[static_cast<std::size_t>(chosen)])};
    }
  }
  for (const Parameter& parameter : parameters_of(scene.coupling(), cord)) {
    show_parameter(parameter, parameter.value(scene.coupling(), cord), object);
  }
}

void TuningPanel::show_parameter(const Parameter& parameter, double value, int object) {
  const bool is_on = !parameter.is_term || (value != 0.0 && std::isfinite(value));
  ImGui::PushID(parameter.property);
  bool wanted = is_on;
  if (parameter.is_term) {
    if (ImGui::Checkbox("##on", &wanted)) {
      change_ = Change{object, parameter.property,
                       wanted ? engine::Properties::Value(parameter.on_value) : off_value(parameter)};
    }
    ImGui::SameLine();
  }
  std::string label = parameter.property;
  if (*parameter.unit != '\0') label.append(" [").append(parameter.unit).append("]");
  if (is_on && parameter.whole) {
    auto whole = static_cast<int>(value);
    if (ImGui::SliderInt(label.c_str(), &whole, static_cast<int>(parameter.min), static_cast<int>(parameter.max))) {
      change_ = Change{object, parameter.property, std::int64_t{whole}};
    }
  } else if (is_on) {
    if (slide(label.c_str(), value, parameter.min, parameter.max, parameter.logarithmic)) {
      change_ = Change{object, parameter.property, value};
    }
  } else {
    ImGui::TextDisabled(words::panel::is_off, parameter.property);
  }
  ImGui::PopID();
}

/// Applies the change of this frame. If it is not accepted, reports it and changes nothing.
void TuningPanel::apply_change(RecordedRun& run) {
  if (run.has_replay()) return;
  if (tuned_ && run.level().map.content_hash != tuned_->level().map.content_hash) tuned_.reset();  // reloaded
  try {
    if (std::exchange(wants_file_, false)) {
      tuned_.reset();
      player_.reset();
      Level level = load_level(run.level().map.file);
      set_yard(level, run.level().yard);
      run.set_level(std::move(level), false);
      wants_restart_ = true;
    }
    if (const auto change = std::exchange(change_, std::nullopt)) {
      message_.clear();
      if (!tuned_) tuned_.emplace(run.level());
      engine::Scene& scene = run.tune().scene();
      if (change->value) {
        tuned_->set(change->object, change->property, *change->value, scene);
      } else {
        tuned_->remove(change->object, change->property, scene);
      }
      Level level = tuned_->level();
      set_yard(level, run.level().yard);
      run.set_level(std::move(level), tuned_->is_changed());
    }
    if (player_) run.tune().player().set_tuning(*player_);  // in each frame, since a restart makes a new player
  } catch (const std::runtime_error& error) {
    message_ = error.what();
  }
}

void TuningPanel::write() {
  try {
    tuned_->write();
    message_ = words::panel::written;
  } catch (const std::runtime_error& error) {
    message_ = error.what();
  }
}

}  // namespace game

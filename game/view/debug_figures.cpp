#include "game/view/debug_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <utility>

#include "game/view/hud_style.h"
#include "game/words/words.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr double usual_size = 14.0;  // units of text
constexpr double min_size = 6.0;     // px, of the font

std::vector<std::string> in_words(std::initializer_list<int> counts) {
  std::vector<std::string> row;
  for (const int count : counts) row.push_back(std::to_string(count));
  return row;
}

int points_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  return static_cast<int>(coupling.cord(cord).positions().size());
}

std::vector<std::vector<std::string>> thesis_counts(const ribbon::box2d::Coupling& coupling) {
  std::vector<std::vector<std::string>> table = {{words::cord, words::points, words::self, words::circles,
                                                  words::tangled, words::fem_skipped, words::held_back,
                                                  words::strained}};
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::thesis) continue;
    const ribbon::StepReport& report = coupling.cord(c).thesis_report();
    const ribbon::StepReport& total = coupling.cord(c).thesis_total();
    table.push_back(in_words({c, points_of(coupling, c), report.self_contacts, report.circle_contacts,
                              report.tangled_columns, total.fem_skipped, total.motion_limited, report.strained_bars}));
  }
  return table;
}

/// Returns a number with two significant digits, or without decimals.
std::string significant(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}
std::string whole(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f", value);
  return text.data();
}

/// Returns a length in millimetres without the unit, with two significant digits below 1 cm.
std::string millimetres(double metres) { return metres < 1e-2 ? significant(1e3 * metres) : whole(1e3 * metres); }

/// Returns the cost of a tick and the budget of 1/60 s.
std::string cost_in_words(const Meter& meter) {
  return words::filled(words::tick_cost, {{"median", whole(meter.median_us())}, {"worst", whole(meter.worst_us())}});
}

std::vector<std::vector<std::string>> direct_counts(const ribbon::box2d::Coupling& coupling, const Meter* meter) {
  std::vector<std::vector<std::string>> table = {{words::cord, words::points, words::touches, words::iterations,
                                                  words::impacts, words::fallbacks, words::unconverged}};
  if (meter != nullptr) table.front().insert(table.front().end(), {words::peak_stretch, words::error_rate});
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::direct) continue;
    const ribbon::IslandReport& total = coupling.cord(c).island_total();
    const auto touches = static_cast<int>(coupling.cord(c).direct().touches().size());
    table.push_back(in_words({c, points_of(coupling, c), touches, coupling.cord(c).island_report().iterations,
                              total.impacts, total.fallbacks, total.unconverged}));
    if (coupling.cord(c).direct().is_asleep()) table.back()[3] = words::asleep;
    if (meter == nullptr) continue;
    table.back().push_back(words::filled(words::per_cent, {{"number", significant(100.0 * meter->peak_stretch(c))}}));
    table.back().push_back(millimetres(meter->error_per_second(c)));
  }
  return table;
}

}  // namespace

DebugFigures::DebugFigures(const Canvas& canvas, const Simulation& simulation, const Meter* meter, double text_scale,
                           Vec2 max_size)
    : legend_{words::legend_points, words::legend_tension},
      text_size_(usual_size * text_scale),
      margin_(usual_size * text_scale) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  if (meter != nullptr) legend_.push_back(cost_in_words(*meter));
  for (auto& table : std::array{thesis_counts(coupling), direct_counts(coupling, meter)}) {
    if (table.size() > 1) tables_.push_back(table);  // else it has titles only
  }
  measure(canvas);
  while (size_.x > max_size.x && text_size_ > min_size) {
    text_size_ = std::max(text_size_ - 0.5, min_size);
    measure(canvas);
  }
  shorten(max_size.y, canvas.line_height(text_size_));
  measure(canvas);
}

/// Leaves out the last rows of the longest table until all fits.
void DebugFigures::shorten(double max_height, double line_height) {
  std::size_t left_out = 0;
  const auto rows = [](const Table& a, const Table& b) { return a.size() < b.size(); };
  const double more_line = line_height;
  double height = size_.y + more_line;
  if (size_.y <= max_height || tables_.empty()) return;
  for (; height > max_height; height -= line_height) {
    Table& longest = *std::max_element(tables_.begin(), tables_.end(), rows);
    if (longest.size() <= 2) break;
    longest.pop_back();
    ++left_out;
  }
  legend_.push_back(words::filled(words::more_cords, {{"count", std::to_string(left_out)}}));
}

void DebugFigures::measure(const Canvas& canvas) {
  std::size_t lines = legend_.size();
  size_ = {};
  for (const std::string& line : legend_) size_.x = std::max(size_.x, canvas.text_width(line, text_size_));
  size_.x += 2.0 * margin_;
  for (const Table& table : tables_) {
    size_.x = std::max(size_.x, column_edges(canvas, table).back() + margin_);
    lines += table.size();
  }
  size_.y = canvas.line_height(text_size_) * static_cast<double>(lines) + margin_;
}

/// Returns the right edge of each column in px from the left edge of the panel.
std::vector<double> DebugFigures::column_edges(const Canvas& canvas, const Table& table) const {
  std::vector<double> right(table.front().size(), 0.0);
  for (const std::vector<std::string>& row : table) {
    for (std::size_t k = 0; k < row.size(); ++k) right[k] = std::max(right[k], canvas.text_width(row[k], text_size_));
  }
  double edge = 0.0;
  for (double& width : right) width = edge += margin_ + width;
  return right;
}

void DebugFigures::draw(Canvas& canvas, Vec2 corner) const {
  canvas.panel(corner, size_, 0.5 * text_size_, hud_style::paper);
  const double step = canvas.line_height(text_size_);
  double y = 0.5 * margin_;
  for (const Table& table : tables_) {
    const std::vector<double> right = column_edges(canvas, table);
    for (const std::vector<std::string>& row : table) {
      for (std::size_t k = 0; k < row.size(); ++k) {
        canvas.text(corner + Vec2{right[k], y}, row[k], text_size_, hud_style::faint, Align::right);
      }
      y += step;
    }
  }
  for (const std::string& line : legend_) {
    canvas.text(corner + Vec2{margin_, y}, line, text_size_, hud_style::faint);
    y += step;
  }
}

}  // namespace game

#include "ribbon/system/bar_rows.h"

#include <limits>

namespace ribbon {

void BarRows::reserve(std::size_t count) {
  bars_.reserve(count);
  tensions_.reserve(count);
}

void BarRows::append(IslandState& state, const Stage& stage, LimitedRows& rows) {
  first_ = rows.rows().size();
  tensions_.clear();
  for (const Member& member : state.members) {
    if (!member.cord->def.tension_only) continue;
    const auto tensions = IslandState::tensions_of(member, state.tensions);
    bars_.clear();
    member.cord->elasticity->append_bars(IslandState::stage_of(stage, member),
                                         IslandState::points_of(member, state.positions), tensions, bars_);
    for (const OneSidedBar& bar : bars_) {
      SlotRow row;
      row.add(static_cast<int>(member.first_point + bar.link), bar.d);
      row.add(static_cast<int>(member.first_point + bar.link + 1), -bar.d);
      rows.add({row, -bar.bar.elongation, bar.bar.compliance, 0.0, std::numeric_limits<double>::infinity(),
                bar.slack ? 0.0 : tensions[bar.link], bar.point_compliance});
      tensions_.push_back(member.first_tension + bar.link);
    }
  }
}

void BarRows::take(const LimitedRows& rows, std::span<double> next) const {
  for (std::size_t k = 0; k < tensions_.size(); ++k) next[tensions_[k]] = rows.rows()[first_ + k].force;
}

}  // namespace ribbon

#include "tests/study/players.h"

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <utility>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"

namespace study {
namespace {

constexpr unsigned tried = 24;
constexpr int ticks = 120;
constexpr unsigned first_seed = 1'000'000;  // the seeds below are those of players that test a recommendation
constexpr unsigned next_seed = 40'000;      // from one try to the next

/// Returns how many of the meetings are not known yet.
std::size_t count_new(const Meetings& own, const Meetings& known) {
  const auto missing = [](const std::vector<int>& some, const std::vector<int>& in) {
    std::vector<int> others;
    std::set_difference(some.begin(), some.end(), in.begin(), in.end(), std::back_inserter(others));
    return others.size();
  };
  return missing(own.held, known.held) + missing(own.touched, known.touched);
}

void add(std::vector<int>& known, const std::vector<int>& more) {
  std::vector<int> both;
  std::set_union(known.begin(), known.end(), more.begin(), more.end(), std::back_inserter(both));
  known = std::move(both);
}

}  // namespace

Inputs random_inputs(unsigned seed, int count) {
  constexpr int held_for = 15;  // ticks, on average
  std::mt19937 random(seed);
  Inputs inputs(static_cast<std::size_t>(count));
  std::uint16_t buttons = game::button_right;
  for (engine::TickInput& input :
       inputs) {  // mostly right and grab, because levels go to the right; a line is thrown at what is ahead
    if (random() % held_for == 0) {
      buttons = 0;
      for (const auto& [button, eighths] : {std::pair{game::button_left, 1U},
                                            {game::button_right, 7U},
                                            {game::button_jump, 4U},
                                            {game::button_grab, 6U},
                                            {game::button_throw, 3U},
                                            {game::button_reel_in, 2U}}) {
        if (random() % 8 < eighths) buttons = static_cast<std::uint16_t>(buttons | button);
      }
    }
    input.buttons = buttons;
  }
  return inputs;
}

Meetings meetings_of(const game::Level& level, const Inputs& inputs) {
  game::Simulation simulation(level);
  Meetings meetings;
  std::set<int> held, touched;
  for (const engine::TickInput& input : inputs) {
    simulation.tick(input);
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    meetings.any_cord = meetings.any_cord || coupling.size() > 0;
    if (const auto place = coupling.body(simulation.player().body()).held_place()) held.insert(place->cord);
    for (const ribbon::box2d::TouchEvent& event : coupling.last_step().touch_events()) {
      if (event.fixture != nullptr && event.fixture->GetBody() == &simulation.player().body())
        touched.insert(event.cord);
    }
  }
  meetings.held.assign(held.begin(), held.end());
  meetings.touched.assign(touched.begin(), touched.end());
  return meetings;
}

Inputs random_inputs_with_cords(const game::Level& level, unsigned seed, int count) {
  for (unsigned k = 0; k < tried; ++k) {
    Inputs inputs = random_inputs(seed + k * next_seed, count);
    if (meetings_of(level, inputs).any_cord) return inputs;
  }
  return random_inputs(seed, count);
}

std::vector<Inputs> players_that_meet_cords(const game::Level& level, unsigned seed, std::size_t count) {
  std::vector<std::pair<Inputs, Meetings>> candidates;
  for (unsigned k = 0; count > 0 && k < tried; ++k) {
    Inputs inputs = random_inputs(first_seed + tried * seed + k, ticks);
    Meetings meetings = meetings_of(level, inputs);
    if (meetings.any_cord) candidates.emplace_back(std::move(inputs), std::move(meetings));
  }
  std::vector<Inputs> chosen;
  Meetings known;
  while (chosen.size() < count && !candidates.empty()) {
    const auto best = std::max_element(candidates.begin(), candidates.end(), [&known](const auto& a, const auto& b) {
      return count_new(a.second, known) < count_new(b.second, known);
    });
    add(known.held, best->second.held);
    add(known.touched, best->second.touched);
    chosen.push_back(std::move(best->first));
    candidates.erase(best);
  }
  return chosen;
}

}  // namespace study

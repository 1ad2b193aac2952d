#pragma once

#include <box2d/b2_fixture.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "ribbon/box.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/cord.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/thesis/thesis_cord.h"

namespace ribbon::box2d {

/// A cord of a coupling: the object of its solver, its reports, and its surroundings in this tick.
struct CoupledCord {
  CoupledCord(std::variant<ThesisCord, Cord> of_solver, const b2Filter& cord_filter);

  // What a tick reads of a resting cord comes first, because most of its cost is reading this memory.
  CordId id = -1;
  bool enabled = true;
  bool resting = false;  // see CordTable
  Box resting_box{};     // m, of the cord when it began to rest
  b2Filter filter;
  std::vector<NearShape> near{};          // the fixtures found in this tick
  std::vector<NearShape> near_sensors{};  // and the sensors; while the cord rests there are none
  std::variant<ThesisCord, Cord> cord;

  // In this tick:
  Box swept_aabb{};  // in which fixtures are searched
  std::vector<RigidCircle> circles{};
  std::vector<RigidSegment> segments{};
  std::vector<Grip> grips{};
  std::vector<GripId> grip_ids{};   // of each grip
  std::vector<Axle> axles{};        // of its pulleys
  std::vector<Support> supports{};  // of the bodies that hold it, carry its pulleys or may touch it
  bool tied = false;
  int step_index = 0;                           // among the cords of the step, of the direct solver
  std::vector<FixtureTouch> touching{};         // in the last step, by fixture number
  std::vector<FixtureTouch> touching_before{};  // in the step before it
  std::vector<std::uint64_t> sensing{};         // numbers of the sensors that it overlapped in the last step, ascending
  std::vector<std::uint64_t> sensing_before{};  // in the step before it

  std::uintptr_t user_data = 0;
  std::shared_ptr<const CordDef> def{};  // that it was added with; null for the thesis's solver
  CordReport report{};
  IslandReport island_report{};
  IslandReport island_total{};
  double error = 0.0;
  StepReport thesis_report{};
  StepReport thesis_total{};

  Solver solver() const { return std::holds_alternative<Cord>(cord) ? Solver::direct : Solver::thesis; }
  bool is_direct() const { return solver() == Solver::direct; }
  // They throw CallError for a cord of the other solver.
  Cord& direct();
  const Cord& direct() const;
  ThesisCord& thesis();
  const ThesisCord& thesis() const;

  CordShape shape() const;
  std::span<const Vec2> positions() const {
    return std::visit([](const auto& of_solver) { return of_solver.positions(); }, cord);
  }
  /// m, between `point` and the point of the next column.
  Vec2 position(int point, double along) const;
  /// Converts a position along the cord from columns, 0 … columns − 1, to rest length [m]; 0 for the thesis's solver.
  double arc_at(double column) const;
  /// The inverse, for the direct solver.
  double column_at(double arc) const;
  /// Returns the pulley on whose wheel a column is, or null.
  const Pulley* wheel_at(double column) const;
  /// Throws CallError unless a column is off the wheels of the cord's pulleys. `what` names what would be there.
  void check_off_wheels(const char* what, double column) const;
  /// Returns how far something gets from a column to another one, off the wheels: at most to a point beside one.
  double free_of_wheels(double from, double to) const;
  /// Returns whether a point of the cord may be within `distance` [m] of `position`.
  bool may_be_within(Vec2 position, double distance) const;

  CordOrigin origin() const { return {def, filter, user_data}; }
  /// Reserves memory, so that the first circle to come near allocates none.
  void reserve();
  /// Clears what the last gather found.
  void clear_surroundings();
};

/// Goes through cords in the order of adding; `Base` goes through pointers to them.
template <typename Base, typename Value>
struct CordIterator {
  Base at;
  Value& operator*() const { return **at; }
  CordIterator& operator++() {
    ++at;
    return *this;
  }
  bool operator==(const CordIterator&) const = default;
};

/// A range of cords.
template <typename Base, typename Value>
struct CordRange {
  Base first, last;
  std::size_t size() const { return static_cast<std::size_t>(last - first); }
  Value& operator[](std::size_t k) const { return *first[static_cast<std::ptrdiff_t>(k)]; }
  CordIterator<Base, Value> begin() const { return {first}; }
  CordIterator<Base, Value> end() const { return {last}; }
};

/// Returns the range of the cords that a vector of pointers refers to.
template <typename Value, typename Pointers>
auto cord_range(Pointers& cords) {
  return CordRange<decltype(cords.begin()), Value>{cords.begin(), cords.end()};
}

/// What a loop over many cords reads of each.
enum class CordMemory : unsigned char {
  surroundings,  ///< of the cord of the coupling, and some of that of the solver; see ribbon::fetch
  reports        ///< with the contacts, of the cord of the coupling only
};
/// Starts to fetch it from memory: first the cord of the coupling, and some time later that of the solver. That changes
/// nothing but the speed.
void fetch_coupled(const CoupledCord& cord, CordMemory what);
void fetch_solver(const CoupledCord& cord);

/// Calls visit(cord) for each cord of a range, and fetches the memory of the next ones meanwhile.
template <typename Range, typename Visit>
void visit_fetched(const Range& cords, CordMemory what, Visit&& visit) {
  constexpr std::size_t far = 8;
  constexpr std::size_t near = 4;
  for (std::size_t k = 0; k < cords.size(); ++k) {
    if (k + far < cords.size()) fetch_coupled(cords[k + far], what);
    if (what == CordMemory::surroundings && k + near < cords.size()) fetch_solver(cords[k + near]);
    visit(cords[k]);
  }
}

/// The cords of a coupling, by id. References to a cord are valid until it is removed.
///
/// Each cord is active or resting. A resting cord is asleep with nothing near it: a tick only looks whether it was
/// changed and whether something came near, and does not step it. Its last report is empty.
class CordTable {
 public:
  /// Adds a cord and assigns its id.
  CordId add(std::unique_ptr<CoupledCord> cord);
  /// Reserves memory for so many cords in all.
  void reserve(std::size_t cords);
  /// Adds a cord that has an id, in place of the one with that id if there is one.
  void put(CoupledCord cord);
  /// Removes the cord with that id, which exists.
  void remove(CordId id);
  /// Returns a cord, or null if there is none with that id.
  CoupledCord* find(CordId id);
  const CoupledCord* find(CordId id) const;
  /// Returns a cord. Throws CallError if there is none with that id.
  CoupledCord& at(CordId id);
  const CoupledCord& at(CordId id) const;
  /// Returns a cord. Throws CallError if there is none with that id or it is disabled.
  CoupledCord& enabled(CordId id);

  int size() const { return static_cast<int>(cords_.size()); }
  /// Returns the ids, ascending.
  std::span<const CordId> ids() const { return ids_; }
  /// Returns the id of the next cord to be added.
  CordId next() const { return next_; }
  /// Sets the id of the next cord, above those of all cords.
  void continue_from(CordId next) { next_ = next; }

  /// Makes a cord active.
  void activate(CoupledCord& cord);
  /// Makes all resting cords active for which a condition holds.
  template <typename Condition>
  void activate_if(Condition&& condition) {
    move_if(resting_, active_, false, condition);
  }
  /// Lets all active cords rest for which a condition holds.
  template <typename Condition>
  void rest_if(Condition&& condition) {
    move_if(active_, resting_, true, condition);
  }
  /// Returns a number that changes with the set of resting cords.
  std::uint64_t resting_version() const { return resting_version_; }

  // All cords:
  auto begin() { return cord_range<CoupledCord>(cords_).begin(); }
  auto end() { return cord_range<CoupledCord>(cords_).end(); }
  auto begin() const { return cord_range<const CoupledCord>(cords_).begin(); }
  auto end() const { return cord_range<const CoupledCord>(cords_).end(); }
  auto active() { return cord_range<CoupledCord>(active_); }
  auto active() const { return cord_range<const CoupledCord>(active_); }
  auto resting() { return cord_range<CoupledCord>(resting_); }
  auto resting() const { return cord_range<const CoupledCord>(resting_); }

 private:
  using Pointers = std::vector<CoupledCord*>;
  template <typename Condition>
  void move_if(Pointers& from, Pointers& to, bool resting, Condition& condition) {
    const std::size_t before = to.size();
    const auto is_moved = [&](CoupledCord* cord) {
      if (!condition(*cord)) return false;
      cord->resting = resting;
      to.push_back(cord);
      return true;
    };
    from.erase(std::remove_if(from.begin(), from.end(), is_moved), from.end());
    if (to.size() == before) return;
    ++resting_version_;
    const auto by_id = [](const CoupledCord* a, const CoupledCord* b) { return a->id < b->id; };
    std::sort(to.begin(), to.end(), by_id);
  }
  std::size_t place(CordId id) const;

  std::vector<std::unique_ptr<CoupledCord>> cords_;  // by id
  std::vector<CordId> ids_;                          // of each
  Pointers active_, resting_;                        // by id
  std::uint64_t resting_version_ = 0;
  CordId next_ = 0;
};

}  // namespace ribbon::box2d

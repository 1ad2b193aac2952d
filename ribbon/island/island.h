#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ribbon/contact/contacts.h"
#include "ribbon/contact/held_body.h"
#include "ribbon/contact/limited_rows.h"
#include "ribbon/cord.h"
#include "ribbon/elastic/elasticity.h"
#include "ribbon/elastic/stage.h"
#include "ribbon/geometry/quadtree.h"
#include "ribbon/island_cord.h"
#include "ribbon/linear/block_ldlt.h"
#include "ribbon/linear/fill_order.h"

namespace ribbon {

/// Cords that are solved together, for they hold the same bodies or touch each other: the step of the direct solver. It
/// keeps memory only, nothing of one step is needed in the next.
class Island {
 public:
  /// Of its own way, that something may be turned aside in a step before that is taken again.
  static constexpr double turned_share = 0.3;
  /// m, how far from its straight way a point of a cord may go in a step unless something hits it hard: a quarter of a
  /// link, a fall, part of its own way, what loads pull it by, and all of the way of what may push it.
  static double room_of(const IslandCord& cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity);

  /// Advances the cords by dt seconds. All of them meet the same `bodies`.
  CordReport step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity);

  /// Takes the memory for steps of a cord with up to this many grips.
  void reserve(const Cord& cord, std::size_t grips);

 private:
  // Points of an outline no more links apart than that go nearly the same way: no further from each other than this
  // share of a link, beyond what their own velocities say. So near they are in each other's reach for rooms of their
  // own.
  static constexpr int close_links = 6;
  static constexpr double near_share = 0.25;
  // Of the scene's energy, that a cord may gain in all.
  static constexpr double tolerated_gain = 5e-4;

  struct Member {
    Cord* cord;
    Surroundings met;
    std::size_t first;          // of its points among all
    std::size_t count;          // of them
    std::size_t first_tension;  // among all
    std::size_t tensions;       // how many
    std::size_t first_dual;     // of its tensions that stay unknowns, among all
    std::size_t first_hold;     // of its grips among all, and the end of them
    std::size_t last_hold;
    std::uint64_t id;
    double mass = 0.0;          // kg, that may press where it touches
    double room = 0.0;          // m, how far from its straight way a point of it may go in a step
    double near_room = 0.0;     // m, and how much further than one near it along the outline
    double longest_link = 0.0;  // m, of its outline
  };
  struct OutlineLink {
    std::size_t member;
    int link;
  };
  struct Body {
    int index;          // into the step's bodies
    bool turns;         // its moment of inertia is finite
    Vec2 acceleration;  // m/s², free motion
  };
  /// A substep that is taken by halves.
  struct Halving {
    double start;          // s, since the step began
    int begun;             // Newton steps of the report before it
    bool gave_up = false;  // some of it is not solved
  };
  using Energy = Cord::Energy;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::size_t center(std::size_t body) const { return count_ + 2 * body; }
  std::size_t angle(std::size_t body) const { return count_ + 2 * body + 1; }
  template <typename T>
  static std::span<T> part(std::vector<T>& all, std::size_t first, std::size_t size) {
    return std::span(all).subspan(first, size);
  }
  void set_sizes(std::size_t slots, std::size_t tensions);

  bool sleep_on(std::span<const IslandCord> cords) const;
  static bool wake(std::span<const IslandCord> cords);
  void begin_step(std::span<const IslandCord> cords, double dt);
  void add_member(const IslandCord& cord);
  void take_over(const Member& member);
  void find_tolerance();
  bool is_alone() const;
  void drive_points(const Member& member, double dt);
  void drive(std::size_t slot, Vec2 velocity);
  void take_hold(Member& member);
  void add_hold(Member& member, std::size_t index);
  void climb(const Member& member);
  double work_of_hands(double dt) const;
  Vec2 pull_of(std::size_t hold, double dt) const;
  void slip();
  std::size_t body_slot(int index);
  void place_bodies();
  void remember_bodies(const Member& member);
  void wind(const Member& member, double dt);
  void count_rest(double dt, const CordReport& report);
  void finish_step(double dt, CordReport& report);
  void finish_member(const Member& member);
  void remember_contacts();

  void find_contacts(double dt);
  static bool may_touch(const Member& member);
  void find_reach(const Member& member);
  static bool holds(const Member& member, int body);
  Box spot_box(const RigidBody& body, Vec2 arm) const;
  int add_spot(int body, Vec2 arm);
  double pressing_mass(const Member& member) const;
  static int links(const Cord& cord);
  ContactPair pair_with_link(const Member& member, int k) const;
  static ContactPair pair_with_point(const Member& member, int k);
  double longest_link(const Member& member) const;
  void add_pair(const Member& member, ContactPair& pair, double mass, double friction, double restitution);
  Vec2 place_of(int anchor) const;
  void meet_circle(const Member& member, const RigidCircle& circle);
  bool is_fixed_in(const ContactPair& link, Vec2 center, double reach) const;
  void meet_segment(const Member& member, const RigidSegment& segment);
  void meet_each_other();
  void meet_block(const Member& member, std::size_t k, Vec2 drift);
  Vec2 mean_way() const;
  bool may_meet(std::size_t disc, const OutlineLink& link, double distance) const;
  void meet_link(const Member& member, int k, const OutlineLink& link);
  static bool are_close(const Cord& cord, int k, int link);
  double rooms_went(const Member& member) const;
  double near_rooms_went(const Member& member) const;
  bool may_have_met(const Member& member, int k, int link) const;
  static bool are_neighbours(const CordDef& def, int k, int link);
  static int outline_size(const CordDef& def);
  bool widen();
  void let_go(double dt);
  void damp_deformation(const Member& member);

  bool take_substeps(double dt, CordReport& report);
  bool substep(double start, double dt, CordReport& report);
  void begin_substep(double start, double dt);
  void return_to_start();
  bool second_order(double start, double dt, const Energy& before, CordReport& report);
  bool gained_energy(const Energy& before, double tolerated);
  bool is_free() const;
  void calm(const Energy& before);
  void slow_down(double excess);
  void add_damping(double sign);
  void unwind();
  void account(const Energy& before);
  double energy_scale(const Energy& energy) const;
  Energy total_energy();
  bool tr_bdf2(double start, double dt, CordReport& report);
  bool sdirk2(double start, double dt, CordReport& report);
  bool euler_bdf2(double start, double dt, CordReport& report);
  bool bdf2_stage(double start, double dt, double gamma, CordReport& report);
  bool implicit_euler(double start, double dt, CordReport& report);
  bool damped_substep(double start, double dt, const Energy& before, CordReport& report);
  bool halved_substep(double start, double dt, const Energy& before, CordReport& report);
  void count_system(CordReport& report);
  bool is_spent(const CordReport& report, double share = 1.0) const;
  double most_work() const;
  /// Whether as much was done in the step as is worth doing before its contacts are posed once.
  bool is_tried(const CordReport& report) const;
  bool is_patient() const;
  bool is_halved_out(const CordReport& report) const;
  void halves(double start, double dt, int depth, Halving& halving, CordReport& report);
  bool will_touch(double start, double dt);
  bool is_good(bool converged, const Energy& before, CordReport& report);

  bool solve_stage(double time, double q, std::span<const Vec2> from, CordReport& report);
  void place_driven(double time);
  void load_member(const Member& member, double time, double q);
  void add_drag(const Member& member, double q);
  bool free_steps(Stage& stage, CordReport& report);
  double furthest() const;
  bool newton_step(Stage& stage);
  bool newton_step_alone(Stage& stage);
  bool newton_step_together(Stage& stage);
  void load_together(Stage& stage);
  bool solve_together();
  void take_direction();
  void update_together(const Stage& stage);
  static Stage stage_of(const Stage& all, const Member& member);
  void make_pattern();
  void find_natural_order();
  void lessen_fill();
  void load_holds();
  void update_holds();
  void append_slips();
  void take_slips();
  bool is_limited(const HeldBody& held) const;
  std::array<int, 4> hold_slots(const HeldBody& held) const;
  Vec2 hold_gap(const HeldBody& held, std::span<const Vec2> x) const;
  Vec2 hold_pull(std::span<const double> tensions, std::size_t hold) const;
  int first_dual(const Member& member) const;
  int hold_dual(std::size_t hold) const;
  double hold_potential(std::span<const Vec2> x) const;
  Vec2 hold_tangent(const HeldBody& held, std::span<const Vec2> x) const;
  double pressed_along(const HeldBody& held) const;
  void move(std::span<Vec2> x, double share) const;
  void close_arms(std::span<Vec2> x) const;
  bool full_steps(Stage& stage, CordReport& report);
  bool are_bars_settled(const Stage& stage, int iteration);
  bool searched_steps(Stage& stage, CordReport& report);
  bool touching_steps(Stage& stage, double time, std::span<const Vec2> from, CordReport& report);
  void posed_step(double dt, CordReport& report);
  bool posed_piece(double start, double dt, CordReport& report);
  bool end_piece(double dt);
  bool go_back(const Energy& before);
  void go_to_start(double share);
  void find_tensions();
  bool limit_speeds();
  bool is_stretched() const;
  bool stretches() const;
  double fastest_before() const;
  double shortest_cord() const;
  double most_stretched(std::span<const Vec2> x) const;
  bool is_posed_out(const CordReport& report) const;
  double next_piece(double start, double left);
  double time_to_blow(double start, double most);
  double blow_time(double most) const;
  bool posed_steps(Stage& stage, double time, std::span<const Vec2> from, CordReport& report);
  void begin_posed(double time, std::span<const Vec2> from);
  enum class Solve { failed, near, exact };
  Solve solve_posed(Stage& stage, bool far, CordReport& report);
  bool solve_active_sets(Stage& stage, int most, CordReport& report);
  Solve solve_interior(Stage& stage, bool far, CordReport& report);
  void keep_solved();
  void return_to_solved();
  void append_limited(const Stage& stage);
  double posed_merit(const Stage& stage, std::span<const Vec2> x);
  bool is_worse_than_best(const Stage& stage);
  bool keep_best(const Stage& stage, bool has_best);
  bool go_to_best(const Stage& stage);
  double posed_share(const Stage& stage);
  bool keep_apart(std::span<const Vec2> from);
  bool keep_to_room(std::span<const Vec2> from);
  void find_groups();
  void go_led(double& left);
  bool ends_stage(std::span<const Vec2> from);
  void rebound(const Energy& before, double dt);
  void keep_momentum(double dt);
  bool is_angle(std::size_t slot) const { return slot >= count_ && (slot - count_) % 2 == 1; }
  Vec2 mean(std::span<const Vec2> x) const;
  double spin(std::span<const Vec2> x, std::span<const Vec2> v, double& inertia) const;
  double search(const Stage& stage, double share, int iteration);
  double merit(const Stage& stage, std::span<const Vec2> x);

  // Who is solved, and with what.
  std::vector<Member> members_;
  std::span<RigidBody> rigid_;
  std::vector<Body> bodies_;    // that are solved with the cords
  std::vector<HeldBody> held_;  // by member and point, ascending
  std::size_t count_ = 0;       // points of all cords
  Accuracy accuracy_;           // the best that one of the cords asks for
  Contacts contacts_;
  bool together_ = false;  // solved by blocks: not one cord whose bodies hold a point each

  // Of the points of all cords; and behind them, in the order of bodies_, two slots of each: its centre of mass, and
  // (φ, 0) of the angle it has turned by in the step. The integrators make no difference between them.
  std::vector<Vec2> positions_;
  std::vector<Vec2> velocities_;
  std::vector<Vec2> accelerations_;
  std::vector<double> masses_;
  std::vector<double> tensions_;
  std::vector<char> constrained_;
  double ledger_ = 0.0;         // J, of the energy guard: lost lately, or gained if negative
  double balance_ = 0.0;        // J, the same since its cords were made
  bool restart_ = false;        // accelerations_ are not those of this state
  bool touch_changed_ = false;  // in the last substep

  Vec2 gravity_;
  double step_dt_ = 0.0;
  double tolerance_ = 0.0;        // m, of this step
  double least_tolerance_ = 0.0;  // m
  double guarded_dt_ = 0.0;       // s, of the substep
  bool driven_ = false;           // something moves or turns a cord that the energy guard does not know
  bool winding_ = false;          // a reel changes rest lengths
  bool unlocking_ = false;
  bool has_fill_order_ = false;         // order_ is one that fills little, found in this step
  CordReport before_take_;              // of the step, when it was last begun
  double begin_ = 0.0;                  // s, of the substep
  std::vector<double> widenings_;       // by member: of the room in which its contacts are looked for,
  std::vector<double> near_widenings_;  // and of that near by along its outline
  double body_room_ = 0.0;              // m, how far from its straight way a body may go in a step
  Energy energy_after_;
  double weight_scale_ = 0.0;  // J, M·g·L
  std::vector<HeldStep> held_steps_;
  std::vector<CondensedBody> carried_;
  std::vector<Vec2> starts_, drives_;  // of driven points: where the step found them, and their velocity
  std::vector<Vec2> x0_, v0_;          // at the start of the substep
  std::vector<double> tension0_;
  std::vector<Vec2> x_start_, v_start_;  // the same, while it is taken by halves
  std::vector<double> tension_start_;
  std::vector<Vec2> x1_, v1_;               // after its first stage
  std::vector<Vec2> predicted_, velocity_;  // x̃ and ṽ of the stage
  std::vector<Vec2> guess_;                 // where the stage's Newton steps begin
  std::vector<double> tension_guess_;
  std::vector<double> inertia_;
  std::vector<Vec2> force_;
  std::vector<Vec2> direction_, trial_;
  std::vector<double> next_;
  std::vector<double> most_tensions_;   // the slopes of the exact penalty
  std::vector<double> values_;          // of the merit, lately
  std::vector<Vec2> solved_positions_;  // of a posed problem that is solved, but for what it has missed
  std::vector<double> solved_tensions_;
  std::vector<HeldBody> solved_held_;
  std::vector<Vec2> step_start_;
  std::vector<Vec2> ends_;  // of the step, if nothing is in the way
  std::vector<Box> link_boxes_;
  std::vector<Box> block_boxes_;  // around as many of these as a block has
  std::vector<OutlineLink> outline_links_;
  std::unique_ptr<Quadtree> tree_;
  std::size_t tree_room_ = 0;
  Box reach_;                       // of the cord whose contacts are looked for,
  std::vector<Box> outline_boxes_;  // and of its outline's points, but for the room
  bool has_pattern_ = false;
  bool meets_ = false;         // there is something to touch
  double stage_weight_ = 0.0;  // s, with which the stage's forces act
  bool euler_ = false;         // the stage is one of implicit Euler
  bool slips_ = false;         // a grip has begun to in the last linear solve
  bool poses_ = false;         // in this step contacts are posed once,
  bool posing_ = false;        // and a piece of it is being solved, see island_posed.cpp
  bool blow_is_due_ = false;   // the next piece takes a blow
  bool blown_ = false;         // this one does,
  int most_iterations_ = 0;    // of the report, after which it is linearised no more
  bool was_cut_ = false;       // in it something was kept from going through something
  LimitedRows limited_;        // of the posed problem
  double left_open_ = 0.0;     // m, that its last linear solve moved something by
  double left_force_ = 0.0;    // N, that this takes
  Energy piece_energy_;        // when it began,
  double pressed_ = 0.0;       // J, and of that what pressed, as stiff as it was in the piece before
  std::vector<Vec2> load_;     // the right side without them
  std::vector<Vec2> best_;     // positions, of those that they led to
  std::vector<double> best_tensions_;
  std::vector<int> groups_;  // by slot: what goes together when it is kept apart from others
  std::vector<double> group_shares_;

  // Of the solve by blocks.
  BlockLdlt blocks_;
  std::vector<int> order_;
  std::size_t filled_ = 0;  // blocks, when an order was found that fills little
  FillOrder fill_order_;
  std::vector<int> places_;               // by slot of points and bodies: in that order
  std::vector<std::array<int, 2>> late_;  // tensions and pulls: the place after which it is eliminated, and its slot
  std::vector<Vec2> right_side_;
  std::size_t duals_ = 0;        // tensions that stay unknowns
  std::vector<int> last_point_;  // by body: the last point that it is coupled with
};

}  // namespace ribbon

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/contact/limited_rows.h"
#include "ribbon/contact/slot_row.h"
#include "ribbon/geometry/separation.h"
#include "ribbon/linear/block_ldlt.h"
#include "ribbon/touch.h"

namespace ribbon {

/// A spot fixed to a body. `center` is the slot of the body's centre of mass, the next one that of its angle; −1 for a
/// body that nothing pushes, whose spot goes from `here` to `goal` in a stage.
struct Spot {
  int center = -1;
  Vec2 arm;  ///< m, from the centre of mass, as the step found it
  // Of one that nothing pushes:
  Vec2 from;             ///< m, its body's centre of mass when the step began
  Vec2 velocity;         ///< m/s, and the body's
  double turning = 0.0;  ///< rad/s
  Vec2 begun;            ///< m, where it was when the stage began,
  Vec2 here;             ///< m, where it is
  Vec2 goal;             ///< m, and where it is at the end of the stage
  double turned = 0.0;   ///< rad, since the step began
  double turned_goal = 0.0;
};

/// A disc and a segment that may touch in a substep. Their places are anchors: a point of a cord by its slot, or behind
/// the points a spot.
struct ContactPair {
  int disc = 0;
  int a = 0;
  int b = 0;
  int before = -1;      ///< the anchor before a on what the segment is part of, −1 where that ends there
  int after = -1;       ///< the same after b
  bool ends = true;     ///< false where the segment's ends are somebody else's
  bool mutual = false;  ///< the disc is a point whose own links meet the segment's ends: one of both counts
  double reach = 0.0;   ///< m, the radii together
  double in =
      0.0;  ///< m, of it that the step found it nearer, for no force of its own: it comes out evenly in the step
  double disc_radius = 0.0;  ///< m
  double stiffness = 0.0;    ///< k, N/m
  double friction = 0.0;     ///< μ
  double restitution = 0.0;
  std::size_t cord = 0;  ///< that remembers it
  Touch touch;
};

/// Contact as a term of the solve: each pair that is nearer than its reach has the energy ½·k·(reach − d)², and Coulomb
/// friction by an anchored spring of k/10 that slides where it would pull with more than μ times the normal force
/// (return mapping; Wriggers 2006, 5.2). One contact a local minimum of the distance: a vertex is touched only if both
/// its segments end there.
class Contacts {
 public:
  /// Of a contact [1], times the mass that may press, over the square of the step: so deep does what presses sink as
  /// its own way in a step is divided by that.
  static constexpr double firmness = 2e3;
  /// The same for Accuracy::soft_contacts, which need less than half the Newton steps.
  static constexpr double soft_firmness = 1e2;

  /// Forgets all pairs and spots; points are the anchors before the spots.
  void clear(std::size_t points);
  int add(const Spot& spot);
  void add(const ContactPair& pair);
  bool empty() const { return pairs_.empty(); }
  /// How many pairs it has memory for.
  std::size_t capacity() const { return pairs_.capacity(); }
  /// How many pairs were looked at for whether they touch, or may on their way, since this was asked last.
  std::int64_t take_visits() { return std::exchange(visits_, 0); }
  std::span<ContactPair> pairs() { return pairs_; }
  std::span<const Spot> spots() const { return spots_; }

  /// Begins a substep that ends with this share of the step: where everything is now is from where friction slides, and
  /// who was in comes out so far.
  void begin(std::span<const Vec2> x, double share);
  /// Finds out who touches at x, with the bodies' slots behind the points. True if others do than the last time.
  bool evaluate(std::span<const Vec2> x);
  /// Begins a stage: nobody has slid yet.
  void begin_stage();
  /// Finds out the same for a linear solve, where who pressed in the last one and has come off by a little still
  /// touches: along a curved way a step leaves what it should stay on, and without it the next would fly off. `strict`
  /// takes contacts and friction as they are at x, for what they are expected to become may not lead downhill.
  void prepare(std::span<const Vec2> x, bool strict);
  /// Whether at x who touches presses as the last linear solve expected, to a thousandth of all forces, or so that it
  /// moves what presses by no more than `tolerated` [m] in a step.
  bool is_settled(std::span<const Vec2> x, double tolerated);
  /// Whether nobody touches deeper than a hundredth of his reach, as evaluated last.
  bool are_shallow() const;
  /// Whether anybody touches, as evaluated last.
  bool any() const { return !active_.empty(); }
  /// Whether others touch at x than when the substep began.
  bool change(std::span<const Vec2> x);
  /// The same, as evaluated last.
  bool changed() const { return touching_ != first_; }
  /// Who touches as evaluated last has been hit in this substep, and got his force times `weight` [s] of impulse.
  void remember_hits(double weight);
  /// Multiplies the substep's impulses: by 0 to begin with none.
  void scale_impulses(double factor);
  bool were_hit() const { return std::find(hit_.begin(), hit_.end(), 1) != hit_.end(); }
  /// Finds who was hit in it faster than a tenth of a metre a second: from velocities `before` it and `after` it by
  /// slot. Each is to part at his share of the speed, no slower and, for BDF2 would have it so, no faster; below half a
  /// metre a second not at all. Until they end, a linear solve gives the step in which all of them do, in dt.
  bool find_rebounds(std::span<const Vec2> x, std::span<const Vec2> before, std::span<const Vec2> after, double dt);
  void end_rebounds(std::span<const Vec2> x);
  /// Whether anybody touches what nothing pushes.
  bool leans() const;
  /// Remembers the forces and friction's anchors at x.
  void finish(std::span<const Vec2> x);

  /// J, of those who touch at x, as evaluated last: their friction by the forces of the last linear solve.
  double potential(std::span<const Vec2> x);
  /// J, of those who touch, as evaluated last.
  double energy() const;
  /// The largest share of the way from x to `to` on which nobody comes nearer than nine tenths of his reach; who is
  /// nearer already may come two hundredths nearer (conservative advancement, Mirtich 1996). `led` moves bodies that
  /// nothing pushes towards their goals too. At most `most`.
  double free_way(std::span<const Vec2> x, std::span<const Vec2> to, bool led, double most);
  /// Whether everybody could have come to x straight from where he was when the stage began without anybody's going
  /// through another. If not, x is a solution on the other side of something.
  bool is_straight(std::span<const Vec2> from, std::span<const Vec2> x);
  /// Takes bodies that nothing pushes to where they are `time` after the step began, or sets that as their goal, or
  /// moves them a share of what is left of their way.
  void place_led(double time);
  void aim(double time);
  void lead(double share);

  /// The blocks that those who touch couple.
  bool are_coupled(const BlockLdlt& matrix) const;
  void couple(BlockLdlt& matrix) const;
  /// Tells visit(body's centre slot, point's slot) who touches whom.
  template <typename Visit>
  void for_each_touched(Visit&& visit) const {
    for (const Active& active : active_) {
      const ContactPair& pair = pairs_[active.pair];
      for (const int body : {pair.disc, pair.a, pair.b}) {
        if (!is_moved_spot(body)) continue;
        for (const int point : {pair.disc, pair.a, pair.b}) {
          if (at(point) < points_) visit(spot(body).center, point);
        }
      }
    }
  }
  /// Adds forces and the positive semidefinite part of the Hessian, at x as prepared last.
  void load(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force);
  /// After a linear solve: what the normal forces are by it.
  void update(std::span<const Vec2> direction);

  // Contacts that are posed once, see island_posed.cpp (contact_posing.cpp):

  /// Poses the pairs that may press on the way from `from`, where the stage began, to `to`: each with the normal where
  /// it ends, or of where it first touches if it would go through. Those posed before that press are posed again. True
  /// if others are posed than the last time.
  bool pose(std::span<const Vec2> from, std::span<const Vec2> to);
  /// Poses those anew, or besides, that go through each other on that way, or end deeper than their force says by more
  /// than `tolerance` [m]: what turned or slid further than its row could tell. True if there are any.
  bool pose_missed(std::span<const Vec2> from, std::span<const Vec2> to, double tolerance);
  /// Poses none.
  void pose_none();
  /// Normal forces and friction of the posed pairs as rows that are linear about x; friction by the normal forces that
  /// were found last. In a piece of a step that is shorter by `shortness` they are stiffer by its square.
  void append_rows(std::span<const Vec2> x, double shortness, LimitedRows& rows);
  /// Takes over the forces that were found, in the order of append_rows. Friction's limits follow the `first` ones and
  /// stay as they are then, for else both could go back and forth.
  void take_forces(const LimitedRows& rows, bool first);
  /// Keeps what is posed and its forces, and returns to them.
  void keep_forces();
  void return_to_forces();
  /// J, of what presses by the forces that were found last, or, of a substep that has just begun, remembered.
  double pressing_energy() const;
  /// The share of the way from x to `to` on which nothing touches whose centre line would then go into what it touches,
  /// bodies that nothing pushes going to their goals.
  double share_to_blow(std::span<const Vec2> x, std::span<const Vec2> to);
  /// m, of all pairs; 0 if there are none.
  double least_reach() const;
  /// What moves as one, by slot of points and bodies, may go a share of its way from `from` to `to`; takes from the
  /// shares of what would go through each other until nothing does. False if a share was cut.
  bool keep_apart(std::span<const Vec2> from, std::span<const Vec2> to, std::span<const int> group_of,
                  std::span<double> shares);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  using Row = SlotRow;
  /// Friction of one who touches, in a linear solve.
  struct Friction {
    Row tangent{};
    double force = 0.0;      // N, along it
    double stiffness = 0.0;  // N/m, with which the solve lets it change
    bool sticks = false;
  };
  /// What a pass over all pairs reads of one.
  struct Corner {
    int disc, a, b;
    double reach, in;
    double passing;  // of the reach: nearer, and the cord's centre line is in what it touches
  };
  struct Active {
    std::size_t pair;
    Separation gap;
  };
  /// A pair as it is posed: its normal, tangent and place along the segment stay as they are.
  struct Posed {
    std::size_t pair;
    Separation gap;
  };

  const Spot& spot(int anchor) const { return spots_[at(anchor) - points_]; }
  bool is_moved_spot(int anchor) const { return at(anchor) >= points_ && spot(anchor).center >= 0; }
  void place(std::span<const Vec2> x, bool led, std::vector<Vec2>& anchors) const;
  bool is_evaluated(std::span<const Vec2> x);
  void find_touching(std::span<const Vec2> x, double kept_share = 0.0);
  void watch(std::span<const Vec2> from, std::span<const Vec2> to);
  void find_paired();
  bool find_left(std::span<const Vec2> from, std::span<const Vec2> to);
  bool is_near(const Corner& pair) const;
  void count_visits(std::size_t count) { visits_ += static_cast<std::int64_t>(count); }
  /// m, nearer than which who was in so far touches.
  double reach_now(double reach, double in) const { return reach - (1.0 - emerged_) * in; }
  double depth(const Active& active) const;
  bool is_minimum(const ContactPair& pair, const Separation& gap) const;
  void pose_pair(std::size_t k);
  Separation gap_at(const ContactPair& pair, double share);
  void go_between(std::span<const Vec2> from, std::span<const Vec2> to);
  void keep_pressing();
  template <typename Condition>
  void keep_before(Condition&& is_kept);
  double limit(const Posed& posed) const;
  int group(int anchor, std::span<const int> group_of) const;
  void add_place(Row& row, int anchor, Vec2 by, Vec2 lever) const;
  Vec2 lever(int anchor, std::span<const Vec2> x) const;
  Row normal_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const;
  Row tangent_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const;
  Row turning_row(const ContactPair& pair, const Separation& gap, std::span<const Vec2> x) const;
  double stretch(const Active& active, const Row& tangent, std::span<const Vec2> x) const;
  double led_speed(const ContactPair& pair, const Separation& gap) const;
  void load_rebounds(std::span<const Vec2> x, BlockLdlt& matrix, std::span<Vec2> force) const;
  double free_share(const Corner& pair, double nearest_share, double most, double kept) const;
  Row slots_of(const ContactPair& pair) const;

  std::size_t points_ = 0;
  std::int64_t visits_ = 0;
  double emerged_ = 0.0;  // share of what pairs were in, by which they are out
  std::vector<Spot> spots_;
  std::vector<ContactPair> pairs_;
  std::vector<Corner> corners_;  // of the pairs
  std::vector<Active> active_;
  std::vector<Posed> posed_, posed_before_;
  double posed_stiffness_ = 1.0;  // of what presses, times the pairs' own
  bool is_posed_ = false;         // the forces found last are those of posed pairs
  std::vector<Posed> kept_posed_;
  std::vector<double> kept_forces_, kept_presses_, kept_rubs_;  // N, by pair
  bool evaluated_ = false;  // active_ and touching_ are those who touch with anchors_ where they are
  // Only these pairs may touch while no anchor is further than its slack [m] from where it was when it was found.
  std::vector<std::size_t> near_;
  std::vector<char> watched_;  // by pair: it is one of these
  std::vector<std::size_t> paired_;
  std::vector<char> left_;  // by anchor: it was not where it was to be the last time
  std::vector<Vec2> watched_from_;
  std::vector<double> slacks_;
  double least_slack_ = 0.0;              // m
  std::vector<double> rubbed_by_;         // N, by pair: the normal force by which friction is limited where it is posed
  std::vector<double> presses_;           // N, by pair: normal force in the last linear solve, negative if it pulled
  std::vector<double> forces_;            // N, by pair: the same, or 0
  std::vector<Row> rows_;                 // normal rows of those who touch, of the last linear solve
  std::vector<char> touching_, touched_;  // by pair: as evaluated last, and before
  std::vector<Friction> frictions_;       // the same of friction
  std::vector<double> rubs_;              // N, by pair, friction in the last linear solve
  std::vector<char> holds_;               // by pair: it stuck in that, and can
  std::vector<double> slid_;              // N, by pair: what it slid with in that, 0 if it stuck
  std::vector<int> turns_;           // by pair: how often it has turned from sliding one way to the other in the stage
  std::vector<char> hit_;            // in this substep
  std::vector<double> impulses_;     // N·s, by pair, of this substep
  std::vector<double> rebounds_;     // m, of those who touch, while they rebound
  std::vector<char> first_;          // when the substep began
  std::vector<double> turned_then_;  // by spot, when the substep began
  std::vector<Vec2> anchors_, starts_;  // where they are, and were when the substep began
  std::vector<Vec2> slots_then_;        // the slots when the substep began
  std::vector<Vec2> from_, to_, ends_;  // of free_way
  std::vector<double> cuts_;            // of keep_apart, by group
};

}  // namespace ribbon

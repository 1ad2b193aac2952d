#include "tests/study/chain_mover.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "game/lab/joint_chain.h"
#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace study {
namespace {

using game::lab::JointChain;
using ribbon::Vec2;
using ribbon::box2d::Coupling;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double lost = 1e9;  // m, the drawn position of a NaN point

constexpr std::uint16_t meets_cords = 0x0004;  // categories of boxes: of cords with cord_contact,
constexpr std::uint16_t meets_none = 0x0008;   // and of cords without it

/// The filter of the cord, which does not collide with players.
b2Filter filter_of(const ribbon::CordDef& def, int cord) {
  b2Filter filter;
  filter.categoryBits = def.cord_contact ? meets_cords : meets_none;
  filter.maskBits = static_cast<std::uint16_t>(~(game::player_category | meets_none));
  if (!def.cord_contact) filter.maskBits &= static_cast<std::uint16_t>(~meets_cords);
  filter.groupIndex = static_cast<std::int16_t>(def.self_contact ? cord + 1 : -(cord + 1));
  return filter;
}

/// A class derived from the joint, which has access to its protected members.
template <typename Joint>
struct Opened : Joint {
  static b2Vec2& first_anchor(Joint& joint) { return joint.*(&Opened::m_localAnchorA); }
};

/// Moves the local anchor of a joint on its body A. Box2D has no function for that, and a new joint would lose the
/// impulses with which it starts the next step.
template <typename Joint>
void move_first_anchor(Joint& joint, b2Vec2 local) {
  Opened<Joint>::first_anchor(joint) = local;
}

class ChainMover {
 public:
  ChainMover(engine::Scene& scene, game::Player& player, const Setting& setting)
      : scene_(&scene), player_(&player), setting_(setting) {
    const b2BodyDef fixed;
    ground_ = scene.world().CreateBody(&fixed);
    Coupling& coupling = scene.coupling();
    for (int c = 0; c < coupling.size(); ++c) {
      ribbon::CordDef def = coupling.cord(c).direct().def();
      def.positions.assign(coupling.cord(c).positions().begin(), coupling.cord(c).positions().end());
      const JointChain& chain = chains_.emplace_back(scene.world(), def, filter_of(def, c));
      for (const int pin : def.pins) chain.hold(pin, *ground_);
      mirrors_.push_back(coupling.cord(c).direct().save());
    }
  }

  void tick(double dt) {
    const Vec2 from = follow_hand();
    const Vec2 to = player_->grip();
    pull_down_player(dt);
    for (int k = 1; k <= setting_.substeps; ++k) {
      move_hand(from + (static_cast<double>(k) / setting_.substeps) * (to - from));
      scene_->world().Step(static_cast<float>(dt / setting_.substeps), setting_.iterations,
                           3 * setting_.iterations / 8);
      if (k == 1) player_->detect_ground(scene_->coupling());
    }
  }

  void show() {
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      std::vector<Vec2>& positions = mirrors_[c].positions;
      for (std::size_t p = 0; p < positions.size(); ++p) {
        const b2Vec2 place = chains_[c].point(static_cast<int>(p));
        positions[p] = place.IsValid() ? to_double(place) : Vec2{lost, lost};
      }
      scene_->coupling().cord(static_cast<int>(c)).direct().restore(mirrors_[c]);
    }
  }

 private:
  /// Creates and destroys the hand's joints as the player grabs and releases. Returns the hand's position relative to
  /// the player's middle, m.
  Vec2 follow_hand() {
    const auto held = scene_->coupling().body(player_->body()).held_place();
    if (!held) {
      let_go();
      return {};
    }
    if (hand_ == nullptr) {
      hand_ = &chains_[static_cast<std::size_t>(held->cord)].hold(held->point, player_->body());
      if (setting_.solver == "box2d_max_distance") keep_near_pins(*held);
      return player_->grip();
    }
    return to_double(hand_->GetLocalAnchorA());
  }

  /// Without a grip the player falls as with a single world step per tick, for any number of steps, so that the
  /// accuracy of the flight has no part in the measurement of the cords.
  void pull_down_player(double dt) {
    b2Body& body = player_->body();
    body.SetGravityScale(hand_ == nullptr ? 0.0F : 1.0F);
    if (hand_ != nullptr) return;
    body.SetLinearVelocity(body.GetLinearVelocity() + static_cast<float>(dt) * scene_->world().GetGravity());
  }

  void let_go() {
    if (hand_ != nullptr) scene_->world().DestroyJoint(hand_);
    for (b2DistanceJoint* limit : limits_) scene_->world().DestroyJoint(limit);
    hand_ = nullptr;
    limits_.clear();
  }

  void keep_near_pins(const ribbon::box2d::CordPoint& held) {
    const ribbon::CordDef& def = scene_->coupling().cord(held.cord).direct().def();
    for (const int pin : def.pins) {
      b2DistanceJointDef joint;
      joint.bodyA = &player_->body();
      joint.bodyB = ground_;
      joint.localAnchorB = chains_[static_cast<std::size_t>(held.cord)].point(pin);  // the ground is at the origin
      joint.minLength = 0.0F;
      joint.maxLength = static_cast<float>(def.length * std::abs(held.point - pin) / (def.points - 1));
      limits_.push_back(static_cast<b2DistanceJoint*>(scene_->world().CreateJoint(&joint)));
    }
  }

  void move_hand(Vec2 local) {
    if (hand_ == nullptr) return;
    move_first_anchor(*hand_, to_float(local));
    for (b2DistanceJoint* limit : limits_) move_first_anchor(*limit, to_float(local));
  }

  engine::Scene* scene_;
  game::Player* player_;
  Setting setting_;
  b2Body* ground_ = nullptr;
  std::vector<JointChain> chains_;
  std::vector<ribbon::Cord::State> mirrors_;  // of the cords, with the chains' positions
  b2RevoluteJoint* hand_ = nullptr;           // while the player holds a cord
  std::vector<b2DistanceJoint*> limits_;
};

}  // namespace

Method chain_method(const Setting& setting) {
  const auto latest = std::make_shared<std::optional<ChainMover>>();
  const auto make = [latest, setting](engine::Scene& scene, game::Player& player) -> game::Mover {
    latest->emplace(scene, player, setting);
    return [latest](double dt) { (*latest)->tick(dt); };
  };
  return {make, [latest] { (*latest)->show(); }, meets_cords | meets_none};
}

std::string chains_unsupported_reason(const game::Level& level, std::span<const engine::TickInput> inputs,
                                      const Trace& own) {
  const auto scene = level.make_scene();
  const Coupling& coupling = scene->coupling();
  if (scene->weather()) return "no wind and water act on a chain, and the level has them";
  if (!scene->wheels().empty()) return "a chain does not run around wheels, and the level has some";
  if (level.second) return "chains are held by one player, and the level is for two";
  for (const engine::MapObject& object : level.map.objects) {
    const bool ties = object.kind == "tie";
    const bool hangs =
        object.kind != "wheel" && object.kind != "chaser" && object.properties.has("cord") && object.kind != "anchor";
    if (ties || hangs || (object.kind == "anchor" && object.properties.has("body"))) {
      return "chains hang at fixed points and are held by the player, and object " + std::to_string(object.id) +
             " of the level " + (ties ? "ties cords together" : "is held by a cord");
    }
  }
  const auto is_as_at_first = [&own](const auto& cords) { return cords == own.cords.front(); };
  if (!std::all_of(own.cords.begin(), own.cords.end(), is_as_at_first) ||
      own.cords.front().size() != static_cast<std::size_t>(coupling.size())) {
    return "a chain exists from the first tick to the last, and cords of the level come and go";
  }
  for (int c = 0; c < coupling.size(); ++c) {
    if (coupling.cord(c).solver() != ribbon::box2d::Solver::direct || coupling.cord(c).shape().rows > 1) {
      return "a chain has no width, and cord " + std::to_string(c) + " of the level is a ribbon";
    }
  }
  const auto drags = [](const engine::TickInput& input) { return (input.buttons & game::button_drag) != 0; };
  if (std::any_of(inputs.begin(), inputs.end(), drags)) return "the recording drags cords with the pointer";
  return {};
}

}  // namespace study

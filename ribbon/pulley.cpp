#include "ribbon/pulley.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ribbon/cord.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/wheel_points.h"

namespace ribbon {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double rounding = 1e-9;  // rad

double sense_of(const PulleyDef& def) { return def.counterclockwise ? 1.0 : -1.0; }

/// A straight piece of the path and the arc that follows it.
struct Piece {
  Vec2 from;
  Vec2 along;     // unit vector
  double length;  // m, of the line
  double arc;     // m, around the wheel behind it; 0 behind the last line
};

/// A common tangent of two circles that the cord runs around, each a point if its radius is 0.
struct CommonTangent {
  Vec2 along;  // unit vector
  double length;
};

void check_wheel(const PulleyDef& def) {
  check_coordinates("center", def.center);
  check_range("radius", def.radius, 1e-6, 1e6);
  check_range("turns", def.turns, 0, 100);
  check_range("inertia", def.inertia, 0.0, 1e12);
  if (std::isfinite(def.friction)) {
    check_range("friction of a groove", def.friction, 0.0, 10.0);
  } else if (!(def.friction > 0.0)) {
    refuse("friction of a groove", def.friction, "0 to 10, or infinity");
  }
  check_range("motor_speed", def.motor_speed, -1e6, 1e6);
  if (!(def.motor_torque >= 0.0)) refuse("motor_torque", def.motor_torque, "0 up to infinity");
}

/// With the normals −sense·perp(t) at both ends, of the tangent t of length s, the vector from one centre to the other
/// is D = s·t + k·perp(t) with k = sense₂·R₂ − sense₁·R₁. As complex numbers, t = D·(s − i·k)/|D|².
CommonTangent common_tangent(const PulleyDef& a, const PulleyDef& b) {
  const Vec2 between = b.center - a.center;
  const double k = sense_of(b) * b.radius - sense_of(a) * a.radius;
  const double size2 = dot(between, between);
  if (!(size2 > k * k)) {
    throw DefinitionError("wheels of a cord overlap, or one holds an end; accepted are ones with a common tangent");
  }
  const double length = std::sqrt(size2 - k * k);
  return {(1.0 / size2) * times(between, {length, -k}), length};
}

Vec2 normal_of(const PulleyDef& def, Vec2 along) { return -sense_of(def) * perp(along); }

/// Returns the angle of contact, 0 … 2π and the whole turns.
double arc_of(const PulleyDef& def, Vec2 arrival, Vec2 departure) {
  const double angle = sense_of(def) * angle_between(arrival, departure);
  return (angle < -rounding ? angle + turn : angle) + def.turns * turn;
}

/// The path as pieces: one before each wheel, and the last line.
std::vector<Piece> find_pieces(std::span<const PulleyDef> circles) {
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k + 1 < circles.size(); ++k) {
    const CommonTangent tangent = common_tangent(circles[k], circles[k + 1]);
    const Vec2 from = circles[k].center + circles[k].radius * normal_of(circles[k], tangent.along);
    pieces.push_back({from, tangent.along, tangent.length, 0.0});
  }
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    const PulleyDef& wheel = circles[k + 1];
    pieces[k].arc =
        wheel.radius * arc_of(wheel, normal_of(wheel, pieces[k].along), normal_of(wheel, pieces[k + 1].along));
  }
  return pieces;
}

/// Returns the place at a distance from the beginning of a piece.
Vec2 place_on(const Piece& piece, const PulleyDef& wheel, double distance) {
  if (distance <= piece.length) return piece.from + distance * piece.along;
  const double angle = (distance - piece.length) / wheel.radius;
  const Vec2 normal = times(rotation(sense_of(wheel) * angle), normal_of(wheel, piece.along));
  return wheel.center + wheel.radius * normal;
}

void check_points_between(const ReevedCord& cord) {
  for (std::size_t k = 0; k < cord.pulleys.size(); ++k) {
    const int lying = cord.pulleys[k].before + 1 - (k == 0 ? 0 : cord.pulleys[k - 1].after);
    if (lying >= (k == 0 ? 1 : 2)) continue;
    throw DefinitionError("points are " + std::to_string(cord.positions.size()) + ", too few for wheel " +
                          std::to_string(k) + "; accepted are enough that two lie between neighbouring wheels");
  }
}

}  // namespace

void check(const PulleyDef& def, int points) {
  check_wheel(def);
  check_range("before", def.before, 0, points - 2);
  check_range("after", def.after, def.before + 1, points - 1);
}

ReevedCord reeve(Vec2 first, std::span<const PulleyDef> wheels, Vec2 last, int points) {
  check_coordinates("first", first);
  check_coordinates("last", last);
  check_range("points", points, 2, 1e6);
  for (const PulleyDef& wheel : wheels) check_wheel(wheel);
  PulleyDef end;
  end.radius = 0.0;
  std::vector<PulleyDef> circles{end};
  circles[0].center = first;
  circles.insert(circles.end(), wheels.begin(), wheels.end());
  circles.push_back(end);
  circles.back().center = last;
  const std::vector<Piece> pieces = find_pieces(circles);

  ReevedCord cord;
  for (const Piece& piece : pieces) cord.length += piece.length + piece.arc;
  cord.pulleys.assign(wheels.begin(), wheels.end());
  const double link = cord.length / (points - 1);
  double begin = 0.0;  // of the piece, m from the beginning of the cord
  std::size_t piece = 0;
  for (int p = 0; p < points; ++p) {
    const double place = p * link;
    while (piece + 1 < pieces.size() && place > begin + pieces[piece].length + pieces[piece].arc) {
      begin += pieces[piece].length + pieces[piece].arc;
      cord.pulleys[piece++].after = p;
    }
    if (piece < wheels.size() && place <= begin + pieces[piece].length) cord.pulleys[piece].before = p;
    cord.positions.push_back(place_on(pieces[piece], circles[piece + 1], place - begin));
  }
  cord.positions.back() = last;
  check_points_between(cord);
  return cord;
}

namespace {

void check_pulley(const CordParts& cord, int pulley) {
  if (cord.state.pulleys.empty()) throw DefinitionError("pulley is " + std::to_string(pulley) + "; the cord has none");
  check_range("pulley", pulley, 0, static_cast<double>(cord.state.pulleys.size()) - 1.0);
}

}  // namespace

std::span<const Pulley> pulleys_of(const Cord& cord) { return cord.parts().state.pulleys; }

int add_pulley(Cord& cord, const PulleyDef& def) {
  CordParts& parts = cord.parts();
  std::vector<Pulley>& pulleys = parts.state.pulleys;
  const auto behind =
      std::find_if(pulleys.begin(), pulleys.end(), [&](const Pulley& other) { return other.def.before >= def.after; });
  const auto added = pulleys.insert(behind, make_pulley(parts, def));
  parts.leave_out_links_on_wheels();
  parts.disturb();
  return static_cast<int>(added - pulleys.begin());
}

void remove_pulley(Cord& cord, int pulley) {
  CordParts& parts = cord.parts();
  check_pulley(parts, pulley);
  parts.state.pulleys.erase(parts.state.pulleys.begin() + pulley);
  parts.leave_out_links_on_wheels();
  parts.disturb();
}

void set_motor(Cord& cord, int pulley, double speed, double torque) {
  CordParts& parts = cord.parts();
  check_pulley(parts, pulley);
  PulleyDef def = parts.state.pulleys[at(pulley)].def;
  def.motor_speed = speed;
  def.motor_torque = torque;
  check(def, parts.def.points);
  parts.state.pulleys[at(pulley)].def = def;
  parts.state.pulleys[at(pulley)].motor_sign = 0.0;
  parts.disturb();
}

}  // namespace ribbon

#include "ribbon/system/cord_in_medium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double max_speed = 1e6;            // m/s, in each component, of a medium
constexpr double max_density = 1e6;          // kg/m³
constexpr double min_half_height = 0.02;     // of a link, so that a thin cord has no jump at a surface
constexpr double min_terminal_factor = 2.0;  // of the terminal velocity, by which buoyancy may change the velocity

/// Half a link, or the share of a row of it: what belongs to one of its points.
struct Piece {
  double length = 0.0;  // m
  double share = 1.0;   // of the row
  Vec2 along;           // unit vector; zero if the link has no direction
};

/// The pieces of a point: one or two.
struct Pieces {
  std::array<Piece, 2> all;
  std::size_t count = 0;

  std::span<const Piece> list() const { return std::span(all).first(count); }
  double length() const { return count == 2 ? all[0].length + all[1].length : all[0].length; }
};

Pieces pieces_of(const CordParts& cord, std::span<const Vec2> x, std::size_t point) {
  const auto rows = static_cast<std::size_t>(cord.def.rows);
  const std::size_t column = point / rows;
  const std::size_t row = point % rows;
  const double edge = row == 0 || row == rows - 1 ? 0.5 : 1.0;
  const double share = rows == 1 ? 1.0 : edge / static_cast<double>(rows - 1);
  Pieces pieces;
  const auto add = [&](std::size_t other, std::size_t link) {
    const Vec2 way = x[other] - x[point];
    const double size = length(way);
    pieces.all[pieces.count++] = {0.5 * cord.state.rest[link], share, size > 0.0 ? (1.0 / size) * way : Vec2{}};
  };
  if (column > 0) add(point - rows, column - 1);
  if (column + 1 < static_cast<std::size_t>(cord.def.points)) add(point + rows, column);
  return pieces;
}

bool is_in_range(const MediumSample& sample) {
  return std::abs(sample.velocity.x) <= max_speed && std::abs(sample.velocity.y) <= max_speed &&
         sample.density >= 0.0 && sample.density <= max_density && is_finite(sample.density_gradient);
}

MediumSample sample_pieces(const CordParts& cord, const Surroundings& surroundings, Vec2 place, const Pieces& pieces,
                           double time) {
  double rise = 0.0;
  for (const Piece& piece : pieces.list()) rise = std::max(rise, piece.length * std::abs(piece.along.y));
  const double thickness = std::max(cord.def.radius, 2.0 * min_half_height * pieces.all[0].length);
  const MediumSample sample = surroundings.medium->at(place, thickness + rise, time);
  return is_in_range(sample) ? sample : MediumSample{};
}

/// Coefficients k [N·s²/m²] of the drag k·v² of a piece.
struct Drag {
  double across;
  double along;
};

/// A ribbon counts as deep as it is wide.
Drag drag_of(const CordDef& def, const Piece& piece, double density) {
  const double area = 0.5 * density * (2.0 * def.radius + def.width) * piece.length * piece.share;
  return {def.drag_across * area, def.drag_along * std::numbers::pi * area};
}

Block outer(Vec2 d) { return {d.x * d.x, d.x * d.y, d.y * d.y}; }

/// What else moves a piece: its mass, and the forces on it apart from tensions and drag.
struct PieceLoad {
  double q;        // s
  double mass;     // kg
  double outside;  // N
};

/// Adds the drag −k·|s|·s in a direction, with s the component of the velocity. Any factor c ≥ 0 of the linearisation
///
///     −k·|s₀|·s₀ − c·(s − s₀)
///
/// is right where the velocity is steady. Newton's is c = 2·k·|s₀|: of second order, but then a light piece that enters
/// a medium needs many steps to slow down, as each halves its velocity. With σ = q·k·|s₀|/m it is k·|s₀|·(1 + 1/(1 +
/// σ)), which differs only by an order of q. What is at rest and begins to fall or rise would overshoot the velocity at
/// which drag balances it, s∞; so 2·k·s∞ is added, times q·k·s∞/m if that is below 1. `extra` [N·s/m] is added too.
void add_drag(double k, double speed, Vec2 direction, const PieceLoad& piece, double extra, MediumLoad& load) {
  const double rate = k * std::abs(speed);
  const double limit = std::sqrt(k * piece.outside);  // k·s∞
  const double newton = rate * (1.0 + 1.0 / (1.0 + piece.q * rate / piece.mass));
  const double factor = newton + 2.0 * limit * std::min(1.0, piece.q * limit / piece.mass) + extra;
  load.force -= (rate * speed) * direction;
  load.resistance = load.resistance + (factor / piece.q) * outer(direction);
}

/// The forces turn with the link, by up to f/l for a force f and a link of length l. That is not linearised: it has no
/// symmetric matrix. Instead the motion across is slowed down by twice what would keep an explicit step stable, which
/// vanishes with q.
void add_drags(const CordParts& cord, const MediumSample& sample, const Piece& piece, const PieceLoad& of_piece,
               Vec2 relative, MediumLoad& load) {
  const Drag drag = drag_of(cord.def, piece, sample.density);
  if (piece.along == Vec2{}) {
    const double speed = length(relative);
    if (speed > 0.0) add_drag(drag.across, speed, (1.0 / speed) * relative, of_piece, 0.0, load);
    return;
  }
  const Vec2 across = perp(piece.along);
  const double along_speed = std::abs(dot(relative, piece.along));
  const double across_speed = std::abs(dot(relative, across));
  const double turning = (drag.across * across_speed + drag.along * along_speed) * along_speed / piece.length;
  add_drag(drag.across, dot(relative, across), across, of_piece, of_piece.q * turning, load);
  add_drag(drag.along, dot(relative, piece.along), piece.along, of_piece, 0.0, load);
}

/// What floats where the density rises downwards is drawn to its level.
void add_buoyancy(const MediumSample& sample, double volume, Vec2 gravity, MediumLoad& load) {
  load.force -= (sample.density * volume) * gravity;
  const double g2 = dot(gravity, gravity);
  if (g2 == 0.0) return;
  const double stiffness = volume * std::max(0.0, dot(sample.density_gradient, gravity)) / g2;
  load.resistance = load.resistance + stiffness * outer(gravity);
}

double volume_of(const CordDef& def, const Pieces& pieces) {
  return def.displaced_area * pieces.length() * pieces.all[0].share;
}

}  // namespace

MediumSample sample_at(const CordParts& cord, const Surroundings& surroundings, std::span<const Vec2> x,
                       std::size_t point, double time) {
  return sample_pieces(cord, surroundings, x[point], pieces_of(cord, x, point), time);
}

MediumEffect find_medium_effect(const CordParts& cord, const Surroundings& surroundings, double dt, Vec2 gravity) {
  MediumEffect effect;
  if (surroundings.medium == nullptr || !feels_medium(cord.def)) return effect;
  for (std::size_t p = 0; p < cord.size(); ++p) {
    const Pieces pieces = pieces_of(cord, cord.state.positions, p);
    const MediumSample sample = sample_pieces(cord, surroundings, cord.state.positions[p], pieces, surroundings.time);
    if (sample.density == 0.0) continue;
    effect.acts = true;
    double drag = 0.0;
    for (const Piece& piece : pieces.list()) {
      const Drag k = drag_of(cord.def, piece, sample.density);
      drag += std::max(k.across, k.along);
    }
    const double mass = cord.state.masses[p];
    const Vec2 relative = cord.state.velocities[p] - sample.velocity;
    const double speed2 = dot(relative, relative);
    const double lift = sample.density * volume_of(cord.def, pieces) * length(gravity);
    double rise = dt * lift / mass;
    if (drag > 0.0) rise = std::min(rise, min_terminal_factor * std::sqrt(lift / drag));
    effect.delta_v = std::max(effect.delta_v, std::min(std::sqrt(speed2), dt * drag * speed2 / mass) + rise);
  }
  return effect;
}

MediumLoad medium_load(const CordParts& cord, const Surroundings& surroundings, const PredictedMotion& motion,
                       std::size_t point) {
  MediumLoad load;
  const Pieces pieces = pieces_of(cord, motion.x, point);
  const MediumSample sample = sample_pieces(cord, surroundings, motion.x[point], pieces, motion.time);
  if (sample.density == 0.0) return load;
  const double mass = cord.state.masses[point];
  const double volume = volume_of(cord.def, pieces);
  Vec2 outside = (cord.def.gravity_scale * mass - sample.density * volume) * motion.gravity;
  if (!cord.state.loads.empty()) outside += cord.state.loads[point];
  const double force = length(outside);
  for (const Piece& piece : pieces.list()) {
    const double share = piece.length / pieces.length();
    add_drags(cord, sample, piece, {motion.q, share * mass, share * force}, motion.v[point] - sample.velocity, load);
  }
  add_buoyancy(sample, volume, motion.gravity, load);
  return load;
}

}  // namespace ribbon

#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/vec2.h"

namespace engine {

/// A line that something follows at constant speed: a polyline back and forth, a polygon round and round.
class Track {
 public:
  /// `points`: two or more, m, of which no two in a row are the same.
  Track(std::vector<ribbon::Vec2> points, bool closed);

  bool is_closed() const { return closed_; }
  /// Returns the length in m; of a closed track once round.
  double length() const { return arcs_.back(); }
  /// Returns the points in m; those of a closed track end with the first one.
  const std::vector<ribbon::Vec2>& points() const { return points_; }
  /// Returns the place after `distance` m, 0 or more, from the first point: a closed track goes on at its start, an
  /// open one turns back at its ends.
  ribbon::Vec2 at(double distance) const;
  /// Returns the distance from the first point to the place nearest to `position`, 0 … length(), m.
  double nearest(ribbon::Vec2 position) const;

 private:
  std::vector<ribbon::Vec2> points_;
  std::vector<double> arcs_;  // m, from the first point to each one
  bool closed_;
};

/// The largest distance in m from the centre of what follows a track to the track.
inline constexpr double max_track_distance = 0.25;
/// The accepted speeds along a track, m/s.
inline constexpr NumberRange track_speed{0.01, 100.0};
inline constexpr double default_track_speed = 1.0;  ///< m/s

/// Throws MapError unless the object of class `path` is a polyline or polygon whose corners are at least 1 cm apart.
void check_path(const MapObject& object);
/// Returns the track that the property `path` of an object names. Throws MapError if it is not the id of a path within
/// max_track_distance of the object's position.
Track track_of(const MapObject& object, const TiledMap& map);

/// The bodies of a scene that follow tracks.
class Rides {
 public:
  /// Puts a kinematic body on the track that its object names, at the nearest place, from where it follows the track
  /// from the first point to the last. Throws MapError as track_of does.
  void add(b2Body& body, const MapObject& object, const TiledMap& map);
  /// Gives each body the velocity with which it is on its track at the end of the next step of `dt` s.
  void lead(double dt);

  bool empty() const { return rides_.empty(); }
  /// Returns the time that the bodies have followed their tracks, s. It is all of the state but the bodies' positions.
  double time() const { return time_; }
  void set_time(double time) { time_ = time; }

 private:
  struct Ride {
    b2Body* body;
    Track track;
    double start;  // m
    double speed;  // m/s
  };
  std::vector<Ride> rides_;
  double time_ = 0.0;
};

}  // namespace engine

#include "engine/scene/scene_paths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ribbon/box2d/convert.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double min_piece = 0.01;  // m, between two corners of a path

bool is_closed(const MapObject& path) { return path.shape == MapShape::polygon; }

}  // namespace

Track::Track(std::vector<Vec2> points, bool closed) : points_(std::move(points)), arcs_{0.0}, closed_(closed) {
  if (closed_) points_.push_back(points_.front());
  for (std::size_t k = 1; k < points_.size(); ++k)
    arcs_.push_back(arcs_.back() + ribbon::length(points_[k] - points_[k - 1]));
}

Vec2 Track::at(double distance) const {
  double arc = std::fmod(distance, closed_ ? length() : 2.0 * length());
  if (arc > length()) arc = 2.0 * length() - arc;
  const auto after = std::upper_bound(arcs_.begin() + 1, arcs_.end() - 1, arc);
  const auto k = static_cast<std::size_t>(after - arcs_.begin());
  const double share = (arc - arcs_[k - 1]) / (arcs_[k] - arcs_[k - 1]);
  return points_[k - 1] + share * (points_[k] - points_[k - 1]);
}

double Track::nearest(Vec2 position) const {
  double best = ribbon::length(points_.front() - position);
  double arc = 0.0;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const Vec2 piece = points_[k] - points_[k - 1];
    const double share = std::clamp(dot(position - points_[k - 1], piece) / dot(piece, piece), 0.0, 1.0);
    const double distance = ribbon::length(points_[k - 1] + share * piece - position);
    if (distance >= best) continue;
    best = distance;
    arc = arcs_[k - 1] + share * (arcs_[k] - arcs_[k - 1]);
  }
  return arc;
}

void check_path(const MapObject& object) {
  object.properties.check_known_properties({});
  if (object.shape != MapShape::polyline && object.shape != MapShape::polygon) {
    throw object.error("the shape of a path is " + std::string(shape_name(object.shape)) +
                       "; accepted is polyline, polygon");
  }
  const std::size_t count = object.points.size();
  for (std::size_t k = is_closed(object) ? 0 : 1; k < count; ++k) {
    if (length(object.points[k] - object.points[(k + count - 1) % count]) >= min_piece) continue;
    throw object.error("two corners of the path are closer than the " + number_in_words(min_piece) + " m accepted");
  }
}

Track track_of(const MapObject& object, const TiledMap& map) {
  const std::int64_t id = object.properties.integer("path");
  const MapObject* const path = map.find(static_cast<int>(id));
  if (path == nullptr || path->id != id || path->kind != "path") {
    throw object.error(
        "property \"path\" is " + std::to_string(id) + ", " +
        (path == nullptr ? "and there is no such object" : "an object of class " + in_quotes(path->kind)) +
        "; accepted is the id of a path");
  }
  check_path(*path);
  Track track(path->points, is_closed(*path));
  const double distance = length(track.at(track.nearest(object.position)) - object.position);
  if (distance <= max_track_distance) return track;
  throw object.error("its centre is " + number_in_words(distance) + " m from its path; accepted is one within " +
                     number_in_words(max_track_distance) + " m");
}

void Rides::add(b2Body& body, const MapObject& object, const TiledMap& map) {
  Track track = track_of(object, map);
  const double start = track.nearest(object.position);
  const double speed = object.properties.number_or("speed", default_track_speed, track_speed);
  body.SetTransform(ribbon::box2d::to_float(track.at(start)), body.GetAngle());
  rides_.push_back({&body, std::move(track), start, speed});
}

void Rides::lead(double dt) {
  time_ += dt;
  for (const Ride& ride : rides_) {
    const Vec2 there = ride.track.at(ride.start + ride.speed * time_);
    const Vec2 here = ribbon::box2d::to_double(ride.body->GetPosition());
    ride.body->SetLinearVelocity(ribbon::box2d::to_float((1.0 / dt) * (there - here)));
  }
}

}  // namespace engine

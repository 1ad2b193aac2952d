#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/draw/canvas_mesh.h"
#include "engine/draw/color.h"
#include "engine/draw/textured_mesh.h"
#include "ribbon/vec2.h"

namespace engine {

/// The camera.
struct View {
  ribbon::Vec2 center{};            ///< m, the point of the world in the middle of the canvas
  double pixels_per_metre = 100.0;  ///< > 0
};

/// The part of a text that is at the given position.
enum class Align { left, center, right };

/// The appearance of Canvas::strip.
struct StripLook {
  const Image* image = nullptr;     ///< u runs along the strip, v across it; null: colour only
  double width = 0.1;               ///< m
  double image_length = 1.0;        ///< m, > 0: the image repeats along the strip after this length
  double start = 0.0;               ///< m, the position in the image at the start of the strip
  Color color{255, 255, 255};       ///< multiplied with the image
  std::span<const Color> colors{};  ///< one per point; replaces `color` unless empty
};

/// The appearance of Canvas::skyline.
struct SkylineLook {
  double top = 0.0;       ///< px, down to which the gradient has its upper colour
  double bottom = 1.0;    ///< px, > top, from which on it has its lower colour
  Color upper, lower;     ///< opaque; alpha is ignored
  double end = 1e9;       ///< px; nothing is filled below it
  bool is_above = false;  ///< fills what is above the line, as for a ceiling
};

/// An abstract drawing surface. Shapes of the world are in metres, y up, and pass through the view; text and panels are
/// in pixels, y down, with the origin at the top left corner. All shapes are antialiased. Shapes without a texture are
/// blended once: where parts of a translucent shape overlap (the joints of a line, a line that crosses itself), its
/// colour does not add up.
///
/// Shapes that are not finite or have no size draw nothing. Only set_view throws.
class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// The size in pixels. That of a window changes only in Window::poll.
  virtual int width() const = 0;
  virtual int height() const = 0;

  /// Fills the canvas with an opaque colour; alpha is ignored.
  void clear(Color color) { paint_background(color, color); }
  /// Fills the canvas with an opaque vertical gradient.
  void clear(Color top, Color bottom) { paint_background(top, bottom); }

  /// Sets the camera. Throws std::invalid_argument, without a change, unless the center is finite and pixels_per_metre
  /// is finite and positive.
  void set_view(View view);
  const View& view() const { return view_; }
  ribbon::Vec2 to_pixels(ribbon::Vec2 world) const;
  ribbon::Vec2 to_world(ribbon::Vec2 pixels) const;

  /// A filled convex polygon, corners in m, in either order. For other polygons use triangles().
  void polygon(std::span<const ribbon::Vec2> corners, Color color);
  /// A filled disc; center and radius in m.
  void circle(ribbon::Vec2 center, double radius, Color color);
  /// The outline of a circle: a line of `width` m, centred on the circle.
  void ring(ribbon::Vec2 center, double radius, double width, Color color);
  /// A line of `width` m through the points (m) with round joints and ends. Requires at least two distinct points.
  /// Lines thinner than a pixel become translucent.
  void polyline(std::span<const ribbon::Vec2> points, double width, Color color);
  /// Filled triangles, three indices each, corners in m, in either order, with an antialiased rim around the union. The
  /// rim is outside, so the shape grows by half a pixel. Draws nothing if an index is out of range; ignores an
  /// incomplete last triangle.
  void triangles(std::span<const ribbon::Vec2> vertices, std::span<const int> indices, Color color);

  /// A textured band of constant width along a line through the points (m): see add_band.
  void strip(std::span<const ribbon::Vec2> points, const StripLook& look);
  /// Textured triangles in pixels, clipped to `clip`. Draws nothing unless is_paintable(mesh). Uses the image only
  /// during the call.
  void textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip = {});
  /// Fills what is below a line across the canvas with a vertical gradient. The points (px) are in order of x. Several
  /// times faster than a mesh. Draws nothing for fewer than two points and for numbers that are not finite.
  void skyline(std::span<const ribbon::Vec2> line, const SkylineLook& look);
  /// A mesh in pixels; all its shapes are blended once together. Draws nothing if an index is out of range or a number
  /// is not finite.
  void mesh(const Mesh& mesh, Color color);

  /// Stores a copy of the picture for recall(), in place of the last one. For backgrounds that are expensive to draw.
  virtual void remember(int key) { static_cast<void>(key); }
  /// Restores the upper `rows` rows of the picture that was stored with this key. Returns false if there is none of the
  /// present size.
  virtual bool recall(int key, int rows) {
    static_cast<void>(key);
    static_cast<void>(rows);
    return false;
  }

  /// A filled rectangle with round corners, in pixels.
  virtual void panel(ribbon::Vec2 top_left, ribbon::Vec2 size, double corner_radius, Color color);

  /// One line of UTF-8 text. `at`: pixels, the left end, middle or right end of the line at its top, rounded to whole
  /// pixels for sharp text. `size`: the em of the font in pixels, rounded and clamped to 6 … 200.
  void text(ribbon::Vec2 at, std::string_view utf8, double size, Color color, Align align = Align::left);
  /// The width of the text in pixels.
  virtual double text_width(std::string_view utf8, double size) const = 0;
  /// The distance in pixels from one line of text to the next.
  virtual double line_height(double size) const = 0;

 protected:
  /// Fills the canvas with a vertical gradient.
  virtual void paint_background(Color top, Color bottom) = 0;
  /// Fills a mesh in pixels. Where triangles overlap, the largest cover counts: the colour is blended at most once per
  /// pixel. Corners are finite but may be far outside.
  virtual void paint_mesh(const Mesh& mesh, Color color) = 0;
  /// Paints the triangles in order. The mesh is paintable; its corners may be far outside.
  virtual void paint_textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) = 0;
  /// Fills what is below or above the line, which has two points or more in order of x. Without an implementation
  /// nothing is drawn.
  virtual void paint_skyline(std::span<const ribbon::Vec2> line, const SkylineLook& look) {
    static_cast<void>(line);
    static_cast<void>(look);
  }
  /// Draws text. `top_left` is finite and in pixels; the text is not empty.
  virtual void paint_text(ribbon::Vec2 top_left, std::string_view utf8, double size, Color color) = 0;

 private:
  std::span<const ribbon::Vec2> pixels_of(std::span<const ribbon::Vec2> world);
  template <typename AddShape>
  void paint(Color color, AddShape add_shape);

  View view_;
  // Scratch memory.
  Mesh mesh_;
  TexturedMesh textured_;
  std::vector<ribbon::Vec2> pixels_;
};

}  // namespace engine

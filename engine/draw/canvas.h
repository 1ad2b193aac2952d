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

/// The camera: which point of the world stands in the middle of the canvas, and how large a metre is drawn.
struct View {
  ribbon::Vec2 center{};            ///< m
  double pixels_per_metre = 100.0;  ///< > 0
};

/// Which part of a text stands at the given place.
enum class Align { left, center, right };

/// How Canvas::strip looks.
struct StripLook {
  const Image* image = nullptr;     ///< none: the colour alone. u runs along the strip, v across it
  double width = 0.1;               ///< m
  double image_length = 1.0;        ///< m of the strip that one image is laid along, then it comes again; > 0
  double start = 0.0;               ///< m along the image where the strip begins
  Color color{255, 255, 255};       ///< multiplied with the image's
  std::span<const Color> colors{};  ///< instead: of each point, as many as there are points
};

/// What a game draws on. World shapes are in metres, y up, and pass through the view; text and panels are in screen
/// pixels, the origin at the top left corner, y down. Every shape is antialiased, and, but for textured ones, blended
/// once: where the parts of one shape overlap (the joints of a line, a line crossing itself), a translucent colour does
/// not add up.
///
/// A shape that is not finite or has no size draws nothing. Nothing here throws except set_view.
class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// The size in pixels. A window's changes only in Window::poll.
  virtual int width() const = 0;
  virtual int height() const = 0;

  /// Fills everything with one opaque colour (alpha is ignored).
  void clear(Color color) { paint_background(color, color); }
  /// Fills everything with an opaque vertical gradient.
  void clear(Color top, Color bottom) { paint_background(top, bottom); }

  /// Throws std::invalid_argument unless the center is finite and pixels_per_metre finite and positive; the old view
  /// then stays.
  void set_view(View view);
  const View& view() const { return view_; }
  ribbon::Vec2 to_pixels(ribbon::Vec2 world) const;
  ribbon::Vec2 to_world(ribbon::Vec2 pixels) const;

  /// A filled convex polygon, corners in m in either order. Not convex: use triangles.
  void polygon(std::span<const ribbon::Vec2> corners, Color color);
  /// A filled disc; center and radius in m.
  void circle(ribbon::Vec2 center, double radius, Color color);
  /// The outline of a circle: a line of this width (m) along the middle of its rim.
  void ring(ribbon::Vec2 center, double radius, double width, Color color);
  /// A line through the points (m), of this width (m), with round joints and ends. It needs two points in different
  /// places. Thinner than a pixel it fades rather than breaking up.
  void polyline(std::span<const ribbon::Vec2> points, double width, Color color);
  /// Filled triangles, three indices each, corners in m in either order, with an antialiased rim around the whole. The
  /// rim lies outside, so the shape grows by half a pixel. Draws nothing if an index is out of range; triangles left
  /// over by an incomplete three are ignored.
  void triangles(std::span<const ribbon::Vec2> vertices, std::span<const int> indices, Color color);

  /// A textured band of constant width along a line through the points (m): see add_band.
  void strip(std::span<const ribbon::Vec2> points, const StripLook& look);
  /// Textured triangles in pixels, within `clip`: what else is drawn with images, and what an immediate-mode interface
  /// hands out. Draws nothing unless is_paintable(mesh). The image is only used during the call.
  void textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip = {});
  /// A mesh in pixels: several shapes of it are blended once together. Draws nothing if an index is out of range, or a
  /// number not finite.
  void mesh(const Mesh& mesh, Color color);

  /// Keeps a copy of the picture as it is, the only one, for recall: for what is the same in every frame and takes
  /// long.
  virtual void remember(int key) { static_cast<void>(key); }
  /// Puts the picture back that was remembered under this key. False if there is none, or none of this size: draw it.
  virtual bool recall(int key) {
    static_cast<void>(key);
    return false;
  }

  /// A filled rectangle with round corners, in pixels; top_left is the corner nearest the origin.
  void panel(ribbon::Vec2 top_left, ribbon::Vec2 size, double corner_radius, Color color);

  /// One line of UTF-8 text. `at`, in pixels, is on the top of the line, at its left end, middle or right end; size is
  /// the font's em in pixels, rounded and kept to 6 … 200. Snapped to whole pixels to stay sharp.
  void text(ribbon::Vec2 at, std::string_view utf8, double size, Color color, Align align = Align::left);
  /// The width in pixels that text() would take.
  virtual double text_width(std::string_view utf8, double size) const = 0;
  /// The distance in pixels from one line of text to the next.
  virtual double line_height(double size) const = 0;

 protected:
  /// Fills everything; equal colours mean a plain fill.
  virtual void paint_background(Color top, Color bottom) = 0;
  /// Fills a mesh, in pixels. Where its triangles overlap, the largest cover counts, so that the color is blended at
  /// most once a pixel. Corners are finite but may lie far outside.
  virtual void paint_mesh(const Mesh& mesh, Color color) = 0;
  /// Paints the triangles in their order. The mesh is paintable; its corners may lie far outside.
  virtual void paint_textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) = 0;
  /// Draws text with its top left corner here, in pixels (finite, the text not empty).
  virtual void paint_text(ribbon::Vec2 top_left, std::string_view utf8, double size, Color color) = 0;

 private:
  std::span<const ribbon::Vec2> pixels_of(std::span<const ribbon::Vec2> world);
  template <typename AddShape>
  void paint(Color color, AddShape add_shape);

  View view_;
  // Kept between shapes for their memory.
  Mesh mesh_;
  TexturedMesh textured_;
  std::vector<ribbon::Vec2> pixels_;
};

}  // namespace engine

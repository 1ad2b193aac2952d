#include "engine/window/sdl_canvas.h"

#include <SDL.h>
#include <SDL_image.h>
#include <SDL_ttf.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace engine {
namespace {

constexpr int max_side = 16384;                // px, the texture size that graphics hardware accepts
constexpr std::size_t max_cached_texts = 512;  // that were used last; as many older ones are kept
constexpr std::size_t max_open_fonts = 32;
constexpr double text_margin = 1e6;  // px; text farther outside is skipped

using Surface = std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)>;
using Font = std::unique_ptr<TTF_Font, decltype(&TTF_CloseFont)>;

std::uint32_t rgb_of(Color c) {
  return static_cast<std::uint32_t>(c.r) << 16U | static_cast<std::uint32_t>(c.g) << 8U | c.b;
}

Color mix(Color top, Color bottom, double t) {
  const auto channel = [t](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
  };
  return {channel(top.r, bottom.r), channel(top.g, bottom.g), channel(top.b, bottom.b)};
}

int pixel_size(double size) { return static_cast<int>(std::lround(std::clamp(size, 6.0, 200.0))); }

Raster make_raster(int width, int height) {
  if (width < 1 || height < 1 || width > max_side || height > max_side)
    throw std::invalid_argument("a canvas of " + std::to_string(width) + " x " + std::to_string(height) +
                                " pixels: each side must be 1 to " + std::to_string(max_side));
  return {width, height};
}

/// The opacity of each pixel of a line of text.
struct Letters {
  std::vector<std::uint8_t> mask;
  int width = 0;
};

Letters read_alpha(SDL_Surface& surface) {
  Letters letters;
  letters.width = surface.w;
  for (int y = 0; y < surface.h; ++y) {
    const auto* row = static_cast<const std::uint8_t*>(surface.pixels) + static_cast<std::ptrdiff_t>(y) * surface.pitch;
    for (int x = 0; x < surface.w; ++x, row += sizeof(std::uint32_t)) {
      std::uint32_t argb = 0;
      std::memcpy(&argb, row, sizeof argb);
      letters.mask.push_back(static_cast<std::uint8_t>(argb >> 24U));
    }
  }
  return letters;
}

}  // namespace

/// Renders text and caches it: most text of a game is the same in the next frame.
class HeadlessCanvas::Typesetter {
 public:
  explicit Typesetter(const std::string& font_file) : font_file_(font_file) {
    if (TTF_Init() != 0) throw std::runtime_error(std::string("cannot start SDL_ttf: ") + TTF_GetError());
    if (font(16) != nullptr) return;
    const std::string reason = TTF_GetError();
    TTF_Quit();
    throw std::runtime_error("cannot open the font " + font_file_ + ": " + reason +
                             "; accepted is a TrueType file (the default is of Debian's package fonts-dejavu-core)");
  }
  Typesetter(const Typesetter&) = delete;
  Typesetter& operator=(const Typesetter&) = delete;
  ~Typesetter() {
    fonts_.clear();
    TTF_Quit();
  }

  const Letters& letters(std::string_view utf8, int size) {
    std::pair<int, std::string> key(size, utf8);
    if (const auto found = texts_.find(key); found != texts_.end()) return found->second;
    // A clock makes a new text in each frame. It must not remove the texts that every frame shows.
    if (texts_.size() >= max_cached_texts) older_texts_ = std::exchange(texts_, {});
    if (auto found = older_texts_.extract(key)) return texts_.insert(std::move(found)).position->second;
    return texts_[std::move(key)] = set(std::string(utf8), size);
  }

  double line_height(int size) {
    TTF_Font* const opened = font(size);
    return opened != nullptr ? TTF_FontLineSkip(opened) : size;
  }

 private:
  Letters set(const std::string& utf8, int size) {
    TTF_Font* const opened = font(size);
    if (opened == nullptr) return {};
    const Surface surface(TTF_RenderUTF8_Blended(opened, utf8.c_str(), {255, 255, 255, 255}), SDL_FreeSurface);
    return surface ? read_alpha(*surface) : Letters{};  // none if the text has no width
  }

  TTF_Font* font(int size) {
    if (const auto found = fonts_.find(size); found != fonts_.end()) return found->second.get();
    Font opened(TTF_OpenFont(font_file_.c_str(), size), TTF_CloseFont);
    if (!opened) return nullptr;
    TTF_SetFontHinting(opened.get(), TTF_HINTING_LIGHT);
    if (fonts_.size() >= max_open_fonts) fonts_.clear();
    return fonts_.emplace(size, std::move(opened)).first->second.get();
  }

  std::string font_file_;
  std::map<int, Font> fonts_;
  std::map<std::pair<int, std::string>, Letters> texts_;
  std::map<std::pair<int, std::string>, Letters> older_texts_;
};

HeadlessCanvas::HeadlessCanvas(int width, int height, const std::string& font)
    : raster_(make_raster(width, height)), typesetter_(std::make_unique<Typesetter>(font)) {}

std::string HeadlessCanvas::default_font() { return WINDOW_FONT; }

HeadlessCanvas::~HeadlessCanvas() = default;

void HeadlessCanvas::resize(int width, int height) {
  raster_ = make_raster(width, height);
  remembered_key_.reset();
}

void HeadlessCanvas::remember(int key) {
  remembered_ = raster_.pixels();
  remembered_key_ = key;
}

bool HeadlessCanvas::recall(int key, int rows) {
  if (remembered_key_ != key) return false;
  raster_.put(remembered_, rows);
  return true;
}

double HeadlessCanvas::text_width(std::string_view utf8, double size) const {
  if (utf8.empty() || !std::isfinite(size) || size <= 0.0) return 0.0;
  return typesetter_->letters(utf8, pixel_size(size)).width;
}

double HeadlessCanvas::line_height(double size) const {
  if (!std::isfinite(size) || size <= 0.0) return 0.0;
  return typesetter_->line_height(pixel_size(size));
}

void HeadlessCanvas::paint_background(Color top, Color bottom) {
  for (int y = 0; y < height(); ++y)
    raster_.fill_row(y, rgb_of(mix(top, bottom, static_cast<double>(y) / std::max(height() - 1, 1))));
}

void HeadlessCanvas::paint_mesh(const Mesh& mesh, Color color) { raster_.fill(mesh, rgb_of(color), color.a); }

void HeadlessCanvas::paint_textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) {
  raster_.fill(mesh, texture, clip);
}

void HeadlessCanvas::paint_skyline(std::span<const ribbon::Vec2> line, const SkylineLook& look) {
  const int end = static_cast<int>(std::clamp(std::ceil(look.end), 0.0, 1.0 * height()));
  raster_.fill(line,
               Raster::Skyline{look.top, look.bottom, rgb_of(look.upper), rgb_of(look.lower), end, look.is_above});
}

void HeadlessCanvas::paint_text(ribbon::Vec2 top_left, std::string_view utf8, double size, Color color) {
  if (std::abs(top_left.x) > text_margin || std::abs(top_left.y) > text_margin) return;
  const Letters& letters = typesetter_->letters(utf8, pixel_size(size));
  raster_.stamp(letters.mask, letters.width, static_cast<int>(std::lround(top_left.x)),
                static_cast<int>(std::lround(top_left.y)), rgb_of(color), color.a);
}

void HeadlessCanvas::save_png(const std::string& path) const {
  const auto fail = [&path](const std::string& reason) {
    throw std::runtime_error("cannot write the picture " + path + ": " + reason);
  };
  // SDL only reads the pixels; its interface has no const.
  auto* const pixels = const_cast<std::uint32_t*>(raster_.pixels().data());
  const Surface surface(
      SDL_CreateRGBSurfaceWithFormatFrom(pixels, width(), height(), 32, 4 * width(), SDL_PIXELFORMAT_RGB888),
      SDL_FreeSurface);
  if (!surface) fail(SDL_GetError());
  SDL_RWops* const file = SDL_RWFromFile(path.c_str(), "wb");
  if (file == nullptr) fail(std::strerror(errno));
  const bool encoded = IMG_SavePNG_RW(surface.get(), file, 0) == 0;
  const std::string encode_error = encoded ? "" : IMG_GetError();
  const bool closed = SDL_RWclose(file) == 0;
  if (!encoded) fail(encode_error);
  if (!closed) fail(SDL_GetError());
}

}  // namespace engine

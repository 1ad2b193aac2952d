#include "engine/panel/debug_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/draw/image.h"

namespace engine {
namespace {

constexpr float text_size = 14.0F;  // desktop units

constexpr std::array<std::pair<ImGuiKey_, Key>, 20> keys = {{
    {ImGuiKey_Tab, Key::tab},
    {ImGuiKey_LeftArrow, Key::left},
    {ImGuiKey_RightArrow, Key::right},
    {ImGuiKey_UpArrow, Key::up},
    {ImGuiKey_DownArrow, Key::down},
    {ImGuiKey_PageUp, Key::page_up},
    {ImGuiKey_PageDown, Key::page_down},
    {ImGuiKey_Home, Key::home},
    {ImGuiKey_End, Key::end},
    {ImGuiKey_Insert, Key::insert},
    {ImGuiKey_Delete, Key::remove},
    {ImGuiKey_Backspace, Key::backspace},
    {ImGuiKey_Space, Key::space},
    {ImGuiKey_Enter, Key::enter},
    {ImGuiKey_Escape, Key::escape},
    {ImGuiKey_A, Key::a},
    {ImGuiKey_C, Key::c},
    {ImGuiKey_V, Key::v},
    {ImGuiKey_X, Key::x},
    {ImGuiKey_Z, Key::z},
}};

Color color_of(ImU32 packed) {
  const auto part = [packed](unsigned shift) { return static_cast<std::uint8_t>(packed >> shift & 0xffU); };
  return {part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT), part(IM_COL32_A_SHIFT)};
}

ribbon::Vec2 vec2(ImVec2 v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

int whole(float x) { return static_cast<int>(std::lround(std::clamp(x, -1e6F, 1e6F))); }

/// Copies the triangles of one command to `mesh`, with only the vertices that they use.
void copy_triangles(const ImDrawList& list, const ImDrawCmd& command, TexturedMesh& mesh) {
  mesh.clear();
  const std::span<const ImDrawIdx> indices(list.IdxBuffer.Data + command.IdxOffset, command.ElemCount);
  if (indices.empty()) return;
  const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
  const std::span<const ImDrawVert> vertices(list.VtxBuffer.Data + command.VtxOffset + *low,
                                             static_cast<std::size_t>(*high - *low) + 1);
  for (const ImDrawVert& vertex : vertices) {
    mesh.vertices.push_back({vec2(vertex.pos), vec2(vertex.uv), color_of(vertex.col)});
  }
  for (const ImDrawIdx index : indices) mesh.indices.push_back(index - *low);
}

}  // namespace

struct DebugPanel::Impl {
  explicit Impl(std::string font_file) : font(std::move(font_file)), context(ImGui::CreateContext()) {
    ImGuiIO& io = use();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    for (const auto& [name, key] : keys) io.KeyMap[name] = static_cast<int>(key);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { ImGui::DestroyContext(context); }

  ImGuiIO& use() const {
    ImGui::SetCurrentContext(context);
    return ImGui::GetIO();
  }
  void set_scale(float wanted);

  std::string font;
  ImGuiContext* context;
  float scale = 0.0F;
  std::optional<Image> atlas;
};

/// Makes font and sizes again for a new scale, since scaled glyphs blur.
void DebugPanel::Impl::set_scale(float wanted) {
  if (std::abs(wanted - scale) < 0.01F) return;
  scale = wanted;
  ImGuiIO& io = use();
  io.Fonts->Clear();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(font, ignored)) {
    io.Fonts->AddFontFromFileTTF(font.c_str(), std::round(text_size * scale));
  } else {
    io.Fonts->AddFontDefault();
  }
  unsigned char* alphas = nullptr;
  int width = 0;
  int height = 0;
  io.Fonts->GetTexDataAsAlpha8(&alphas, &width, &height);
  std::vector<Color> pixels;
  for (const unsigned char alpha :
       std::span(alphas, static_cast<std::size_t>(width) * static_cast<std::size_t>(height))) {
    pixels.push_back({255, 255, 255, alpha});
  }
  atlas.emplace(width, height, pixels, Mipmaps::no);

  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowRounding = 6.0F;
  style.FrameRounding = 3.0F;
  style.Colors[ImGuiCol_WindowBg].w = 0.88F;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

DebugPanel::DebugPanel(const std::string& font) : impl_(std::make_unique<Impl>(font)) {}
DebugPanel::~DebugPanel() = default;

void DebugPanel::begin(const WindowInput& input, int width, int height, double scale, double seconds) {
  impl_->set_scale(static_cast<float>(std::clamp(scale, 0.5, 4.0)));
  ImGuiIO& io = impl_->use();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = static_cast<float>(std::clamp(seconds, 1e-4, 1.0));
  io.MousePos = {static_cast<float>(input.mouse.x), static_cast<float>(input.mouse.y)};
  constexpr std::array buttons = {MouseButton::left, MouseButton::right, MouseButton::middle};  // in ImGui's order
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    io.MouseDown[k] = input.held(buttons[k]) || input.pressed(buttons[k]);  // includes clicks between two frames
  }
  io.MouseWheel = static_cast<float>(input.wheel.y);
  io.MouseWheelH = static_cast<float>(input.wheel.x);
  for (std::size_t k = 0; k < key_count; ++k) io.KeysDown[k] = input.keys_held[k] || input.keys_pressed[k];
  io.KeyCtrl = input.held(Key::ctrl);
  io.KeyShift = input.held(Key::shift);
  io.KeyAlt = input.held(Key::alt);
  io.AddInputCharactersUTF8(input.text.c_str());
  ImGui::NewFrame();
}

void DebugPanel::end() {
  impl_->use();
  ImGui::Render();
}

void DebugPanel::draw(Canvas& canvas) const {
  impl_->use();
  const ImDrawData* data = ImGui::GetDrawData();
  if (data == nullptr || !data->Valid) return;
  const Texture texture{&*impl_->atlas, Filter::linear, Wrap::clamp, Wrap::clamp};
  TexturedMesh mesh;
  for (const ImDrawList* list : std::span(data->CmdLists, static_cast<std::size_t>(data->CmdListsCount))) {
    for (const ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback != nullptr) continue;
      copy_triangles(*list, command, mesh);
      const ImVec4 clip = command.ClipRect;
      canvas.textured(mesh, texture, {whole(clip.x), whole(clip.y), whole(clip.z), whole(clip.w)});
    }
  }
}

bool DebugPanel::wants_mouse() const { return impl_->use().WantCaptureMouse; }
bool DebugPanel::wants_keyboard() const { return impl_->use().WantTextInput; }

WindowInput without_captured(const DebugPanel& panel, const WindowInput& input) {
  WindowInput rest = input;
  if (panel.wants_mouse()) {
    rest.buttons_held.reset();
    rest.buttons_pressed.reset();
    rest.wheel = {};
    rest.wheel_turned.reset();
  }
  if (panel.wants_keyboard()) {
    rest.keys_held.reset();
    rest.keys_pressed.reset();
    rest.text.clear();
  }
  return rest;
}

}  // namespace engine

#include "engine/window/input_names.h"

#include <algorithm>
#include <array>

namespace engine {
namespace {

struct Row {
  InputCode code;
  std::string_view name;
  std::string_view title;
};

constexpr std::array table = std::to_array<Row>({
    {Key::a, "key_a", "A"},
    {Key::b, "key_b", "B"},
    {Key::c, "key_c", "C"},
    {Key::d, "key_d", "D"},
    {Key::e, "key_e", "E"},
    {Key::f, "key_f", "F"},
    {Key::g, "key_g", "G"},
    {Key::h, "key_h", "H"},
    {Key::i, "key_i", "I"},
    {Key::j, "key_j", "J"},
    {Key::k, "key_k", "K"},
    {Key::l, "key_l", "L"},
    {Key::m, "key_m", "M"},
    {Key::n, "key_n", "N"},
    {Key::o, "key_o", "O"},
    {Key::p, "key_p", "P"},
    {Key::q, "key_q", "Q"},
    {Key::r, "key_r", "R"},
    {Key::s, "key_s", "S"},
    {Key::t, "key_t", "T"},
    {Key::u, "key_u", "U"},
    {Key::v, "key_v", "V"},
    {Key::w, "key_w", "W"},
    {Key::x, "key_x", "X"},
    {Key::y, "key_y", "Y"},
    {Key::z, "key_z", "Z"},
    {Key::digit_0, "key_digit_0", "0"},
    {Key::digit_1, "key_digit_1", "1"},
    {Key::digit_2, "key_digit_2", "2"},
    {Key::digit_3, "key_digit_3", "3"},
    {Key::digit_4, "key_digit_4", "4"},
    {Key::digit_5, "key_digit_5", "5"},
    {Key::digit_6, "key_digit_6", "6"},
    {Key::digit_7, "key_digit_7", "7"},
    {Key::digit_8, "key_digit_8", "8"},
    {Key::digit_9, "key_digit_9", "9"},
    {Key::left, "key_left", "←"},
    {Key::right, "key_right", "→"},
    {Key::up, "key_up", "↑"},
    {Key::down, "key_down", "↓"},
    {Key::space, "key_space", "Space"},
    {Key::enter, "key_enter", "Enter"},
    {Key::escape, "key_escape", "Esc"},
    {Key::tab, "key_tab", "Tab"},
    {Key::shift, "key_shift", "Shift"},
    {Key::ctrl, "key_ctrl", "Ctrl"},
    {Key::comma, "key_comma", "Comma"},
    {Key::period, "key_period", "Full stop"},
    {Key::f1, "key_f1", "F1"},
    {Key::f2, "key_f2", "F2"},
    {Key::f3, "key_f3", "F3"},
    {Key::f4, "key_f4", "F4"},
    {Key::f5, "key_f5", "F5"},
    {Key::f6, "key_f6", "F6"},
    {Key::f7, "key_f7", "F7"},
    {Key::f8, "key_f8", "F8"},
    {Key::f9, "key_f9", "F9"},
    {Key::f10, "key_f10", "F10"},
    {Key::f11, "key_f11", "F11"},
    {Key::f12, "key_f12", "F12"},
    {Key::backspace, "key_backspace", "Backspace"},
    {Key::alt, "key_alt", "Alt"},
    {Key::insert, "key_insert", "Insert"},
    {Key::remove, "key_remove", "Delete"},
    {Key::home, "key_home", "Home"},
    {Key::end, "key_end", "End"},
    {Key::page_up, "key_page_up", "Page up"},
    {Key::page_down, "key_page_down", "Page down"},
    {Key::minus, "key_minus", "Minus"},
    {Key::equals, "key_equals", "Equals"},
    {Key::slash, "key_slash", "Slash"},
    {Key::semicolon, "key_semicolon", "Semicolon"},
    {Key::left_shift, "key_left_shift", "Left Shift"},
    {Key::right_shift, "key_right_shift", "Right Shift"},
    {Key::left_ctrl, "key_left_ctrl", "Left Ctrl"},
    {Key::right_ctrl, "key_right_ctrl", "Right Ctrl"},
    {MouseButton::left, "mouse_left", "Left mouse"},
    {MouseButton::middle, "mouse_middle", "Middle mouse"},
    {MouseButton::right, "mouse_right", "Right mouse"},
    {WheelTurn::up, "wheel_up", "Wheel up"},
    {WheelTurn::down, "wheel_down", "Wheel down"},
    {PadButton::a, "pad_a", "A"},
    {PadButton::b, "pad_b", "B"},
    {PadButton::x, "pad_x", "X"},
    {PadButton::y, "pad_y", "Y"},
    {PadButton::back, "pad_back", "Back"},
    {PadButton::start, "pad_start", "Start"},
    {PadButton::left_stick, "pad_left_stick", "L3"},
    {PadButton::right_stick, "pad_right_stick", "R3"},
    {PadButton::left_shoulder, "pad_left_shoulder", "LB"},
    {PadButton::right_shoulder, "pad_right_shoulder", "RB"},
    {PadButton::dpad_up, "pad_dpad_up", "D-pad ↑"},
    {PadButton::dpad_down, "pad_dpad_down", "D-pad ↓"},
    {PadButton::dpad_left, "pad_dpad_left", "D-pad ←"},
    {PadButton::dpad_right, "pad_dpad_right", "D-pad →"},
    {PadButton::left_trigger, "pad_left_trigger", "LT"},
    {PadButton::right_trigger, "pad_right_trigger", "RT"},
    {PadButton::left_stick_left, "pad_left_stick_left", "L stick ←"},
    {PadButton::left_stick_right, "pad_left_stick_right", "L stick →"},
    {PadButton::left_stick_up, "pad_left_stick_up", "L stick ↑"},
    {PadButton::left_stick_down, "pad_left_stick_down", "L stick ↓"},
    {PadButton::right_stick_left, "pad_right_stick_left", "R stick ←"},
    {PadButton::right_stick_right, "pad_right_stick_right", "R stick →"},
    {PadButton::right_stick_up, "pad_right_stick_up", "R stick ↑"},
    {PadButton::right_stick_down, "pad_right_stick_down", "R stick ↓"},
});
static_assert(table.size() == key_count + mouse_button_count + wheel_turn_count + pad_button_count);

const Row& row(const InputCode& code) {
  return *std::find_if(table.begin(), table.end(), [&code](const Row& one) { return one.code == code; });
}

}  // namespace

std::string_view input_name(const InputCode& code) { return row(code).name; }

std::optional<InputCode> input_of_name(std::string_view name) {
  for (const Row& one : table) {
    if (one.name == name) return one.code;
  }
  return std::nullopt;
}

std::string_view input_title(const InputCode& code) { return row(code).title; }

}  // namespace engine

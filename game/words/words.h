#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

/// All texts that the game shows. A name in braces is replaced by `filled`. Titles, hints and signs of levels are in
/// their files, the reasons of errors where they are found. tests/house/shown_words looks for texts elsewhere.
namespace game::words {

/// Replaces names in braces: filled("in {time}", {{"time", "12.00 s"}}) is "in 12.00 s". Other braces stay.
std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string_view>> values);

// Menus
inline constexpr const char* game_title = "Rope swing";
inline constexpr const char* window_title = "Rope swing - {screen}";
inline constexpr const char* tagline = "Swing from rope to rope to the flag";
inline constexpr const char* play = "Play";
inline constexpr const char* open_lab = "Lab";
inline constexpr const char* options = "Options";
inline constexpr const char* quit = "Quit";
inline constexpr const char* back = "Back";
inline constexpr const char* resume = "Resume";
inline constexpr const char* paused = "Paused";
inline constexpr const char* restart_level = "Restart level";
inline constexpr const char* levels = "Levels";
inline constexpr const char* title_screen = "Title screen";
inline constexpr const char* retry = "Retry";
inline constexpr const char* next_level = "Next level";
inline constexpr const char* watch_run = "Watch this run";
inline constexpr const char* menu_keys = "↑ ↓ choose   ← → change   Enter: go   Esc: back";
inline constexpr const char* menu_buttons = "D-pad: choose and change   A: go   B: back";
inline constexpr const char* title_keys = "↑ ↓ choose   Enter: go";
inline constexpr const char* title_buttons = "D-pad: choose   A: go";
inline constexpr const char* grid_keys = "Arrows: choose   Enter: play   Esc: back";
inline constexpr const char* grid_buttons = "D-pad: choose   A: play   B: back";
inline constexpr const char* menu_step = "   {key}: one tick";
inline constexpr const char* more_above = "▲";
inline constexpr const char* more_below = "▼";
inline constexpr const char* less = "‹";
inline constexpr const char* more = "›";

// The names of screens in the title of the window
inline constexpr const char* screen_title = "title";
inline constexpr const char* screen_lab = "the lab: {scene}";
inline constexpr const char* screen_levels = "levels";
inline constexpr const char* screen_options = "options";
inline constexpr const char* screen_keys = "keys and buttons";
inline constexpr const char* screen_paused = "paused";
inline constexpr const char* screen_yard = "building in the yard";
inline constexpr const char* screen_results = "results";
inline constexpr const char* screen_last_seconds = "the last seconds with {preset}";
inline constexpr const char* screen_replay = "{level}, a replay";

// The list of levels
inline constexpr const char* level_for_two = "{level}, for two";
inline constexpr const char* not_completed = "Not completed yet";
inline constexpr const char* your_best = "Your best: {best}";
inline constexpr const char* best_with_medal = "{time}, {medal}";
inline constexpr const char* best_with_assists = "{time} with assists";
inline constexpr const char* no_levels = "No levels were found in";
inline constexpr const char* no_levels_advice = "Install the game again, or set ROPESWING_ASSETS to the folder assets.";
inline constexpr const char* level_unreadable = "This level cannot be read";

// Options
inline constexpr const char* keys_and_buttons_more = "Keys and buttons …";
inline constexpr const char* options_note =
    "With a lower speed, a longer reach or no falls, a time counts but earns no medal.";
inline constexpr const char* catch_a_rope = "Catch a rope";
inline constexpr const char* hold_the_key = "hold the key";
inline constexpr const char* press_once = "press once";
inline constexpr const char* game_speed = "Game speed";
inline constexpr const char* longer_reach = "Longer reach";
inline constexpr const char* from_next_level = "on, from the next level";
inline constexpr const char* after_a_fall = "After a fall";
inline constexpr const char* back_to_checkpoint = "back to start or checkpoint";
inline constexpr const char* back_to_foothold = "back to the last foothold";
inline constexpr const char* ghost_of_best = "Ghost of the best run";
inline constexpr const char* hidden = "hidden";
inline constexpr const char* shown = "shown";
inline constexpr const char* motion = "Motion";
inline constexpr const char* full_motion = "full";
inline constexpr const char* reduced_motion = "reduced";
inline constexpr const char* colours = "Colours";
inline constexpr const char* normal_colours = "normal";
inline constexpr const char* high_contrast = "high contrast";
inline constexpr const char* rope_strain = "Rope strain";
inline constexpr const char* coloured = "coloured";
inline constexpr const char* volume = "Volume";
inline constexpr const char* music_volume = "Music volume";
inline constexpr const char* sound = "Sound";
inline constexpr const char* on = "on";
inline constexpr const char* off = "off";
inline constexpr const char* keys_shown = "Keys on the screen";
inline constexpr const char* full_screen = "Full screen";
inline constexpr const char* per_cent = "{number} %";

// Keys and buttons
inline constexpr const char* keys_and_buttons = "Keys and buttons";
inline constexpr const char* keys_note =
    "Keyboard and mouse   |   gamepad.   Choose an action, then press its new key.";
inline constexpr const char* second_keys_note =
    "The second player's half of the keyboard, in levels for two. What it has, the first player has not.";
inline constexpr const char* keys_of = "Keys of";
inline constexpr const char* first_player = "the first player";
inline constexpr const char* second_player = "the second player";
inline constexpr const char* both_devices = "{keys}   |   {buttons}";
inline constexpr const char* waiting_for_key = "…";
inline constexpr const char* reset_to_defaults = "Reset to defaults";
inline constexpr const char* press_a_key =
    "Press a key or button for “{action}”. One that it has already is removed. Esc or Start: stop";
inline constexpr const char* key_is_taken = "{key} is for “{owner}”. Press it again to use it for “{action}” instead.";

inline constexpr const char* or_key = " or ";
inline constexpr const char* no_key = "none";

// The titles of the actions
inline constexpr const char* do_left = "Run or swing left";
inline constexpr const char* do_right = "Run or swing right";
inline constexpr const char* do_up = "Climb up";
inline constexpr const char* do_down = "Climb down";
inline constexpr const char* do_jump = "Jump, let go";
inline constexpr const char* do_grab = "Catch a rope";
inline constexpr const char* do_throw_line = "Throw a line";
inline constexpr const char* do_throw_second = "Throw a second line";
inline constexpr const char* do_tie = "Tie the line";
inline constexpr const char* do_cut = "Cut a rope";
inline constexpr const char* do_reel_in = "Reel in";
inline constexpr const char* do_reel_out = "Reel out";
inline constexpr const char* do_retry = "Back to the checkpoint";
inline constexpr const char* do_restart = "Restart the level";
inline constexpr const char* do_pause = "Pause";
inline constexpr const char* do_step = "Advance one tick";
inline constexpr const char* do_slow_motion = "Slow motion 1/2, 1/4";
inline constexpr const char* do_help = "Show or hide the keys";
inline constexpr const char* do_debug_view = "Debug view, drag by mouse";
inline constexpr const char* do_panel = "Figures and parameters";
inline constexpr const char* do_palette = "Build in the sandbox";
inline constexpr const char* do_mute = "Sound on or off";
inline constexpr const char* do_fullscreen = "Full screen";
inline constexpr const char* do_film = "Start or stop a video";
inline constexpr const char* do_screenshot = "Take a screenshot";

// Play
inline constexpr const char* help_key = "{key}: help";
inline constexpr const char* help_entry = "{keys}: {action}";
inline constexpr const char* help_hold = "Hold {keys}";
inline constexpr const char* help_of_two = "{first} | {second}: {action}";
inline constexpr const char* replay_controls = "Replay: the controls are off";
inline constexpr const char* leave_key = "Esc: back";
inline constexpr const char* leave_button = "B: back";
inline constexpr const char* verified = "Verified";
inline constexpr const char* differs = "Differs from the recording";
inline constexpr const char* two_parts = "{first}   {second}";
inline constexpr const char* end_of_recording = "End of the recording";
inline constexpr const char* stopped = "Stopped";
inline constexpr const char* stopped_keys = "{pause}: resume   {step}: one tick";
inline constexpr const char* one_at_flag = "One player is at the flag; both must touch it";
inline constexpr const char* made_it = "You made it!";
inline constexpr const char* made_it_in = "in {time}";
inline constexpr const char* slow_motion = "slow motion 1/{factor}";
inline constexpr const char* time_and_falls = "{time}   falls {falls}";
inline constexpr const char* time_and_coins = "{time}   coins {found}/{all}";
inline constexpr const char* seconds = "{number} s";
inline constexpr const char* kilograms = "{number} kg";
inline constexpr const char* tonnes = "{number} t";
inline constexpr const char* flag_right = "flag {metres} m →";
inline constexpr const char* flag_left = "← flag {metres} m";

// Building in a sandbox
inline constexpr const char* place_things = "Build";
inline constexpr const char* build_key = "{key}: build";
inline constexpr const char* yard_headline = "Build";
inline constexpr const char* yard_rope = "Rope between two points";
inline constexpr const char* yard_hanging_rope = "Rope from one point";
inline constexpr const char* yard_curtain = "Ribbon from one point";
inline constexpr const char* yard_trampoline = "Trampoline";
inline constexpr const char* yard_crate = "Crate";
inline constexpr const char* yard_ball = "Ball";
inline constexpr const char* yard_peg = "Peg";
inline constexpr const char* yard_move = "Move";
inline constexpr const char* yard_remove = "Remove";
inline constexpr const char* yard_clear = "Clear";
inline constexpr const char* yard_done = "Done";
inline constexpr const char* yard_count = "{count} of {most} things";
inline constexpr const char* yard_too_many = "{count} things at most: remove one";
inline constexpr const char* yard_outside = "Too near the edge of the yard";
inline constexpr const char* yard_too_short = "At least {least} m from end to end";
inline constexpr const char* yard_too_long = "At most {most} m from end to end";
inline constexpr const char* yard_in_the_way = "Something is in the way";
inline constexpr const char* yard_keys = "Tab: next   mouse or arrows: pointer   click or Enter: use   Esc: done";
inline constexpr const char* yard_buttons = "LB RB: choose   stick: pointer   A: use   B: done";
inline constexpr const char* recording_ended_by_building = "The recording ended: the yard was changed";

// The last seconds with another preset
inline constexpr const char* last_seconds_headline = "The last seconds with “{preset}”";
inline constexpr const char* last_seconds_keys = "← → preset   Esc: back";
inline constexpr const char* last_seconds_buttons = "D-pad: preset   B: back";
inline constexpr const char* last_seconds_progress = "repeating the run: {percent} %";
inline constexpr const char* last_seconds_legend = "thin lines: with this preset; the rest: as played";
inline constexpr const char* last_seconds_gap = "apart now {now} cm, most {most} cm after {time} s";
inline constexpr const char* last_seconds_cost = "a tick {other} µs, as played {played} µs";

// Medals
inline constexpr const char* gold = "Gold";
inline constexpr const char* silver = "Silver";
inline constexpr const char* bronze = "Bronze";

// Results
inline constexpr const char* time_and_medal = "{time}   {medal}!";
inline constexpr const char* made_it_through = "You made it through “{level}”";
inline constexpr const char* best_so_far = "New best time!";
inline constexpr const char* first_time = "First completion!";
inline constexpr const char* best_before = "Previous best: {best}";
inline constexpr const char* best_is = "Your best: {best}";
inline constexpr const char* no_medal = "With assists: no medal for this time";
inline constexpr const char* next_medal = "{medal}: {time} or less";
inline constexpr const char* coins_of = "Coins: {found} of {all}";
inline constexpr const char* checkpoint_splits = "Checkpoint {splits}";
inline constexpr const char* no_falls = "No falls";
inline constexpr const char* one_fall = "1 fall";
inline constexpr const char* some_falls = "{count} falls";

// Notices
inline constexpr const char* times_unreadable = "The best times cannot be read; the file is kept as best.json.broken";
inline constexpr const char* times_not_written = "The best times cannot be written; they last until the game ends";
inline constexpr const char* settings_unreadable =
    "The settings cannot be read, so the defaults are used; the file is kept as settings.json.broken";
inline constexpr const char* settings_not_written = "The settings cannot be written; they last until the game ends";
inline constexpr const char* rival_refused =
    "--ghost {file} cannot be raced against: {reason}; accepted is a recording of the level that is played";
inline constexpr const char* rival_of_other_version = "The recording is of another version of this level: no ghost";
inline constexpr const char* pad_found = "A gamepad is plugged in";
inline constexpr const char* pad_lost = "The gamepad was unplugged";
inline constexpr const char* sound_missing = "A sound is missing: {reason}";
inline constexpr const char* level_reloaded = "The level was reloaded";
inline constexpr const char* runs_not_recorded = "Runs are not recorded: the folder cannot be written";
inline constexpr const char* recording_stopped = "Recording stopped: the file cannot be written";
inline constexpr const char* recording_unreadable = "The recording of this run cannot be read";
inline constexpr const char* screenshot = "Screenshot: {file}";
inline constexpr const char* screenshot_failed = "The screenshot cannot be written: {reason}";
inline constexpr const char* no_folder = "there is no home folder for it";
inline constexpr const char* film_failed = "No video: {reason}";
inline constexpr const char* film_begins = "Recording a video to {file}";
inline constexpr const char* film_ends = "Video: {file}";
inline constexpr const char* film_resized = "The window has another size now; video: {file}";

// The legend of strain
inline constexpr const char* stretched_by = "stretched by";

// The figures of the debug view
inline constexpr const char* legend_points =
    "points: blue free, grey asleep, yellow dragged, red constrained; pink: contacts; boxes: what a cord may reach";
inline constexpr const char* legend_tension =
    "ropes: tension, from violet (1 N) to yellow (10 kN); red cells are inside out";
inline constexpr const char* tick_cost = "a tick: {median} µs, at most {worst} µs in the last second (of 16667)";
inline constexpr const char* more_cords = "and {count} more cords";
inline constexpr const char* cord = "cord";
inline constexpr const char* points = "points";
inline constexpr const char* self = "self";
inline constexpr const char* circles = "circles";
inline constexpr const char* tangled = "tangled";
inline constexpr const char* fem_skipped = "FEM skipped in all";
inline constexpr const char* held_back = "held back in all";
inline constexpr const char* strained = "strained";
inline constexpr const char* touches = "touches";
inline constexpr const char* iterations = "iterations";
inline constexpr const char* impacts = "impacts in all";
inline constexpr const char* fallbacks = "fallbacks in all";
inline constexpr const char* unconverged = "unconverged in all";
inline constexpr const char* peak_stretch = "peak stretch";
inline constexpr const char* error_rate = "est. error mm/s";
inline constexpr const char* asleep = "asleep";

}  // namespace game::words
